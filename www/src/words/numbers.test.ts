import { expect, it } from "vitest";
import { count } from "./numbers";

it("groups digits by three", () => {
  expect([0, 999, 1100, 9_007_199_254_740_991, -20_000, 1234.5678, 0.0001].map(count)).toEqual([
    "0", "999", "1,100", "9,007,199,254,740,991", "-20,000", "1,234.5678", "0.0001",
  ]);
});
