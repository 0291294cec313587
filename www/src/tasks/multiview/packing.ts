/** How drawings go along in files, and come back from them. */

import { msg } from "@lit/localize";
import { onSheet } from "../../state/carrying/resized";
import type { Packing } from "../../state/contract/task";
import { NO_PAPERS, sheetsOf, SLOTS, type Papers } from "./given";
import { compose, PAPER_PX, withStamp } from "./paper";

export const packing: Packing<Papers> = {
  async pack(papers) {
    const drawings = sheetsOf(papers).map(({ slot, paper }) => ({ view: slot, label: paper.label, width: PAPER_PX, height: PAPER_PX, ink: compose(paper) }));
    return { drawings, pairs: {} };
  },
  /** Onto the pads of their names; those of other views, onto the pads that are left. */
  async unpack({ drawings }) {
    let papers = NO_PAPERS;
    const named = SLOTS.filter((slot) => drawings.some(({ view }) => view === slot));
    const left = SLOTS.filter((slot) => !named.includes(slot));
    for (const drawing of drawings) {
      const slot = named.find((slot) => slot === drawing.view) ?? left.shift();
      if (slot) papers = { ...papers, [slot]: withStamp(null, { label: drawing.label || msg("Drawing"), ink: onSheet(drawing, PAPER_PX) }) };
    }
    return sheetsOf(papers).length ? papers : null;
  },
};
