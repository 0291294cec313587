/** From whole numbers to knots and control points in world units. Twin of the end of `src/export/share/mod.rs`. */

import type { KnotCode } from "./contents";

/** x, y, z, width, again and again; `steps` are those of coordinates and of widths. */
export function pointsFrom(points: Int32Array, steps: readonly [number, number]): Float64Array {
  const controlPoints = new Float64Array(points.length);
  for (let at = 0; at < points.length; at++) controlPoints[at] = points[at]! * steps[at % 4 === 3 ? 1 : 0];
  return controlPoints;
}

/** Clamped where the wire is open; periodic, to the last bit, where it is closed. */
export function knotsFrom({ start, longest, perOctave, intervals }: KnotCode, closed: boolean): Float64Array {
  const count = intervals.length;
  const knots = new Float64Array(count + 7);
  let sum = 0;
  knots.fill(start, 0, 4);
  intervals.forEach((interval, k) => {
    if (interval > 0) sum += longest * 2 ** (-(interval - 1) / perOctave);
    knots[k + 4] = start + sum;
  });
  const end = knots[count + 3]!;
  knots.fill(end, count + 4);
  if (closed && count >= 3) {
    const period = end - start;
    for (let i = 0; i < 3; i++) knots[i] = knots[i + count] === end ? start : knots[i + count]! - period;
    for (let i = 4; i < 7; i++) knots[i + count] = knots[i] === start ? end : knots[i]! + period;
  }
  return knots;
}
