import { expect, it } from "vitest";
import { addressed as written } from "./address";
import { withDesk, type Doc, type Made } from "../keeping/document";
import type { Named } from "./fragment";

const BLANK: Doc = { task: "multiview", given: {}, desks: {} };
const TASKS: readonly Named[] = [
  { name: "multiview" },
  { name: "stroke" },
  { name: "fill", address: { keys: ["shape"], write: (shape) => ({ shape: String(shape) }), read: () => null } },
];
const addressed = (hash: string, doc: Doc, madeOf: unknown = null): string => written(hash, doc, TASKS, madeOf);

const doc = (code: string | null, settings = {}, task = "multiview"): Doc => {
  const made = code === null ? null : ({ finished: { code } } as Made);
  return { ...BLANK, task, ...withDesk(BLANK, task, { settings, made }) };
};

it("carries settings, and a wire only while it is the one on the stage", () => {
  expect(addressed("", doc(null))).toBe("");
  expect(addressed("#v=1&w=AB&seed=3", doc("AB", { seed: "4" }))).toBe("#v=1&w=AB&seed=4");
  expect(addressed("#v=1&w=AB", doc("CD", { seed: "4" }))).toBe("#v=1&seed=4");
  expect(addressed("#w=AB", doc("CD"))).toBe("");
  // What was not asked for is not put in: an address is not to be full of a wire unless somebody shares it.
  expect(addressed("", doc("CD"))).toBe("");
});

it("carries the task that is looked at, unless it is the first", () => {
  expect(addressed("", doc(null, {}, "stroke"))).toBe("#v=1&job=stroke");
  expect(addressed("#v=1&job=stroke&w=AB", doc("AB", { seed: "4" }, "stroke"))).toBe("#v=1&job=stroke&w=AB&seed=4");
  // A wire never stands beside a shape that it does not cover.
  const turned = { ...doc("AB", {}, "fill"), given: { fill: "knot" } };
  expect(addressed("#v=1&job=fill&shape=vase&w=AB", turned, "vase")).toBe("#v=1&job=fill&shape=vase&w=AB");
  expect(addressed("#v=1&job=fill&shape=vase&w=AB", turned, null)).toBe("#v=1&job=fill&w=AB");
  expect(addressed("#v=1&job=fill&shape=vase&w=CD", turned, "vase")).toBe("#v=1&job=fill&shape=knot");
  // What the other task has made is not on the stage.
  expect(addressed("#v=1&w=AB", { ...doc("AB"), task: "stroke" })).toBe("#v=1&job=stroke");
});

it("carries what guides the next run, but no file of one's own", () => {
  const guided = (guide: object): Doc => ({ ...BLANK, ...withDesk(BLANK, "multiview", { settings: { seed: "4" }, guide: guide as never }) });
  expect(addressed("", guided({ words: { front: "a cat", top: "" }, weight: 0.3, by: "icons" }))).toBe("#v=1&seed=4&guide-front=a%20cat");
  expect(addressed("", guided({ words: { front: "cat" }, weight: 1, by: "0a1b" }))).toBe("#v=1&seed=4&guide-front=cat&guide-weight=1");
  expect(addressed("", guided({ words: {}, weight: 1, by: "denoiser" }))).toBe("#v=1&seed=4");
});
