/** What makes a wire and a view valid: the same rules as the core's, for codes that were made up. */

import type { View } from "../scene/view";

/** Spline: simple knots. Chain and bag: Béziers that share their ends, or nothing; knots are repeated 3 and 4 times. */
export type Form = "spline" | "chain" | "bag";

export const MAX_CONTROL_POINTS = 20_000;
const MIN_CONTROL_POINTS = 4;
/** World units; the object fits the unit ball. */
const MAX_COORDINATE = 1e4;
const MAX_KNOT = 1e6;
const MIN_KNOT_SPACING = 1e-5;
const MAX_VIEW_PX = 8192;
const MAX_WORLD = 1e6;

/** What is wrong with a wire, in words; `null` for nothing. */
export function wireProblem(form: Form, closed: boolean, knots: Float64Array, points: Float64Array): string | null {
  const count = points.length / 4;
  if (count < MIN_CONTROL_POINTS || count > MAX_CONTROL_POINTS) return `it has ${count} control points`;
  if (form === "bag" && closed) return "a bag of separate Béziers cannot be closed";
  const leftOver = form === "bag" ? count % 4 : form === "chain" ? (closed ? count % 3 : (count - 1) % 3) : 0;
  if (leftOver) return `${count} control points make no whole number of Bézier segments`;
  return knotProblem(form, closed, count, knots) ?? pointProblem(points);
}

function knotProblem(form: Form, closed: boolean, count: number, knots: Float64Array): string | null {
  if (!knots.every((knot) => Math.abs(knot) <= MAX_KNOT)) return "a knot is not a usable number";
  const most = form === "bag" ? 4 : 3;
  // The four equal knots at a clamped end are no repetition.
  const [first, last] = closed || form === "bag" ? [0, knots.length] : [4, count];
  const repeat = { spline: 1, chain: 3, bag: 4 }[form];
  const end = closed ? count + 3 : count;
  for (let k = 0; k < knots.length; k++) {
    const step = knots[k + 1]! - knots[k]!;
    if (step < 0) return "its knots fall";
    if (step > 0 && step < MIN_KNOT_SPACING) return "two knots nearly coincide";
    const repeated = knots[k] === knots[k + 4] || (k >= first && k + most < last && knots[k] === knots[k + most]);
    if (repeated) return "a knot is repeated too often";
    if (form !== "spline" && k >= 3 && k < end && step > 0 !== ((k - 3) % repeat === 0)) {
      return "its knots do not cut it into Bézier segments";
    }
  }
  return null;
}

function pointProblem(points: Float64Array): string | null {
  for (let at = 0; at < points.length; at++) {
    const index = at >> 2;
    if (!Number.isFinite(points[at]!)) return `control point ${index} is not finite`;
    if (Math.abs(points[at]!) > MAX_COORDINATE) return `control point ${index} is far outside the unit ball`;
    if (at % 4 === 3 && points[at]! < 0) return `control point ${index} has a negative width`;
  }
  return null;
}

/** Whether a view can be seen through. */
export function isView(view: View): boolean {
  const { name, eye, target, up } = view;
  const plain = /^[\p{Alphabetic}\p{N}\-_,+ ][\p{Alphabetic}\p{N}\-_.,+ ]*$/u;
  if (!plain.test(name) || new TextEncoder().encode(name).length > 64) return false;
  if ([...eye, ...target, ...up].some((x) => !(Math.abs(x) <= MAX_WORLD))) return false;
  const sight = eye.map((x, c) => target[c]! - x) as [number, number, number];
  const [far, upright] = [Math.hypot(...sight), Math.hypot(...up)];
  const [sx, sy, sz] = sight;
  const [ux, uy, uz] = up;
  const across = Math.hypot(sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux) / (far * upright);
  if (!(far >= 1e-9 && upright >= 1e-9 && across >= 1e-6)) return false;
  const lens =
    view.projection === "perspective"
      ? view.fov_y_rad! > 1e-4 && view.fov_y_rad! < 3.1
      : view.height_world! > 1e-9 && view.height_world! <= MAX_WORLD;
  return lens && [view.width_px, view.height_px].every((size) => size >= 1 && size <= MAX_VIEW_PX);
}
