import { expect, it } from "vitest";
import { cameraOf } from "#sculpture/scene/orbit";
import { onPicture } from "../../view/on-picture";
import { arrowsOf, scaleOf } from "./arrows";

/** Two control points: one pulled gently to the right, one hard upwards. */
const points = [0, 0, 0, 0.1, 1, 0, 0, 0.1];
const gradient = Float32Array.of(-1, 0, 0, 9, 0, -100, 0, 9);

it("points down the gradient, of the place and not of the width", () => {
  const ends = arrowsOf(points, gradient, 0.01);
  expect([...ends].map((x) => Number(x.toFixed(6)))).toEqual([0, 0, 0, 0.01, 0, 0, 1, 0, 0, 1, 0.4, 0]);
});

it("makes most arrows as long as can be read, on one scale, and few of them no longer", () => {
  const many = new Float32Array(4 * 100).map((_, i) => (i % 4 === 0 ? 2 : 0));
  many[0] = 2000;
  const scale = scaleOf([many]);
  const ends = arrowsOf(new Float32Array(400), many, scale);
  const lengths = Array.from({ length: 100 }, (_, i) => Math.abs(ends[6 * i + 3]! - ends[6 * i]!));
  expect(lengths[1]).toBeCloseTo(0.16, 5);
  expect(lengths[0]).toBeCloseTo(0.4, 5);
  // A second term that pulls less is shorter on the common scale, and as long on its own.
  const less = many.map((value) => value / 4);
  expect(scaleOf([many, less])).toBeCloseTo(scale, 6);
  expect(scaleOf([less])).toBeCloseTo(4 * scale, 6);
  expect(scaleOf([new Float32Array(8)])).toBe(0);
  expect(scaleOf([])).toBe(0);
});

it("puts what is looked at into the middle of the picture, and up is up", () => {
  const pose = { azimuthRad: 0.3, elevationRad: 0.2, reach: 1, fovYRad: 0.5, target: [0.1, 0.2, -0.3] as const };
  const { clipFromWorld, eye } = cameraOf(pose, 400, 300);
  const middle = onPicture(clipFromWorld, 400, 300, 0.1, 0.2, -0.3)!;
  expect(middle[0]).toBeCloseTo(200, 2);
  expect(middle[1]).toBeCloseTo(150, 2);
  expect(onPicture(clipFromWorld, 400, 300, 0.1, 0.5, -0.3)![1]).toBeLessThan(150);
  const behind = [0, 1, 2].map((c) => eye[c]! + (eye[c]! - pose.target[c]!)) as [number, number, number];
  expect(onPicture(clipFromWorld, 400, 300, ...behind)).toBeNull();
});
