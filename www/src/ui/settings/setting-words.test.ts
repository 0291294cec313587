import { expect, it } from "vitest";
import { WORDS, wordsFor } from "./setting-words";

it("has words for every label and choice, and sliders that can be moved", () => {
  for (const { label, choices, slider } of Object.values(WORDS)) {
    expect(label).toMatch(/^[A-Z]/);
    for (const words of Object.values(choices ?? {})) expect(words).toMatch(/^[A-Z]/);
    if (slider) expect((slider[1] - slider[0]) / slider[2]).toBeGreaterThanOrEqual(5);
  }
});

it("makes do with the name of a setting it does not know", () => {
  expect(wordsFor("may_fly")).toEqual({ label: "May fly" });
  expect(wordsFor("constructor")).toEqual({ label: "Constructor" });
});
