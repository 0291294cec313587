import { expect, it } from "vitest";
import { viewFrom, viewWords } from "./heading";

const rounded = (numbers: readonly number[]): number[] => numbers.map((x) => Math.round(x * 1000) / 1000 + 0);

it("looks from the front, the side and above as the core's views do", () => {
  const front = viewFrom({ azimuth: 0, elevation: 0 }, "front");
  expect([rounded(front.eye), rounded(front.up)]).toEqual([[0, 0, 3], [0, 1, 0]]);
  const side = viewFrom({ azimuth: 90, elevation: 0 }, "side");
  expect([rounded(side.eye), rounded(side.up)]).toEqual([[3, 0, 0], [0, 1, 0]]);
  const top = viewFrom({ azimuth: 0, elevation: 90 }, "top");
  expect([rounded(top.eye), rounded(top.up)]).toEqual([[0, 3, 0], [0, 0, -1]]);
});

it("keeps the picture upright at any heading", () => {
  const { eye, up } = viewFrom({ azimuth: 200, elevation: -35 }, "x");
  expect(eye[0] * up[0] + eye[1] * up[1] + eye[2] * up[2]).toBeCloseTo(0);
  expect(up[1]).toBeGreaterThan(0);
});

it("puts the core's names for sides into words, and leaves others alone", () => {
  expect(viewWords("33,6")).toBe("33° round, 6° up");
  expect(viewWords("270,-5")).toBe("270° round, 5° down");
  expect(viewWords("90,0")).toBe("90° round");
  expect(viewWords("front")).toBe("front");
});
