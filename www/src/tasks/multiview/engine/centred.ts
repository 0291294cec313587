/** Pictures laid onto the middle of square sheets, in plain arithmetic, the same in every browser. */

import type { Ink } from "../../../engine/protocol";

/** Room left around such a picture, as a share of the sheet's side. */
const MARGIN = 0.04;

/** Ink scaled onto the middle of a square, as large as the margin lets it be, never stretched. */
export function centred({ width, height, ink }: Ink, side: number): Uint8Array<ArrayBuffer> {
  const scale = (side * (1 - 2 * MARGIN)) / Math.max(width, height);
  // Even sides leave the same margin left and right, so that a turned sheet is the same sheet turned.
  const [across, down] = [width, height].map((length) => 2 * Math.max(1, Math.round((length * scale) / 2))) as [number, number];
  const rows = scaledAcross(Float32Array.from(ink), width, height, tent(width, across));
  const scaled = scaledDown(rows, across, tent(height, down));
  const sheet = new Uint8Array(side * side);
  const [left, top] = [(side - across) / 2, (side - down) / 2];
  for (let y = 0; y < down; y++) {
    for (let x = 0; x < across; x++) sheet[(top + y) * side + left + x] = Math.round(scaled[y * across + x]!);
  }
  return sheet;
}

/** What each of the pixels at another length is made of: `reach` of the old ones from the first on, by their weights. */
interface Tent {
  readonly count: number;
  readonly reach: number;
  readonly firsts: Int32Array;
  /** `reach` a pixel; they add up to 1. */
  readonly weights: Float64Array;
}

/** As wide as the coarser of the two grids: linear upwards, averaging downwards. */
function tent(length: number, count: number): Tent {
  const step = length / count;
  const radius = Math.max(1, step);
  const reach = Math.min(length, Math.floor(2 * radius) + 1);
  const firsts = new Int32Array(count);
  const weights = new Float64Array(count * reach);
  for (let i = 0; i < count; i++) {
    const centre = (i + 0.5) * step;
    const first = Math.max(0, Math.min(length - reach, Math.ceil(centre - radius - 0.5)));
    const own = weights.subarray(i * reach, (i + 1) * reach);
    for (let k = 0; k < reach; k++) own[k] = Math.max(0, 1 - Math.abs(first + k + 0.5 - centre) / radius);
    const total = own.reduce((sum, weight) => sum + weight, 0);
    for (let k = 0; k < reach; k++) own[k]! /= total;
    firsts[i] = first;
  }
  return { count, reach, firsts, weights };
}

function scaledAcross(source: Float32Array, width: number, height: number, { count, reach, firsts, weights }: Tent): Float32Array {
  const result = new Float32Array(count * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < count; x++) {
      const from = y * width + firsts[x]!;
      let sum = 0;
      for (let k = 0; k < reach; k++) sum += weights[x * reach + k]! * source[from + k]!;
      result[y * count + x] = sum;
    }
  }
  return result;
}

function scaledDown(source: Float32Array, width: number, { count, reach, firsts, weights }: Tent): Float32Array {
  const result = new Float32Array(width * count);
  for (let y = 0; y < count; y++) {
    for (let x = 0; x < width; x++) {
      const from = firsts[y]! * width + x;
      let sum = 0;
      for (let k = 0; k < reach; k++) sum += weights[y * reach + k]! * source[from + k * width]!;
      result[y * width + x] = sum;
    }
  }
  return result;
}
