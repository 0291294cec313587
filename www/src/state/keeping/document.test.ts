import { expect, it } from "vitest";
import { BLANK, deskOf, differingJob, untouched, withDesk, type Doc, type Made } from "./document";
import { trackOf } from "./keep";

const made = {} as Made;
const subject = {} as Doc["subject"];

it("gives each job a desk of its own", () => {
  const doc: Doc = { ...BLANK, job: "stroke", ...withDesk(BLANK, "stroke", { settings: { seed: "3" } }) };
  expect(deskOf(doc).settings).toEqual({ seed: "3" });
  expect(deskOf({ ...doc, job: "multiview" })).toBe(BLANK.desks.multiview);
});

it("knows what was never touched", () => {
  expect([untouched(BLANK, "multiview"), untouched(BLANK, "stroke")]).toEqual([true, true]);
  const doc: Doc = { ...BLANK, subject };
  expect([untouched(doc, "multiview"), untouched(doc, "stroke")]).toEqual([true, false]);
  const done: Doc = { ...BLANK, ...withDesk(BLANK, "multiview", { made }) };
  expect([untouched(done, "multiview"), untouched(done, "stroke")]).toEqual([false, true]);
  expect(untouched({ ...BLANK, cover: { solid: { shape: "vase" }, style: null } }, "fill")).toBe(false);
  // Settings alone leave room for an example.
  expect(untouched({ ...BLANK, ...withDesk(BLANK, "stroke", { settings: { seed: "1" } }) }, "stroke")).toBe(true);
});

it("finds the job in which two documents differ, however they are looked at", () => {
  expect(differingJob(BLANK, { ...BLANK, job: "stroke" })).toBeNull();
  expect(differingJob(BLANK, { ...BLANK, job: "multiview", subject })).toBe("stroke");
  expect(differingJob(BLANK, { ...BLANK, cover: { solid: { shape: "vase" }, style: null } })).toBe("fill");
  expect(differingJob({ ...BLANK, job: "stroke" }, { ...BLANK, papers: { ...BLANK.papers } })).toBe("multiview");
  expect(differingJob(BLANK, { ...BLANK, papers: { ...BLANK.papers }, subject })).toBeNull();
});

it("reads runs of before there was a second job", () => {
  const rest = { settings: {}, iterations: 10, losses: [], events: [], snapshots: [] };
  const sheets = [{ slot: "front", paper: { layers: [], label: "Cat" } }] as const;
  expect(trackOf({ ...rest, sheets } as never)).toMatchObject({ given: { job: "multiview", sheets }, iterations: 10 });
  const now = { ...rest, given: { job: "multiview" as const, sheets: [] } };
  expect(trackOf(now)).toBe(now);
});
