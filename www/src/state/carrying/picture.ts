/** Ink as a picture again, and a picture's ink. */

import type { Ink, Pixels } from "../../engine/protocol";
import { kept, type KeptPicture } from "../picture/picture";

/** Black on white. */
export function pictureOf({ width, height, ink }: Ink, name: string): KeptPicture {
  const rgba = new Uint8ClampedArray(4 * width * height).fill(255);
  ink.forEach((value, i) => rgba.fill(255 - value, 4 * i, 4 * i + 3));
  return kept({ width, height, rgba }, name);
}

/** How dark each pixel is, on white paper. */
export function darkness({ width, height, rgba }: Pixels): Ink {
  const ink = new Uint8Array(width * height);
  for (let i = 0; i < ink.length; i++) {
    const [r, g, b, a] = rgba.subarray(4 * i, 4 * i + 4) as unknown as [number, number, number, number];
    ink[i] = Math.round(((255 - (0.299 * r + 0.587 * g + 0.114 * b)) * a) / 255);
  }
  return { width, height, ink };
}
