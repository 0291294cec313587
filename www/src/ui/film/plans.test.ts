import { expect, it } from "vitest";
import { side, sizeWords } from "./plans";

it("makes a side that can be drawn of whatever was typed", () => {
  expect([side(1080.4, 1), side(-5, 1), side(1e9, 1), side(NaN, 640), side(Infinity, 640)]).toEqual([1080, 64, 4096, 640, 640]);
});

it("says how large a file is", () => {
  expect([sizeWords(12), sizeWords(340_400), sizeWords(2_149_000)]).toEqual(["1 kB", "340 kB", "2.1 MB"]);
});
