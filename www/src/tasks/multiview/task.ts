/** Several drawings, one wire that shows each from its side. */

import { msg } from "@lit/localize";
import { nextTurn } from "../../state/common/next-turn";
import { QUIET } from "../../state/contract/state";
import type { PageTask } from "../../ui/shared/page-task";
import { drawingOf } from "./paper";
import { guidedAlone, laidOut, NO_PAPERS, sheetsOf, SLOTS, type Papers } from "./given";
import { NO_PREVIEW } from "./previewer";
import type { Drawing, Work } from "./protocol";
import { Pads, type Passing } from "./pads";
import { verdict } from "./verdict";

export const multiview: PageTask<Papers, Passing, Pads> = {
  name: "multiview",
  words: {
    given: "drawings",
    looking: msg("Looking at the drawings"),
    needs: msg("A wire needs at least two drawings."),
    remedy: msg("Put one into another pad, or let a word pull there, then press Run."),
    text: msg("That was text. To make a wire of a word, open a pad, choose Type and write it there."),
  },
  page: {
    tab: msg("Three views"),
    title: msg("Three drawings, one wire"),
    panel: msg("Pictures"),
    drops: msg("pictures, or a wire saved here"),
    run: msg("Run"),
    own: { icon: "pencil", instead: msg("Draw your own"), again: msg("Start over") },
    result: msg("Match"),
    example: msg("Three pictures in one wire. Make it again to watch how it gets there."),
  },
  stage: {
    views: {
      room: msg("The wire hangs in the corner of a room. Its shadows on the back wall, the side wall and the floor are the three drawings."),
      front: msg("Seen straight from the front, where the wire shows the first drawing."),
      side: msg("Seen straight from the side, where the wire shows the second drawing."),
      top: msg("Seen straight from above, where the wire shows the third drawing."),
    },
    tour: ["front", "side", "top", "room"],
  },
  blank: NO_PAPERS,
  quiet: { ...NO_PREVIEW, pads: { front: QUIET, side: QUIET, top: QUIET } },
  takes: { pictures: SLOTS.length, meshes: false },
  keeps: { settings: [], groups: ["views"] },
  // Ink is found pad by pad.
  elsewhere: ["bend", "ink", "read", "lines"],
  compared: SLOTS,
  form: {
    parts: (papers) => ({ ...papers }),
    whole: (parts) => ({ ...NO_PAPERS, ...parts }),
  },
  packing: async () => (await import("./packing")).packing,
  isBlank: (papers) => laidOut(papers).length === 0,
  suffices: (papers, guide, closely = false) => (closely ? sheetsOf(papers) : laidOut(papers)).length + guidedAlone(papers, guide, closely).length >= 2,
  fewer: (papers) => {
    const laid = laidOut(papers);
    return laid.length > 2 ? { ...papers, [laid.at(-1)!]: null } : null;
  },
  labels: (papers) => sheetsOf(papers).map(({ paper }) => paper.label),
  async work(papers, guide): Promise<Work> {
    const drawings: Drawing[] = [];
    for (const { slot, paper } of sheetsOf(papers)) {
      await nextTurn();
      drawings.push(drawingOf(paper, slot));
    }
    return { drawings, guided: guidedAlone(papers, guide, true) };
  },
  example: async (engine) => (await import("./example/example")).example(engine),
  verdict,
  open: (bench) => new Pads(bench, multiview),
  parts: () => import("./parts/parts"),
  help: () => import("./help"),
};
