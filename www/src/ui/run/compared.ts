/** What one wire and loose strokes have to tell of each other. */

import { msg, str } from "@lit/localize";
import type { Made } from "../../state/keeping/document";
import { count, counted, percent } from "../../words/numbers";
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

/** That as people read it; a dash where nothing was given. */
export function matchWords(made: Made, views: number): string {
  const share = meanMatch(made, views);
  return share === null ? "–" : percent(share);
}

export const shareWords = (share: number): string => (share > 0 && share < 0.01 ? msg("under 1%") : percent(share));

export function compared(wire: Made, loose: Made, views: number): string {
  const [a, b] = [meanMatch(wire, views), meanMatch(loose, views)];
  const [pieces, strokes] = [wire.finished.measures.components, loose.finished.measures.components];
  const gap = gapOf(loose);
  const sentences = [
    a === null || b === null ? "" : Math.abs(a - b) < ALIKE ? msg("Both match about as well.") : a > b ? msg("The wire matches better.") : msg("Loose strokes match better."),
    strokes > pieces
      ? counted(pieces, msg(str`Loose strokes fall into ${count(strokes)} pieces, the wire is one.`), msg(str`Loose strokes fall into ${count(strokes)} pieces, the wire into ${count(pieces)}.`))
      : strokes === pieces
        ? counted(pieces, msg("Both are in one piece."), msg(str`Both are in ${count(pieces)} pieces.`))
        : "",
    gap > 0.005 ? msg(str`To join them would take ${percent(gap)} more wire.`) : "",
    loose.stopped ? msg("The loose strokes were stopped early.") : "",
  ];
  return sentences.filter(Boolean).join(" ");
}

/** Wire that would join its pieces, as a share of its length. */
export function gapOf({ finished }: Made): number {
  const { connectivity_cost, length } = finished.measures;
  return length > 0 ? connectivity_cost / length : 0;
}

/** Shares of the length that differ by less are alike. */
const ALIKE_SHARE = 0.01;

/** What a wire and one that was made another way have to tell of each other. */
export function weighed(wire: Made, other: Made, views: number): string {
  const [a, b] = [meanMatch(wire, views), meanMatch(other, views)];
  const [of, ofOther] = [wire.finished.measures, other.finished.measures];
  const longer = of.length > 0 ? ofOther.length / of.length - 1 : 0;
  const [tight, through] = [(ofOther.tight_share ?? 0) - (of.tight_share ?? 0), (ofOther.penetrating_share ?? 0) - (of.penetrating_share ?? 0)];
  const sentences = [
    a === null || b === null ? "" : Math.abs(a - b) < ALIKE ? msg("Both match about as well.") : a > b ? msg(str`The other wire matches worse: ${percent(b)}, not ${percent(a)}.`) : msg(str`The other wire matches better: ${percent(b)}, not ${percent(a)}.`),
    Math.abs(longer) < ALIKE_SHARE ? "" : longer > 0 ? msg(str`It is ${percent(longer)} longer.`) : msg(str`It is ${percent(-longer)} shorter.`),
    Math.abs(tight) < ALIKE_SHARE ? "" : tight > 0 ? msg("It bends tightly more often.") : msg("It bends tightly less often."),
    Math.abs(through) < ALIKE_SHARE ? "" : through > 0 ? msg("It passes through itself more often.") : msg("It passes through itself less often."),
    other.stopped ? msg("It was stopped early.") : "",
  ];
  return sentences.filter(Boolean).join(" ");
}
