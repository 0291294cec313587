/**
 * What a sheet's layers come down to: ink laid onto a square, in plain arithmetic, the same in every browser.
 *
 * Pixel (x, y) covers [x, x + 1] × [y, y + 1], y down; ink is 0 (ground) to 255.
 */

import type { Ink } from "../../engine/protocol";
import type { Lay, StrokeLayer } from "./paper";

type Sheet = Uint8Array<ArrayBuffer>;

/** More ink wins: drawings never darken where they cross. */
export function over(sheet: Sheet, ink: Sheet): void {
  for (let i = 0; i < sheet.length; i++) if (ink[i]! > sheet[i]!) sheet[i] = ink[i]!;
}

/** A round pen along a polyline. A pixel is covered by how far the pen's rim lies beyond its centre, up to one pixel. */
export function stroke(sheet: Sheet, side: number, { points, widthPx, erase }: Pick<StrokeLayer, "points" | "widthPx" | "erase">): void {
  const count = points.length / 2;
  for (let i = 0; i < count; i++) {
    const next = Math.min(i + 1, count - 1);
    if (i === next && count > 1) break;
    segment(sheet, side, points[2 * i]!, points[2 * i + 1]!, points[2 * next]!, points[2 * next + 1]!, widthPx / 2, erase);
  }
}

function segment(sheet: Sheet, side: number, ax: number, ay: number, bx: number, by: number, radius: number, erase: boolean): void {
  const [dx, dy] = [bx - ax, by - ay];
  const perLength2 = dx || dy ? 1 / (dx * dx + dy * dy) : 0;
  const reach = radius + 0.5;
  const solid2 = Math.max(0, radius - 0.5) ** 2;
  const [left, right] = span(ax, bx, reach, side);
  const [top, bottom] = span(ay, by, reach, side);
  for (let y = top; y < bottom; y++) {
    const py = y + 0.5 - ay;
    for (let x = left; x < right; x++) {
      const px = x + 0.5 - ax;
      const t = Math.min(1, Math.max(0, (px * dx + py * dy) * perLength2));
      const [ex, ey] = [px - t * dx, py - t * dy];
      const distance2 = ex * ex + ey * ey;
      if (distance2 >= reach * reach) continue;
      const covered = distance2 <= solid2 ? 255 : Math.min(255, Math.round(255 * (reach - Math.sqrt(distance2))));
      const i = y * side + x;
      sheet[i] = erase ? Math.min(sheet[i]!, 255 - covered) : Math.max(sheet[i]!, covered);
    }
  }
}

const span = (a: number, b: number, reach: number, side: number): readonly [number, number] => [
  Math.max(0, Math.floor(Math.min(a, b) - reach)),
  Math.min(side, Math.ceil(Math.max(a, b) + reach)),
];

/** The same line with fewer points: none is further than the tolerance from what is left (Douglas and Peucker's way). */
export function thinned(points: Float32Array<ArrayBuffer>, tolerance: number): Float32Array<ArrayBuffer> {
  const count = points.length / 2;
  if (count < 3) return points;
  const kept = new Set([0, count - 1]);
  const open: [number, number][] = [[0, count - 1]];
  for (let range = open.pop(); range; range = open.pop()) {
    const [first, last] = range;
    let [furthest, most] = [0, tolerance];
    for (let i = first + 1; i < last; i++) {
      const distance = offLine(points, i, first, last);
      if (distance > most) [furthest, most] = [i, distance];
    }
    if (furthest === 0) continue;
    kept.add(furthest);
    open.push([first, furthest], [furthest, last]);
  }
  return Float32Array.from([...kept].sort((a, b) => a - b).flatMap((i) => [points[2 * i]!, points[2 * i + 1]!]));
}

/** How far a point is from the segment between two others. */
function offLine(points: Float32Array, i: number, a: number, b: number): number {
  const [ax, ay] = [points[2 * a]!, points[2 * a + 1]!];
  const [dx, dy] = [points[2 * b]! - ax, points[2 * b + 1]! - ay];
  const [px, py] = [points[2 * i]! - ax, points[2 * i + 1]! - ay];
  const t = dx || dy ? Math.min(1, Math.max(0, (px * dx + py * dy) / (dx * dx + dy * dy))) : 0;
  return Math.hypot(px - t * dx, py - t * dy);
}

/** Ink scaled onto the middle of a square, as large as the margin lets it be, never stretched. */
export function fitted({ width, height, ink }: Ink, side: number, margin: number): Sheet {
  const scale = (side * (1 - 2 * margin)) / Math.max(width, height);
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

/** The sheet mirrored and turned; exact. */
export function laid(sheet: Sheet, side: number, { mirrored, quarterTurns }: Lay): Sheet {
  const turns = quarters(quarterTurns);
  if (!mirrored && turns === 0) return sheet;
  const result = new Uint8Array(sheet.length);
  const last = side - 1;
  for (let y = 0; y < side; y++) {
    for (let x = 0; x < side; x++) {
      let [u, v] = [mirrored ? last - x : x, y];
      for (let turn = 0; turn < turns; turn++) [u, v] = [v, last - u];
      result[v * side + u] = sheet[y * side + x]!;
    }
  }
  return result;
}

/** A stroke's points mirrored and turned; exact for points on a binary grid. */
export function laidPoints(points: Float32Array<ArrayBuffer>, side: number, { mirrored, quarterTurns }: Lay): Float32Array<ArrayBuffer> {
  const result = points.slice();
  for (let i = 0; i < points.length; i += 2) {
    let [u, v] = [mirrored ? side - points[i]! : points[i]!, points[i + 1]!];
    for (let turn = 0; turn < quarters(quarterTurns); turn++) [u, v] = [v, side - u];
    result[i] = u;
    result[i + 1] = v;
  }
  return result;
}

/** 0 to 3, whichever way and however often. */
export const quarters = (turns: number): number => ((turns % 4) + 4) % 4;
