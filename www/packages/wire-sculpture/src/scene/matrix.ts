/** The little linear algebra the stage needs. Matrices are column-major, as WebGL wants them. */

export type Vec3 = readonly [number, number, number];
export type Mat4 = Float32Array;

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const scale = (a: Vec3, k: number): Vec3 => [a[0] * k, a[1] * k, a[2] * k];

/** View axes (right, up, back) at the eye, rows of the rotation. */
function viewFrom(right: Vec3, up: Vec3, back: Vec3, eye: Vec3): Mat4 {
  return new Float32Array([
    right[0], up[0], back[0], 0,
    right[1], up[1], back[1], 0,
    right[2], up[2], back[2], 0,
    -dot(right, eye), -dot(up, eye), -dot(back, eye), 1,
  ]);
}

/** Orthographic: `half` world units from the middle to the border both ways. */
export function orthographic(right: Vec3, up: Vec3, back: Vec3, half: number): Mat4 {
  const k = 1 / half;
  const depth = -1 / 4;
  return new Float32Array([
    right[0] * k, up[0] * k, back[0] * depth, 0,
    right[1] * k, up[1] * k, back[1] * depth, 0,
    right[2] * k, up[2] * k, back[2] * depth, 0,
    0, 0, 0, 1,
  ]);
}

/** Perspective camera at `eye` with the given axes. */
export function perspective(
  right: Vec3,
  up: Vec3,
  back: Vec3,
  eye: Vec3,
  fovYRad: number,
  aspect: number,
  near: number,
  far: number,
): Mat4 {
  const f = 1 / Math.tan(fovYRad / 2);
  const projection = new Float32Array([
    f / aspect, 0, 0, 0,
    0, f, 0, 0,
    0, 0, (far + near) / (near - far), -1,
    0, 0, (2 * far * near) / (near - far), 0,
  ]);
  return multiply(projection, viewFrom(right, up, back, eye));
}

export function multiply(a: Mat4, b: Mat4): Mat4 {
  const out = new Float32Array(16);
  for (let column = 0; column < 4; column++) {
    for (let row = 0; row < 4; row++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += a[k * 4 + row]! * b[column * 4 + k]!;
      out[column * 4 + row] = sum;
    }
  }
  return out;
}
