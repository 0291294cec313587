import { expect, it } from "vitest";
import type { WireShape } from "#sculpture/scene/shape";
import { profileOf, radiusInDiameters, sampleAt } from "./profile";

/** A ring of a radius, with as many control points, a little farther out than the curve. */
function ring(radius: number, count: number, width: number): WireShape {
  const step = (2 * Math.PI) / count;
  const out = radius / ((2 + Math.cos(step)) / 3);
  const controlPoints = Array.from({ length: count }, (_, i) => [out * Math.cos(i * step), out * Math.sin(i * step), 0.1, width]).flat();
  return { closed: true, knots: Array.from({ length: count + 7 }, (_, i) => i), controlPoints };
}

it("finds a ring's radius, width and length everywhere", () => {
  const profile = profileOf(ring(0.5, 64, 0.1));
  expect(profile.length).toBeCloseTo(Math.PI, 4);
  for (let i = 0; i < profile.count; i++) {
    expect(1 / profile.curvatures[i]!).toBeCloseTo(0.5, 2);
    expect(profile.widths[i]).toBeCloseTo(0.1, 6);
    expect(radiusInDiameters(profile, i)).toBeCloseTo(5, 1);
    expect(Math.hypot(profile.places[3 * i]!, profile.places[3 * i + 1]!)).toBeCloseTo(0.5, 4);
  }
});

it("knows the second derivative of a parabola, whatever its knots", () => {
  // y = x² over x in 0 to 1, as a cubic Bézier: curvature 2 / (1 + 4x²)^1.5.
  const profile = profileOf({ closed: false, knots: [0, 0, 0, 0, 3, 3, 3, 3], controlPoints: [0, 0, 0, 1, 1 / 3, 0, 0, 1, 2 / 3, 1 / 3, 0, 1, 1, 1, 0, 1] });
  for (let i = 0; i < profile.count; i++) {
    const x = profile.places[3 * i]!;
    expect(profile.curvatures[i]).toBeCloseTo(2 / (1 + 4 * x * x) ** 1.5, 4);
  }
  expect([...profile.shares]).toEqual([...profile.shares].sort((a, b) => a - b));
});

it("goes to the nearest place", () => {
  const profile = profileOf(ring(0.5, 8, 0.1));
  for (const share of [0, 0.123, 0.5, 0.999, 1]) {
    const at = sampleAt(profile, share);
    const off = (i: number): number => Math.abs(profile.shares[i]! - share);
    for (let i = 0; i < profile.count; i++) expect(off(at)).toBeLessThanOrEqual(off(i));
  }
});

it("has no bends where nothing moves, and none in nothing", () => {
  const still = profileOf({ closed: false, knots: [0, 0, 0, 0, 1, 1, 1, 1], controlPoints: new Array<number>(16).fill(0.2) });
  expect([...still.curvatures].every((curvature) => curvature === 0)).toBe(true);
  expect(radiusInDiameters(still, 0)).toBe(Infinity);
  expect(profileOf({ closed: false, knots: [], controlPoints: [] }).count).toBe(0);
});
