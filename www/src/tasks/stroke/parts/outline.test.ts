import { expect, it } from "vitest";
import type { Ink } from "../../../engine/protocol";
import { outline, SOFT_LEVEL, softened } from "./outline";

const filled = (width: number, height: number, inside: (x: number, y: number) => number): Ink => ({
  width,
  height,
  ink: Uint8Array.from({ length: width * height }, (_, i) => inside((i % width) + 0.5, Math.floor(i / width) + 0.5)),
});

function length(segments: Float32Array): number {
  let sum = 0;
  for (let i = 0; i < segments.length; i += 4) sum += Math.hypot(segments[i + 2]! - segments[i]!, segments[i + 3]! - segments[i + 1]!);
  return sum;
}

/** Ends of segments that only one of them has. */
function loose(segments: Float32Array): number {
  const ends = new Map<string, number>();
  for (let i = 0; i < segments.length; i += 2) {
    const end = `${segments[i]!.toFixed(3)} ${segments[i + 1]!.toFixed(3)}`;
    ends.set(end, (ends.get(end) ?? 0) + 1);
  }
  return [...ends.values()].filter((count) => count % 2 === 1).length;
}

const disc = (radius: number) => filled(60, 40, (x, y) => 255 * Math.min(1, Math.max(0, radius + 0.5 - Math.hypot(x - 30, y - 20))));

it("goes round a disc, closed", () => {
  const round = outline(disc(12));
  expect(length(round)).toBeGreaterThan(0.98 * 24 * Math.PI);
  expect(length(round)).toBeLessThan(1.02 * 24 * Math.PI);
  expect(loose(round)).toBe(0);
  for (let i = 0; i < round.length; i += 2) expect(Math.abs(Math.hypot(round[i]! - 30, round[i + 1]! - 20) - 12)).toBeLessThan(0.3);
});

it("goes along the picture's edge where the shape does", () => {
  const all = outline(filled(10, 6, () => 255));
  expect(loose(all)).toBe(0);
  // Each corner is cut from pixel edge to pixel edge.
  expect(length(all)).toBeCloseTo(32 - 4 * (1 - Math.SQRT1_2), 1);
  expect(loose(outline(disc(25)))).toBe(0);
});

it("keeps shapes apart that meet at a corner, and is nothing where nothing is", () => {
  const corners = outline(filled(4, 4, (x, y) => (x < 2 === y < 2 ? 255 : 0)));
  expect(loose(corners)).toBe(0);
  expect(outline(filled(5, 5, () => 0))).toHaveLength(0);
  expect(outline(filled(5, 5, () => 127))).toHaveLength(0);
});

it("loses the stairs of a mask without shades, and no thin lines", () => {
  const hard = filled(60, 40, (x, y) => (Math.hypot(x - 30, y - 20) < 12 ? 255 : 0));
  const spread = (segments: Float32Array): number => {
    const radii = Array.from({ length: segments.length / 2 }, (_, i) => Math.hypot(segments[2 * i]! - 30, segments[2 * i + 1]! - 20));
    return Math.max(...radii) - Math.min(...radii);
  };
  expect(spread(outline(softened(hard), SOFT_LEVEL))).toBeLessThan(0.7 * spread(outline(hard)));
  for (const line of [filled(20, 20, (x) => (x === 9.5 ? 255 : 0)), filled(20, 20, (x, y) => (x === y ? 255 : 0))]) {
    expect(length(outline(softened(line), SOFT_LEVEL))).toBeGreaterThan(2 * 18);
  }
  expect(softened(filled(9, 5, () => 255)).ink.every((value) => value === 255)).toBe(true);
});
