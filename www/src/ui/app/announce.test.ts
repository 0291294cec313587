import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { StudioState } from "../../state/studio";
import { news, Pacer } from "./announce";

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it("says at most one thing in three seconds, and then the newest", () => {
  const said: string[] = [];
  const pacer = new Pacer((message) => said.push(message));
  for (const message of ["one", "two", "", "three"]) pacer.add(message);
  expect(said).toEqual(["one"]);
  vi.advanceTimersByTime(2999);
  expect(said).toEqual(["one"]);
  vi.advanceTimersByTime(1);
  expect(said).toEqual(["one", "three"]);
  vi.advanceTimersByTime(10_000);
  pacer.add("four");
  expect(said).toEqual(["one", "three", "four"]);
});

it("tells phases, quarters and words, and keeps quiet otherwise", () => {
  const state = (phase: StudioState["phase"], share: number, said = ""): StudioState =>
    ({ doc: { task: "knit", given: {}, desks: {} }, phase, said, progress: { share } }) as StudioState;
  expect(news(state("idle", 0), state("preparing", 0), [])).toBe("Preparing the run.");
  expect(news(state("running", 0.2), state("running", 0.24), [])).toBe("");
  expect(news(state("running", 0.24), state("running", 0.26), [])).toBe("25% done.");
  expect(news(state("running", 0.99), state("idle", 0), [])).toBe("The run has ended.");
  expect(news(state("idle", 0), state("idle", 0, "Link copied."), [])).toBe("Link copied.");
});
