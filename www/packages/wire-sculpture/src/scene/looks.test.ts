import { expect, it } from "vitest";
import { linear } from "./gl";
import { LOOK_NAMES, lookOf, tonesOf } from "./looks";
import { TINTS, type Tints } from "./tints";

const samples = { points: Float32Array.of(0, 0, 0, 0.1, 1, 0, 0, 0.3, 2, 0, 0, 0.2), parameters: Float32Array.of(0, 0.5, 1) };

it("tells a wire's parts apart by place or by width", () => {
  expect([...tonesOf("parameter", samples)]).toEqual([0, 0.5, 1]);
  expect([...tonesOf("width", samples)].map((tone) => Math.round(tone * 1e5) / 1e5)).toEqual([0, 1, 0.5]);
  expect([...tonesOf("width", { points: Float32Array.of(0, 0, 0, 0.1), parameters: Float32Array.of(0) })]).toEqual([0.5]);
});

it("has colours that only get lighter along the map, so that nobody needs to tell hues apart", () => {
  const lightness = (hex: string): number => {
    const [r, g, b] = linear(hex);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  for (const dark of [0, 1]) {
    const tints = Object.fromEntries(Object.entries(TINTS).map(([name, both]) => [name, both[dark]!])) as Tints;
    for (const name of LOOK_NAMES) {
      const { ramp, colouring } = lookOf(name, tints, true);
      for (let k = 1; k < ramp.length; k++) {
        const [before, after] = [lightness(ramp[k - 1]!), lightness(ramp[k]!)];
        if (colouring === "metal") expect(after).toBe(before);
        else expect(after).toBeGreaterThan(1.25 * before);
      }
    }
  }
});
