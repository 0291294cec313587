/** How the wire and its room can look. */

import type { Tints } from "./tints";

/** Colours as `#rrggbb`. */
export interface Look {
  /** Metal of one colour, or a colour map along the wire or by its width. */
  readonly colouring: "metal" | "parameter" | "width";
  /** From one end to the other, or from thin to thick; all the same for metal. */
  readonly ramp: readonly [string, string, string, string, string];
  /** Share of light that is mirrored: 1 is polished, 0 is chalk. */
  readonly gloss: number;
  /** Light from above and from below that the wire mirrors. */
  readonly sky: string;
  readonly ground: string;
  /** The walls, where light falls on them, and where the wire takes it away. */
  readonly wall: string;
  readonly lit: string;
  readonly shadow: string;
  /** Rings round places. */
  readonly mark: string;
  /** Off: the wire alone. */
  readonly room: boolean;
}

export const LOOK_NAMES = ["copper", "steel", "parameter", "width"] as const;
export type LookName = (typeof LOOK_NAMES)[number];

const RAMP = ["ramp-1", "ramp-2", "ramp-3", "ramp-4", "ramp-5"] as const;

/** `metal` goes before the metal's own colour. */
export function lookOf(name: LookName, tints: Tints, room: boolean, metal: string | null = null): Look {
  const { sky, ground, wall, lit, shade, mark } = tints;
  const walls = { sky, ground, wall, lit, shadow: shade, mark, room };
  if (name === "parameter" || name === "width") {
    return { ...walls, colouring: name, gloss: 0.25, ramp: RAMP.map((stop) => tints[stop]) as unknown as Look["ramp"] };
  }
  const colour = metal ?? tints[name];
  return { ...walls, colouring: "metal", gloss: name === "steel" ? 0.9 : 0.8, ramp: [colour, colour, colour, colour, colour] };
}

/** Each sample's place on the ramp, 0 to 1. */
export function tonesOf(colouring: Look["colouring"], samples: { readonly points: Float32Array; readonly parameters: Float32Array }): Float32Array {
  const { points, parameters } = samples;
  if (colouring !== "width") return parameters;
  const tones = new Float32Array(parameters.length);
  let [least, most] = [Infinity, 0];
  for (let at = 3; at < points.length; at += 4) {
    least = Math.min(least, points[at]!);
    most = Math.max(most, points[at]!);
  }
  for (let k = 0; k < tones.length; k++) tones[k] = most - least > 1e-6 ? (points[4 * k + 3]! - least) / (most - least) : 0.5;
  return tones;
}
