/** Ink in another size, in plain arithmetic, the same in every browser. */

import type { Ink } from "../../engine/protocol";

/** Every new pixel is what lies under it, its neighbours weighted by how near they are; never stretched, if both sides change alike. */
export function resized({ width, height, ink }: Ink, toWidth: number, toHeight: number): Ink {
  const across = weights(width, toWidth);
  const down = weights(height, toHeight);
  const rows = new Float32Array(height * toWidth);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < toWidth; x++) rows[y * toWidth + x] = summed(across[x]!, (i) => ink[y * width + i]!);
  }
  const result = new Uint8Array(toWidth * toHeight);
  for (let y = 0; y < toHeight; y++) {
    for (let x = 0; x < toWidth; x++) result[y * toWidth + x] = Math.round(summed(down[y]!, (i) => rows[i * toWidth + x]!));
  }
  return { width: toWidth, height: toHeight, ink: result };
}

/** So that neither side is longer than that; smaller ones stay. */
export function within(ink: Ink, most: number): Ink {
  const shrink = Math.min(1, most / Math.max(ink.width, ink.height));
  const side = (length: number): number => Math.max(1, Math.round(length * shrink));
  return shrink === 1 ? ink : resized(ink, side(ink.width), side(ink.height));
}

/** Onto the middle of a square sheet, as large as it fits. */
export function onSheet(ink: Ink, side: number): Uint8Array<ArrayBuffer> {
  const scale = side / Math.max(ink.width, ink.height);
  const fitted = resized(ink, Math.max(1, Math.round(ink.width * scale)), Math.max(1, Math.round(ink.height * scale)));
  const [left, top] = [(side - fitted.width) >> 1, (side - fitted.height) >> 1];
  const sheet = new Uint8Array(side * side);
  for (let y = 0; y < fitted.height; y++) sheet.set(fitted.ink.subarray(y * fitted.width, (y + 1) * fitted.width), (top + y) * side + left);
  return sheet;
}

type Weights = readonly (readonly [at: number, share: number])[];

function weights(from: number, to: number): readonly Weights[] {
  const step = from / to;
  const reach = Math.max(1, step);
  return Array.from({ length: to }, (_, i) => {
    const middle = (i + 0.5) * step - 0.5;
    const near: [number, number][] = [];
    for (let at = Math.max(0, Math.ceil(middle - reach)); at <= Math.min(from - 1, Math.floor(middle + reach)); at++) {
      near.push([at, reach - Math.abs(at - middle)]);
    }
    const total = near.reduce((sum, [, share]) => sum + share, 0);
    return near.map(([at, share]) => [at, share / total] as const);
  });
}

function summed(weights: Weights, value: (at: number) => number): number {
  let sum = 0;
  for (const [at, share] of weights) sum += share * value(at);
  return sum;
}
