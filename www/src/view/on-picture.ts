import type { Mat4 } from "#sculpture/scene/matrix";

/** CSS pixels in a picture of that size; null behind the camera. */
export function onPicture(clip: Mat4, width: number, height: number, x: number, y: number, z: number): readonly [number, number] | null {
  const w = clip[3]! * x + clip[7]! * y + clip[11]! * z + clip[15]!;
  if (!(w > 1e-6)) return null;
  const right = (clip[0]! * x + clip[4]! * y + clip[8]! * z + clip[12]!) / w;
  const up = (clip[1]! * x + clip[5]! * y + clip[9]! * z + clip[13]!) / w;
  return [((1 + right) * width) / 2, ((1 - up) * height) / 2];
}
