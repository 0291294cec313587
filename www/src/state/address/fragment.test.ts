import { describe, expect, it } from "vitest";
import { readFragment, writeFragment, type Named } from "./fragment";

const TASKS: readonly Named[] = [{ name: "multiview" }, { name: "stroke" }, { name: "fill", address: { keys: ["shape", "style"], write: () => ({}), read: () => null } }];

describe("a fragment", () => {
  it("reads what it writes", () => {
    const settings = { preset: "fast", smoothness: "1.5" };
    const fragment = writeFragment("multiview", "AB-_9", settings, {}, TASKS);
    expect(fragment).toBe("#v=1&w=AB-_9&preset=fast&smoothness=1.5");
    expect(readFragment(fragment, TASKS)).toEqual({ task: "multiview", code: "AB-_9", given: {}, settings, newer: false });
    expect(writeFragment("multiview", null, {}, {}, TASKS)).toBe("");
    expect(readFragment("", TASKS)).toEqual({ task: null, code: null, given: {}, settings: {}, newer: false });
    const stroke = writeFragment("stroke", "AB", settings, {}, TASKS);
    expect(stroke).toBe("#v=1&job=stroke&w=AB&preset=fast&smoothness=1.5");
    expect(readFragment(stroke, TASKS)).toEqual({ task: "stroke", code: "AB", given: {}, settings, newer: false });
    expect(readFragment("#v=1&job=knit&seed=3", TASKS).task).toBe("multiview");
  });

  it("names what is given by the keys of the task", () => {
    const given = { shape: "vase", style: "waves" };
    const fragment = writeFragment("fill", "AB", { density: "0.7" }, given, TASKS);
    expect(fragment).toBe("#v=1&job=fill&shape=vase&style=waves&w=AB&density=0.7");
    expect(readFragment(fragment, TASKS)).toEqual({ task: "fill", code: "AB", given, settings: { density: "0.7" }, newer: false });
    // Other tasks have no shape.
    expect(readFragment("#v=1&job=stroke&shape=vase&seed=3", TASKS)).toMatchObject({ given: {}, settings: { seed: "3" } });
  });

  it("reads links of before there was a version, and tells newer ones", () => {
    expect(readFragment("#w=AB", TASKS)).toEqual({ task: "multiview", code: "AB", given: {}, settings: {}, newer: false });
    expect(readFragment("#v=2&w=AB", TASKS).newer).toBe(true);
    expect(readFragment("#v=x&w=AB", TASKS).newer).toBe(true);
  });
});
