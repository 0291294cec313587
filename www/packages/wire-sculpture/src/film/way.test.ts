import { describe, expect, it } from "vitest";
import type { WireShape } from "../scene/shape";
import { Way } from "./way";

/** A closed ring of that many control points and that radius. */
function ring(points: number, radius: number): WireShape {
  const controlPoints = Array.from({ length: points }, (_, i) => (2 * Math.PI * i) / points).flatMap((angle) => [radius * Math.cos(angle), radius * Math.sin(angle), 0, 0.02]);
  return { closed: true, knots: Array.from({ length: points + 7 }, (_, i) => i), controlPoints };
}

function open(points: number): WireShape {
  const knots = [0, 0, 0, ...Array.from({ length: points - 2 }, (_, i) => i), points - 3, points - 3, points - 3];
  return { closed: false, knots, controlPoints: Array.from({ length: points }, (_, i) => [i / points, 0, 0, 0.02]).flat() };
}

const radii = (way: Way, place: number): number[] => {
  const { points, count } = way.at(place);
  return Array.from({ length: count }, (_, i) => Math.hypot(points[4 * i]!, points[4 * i + 1]!));
};

describe("the way of a wire", () => {
  it("moves evenly between wires, also where their control points were laid anew", () => {
    const way = new Way([ring(40, 0.4), ring(64, 0.8)], 400);
    const [first] = radii(way, 0);
    const [last] = radii(way, 1);
    for (const radius of radii(way, 0.25)) expect(radius).toBeCloseTo(first! + (last! - first!) * 0.25, 2);
  });

  it("has directions along the wire on the way, too", () => {
    const { points, tangents, count } = new Way([ring(40, 0.4), ring(64, 0.8)], 400).at(0.5);
    for (let i = 0; i < count; i++) {
      const across = tangents[3 * i]! * points[4 * i]! + tangents[3 * i + 1]! * points[4 * i + 1]!;
      expect(Math.abs(across)).toBeLessThan(0.02);
    }
  });

  it("shows the wires themselves where they are, and the nearer of two that do not fit together", () => {
    const way = new Way([ring(40, 0.4), open(20), ring(64, 0.8)], 400);
    expect(way.at(0.5).strips[0]!.closed).toBe(false);
    expect(way.at(0.2).strips[0]!.closed).toBe(true);
    expect(way.at(0.3).strips[0]!.closed).toBe(false);
    expect(new Way([open(9)], 100).at(0.7).count).toBeGreaterThan(9);
  });
});
