/** A view at one scale of the loss: the wire, what it should be, and the difference. */

import type { LossLevel } from "../../engine/protocol";

export const SHOWINGS = ["difference", "seen", "wanted"] as const;
export type Showing = (typeof SHOWINGS)[number];

type Rgb = readonly [number, number, number];

/** Where all is right, where there is too much wire, and where wire lacks: dark and light, for those who see no colours. */
export const RIGHT: Rgb = [0x9c, 0x96, 0x8c];
export const TOO_MUCH: Rgb = [0x4a, 0x22, 0x05];
export const LACKING: Rgb = [0xb4, 0xff, 0xf0];
/** Of ink and its ground. */
const INK: Rgb = [0x1d, 0x1b, 0x19];
const GROUND: Rgb = [0xf6, 0xf3, 0xee];

/** The colour of a difference, -1 (wire lacks) to 1 (too much of it). */
export function colourOfDifference(difference: number): Rgb {
  return mixed(RIGHT, difference > 0 ? TOO_MUCH : LACKING, Math.min(1, Math.abs(difference)));
}

const mixed = (a: Rgb, b: Rgb, share: number): Rgb => [0, 1, 2].map((c) => Math.round(a[c]! + (b[c]! - a[c]!) * share)) as unknown as Rgb;

/** Every pixel of the level is one of the canvas. */
export function paintLevel(canvas: HTMLCanvasElement, { seen, wanted }: LossLevel, showing: Showing): void {
  const { width, height } = seen;
  [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d")!;
  const pixels = context.createImageData(width, height);
  for (let i = 0; i < seen.ink.length; i++) {
    const [a, b] = [seen.ink[i]! / 255, wanted.ink[i]! / 255];
    const colour = showing === "difference" ? colourOfDifference(a - b) : mixed(GROUND, INK, showing === "seen" ? a : b);
    pixels.data.set(colour, 4 * i);
    pixels.data[4 * i + 3] = 255;
  }
  context.putImageData(pixels, 0, 0);
}
