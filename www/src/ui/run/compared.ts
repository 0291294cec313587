/** What one wire and loose strokes have to tell of each other. */

import type { Made } from "../../state/keeping/document";
import { percent } from "../../state/common/words";
import { count } from "../../state/common/count";
import { match } from "../../view/likeness";

/** Matches that differ by less look alike. */
const ALIKE = 0.02;

/** How well a wire shows what was given, 0 to 1: the mean over the first `views`, those that a picture was given for. */
export function meanMatch({ finished }: Made, views: number): number | null {
  const shares = finished.measures.views
    .slice(0, views)
    .flatMap((view) => match(view) ?? []);
  return shares.length ? shares.reduce((sum, share) => sum + share, 0) / shares.length : null;
}

export function compared(wire: Made, loose: Made, views: number): string {
  const [a, b] = [meanMatch(wire, views), meanMatch(loose, views)];
  const [pieces, strokes] = [wire.finished.measures.components, loose.finished.measures.components];
  const gap = gapOf(loose);
  const sentences = [
    a === null || b === null ? "" : Math.abs(a - b) < ALIKE ? "Both match about as well." : `${a > b ? "The wire" : "Loose strokes"} match${a > b ? "es" : ""} better.`,
    strokes > pieces
      ? `Loose strokes fall into ${count(strokes)} pieces, the wire ${pieces === 1 ? "is one" : `into ${count(pieces)}`}.`
      : strokes === pieces
        ? `Both are ${pieces === 1 ? "in one piece" : `in ${count(pieces)} pieces`}.`
        : "",
    gap > 0.005 ? `To join them would take ${percent(gap)} more wire.` : "",
    loose.stopped ? "The loose strokes were stopped early." : "",
  ];
  return sentences.filter(Boolean).join(" ");
}

/** Wire that would join its pieces, as a share of its length. */
export function gapOf({ finished }: Made): number {
  const { connectivity_cost, length } = finished.measures;
  return length > 0 ? connectivity_cost / length : 0;
}
