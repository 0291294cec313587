import { expect, it } from "vitest";
import { sampleWire } from "#sculpture/scene/shape";
import type { View } from "../engine/protocol";
import { project } from "./project";

const view = (eye: View["eye"], up: View["up"], more: Partial<View> = {}): View => ({
  name: "view", projection: "orthographic", eye, target: [0, 0, 0], up, height_world: 2.2, width_px: 256, height_px: 256, ...more,
});
// A wire that stays at (0.1, 0.2, 0.3), half a world unit wide.
const still = { closed: false, knots: [0, 0, 0, 0, 1, 1, 1, 1], controlPoints: Array<number[]>(4).fill([0.1, 0.2, 0.3, 0.5]).flat() };
const pixel = (view: View): number[] => [...project(sampleWire(still, 1), view, 220).subarray(0, 3)].map((x) => Math.round(x * 1e3) / 1e3);

it("shows front along -z, side along -x and top along -y, image y down", () => {
  expect(pixel(view([0, 0, 3], [0, 1, 0]))).toEqual([120, 90, 25]);
  expect(pixel(view([3, 0, 0], [0, 1, 0]))).toEqual([80, 90, 25]);
  expect(pixel(view([0, 3, 0], [0, 0, -1]))).toEqual([120, 140, 25]);
});

it("agrees between a perspective view from afar and the parallel one, and not from nearby", () => {
  const from = (distance: number): View =>
    view([0, 0, distance], [0, 1, 0], { projection: "perspective", fov_y_rad: 2 * Math.atan(1.1 / distance) });
  expect(pixel(from(1000))[0]).toBeCloseTo(120, 1);
  expect(pixel(from(1000))[1]).toBeCloseTo(90, 1);
  expect(pixel(from(2))[0]).not.toBeCloseTo(120, 1);
});
