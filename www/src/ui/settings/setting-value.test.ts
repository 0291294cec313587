import { expect, it } from "vitest";
import type { SettingRow } from "../../engine/protocol";
import { isSwitch, refusal, switched } from "./setting-value";

const row = (more: Partial<SettingRow>): SettingRow => ({ name: "x", group: "run", unit: "", help: "", kind: "integer", min: 32, max: 2048, affects: ["course"], ...more });

it("refuses what is out of range and says the range", () => {
  expect(refusal(row({}), "256")).toBe("");
  for (const text of ["", "31", "2049", "40.5", "1e400", "many", " "]) expect(refusal(row({}), text)).toBe("Give a whole number from 32 to 2,048.");
  expect(refusal(row({ kind: "number", min: 0.0001, max: 10 }), "0.8")).toBe("");
  expect(refusal(row({ kind: "number", min: 0.0001, max: 10 }), "11")).toBe("Give a number from 0.0001 to 10.");
});

it("knows a yes or no in both spellings", () => {
  const arrange = row({ kind: "choice", choices: ["on", "off"] });
  expect(isSwitch(arrange)).toBe(true);
  expect(switched(arrange, true)).toBe("on");
  expect(switched(row({ kind: "switch" }), false)).toBe("false");
  expect(isSwitch(row({ kind: "choice", choices: ["none", "top"] }))).toBe(false);
});
