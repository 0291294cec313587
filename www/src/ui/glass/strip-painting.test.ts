import { expect, it } from "vitest";
import type { Profile } from "../../view/profile";
import { columnsOf } from "./strip-painting";

const profile: Profile = {
  count: 4,
  places: new Float32Array(12),
  widths: Float32Array.of(0.1, 0.2, 0.1, 0.1),
  curvatures: Float32Array.of(1, 2, 0, 5),
  shares: Float32Array.of(0.1, 0.15, 0.6, 0.9),
  length: 1,
};

it("shows the tightest bend and the greatest width of each part, and goes on where there is no sample", () => {
  const columns = columnsOf(profile, 5);
  expect(columns.map(({ radius }) => Number(radius.toFixed(3)))).toEqual([2.5, 2.5, 2.5, Infinity, 2]);
  expect(columns.map(({ width }) => Number(width.toFixed(3)))).toEqual([0.2, 0.2, 0.2, 0.1, 0.1]);
});

it("shows nothing of nothing", () => {
  expect(columnsOf({ ...profile, count: 0 }, 2)).toEqual([
    { radius: Infinity, width: 0 },
    { radius: Infinity, width: 0 },
  ]);
});
