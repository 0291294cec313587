/** One picture, one wire that draws it and still makes sense from the side. */

import { msg } from "@lit/localize";
import { QUIET, type PadState } from "../../state/contract/state";
import { pixelsOf } from "../../state/picture/picture";
import type { PageTask } from "../../ui/shared/page-task";
import { hintsOf, isPointedAt, maskOf, type Subject } from "./given";
import type { StrokeWork } from "./protocol";
import { keyOf, SubjectTaker } from "./taking";
import { verdict } from "./verdict";

export const stroke: PageTask<Subject | null, PadState, SubjectTaker> = {
  name: "stroke",
  words: {
    given: "picture",
    looking: msg("Looking at the picture"),
    needs: msg("A wire needs a picture."),
    remedy: msg("Give one on the left, then press Run."),
    text: msg("That was text. Here a wire is made of a picture: paste or drop one."),
  },
  page: {
    tab: msg("One picture"),
    title: msg("One picture, one wire that turns"),
    panel: msg("Picture"),
    drops: msg("a picture, or a wire saved here"),
    run: msg("Run"),
    own: { icon: "picture", instead: msg("Use your own"), again: msg("Start over") },
    result: msg("Match"),
    example: msg("One wire draws the picture, and goes on round the back. Make it again to watch how it gets there."),
  },
  stage: {
    views: {
      room: msg("The wire hangs in the corner of a room. Its shadow on the back wall is the picture."),
      front: msg("Seen straight from the front, where the wire shows the picture."),
      side: msg("Seen straight from the side."),
      top: msg("Seen straight from above."),
    },
    tour: ["front", ...[45, 135, 225, 315].map((azimuth) => ({ azimuth, elevation: 10 })), "front", "room"],
  },
  blank: null,
  quiet: QUIET,
  takes: { pictures: 1, meshes: false },
  keeps: { settings: ["control_points", "min_width", "max_width"], groups: ["views", "stroke"] },
  // An object is chosen where it is seen, and one picture has nothing to bend to.
  elsewhere: ["object", "bend"],
  compared: ["front"],
  form: {
    parts: (subject) => ({ subject }),
    whole: ({ subject = null }) => subject as Subject | null,
  },
  packing: async () => (await import("./packing")).packing,
  isBlank: (subject) => subject === null,
  suffices: (subject) => subject !== null,
  labels: (subject) => [subject?.picture.name ?? ""],
  async work(subject): Promise<StrokeWork> {
    const { picture, depth, strokes } = subject!;
    // What is pointed at the core draws as surely as it sees it; a hand knows better.
    const mask = isPointedAt(subject!) && strokes.length === 0 ? null : maskOf(subject!);
    return { key: keyOf(picture), picture: await pixelsOf(picture), mask, hints: hintsOf(subject!), depth: depth && (await pixelsOf(depth)) };
  },
  example: async () => (await import("./example/example")).example(),
  verdict,
  open: (bench) => new SubjectTaker(bench, stroke),
  parts: () => import("./parts/parts"),
  help: () => import("./help"),
};
