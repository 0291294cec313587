/** The line round a shape in a picture. */

import type { Ink } from "../../engine/protocol";

/** Half of a pixel's ink: what has more is inside. */
const LEVEL = 127.5;

/**
 * Where the ink, smooth between the pixels' middles, crosses one half: segments x0, y0, x1, y1, … in px, y down (marching
 * squares). Beyond the picture's edge there is no ink, so that every outline is closed.
 */
export function outline({ width, height, ink }: Ink): Float32Array<ArrayBuffer> {
  const segments: number[] = [];
  const at = (x: number, y: number): number => (x < 0 || y < 0 || x >= width || y >= height ? 0 : ink[y * width + x]!);
  const inside = (value: number): number => (value > LEVEL ? 1 : 0);
  for (let y = -1; y < height; y++) {
    for (let x = -1; x < width; x++) {
      const [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
      const kind = inside(a) | (inside(b) << 1) | (inside(c) << 2) | (inside(d) << 3);
      if (kind === 0 || kind === 15) continue;
      const edges = [cross(x, y, a, 1, 0, b), cross(x + 1, y, b, 0, 1, c), cross(x, y + 1, d, 1, 0, c), cross(x, y, a, 0, 1, d)];
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

/** Where the ink between two neighbours' middles is one half. */
function cross(x: number, y: number, from: number, right: number, down: number, to: number): readonly [number, number] {
  const t = from === to ? 0.5 : Math.min(1, Math.max(0, (LEVEL - from) / (to - from)));
  return [x + 0.5 + right * t, y + 0.5 + down * t];
}
