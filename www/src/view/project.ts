/** World to pixels for a view of wire.json, for flat drawings. The same formulas as the core's cameras. */

import type { View } from "../engine/protocol";
import type { Samples } from "#sculpture/scene/shape";

type Vec3 = readonly [number, number, number];
const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
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
  const { count, points } = samples;
  const out = new Float32Array(count * 3);
  // Written out, since it is done for thousands of samples a frame.
  for (let i = 0; i < count; i++) {
    const x = points[4 * i]! - origin[0];
    const y = points[4 * i + 1]! - origin[1];
    const z = points[4 * i + 2]! - origin[2];
    const k = perspective ? scale / Math.max(1e-3, forward[0] * x + forward[1] * y + forward[2] * z) : scale;
    out[3 * i] = (height_px * aspect) / 2 + k * (right[0] * x + right[1] * y + right[2] * z);
    out[3 * i + 1] = height_px / 2 - k * (up[0] * x + up[1] * y + up[2] * z);
    out[3 * i + 2] = k * points[4 * i + 3]!;
  }
  return out;
}
