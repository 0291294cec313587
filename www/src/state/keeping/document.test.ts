import { expect, it } from "vitest";
import { deskOf, differingTask, EMPTY_DESK, withDesk, withGiven, type Doc } from "./document";

const BLANK: Doc = { task: "knit", given: { knit: null, sew: null }, desks: {} };

it("gives each task a desk of its own", () => {
  const doc: Doc = { ...BLANK, task: "sew", ...withDesk(BLANK, "sew", { settings: { seed: "3" } }) };
  expect(deskOf(doc)).toEqual({ ...EMPTY_DESK, settings: { seed: "3" } });
  expect(deskOf(doc, "knit")).toBe(EMPTY_DESK);
});

it("finds the task in which two documents differ, however they are looked at", () => {
  const sewn = withGiven(BLANK, "sew", "cloth");
  expect(differingTask(BLANK, { ...BLANK, task: "sew" })).toBeNull();
  expect(differingTask(BLANK, { ...BLANK, ...sewn })).toBe("sew");
  expect(differingTask({ ...BLANK, task: "sew" }, { ...BLANK, ...withDesk(BLANK, "knit", { settings: { seed: "1" } }) })).toBe("knit");
  expect(differingTask(BLANK, { ...BLANK, ...sewn, ...withDesk(BLANK, "knit", { settings: { seed: "1" } }) })).toBeNull();
});
