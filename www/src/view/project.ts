/** World to pixels for a view of wire.json, for flat drawings. The same formulas as the core's cameras. */

import type { View } from "../engine/protocol";
import type { Samples } from "../embed/shape";

type Vec3 = readonly [number, number, number];
const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a: Vec3): Vec3 => {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
};

/** x_px, y_px, radius_px for each sample in a picture that is `height_px` high. */
export function project(samples: Samples, view: View, height_px: number): Float32Array {
  const forward = unit(minus(view.target, view.eye));
  const right = unit(cross(forward, view.up));
  const up = cross(right, forward);
  const aspect = view.width_px / view.height_px;
  const perspective = view.projection === "perspective";
  const origin = perspective ? view.eye : view.target;
  const scale = perspective ? height_px / 2 / Math.tan((view.fov_y_rad ?? 1) / 2) : height_px / (view.height_world ?? 2);
  const out = new Float32Array(samples.count * 3);
  for (let i = 0; i < samples.count; i++) {
    const p = minus([samples.points[4 * i]!, samples.points[4 * i + 1]!, samples.points[4 * i + 2]!], origin);
    const k = perspective ? scale / Math.max(1e-3, dot(forward, p)) : scale;
    out[3 * i] = (height_px * aspect) / 2 + k * dot(right, p);
    out[3 * i + 1] = height_px / 2 - k * dot(up, p);
    out[3 * i + 2] = k * samples.points[4 * i + 3]!;
  }
  return out;
}
