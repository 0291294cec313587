import { expect, it } from "vitest";
import type { WireShape } from "#sculpture/shape";
import { wiresFor } from "./wires";

const wire = (x: number): WireShape => ({ closed: true, knots: [0, 1, 2], controlPoints: [x, 0, 0, 1] });

it("takes at most sixty wires from all of the way, the finished one last", () => {
  const way = Array.from({ length: 500 }, (_, i) => wire(i));
  const wires = wiresFor(way, wire(1000));
  expect(wires).toHaveLength(60);
  const firsts = wires.map(({ controlPoints }) => controlPoints[0]!);
  expect(firsts[0]).toBe(0);
  expect(firsts.at(-1)).toBe(1000);
  expect(firsts.at(-2)).toBeGreaterThan(480);
  expect([...firsts].sort((a, b) => a - b)).toEqual(firsts);
});

it("takes all of a short way, and the wire alone where there is none", () => {
  expect(wiresFor([wire(1), wire(2)], wire(3))).toHaveLength(3);
  expect(wiresFor([], wire(3))).toHaveLength(1);
});
