import { describe, expect, it } from "vitest";
import type { SettingsTable } from "../../engine/protocol";
import { known, problemWith, readFragment, writeFragment } from "./fragment";

const NONE = { shape: null, style: null };

const table: SettingsTable = {
  rows: [
    { name: "preset", group: "run", unit: "", help: "", kind: "choice", choices: ["best", "fast"], affects: ["course"] },
    { name: "seed", group: "run", unit: "", help: "", kind: "integer", min: 0, max: 1000, affects: ["course"] },
    { name: "smoothness", group: "fit", unit: "times", help: "", kind: "number", min: 0, max: 10, affects: ["course"] },
    { name: "refine", group: "fit", unit: "", help: "", kind: "switch", affects: ["course"] },
  ],
  presets: {
    best: { preset: "best", seed: "0", smoothness: "1", refine: "false" },
    fast: { preset: "fast", seed: "0", smoothness: "2", refine: "false" },
  },
};

describe("a fragment", () => {
  it("reads what it writes", () => {
    const settings = { preset: "fast", smoothness: "1.5" };
    const fragment = writeFragment("multiview", "AB-_9", settings);
    expect(fragment).toBe("#v=1&w=AB-_9&preset=fast&smoothness=1.5");
    expect(readFragment(fragment)).toEqual({ job: "multiview", code: "AB-_9", cover: NONE, settings, newer: false });
    expect(writeFragment("multiview", null, {})).toBe("");
    expect(readFragment("")).toEqual({ job: null, code: null, cover: NONE, settings: {}, newer: false });
    const stroke = writeFragment("stroke", "AB", settings);
    expect(stroke).toBe("#v=1&job=stroke&w=AB&preset=fast&smoothness=1.5");
    expect(readFragment(stroke)).toEqual({ job: "stroke", code: "AB", cover: NONE, settings, newer: false });
    expect(readFragment("#v=1&job=knit&seed=3").job).toBe("multiview");
  });

  it("names a shape and a style by formula, and nothing else", () => {
    const cover = { shape: "vase", style: "waves" } as const;
    const fragment = writeFragment("fill", "AB", { density: "0.7" }, cover);
    expect(fragment).toBe("#v=1&job=fill&shape=vase&style=waves&w=AB&density=0.7");
    expect(readFragment(fragment)).toEqual({ job: "fill", code: "AB", cover, settings: { density: "0.7" }, newer: false });
    // A mesh of one's own stays where it is, and so does what it wears; other jobs have no shape.
    expect(writeFragment("fill", null, {}, { shape: null, style: "waves" })).toBe("#v=1&job=fill");
    expect(writeFragment("stroke", null, {}, cover)).toBe("#v=1&job=stroke");
    expect(readFragment("#v=1&job=fill&shape=teapot&style=tartan").cover).toEqual(NONE);
  });

  it("reads links of before there was a version, and tells newer ones", () => {
    expect(readFragment("#w=AB")).toEqual({ job: "multiview", code: "AB", cover: NONE, settings: {}, newer: false });
    expect(readFragment("#v=2&w=AB").newer).toBe(true);
    expect(readFragment("#v=x&w=AB").newer).toBe(true);
  });

  it("ignores what the table does not know or allow, and what the preset says anyway", () => {
    expect(known({ preset: "fast", seed: "7", smoothness: "2", colour: "red", refine: "maybe" }, table)).toEqual({ preset: "fast", seed: "7" });
    expect(known({ preset: "best", smoothness: "2" }, table)).toEqual({ smoothness: "2" });
    expect(known({ __proto__: "x", constructor: "y" } as never, table)).toEqual({});
  });
});

it("says what a setting may be", () => {
  expect(problemWith("seed", "7", table)).toBeNull();
  for (const value of ["", " ", "x", "-1", "1001", "1.5", "NaN", "Infinity"]) expect(problemWith("seed", value, table)).toBe("give a whole number from 0 to 1000");
  expect(problemWith("preset", "slow", table)).toBe("choose best, fast");
  expect(problemWith("refine", "on", table)).toBe("choose on or off");
});
