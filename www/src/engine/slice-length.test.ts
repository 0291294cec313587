import { describe, expect, it } from "vitest";
import { SliceLength } from "./slice-length";

/** Slices of an engine that waits and then takes so long for each iteration, give or take a share of it. */
function slices(count: number, waitMs: number, eachMs: number, noise = 0, length = new SliceLength()): { n: number; ms: number }[] {
  let seed = 1;
  const random = (): number => (seed = (seed * 16807) % 2147483647) / 2147483647;
  return Array.from({ length: count }, (_, i) => {
    const n = length.next;
    const ms = (waitMs + n * eachMs) * (1 + noise * (2 * random() - 1)) + (i === 0 ? 100 : 0);
    length.learn(n, ms);
    return { n, ms };
  });
}

const middle = (values: readonly number[]): number => [...values].sort((a, b) => a - b)[values.length >> 1]!;
/** Once it has learned. */
const later = (all: readonly { n: number; ms: number }[]) => ({ n: middle(all.slice(30).map(({ n }) => n)), ms: middle(all.slice(30).map(({ ms }) => ms)) });

describe("the length of a slice", () => {
  it("fills about thirty milliseconds where nothing waits", () => {
    for (const eachMs of [0.1, 1, 4]) {
      const { ms } = later(slices(80, 0, eachMs));
      expect(ms).toBeGreaterThan(22);
      expect(ms).toBeLessThan(40);
    }
    expect(later(slices(80, 0, 0.01)).n).toBe(512);
    expect(later(slices(80, 3, 0.2)).ms).toBeLessThan(45);
  });

  it("does one iteration at a time where that takes longer", () => {
    const all = slices(80, 0, 200);
    expect(later(all).n).toBe(1);
    expect(Math.max(...all.map(({ n }) => n))).toBe(2);
  });

  it("works about as long as it waits where waiting takes longer", () => {
    const { n, ms } = later(slices(80, 60, 0.5));
    expect(n).toBeGreaterThan(60);
    expect(ms).toBeLessThan(200);
  });

  it("is not misled by a busy machine", () => {
    for (const [waitMs, eachMs] of [[0, 1], [5, 0.2], [40, 0.3]] as const) {
      const all = slices(200, waitMs, eachMs, 0.4);
      const { n, ms } = later(all);
      expect(n * eachMs).toBeGreaterThan(10);
      expect(ms).toBeLessThan(120);
    }
  });

  it("shrinks at once where the engine becomes slow", () => {
    const length = new SliceLength();
    slices(50, 1, 0.1, 0, length);
    const [first, ...rest] = slices(40, 0, 5, 0, length).map(({ n }) => n);
    expect(first).toBeGreaterThan(100);
    expect(rest[0]).toBe(1);
    expect(Math.max(...rest)).toBeLessThan(12);
  });
});
