import { expect, it } from "vitest";
import type { SurfaceMeasures } from "../../engine/protocol";
import type { Made } from "../../state/keeping/document";
import { verdict } from "./verdict";

const even: SurfaceMeasures = { spacing: 0.06, mean: 0.26, p99: 0.55, worst: 0.8, drift_mean: 0.002, drift_max: 0.01, strands: [], crowded: 0.005 };
const made = (surface: Partial<SurfaceMeasures> | null, more: Partial<Made> = {}, components = 1): Made =>
  ({ finished: { measures: { components, surface: surface && { ...even, ...surface } } }, source: "run", track: null, stopped: false, ...more }) as unknown as Made;

it("says how near the wire is everywhere, and leaves it at that where all is well", () => {
  expect(verdict(made({}))).toBe("The wire is one closed loop. No spot is farther from it than 2.4% of the shape’s size.");
});

it("says what is not well, and what to try", () => {
  expect(verdict(made({ drift_max: 0.1 }))).toMatch(/leaves the surface by up to 5\.0%: less style/);
  expect(verdict(made({ crowded: 0.08 }))).toMatch(/Along 8% of it/);
  expect(verdict(made({}, {}, 3))).toMatch(/3 pieces/);
  expect(verdict(made({}, { stopped: true }))).toMatch(/stopped early/);
});

it("has less to say of a wire from elsewhere", () => {
  expect(verdict(made(null, { source: "link" }))).toMatch(/nothing to measure it by/);
});
