/** What a person gives: a drawing a pad. Immutable, without elements. */

import type { Guide } from "../../engine/protocol";
import { isBlank, type Paper } from "./paper";

/** The pads, in the run's order. */
export const SLOTS = ["front", "side", "top"] as const;
export type Slot = (typeof SLOTS)[number];

export type Papers = Readonly<Record<Slot, Paper | null>>;

export interface Sheet {
  readonly slot: Slot;
  readonly paper: Paper;
}

export const NO_PAPERS: Papers = { front: null, side: null, top: null };

/** The pads on which something lies, even if it is blank: known at a glance. */
export const laidOut = (papers: Papers): readonly Slot[] => SLOTS.filter((slot) => papers[slot] !== null);

/** The pads that hold ink, in order. */
export function sheetsOf(papers: Papers): readonly Sheet[] {
  return SLOTS.flatMap((slot) => {
    const paper = papers[slot];
    return paper && !isBlank(paper) ? [{ slot, paper }] : [];
  });
}

/** The pads that have a word and nothing drawn; a blank sheet is nothing when looked at closely. */
export function guidedAlone(papers: Papers, guide: Guide | null, closely = false): readonly Slot[] {
  const isDrawn = (paper: Paper | null): boolean => (closely ? !isBlank(paper) : paper !== null);
  return SLOTS.filter((slot) => guide && guide.weight > 0 && guide.words[slot] && !isDrawn(papers[slot]));
}
