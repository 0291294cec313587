import { expect, it } from "vitest";
import { curve } from "./curve";

const points = (path: string): number[][] => path.slice(1).split("L").map((point) => point.split(" ").map(Number));

it("falls from the top left to the bottom right, logarithmically", () => {
  const [first, middle, last] = points(curve([[0, 1], [50, 0.1], [100, 0.01]], 100, 240, 56));
  expect(first).toEqual([0, 3]);
  expect(middle).toEqual([120, 27]);
  expect(last).toEqual([240, 51]);
});

it("leaves room for what is still to come", () => {
  expect(points(curve([[0, 1], [50, 0.1]], 100, 240, 56)).at(-1)![0]).toBe(120);
});

it("stays small however long the run", () => {
  const long = Array.from({ length: 5000 }, (_, i) => [i, 1 / (i + 1)] as const);
  expect(points(curve(long, 5000, 240, 56)).length).toBeLessThanOrEqual(122);
});

it("draws a level line where nothing changes", () => {
  expect(points(curve([[0, 0.5], [9, 0.5]], 9, 240, 56)).map(([, y]) => y)).toEqual([51, 51]);
});
