/** The line round a shape in a picture. */

import type { Ink } from "../../../engine/protocol";

/** Half of a pixel's ink. */
const HALF = 127.5;

/**
 * Where the ink, smooth between the pixels' middles, crosses a level: segments x0, y0, x1, y1, … in px, y down (marching
 * squares). Beyond the picture's edge there is no ink, so that every outline is closed.
 */
export function outline({ width, height, ink }: Ink, level = HALF): Float32Array<ArrayBuffer> {
  const segments: number[] = [];
  const at = (x: number, y: number): number => (x < 0 || y < 0 || x >= width || y >= height ? 0 : ink[y * width + x]!);
  const inside = (value: number): number => (value > level ? 1 : 0);
  for (let y = -1; y < height; y++) {
    for (let x = -1; x < width; x++) {
      const [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
      const kind = inside(a) | (inside(b) << 1) | (inside(c) << 2) | (inside(d) << 3);
      if (kind === 0 || kind === 15) continue;
      const [ab, bc, dc, ad] = [share(a, b, level), share(b, c, level), share(d, c, level), share(a, d, level)];
      const [left, top] = [x + 0.5, y + 0.5];
      const edges = [[left + ab, top], [left + 1, top + bc], [left + dc, top + 1], [left, top + ad]] as const;
      for (const [from, to] of CROSSED[kind]!) segments.push(...edges[from]!, ...edges[to]!);
    }
  }
  return Float32Array.from(segments);
}

const [TOP, RIGHT, BOTTOM, LEFT] = [0, 1, 2, 3];
/** Which sides of a square of four pixels the outline joins, by which of them are inside: 1, 2, 4, 8 clockwise from the top left. */
const CROSSED: readonly (readonly (readonly [number, number])[])[] = [
  [], [[LEFT, TOP]], [[TOP, RIGHT]], [[LEFT, RIGHT]], [[RIGHT, BOTTOM]], [[LEFT, TOP], [RIGHT, BOTTOM]], [[TOP, BOTTOM]], [[LEFT, BOTTOM]],
  [[LEFT, BOTTOM]], [[TOP, BOTTOM]], [[TOP, RIGHT], [LEFT, BOTTOM]], [[RIGHT, BOTTOM]], [[LEFT, RIGHT]], [[TOP, RIGHT]], [[LEFT, TOP]], [],
];

/** Where between two neighbours' middles the level is. */
function share(from: number, to: number, level: number): number {
  return from === to ? 0.5 : Math.min(1, Math.max(0, (level - from) / (to - from)));
}

/**
 * The level of `softened` ink for an outline that still goes round lines of one pixel, slanting ones in one piece; half a
 * pixel outside of what is wider.
 */
export const SOFT_LEVEL = 60;

/** Each pixel with some of its neighbours (1 2 1, across and down): takes the stairs from a mask without shades. */
export function softened({ width, height, ink }: Ink): Ink {
  const across = new Uint16Array(ink.length);
  for (let i = 0; i < ink.length; i++) {
    const x = i % width;
    across[i] = 2 * ink[i]! + ink[x > 0 ? i - 1 : i]! + ink[x + 1 < width ? i + 1 : i]!;
  }
  const soft = new Uint8Array(ink.length);
  for (let i = 0; i < ink.length; i++) {
    const [above, below] = [i >= width ? i - width : i, i + width < ink.length ? i + width : i];
    soft[i] = (2 * across[i]! + across[above]! + across[below]!) / 16;
  }
  return { width, height, ink: soft };
}
