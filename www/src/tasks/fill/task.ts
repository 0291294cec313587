/** A mesh, and one closed wire all over it, in a style. */

import { msg, str } from "@lit/localize";
import { QUIET } from "../../state/contract/state";
import type { PageTask } from "../../ui/shared/page-task";
import { NO_COVER } from "./coverer";
import { address, meshName, workOf, type Cover } from "./given";
import { NO_PLAN } from "./planning";
import { CoverTaker, type Passing } from "./taking";
import { verdict } from "./verdict";

export const fill: PageTask<Cover | null, Passing, CoverTaker> = {
  name: "fill",
  words: {
    given: "shape",
    looking: msg("Looking at the shape"),
    needs: msg("A wire needs a shape to cover."),
    remedy: msg("Choose one on the left, then press Cover it."),
    text: msg("That was text. Here a wire covers a shape: drop a mesh, or a picture for its style."),
  },
  page: {
    tab: msg("A shape"),
    title: msg("One shape, one wire all over it"),
    panel: msg("Shape"),
    drops: msg("a mesh, a picture for its style, or a wire saved here"),
    run: msg("Cover it"),
    own: { icon: "open", instead: msg("Open a mesh"), again: msg("Open a mesh") },
    result: msg("Cover"),
    example: msg("One closed wire covers the whole shape. Make it again to watch how it gets there."),
    planned: {
      made: msg("The lines would run another way now: cover it to make that wire. The one made before is kept until then."),
      none: msg("The thin line on the stage is the way of the wire. Cover it, and it thickens and bends into the style."),
    },
  },
  stage: {
    views: {
      room: msg("The wire covers the shape, in the corner of a room."),
      front: msg("Seen straight from the front."),
      right: msg("Seen straight from the right."),
      back: msg("Seen straight from behind."),
      left: msg("Seen straight from the left."),
      top: msg("Seen straight from above."),
    },
    tour: ["front", ...[60, 120, 180, 240, 300].map((azimuth) => ({ azimuth, elevation: 15 })), "front", "room"],
    farSide: "hidden_lines",
  },
  blank: null,
  quiet: { ...QUIET, ...NO_COVER, ...NO_PLAN },
  takes: { pictures: 1, meshes: true },
  keeps: { settings: [], groups: ["views", "surface"] },
  // There is no picture that could bend.
  elsewhere: ["bend"],
  compared: [],
  form: {
    // A mesh may be large, and is not written again with every style.
    parts: (cover) => ({ mesh: cover?.mesh ?? null, style: cover?.style ?? null }),
    whole: ({ mesh = null, style = null }) => (mesh === null ? null : ({ mesh, style } as Cover)),
  },
  address,
  packing: async () => (await import("./packing")).packing,
  isBlank: (cover) => cover === null,
  suffices: (cover) => cover !== null,
  labels: (cover) => [cover ? meshName(cover.mesh) : ""],
  work: (cover) => workOf(cover!),
  example: async () => (await import("./example/example")).example(),
  verdict,
  stale: ({ stale }) => stale,
  wire: ({ stale, curve, ofThisMesh }, made) => (stale !== "way" ? made : (curve ?? (ofThisMesh ? made : null))),
  stays(cover) {
    const mesh = cover !== null && !("shape" in cover.mesh);
    const picture = cover !== null && cover.style !== null && typeof cover.style !== "string";
    const stays = mesh && picture ? msg("Your mesh and your picture stay") : mesh ? msg("Your mesh stays") : picture ? msg("Your picture stays") : "";
    return stays && msg(str`${stays} on this device.`);
  },
  open: (bench) => new CoverTaker(bench, fill),
  parts: () => import("./parts/parts"),
  help: () => import("./help"),
};
