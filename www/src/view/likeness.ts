/** How like the pictures a wire is, in numbers, and in the words that tasks share. */

import { msg, str } from "@lit/localize";
import type { ViewMeasures } from "../engine/protocol";
import { counted, decimal, percent } from "../words/numbers";
import type { Made } from "../state/keeping/document";

const GOOD = 0.82;
export const FAIR = 0.65;
/** A thin line that is off by its own width reads the same: it is enough if so much of wire and drawing is within two pixels. */
const NEAR = 0.95;
/** Ink missing, or wire beside the drawing, of less than this share nobody sees. */
export const SEEN = 0.03;
/** Bending of less than this, in pixels of 256, changes no drawing's look. */
const SEEN_PX = 2;

/** A view that was compared, and how well it matches, 0 to 1. */
export type Compared = ViewMeasures & { readonly value: number };

/** How well a view matches what the wire was asked for: the drawing as it was bent, or as given. */
export function match(view: ViewMeasures): number | null {
  return view.bent?.soft_iou ?? view.soft_iou;
}

/** Those of the views that there was a picture for, with the numbers of what they were asked for. */
export function comparedViews({ finished }: Made): readonly Compared[] {
  return finished.measures.views.flatMap((view) => {
    const value = match(view);
    return value === null ? [] : [{ ...view, value, ...(view.bent ?? {}) }];
  });
}

export function isGood({ value, precision_2px, recall_2px }: Compared): boolean {
  return value >= GOOD || (value >= FAIR && Math.min(precision_2px ?? 0, recall_2px ?? 0) >= NEAR);
}

export const worst = (views: readonly Compared[]): Compared => views.reduce((a, b) => (b.value < a.value ? b : a));

/** What is wrong with how a view matches, for whoever is to give advice. */
export interface Flaw {
  readonly kind: "none" | "missing" | "stray" | "unclear";
  readonly words: string;
}

/** `missing` and `stray` tell of shares of the drawing's ink and of the wire; `subject` is what the view should show. */
export function flawOf(view: Compared, subject: string, missing: (share: string) => string, stray: (share: string) => string): Flaw {
  const lacking = 1 - (view.recall_2px ?? 1);
  const beside = 1 - (view.precision_2px ?? 1);
  if (lacking >= SEEN && lacking >= beside) return { kind: "missing", words: missing(percent(lacking)) };
  if (beside >= SEEN) return { kind: "stray", words: stray(percent(beside)) };
  if (view.value < FAIR) return { kind: "unclear", words: msg(str`${subject} is hard to recognise (${percent(view.value)})`) };
  if (!isGood(view)) return { kind: "unclear", words: msg(str`${subject} matches fairly well (${percent(view.value)})`) };
  return { kind: "none", words: "" };
}

/** The whole verdict: what is good, what is not, in how many pieces, how far drawings were bent, and what to try. */
export function verdictOf({ finished }: Made, views: readonly Compared[], good: string, flaw: Flaw, advice: string): string {
  const { components } = finished.measures;
  const apart = components > 1;
  const sentences = [
    flaw.words ? msg(str`${good}; ${flaw.words}.`) : apart ? msg(str`${good}.`) : msg(str`${good}, in one piece of wire.`),
    apart ? msg(str`The wire is in ${components} pieces.`) : "",
    bending(views),
    advice,
  ];
  return sentences.filter(Boolean).join(" ");
}

/** Of a wire without its pictures. */
export function nothingToCompare({ finished, carried }: Made): string {
  const { components } = finished.measures;
  const why = carried ? msg("It is compared with its drawings when it is made again.") : msg("Its drawings are not with it, so there is nothing to compare.");
  return `${counted(components, msg("One piece of wire."), msg(str`${components} pieces of wire.`))} ${why}`;
}

function bending(views: readonly Compared[]): string {
  const mostPx = Math.max(...views.map(({ bent }) => bent?.mean_px ?? 0));
  return mostPx > SEEN_PX ? msg(str`To agree, lines moved by ${decimal(mostPx, 1)} of 256 pixels.`) : "";
}
