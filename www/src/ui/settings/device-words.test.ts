import { expect, it } from "vitest";
import { deviceOf, paceOf, reasonOf } from "./device-words";

it("names a graphics card, and no processor twice", () => {
  expect(deviceOf({ backend: "gpu", device: "Apple M2", why: "" })).toBe("Graphics card · Apple M2");
  expect(deviceOf({ backend: "gpu", device: "", why: "" })).toBe("Graphics card");
  expect(deviceOf({ backend: "cpu", device: "processor", why: "" })).toBe("Processor");
});

it("says how many cores are at work, where that is more than one", () => {
  const why = "The processor does the work.";
  expect(reasonOf({ backend: "cpu", device: "processor", why })).toBe(why);
  expect(reasonOf({ backend: "cpu", device: "processor", why, workers: 2 })).toBe(`${why} It uses 2 of its cores.`);
});

it("counts steps as exactly as one can read them", () => {
  expect(paceOf(12_345.6)).toMatch(/^12.346 steps a second$/);
  expect(paceOf(210.4)).toBe("210 steps a second");
  expect(paceOf(1.25)).toMatch(/^1\.[23] steps a second$/);
});
