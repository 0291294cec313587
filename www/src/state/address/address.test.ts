import { expect, it } from "vitest";
import { addressed } from "./address";
import { BLANK, withDesk, type Doc, type Job, type Made } from "../keeping/document";

const doc = (code: string | null, settings = {}, job: Job = "multiview"): Doc => {
  const made = code === null ? null : ({ finished: { code } } as Made);
  return { ...BLANK, job, ...withDesk(BLANK, job, { settings, made }) };
};

it("carries settings, and a wire only while it is the one on the stage", () => {
  expect(addressed("", doc(null))).toBe("");
  expect(addressed("#v=1&w=AB&seed=3", doc("AB", { seed: "4" }))).toBe("#v=1&w=AB&seed=4");
  expect(addressed("#v=1&w=AB", doc("CD", { seed: "4" }))).toBe("#v=1&seed=4");
  expect(addressed("#w=AB", doc("CD"))).toBe("");
  // What was not asked for is not put in: an address is not to be full of a wire unless somebody shares it.
  expect(addressed("", doc("CD"))).toBe("");
});

it("carries the job that is looked at, unless it is the first", () => {
  expect(addressed("", doc(null, {}, "stroke"))).toBe("#v=1&job=stroke");
  expect(addressed("#v=1&job=stroke&w=AB", doc("AB", { seed: "4" }, "stroke"))).toBe("#v=1&job=stroke&w=AB&seed=4");
  // A wire never stands beside a shape that it does not cover.
  const [vase, knot] = (["vase", "knot"] as const).map((shape) => ({ solid: { shape }, style: null }));
  const turned = { ...doc("AB", {}, "fill"), cover: knot! };
  expect(addressed("#v=1&job=fill&shape=vase&w=AB", turned, vase)).toBe("#v=1&job=fill&shape=vase&w=AB");
  expect(addressed("#v=1&job=fill&shape=vase&w=AB", turned, null)).toBe("#v=1&job=fill&w=AB");
  expect(addressed("#v=1&job=fill&shape=vase&w=CD", turned, vase)).toBe("#v=1&job=fill&shape=knot");
  // What the other job has made is not on the stage.
  expect(addressed("#v=1&w=AB", { ...doc("AB"), job: "stroke" })).toBe("#v=1&job=stroke");
});
