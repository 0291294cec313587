/** The terms of the loss, for people: what each wants, and how its arrows look. */

import { msg, str } from "@lit/localize";
import type { TermPull } from "../../engine/protocol";
import { viewWords } from "../../view/heading";

/** How the arrows of a term look: a colour for light and one for dark, and a dash for those who tell no colours apart. */
export interface Ink {
  readonly light: string;
  readonly dark: string;
  /** CSS pixels on and off; none for a whole line. */
  readonly dash: readonly number[];
  /** CSS pixels across, where that is not the usual. */
  readonly wide?: number;
}

/** Told apart by those with any kind of colour sight, and by their dashes by those with none. */
const OF_VIEWS: readonly Ink[] = [
  { light: "#0063b0", dark: "#7cc0ff", dash: [] },
  { light: "#00704f", dark: "#4fd6a8", dash: [9, 3] },
  { light: "#8a2f8f", dark: "#e29bf0", dash: [1, 1] },
  { light: "#7a5c00", dark: "#e8cf5a", dash: [9, 2, 1, 2] },
  { light: "#00707a", dark: "#62dfe8", dash: [4, 1] },
  { light: "#51519c", dark: "#bcbcff", dash: [12, 2] },
  { light: "#8c4a2a", dark: "#f0b088", dash: [4, 2, 1, 2] },
];
const OF_WIRE: Readonly<Record<string, Ink>> = {
  jerk: { light: "#6a6a00", dark: "#d8d860", dash: [6, 4] },
  length: { light: "#5c5852", dark: "#c9c1b5", dash: [2, 2] },
  surface: { light: "#00606e", dark: "#62d5e6", dash: [8, 2] },
  texture: { light: "#3f47b5", dark: "#aab2ff", dash: [4, 2] },
  bending: { light: "#b3261e", dark: "#ff9b90", dash: [5, 2] },
  tightness: { light: "#b0125f", dark: "#ff94c6", dash: [2, 3] },
  evenness: { light: "#4f6b00", dark: "#bfdd5c", dash: [3, 2] },
  clearance: { light: "#9a4a00", dark: "#ffb26b", dash: [7, 2, 2, 2] },
  guidance: { light: "#444444", dark: "#dddddd", dash: [1, 2] },
};
export const OF_ALL: Ink = { light: "#1d1b19", dark: "#ece7df", dash: [], wide: 2.2 };
/** By the name of what adds up all terms. */
export const ALL = "all";

export function inkOf({ name, ofView }: TermPull, index: number): Ink {
  return ofView ? OF_VIEWS[index % OF_VIEWS.length]! : (OF_WIRE[name] ?? OF_ALL);
}

/** What a term wants. */
export function termWords({ name, ofView }: Pick<TermPull, "name" | "ofView">): string {
  if (ofView) return msg(str`Match: ${viewWords(name)}`);
  switch (name) {
    case "jerk":
      return msg("Change gently (jerk)");
    case "length":
      return msg("Be short (length)");
    case "surface":
      return msg("Stay on the shape (surface)");
    case "texture":
      return msg("Look like the style (texture)");
    case "bending":
      return msg("Bend little (bending)");
    case "tightness":
      return msg("No tight bends (tightness)");
    case "evenness":
      return msg("Points at even steps (evenness)");
    case "clearance":
      return msg("Keep strands apart (clearance)");
    default:
      return name;
  }
}

/** How strongly a term pulls all in all: the lengths of its gradient at the points, added up. */
export function strength({ gradient }: Pick<TermPull, "gradient">): number {
  let sum = 0;
  for (let at = 0; at + 3 < gradient.length; at += 4) sum += Math.hypot(gradient[at]!, gradient[at + 1]!, gradient[at + 2]!);
  return sum;
}

/** The gradient of all terms together. */
export function together(pulls: readonly TermPull[]): Float32Array {
  const sum = new Float32Array(pulls[0]?.gradient.length ?? 0);
  for (const { gradient } of pulls) gradient.forEach((value, i) => (sum[i]! += value));
  return sum;
}
