/** Numbers by a formula of 32-bit integers, as `tools/guidance` makes them, bit for bit: a self-test's inputs need no file. */

/** Numbers in a sketch, and the most that a sidecar holds of an output as they are. */
export const BUCKETS = 64;

/** A bijection of 32-bit integers that leaves no visible pattern. */
export function mix(index: number): number {
  let x = index | 0;
  x ^= x >>> 16;
  x = Math.imul(x, 0x7feb352d);
  x ^= x >>> 15;
  x = Math.imul(x, 0x846ca68b);
  x ^= x >>> 16;
  return x >>> 0;
}

/** `count` numbers, 0 <= u < 1. 24 bits fit a float32 exactly. */
export function uniform(seed: number, count: number): Float32Array<ArrayBuffer> {
  const offset = Math.imul(seed, 0x9e3779b9);
  return Float32Array.from({ length: count }, (_, i) => (mix(i + offset) >>> 8) / 2 ** 24);
}

/** `count` numbers, -1 <= s < 1. */
export function signed(seed: number, count: number): Float32Array<ArrayBuffer> {
  return uniform(seed, count).map((u) => 2 * u - 1);
}

/** Rows of `width` numbers, each of length 1. */
export function unitRows(seed: number, count: number, width: number): Float32Array<ArrayBuffer> {
  return madeUnit(signed(seed, count), width);
}

/** Each row of `width` numbers over its length, in place; a row of zeros stays as it is. */
export function madeUnit(rows: Float32Array<ArrayBuffer>, width: number): Float32Array<ArrayBuffer> {
  for (let at = 0; at < rows.length; at += width) {
    const row = rows.subarray(at, at + width);
    const length = norm(row);
    if (length > 0) for (let i = 0; i < width; i++) row[i]! /= length;
  }
  return rows;
}

/** min(n, 64) signed sums of n numbers: how an array is compared with another without shipping it. */
export function sketch(values: ArrayLike<number>): Float64Array {
  const buckets = Math.max(1, Math.min(values.length, BUCKETS));
  const sums = new Float64Array(buckets);
  for (let i = 0; i < values.length; i++) sums[i % buckets]! += mix(i) < 2 ** 31 ? values[i]! : -values[i]!;
  return sums;
}

export function norm(values: ArrayLike<number>): number {
  let squares = 0;
  for (let i = 0; i < values.length; i++) squares += values[i]! ** 2;
  return Math.sqrt(squares);
}

/** Of the angle between two arrays of one size; 1 where both are zero. */
export function cosine(a: ArrayLike<number>, b: ArrayLike<number>): number {
  const lengths = norm(a) * norm(b);
  if (!(lengths > 0)) return norm(a) === norm(b) ? 1 : 0;
  let dot = 0;
  for (let i = 0; i < a.length; i++) dot += a[i]! * b[i]!;
  return dot / lengths;
}
