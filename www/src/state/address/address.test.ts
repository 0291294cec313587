import { expect, it } from "vitest";
import { addressed } from "./address";
import { BLANK, type Doc } from "../keeping/document";

const doc = (code: string | null, settings = {}): Doc => ({ ...BLANK, settings, made: code === null ? null : ({ finished: { code } } as Doc["made"]) });

it("carries settings, and a wire only while it is the one on the stage", () => {
  expect(addressed("", doc(null))).toBe("");
  expect(addressed("#v=1&w=AB&seed=3", doc("AB", { seed: "4" }))).toBe("#v=1&w=AB&seed=4");
  expect(addressed("#v=1&w=AB", doc("CD", { seed: "4" }))).toBe("#v=1&seed=4");
  expect(addressed("#w=AB", doc("CD"))).toBe("");
  // What was not asked for is not put in: an address is not to be full of a wire unless somebody shares it.
  expect(addressed("", doc("CD"))).toBe("");
});
