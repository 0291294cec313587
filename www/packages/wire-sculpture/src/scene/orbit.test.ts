import { expect, it } from "vitest";
import type { Mat4, Vec3 } from "./matrix";
import { cameraOf, DIRECTIONS, framed, Orbit } from "./orbit";

const box: readonly Vec3[] = [[-0.3, 0.1, -0.9], [0.8, 0.1, -0.9], [-0.3, 0.9, 0.2], [0.8, 0.4, 0.5], [0.1, -0.6, 0.3]];

/** Where a point is in the picture, -1 to 1 both ways. */
function seen(clipFromWorld: Mat4, [x, y, z]: Vec3): [number, number] {
  const row = (r: number): number => clipFromWorld[r]! * x + clipFromWorld[4 + r]! * y + clipFromWorld[8 + r]! * z + clipFromWorld[12 + r]!;
  return [row(0) / row(3), row(1) / row(3)];
}

function bounds(points: readonly [number, number][]): { middle: [number, number]; half: [number, number] } {
  const along = (c: 0 | 1): [number, number] => [Math.min(...points.map((p) => p[c])), Math.max(...points.map((p) => p[c]))];
  const [x, y] = [along(0), along(1)];
  return { middle: [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2], half: [(x[1] - x[0]) / 2, (y[1] - y[0]) / 2] };
}

it.each([0.4, 0.9, 1, 1.6, 3])("puts what it frames in the middle of a picture %f times as wide as high", (aspect) => {
  for (const direction of Object.values(DIRECTIONS)) {
    const { clipFromWorld } = cameraOf(framed(direction, box, aspect, 0.9), 600 * aspect, 600);
    const { middle, half } = bounds(box.map((point) => seen(clipFromWorld, point)));
    expect(Math.abs(middle[0])).toBeLessThan(0.01);
    expect(Math.abs(middle[1])).toBeLessThan(0.01);
    expect(Math.max(...half)).toBeCloseTo(0.9, 2);
  }
});

it("frames a single point without falling into it", () => {
  const { reach, target } = framed(DIRECTIONS.front, [[0.2, 0.1, 0]], 1.5, 0.9);
  expect(reach).toBeGreaterThan(0.05);
  expect(target[0]).toBeCloseTo(0.2, 5);
});

it("flies the short way round and lands where it was sent", () => {
  const orbit = new Orbit({ ...framed(DIRECTIONS.front, box, 1, 0.9), azimuthRad: 6 });
  orbit.flyTo(framed(DIRECTIONS.side, box, 1, 0.9), 0, 100);
  orbit.advance(50);
  expect(orbit.flying).toBe(true);
  expect(orbit.pose.azimuthRad).toBeGreaterThan(-0.3);
  expect(orbit.pose.azimuthRad).toBeLessThan(Math.PI / 2);
  expect(orbit.advance(100)).toBe(false);
  expect(orbit.pose.azimuthRad).toBeCloseTo(Math.PI / 2, 12);
});

it("adds up steps that are pressed while one is under way", () => {
  const orbit = new Orbit(framed(DIRECTIONS.room, box, 1, 0.9));
  const { azimuthRad, reach } = orbit.pose;
  for (let i = 0; i < 3; i++) orbit.step(0.25, 1, 0, 100);
  orbit.step(0, 0.5, 0, 100);
  orbit.advance(100);
  expect(orbit.pose.azimuthRad).toBeCloseTo(azimuthRad + 0.75, 12);
  expect(orbit.pose.reach).toBeCloseTo(reach / 2, 12);
});

it("lets a person end a flight, and keeps the camera where it can see", () => {
  const orbit = new Orbit(framed(DIRECTIONS.front, box, 1, 0.9));
  orbit.flyTo(framed(DIRECTIONS.top, box, 1, 0.9), 0, 100);
  orbit.turn(0.1, 99);
  expect(orbit.flying).toBe(false);
  expect(orbit.pose.elevationRad).toBeLessThanOrEqual(Math.PI / 2);
  orbit.zoom(1e9);
  orbit.pan(1e9, -1e9);
  expect(orbit.pose.reach).toBeLessThan(10);
  expect(orbit.pose.target.every((x) => Math.abs(x) <= 1.5)).toBe(true);
});
