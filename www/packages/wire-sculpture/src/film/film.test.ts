import { describe, expect, it } from "vitest";
import { turned } from "./darkroom";
import { eased, FOUND, momentsOf, TURNTABLE } from "./film";
import { DIRECTIONS, framed } from "../scene/orbit";

describe("a turntable", () => {
  it("goes on where it began, at an even pace", () => {
    const moments = momentsOf(TURNTABLE, 24);
    const steps = moments.map(({ turnRad }, i) => (moments[i + 1]?.turnRad ?? 2 * Math.PI) - turnRad);
    for (const step of steps) expect(step).toBeCloseTo((2 * Math.PI) / 24, 12);
    expect(moments.every(({ way }) => way === 1)).toBe(true);
    const pose = framed(DIRECTIONS.room, [[-1, -1, -1], [1, 0.4, 0.2]], 1, 0.9);
    const once = turned(pose, 2 * Math.PI, [0.2, 0, -0.1]);
    for (const c of [0, 1, 2] as const) expect(once.target[c]).toBeCloseTo(pose.target[c], 12);
    expect(Math.cos(once.azimuthRad)).toBeCloseTo(Math.cos(pose.azimuthRad), 12);
    // Half way it looks from the other side, and as far away.
    expect(turned(pose, Math.PI, [0, 0, 0]).target[0]).toBeCloseTo(-pose.target[0], 12);
    expect(turned(pose, 1, [0, 0, 0]).reach).toBe(pose.reach);
  });
});

describe("how it was found", () => {
  const moments = momentsOf(FOUND, 240);
  it("begins with the first wire, never goes back, and stays at the last", () => {
    expect(moments[0]!.way).toBe(0);
    expect(moments.at(-1)!.way).toBe(1);
    for (let i = 1; i < moments.length; i++) expect(moments[i]!.way).toBeGreaterThanOrEqual(moments[i - 1]!.way);
    const found = moments.findIndex(({ way }) => way === 1);
    expect(found / moments.length).toBeGreaterThan(0.4);
    expect(found / moments.length).toBeLessThan(0.7);
  });

  it("turns a little to either side when it is found, and comes to rest in the middle", () => {
    const after = moments.filter(({ way }) => way === 1).map(({ turnRad }) => turnRad);
    expect(Math.max(...after)).toBeGreaterThan(0.5);
    expect(Math.min(...after)).toBeLessThan(-0.5);
    expect(after.at(-1)).toBeCloseTo(0, 9);
    expect(Math.max(...moments.map(({ turnRad }) => Math.abs(turnRad)))).toBeLessThanOrEqual(FOUND.swingRad);
  });

  it("moves without a jerk", () => {
    const speeds = moments.slice(1).map(({ turnRad, way }, i) => [turnRad - moments[i]!.turnRad, way - moments[i]!.way] as const);
    for (let i = 1; i < speeds.length; i++) for (const c of [0, 1] as const) expect(Math.abs(speeds[i]![c] - speeds[i - 1]![c])).toBeLessThan(0.01);
  });
});

it("eases from rest to rest", () => {
  expect([eased(-1), eased(0), eased(0.5), eased(1), eased(7)]).toEqual([0, 0, 0.5, 1, 1]);
  expect(eased(0.01)).toBeLessThan(0.0001);
});

it("has as many moments as frames, be there only one", () => {
  expect(momentsOf(FOUND, 1)).toHaveLength(1);
  expect(momentsOf(TURNTABLE, 180)).toHaveLength(180);
});
