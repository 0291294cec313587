import { expect, it } from "vitest";
import type { SettingsTable } from "../../engine/protocol";
import { known, problemWith } from "./values";

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

it("ignores what the table does not know or allow, and what the preset says anyway", () => {
  expect(known({ preset: "fast", seed: "7", smoothness: "2", colour: "red", refine: "maybe" }, table)).toEqual({ preset: "fast", seed: "7" });
  expect(known({ preset: "best", smoothness: "2" }, table)).toEqual({ smoothness: "2" });
  expect(known({ __proto__: "x", constructor: "y" } as never, table)).toEqual({});
});

it("says what a setting may be", () => {
  expect(problemWith("seed", "7", table)).toBeNull();
  for (const value of ["", " ", "x", "-1", "1001", "1.5", "NaN", "Infinity"]) expect(problemWith("seed", value, table)).toBe("give a whole number from 0 to 1000");
  expect(problemWith("preset", "slow", table)).toBe("choose best, fast");
  expect(problemWith("refine", "on", table)).toBe("choose on or off");
});
