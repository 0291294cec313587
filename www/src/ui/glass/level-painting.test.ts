import { expect, it } from "vitest";
import { colourOfDifference } from "./level-painting";

/** How light a colour is for those who see none (Rec. 709, close enough). */
const light = ([r, g, b]: readonly [number, number, number]): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

it("tells too much from too little by lightness alone, and the more the farther off", () => {
  const steps = [-1, -0.5, -0.2, 0, 0.2, 0.5, 1].map((difference) => light(colourOfDifference(difference)));
  expect(steps).toEqual([...steps].sort((a, b) => b - a));
  expect(steps[0]! - steps[3]!).toBeGreaterThan(60);
  expect(steps[3]! - steps[6]!).toBeGreaterThan(60);
  expect(colourOfDifference(9)).toEqual(colourOfDifference(1));
});
