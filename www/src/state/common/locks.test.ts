import { expect, it } from "vitest";
import { isHidden, isLocked, isSettingLocked, joined, NO_LOCKS } from "./locks";

it("locks what is locked, and what is hidden", () => {
  const state = { locks: { lock: ["undo", "seed"], hide: ["share"] } };
  expect([isLocked(state, "undo"), isLocked(state, "share"), isLocked(state, "run")]).toEqual([true, true, false]);
  expect([isHidden(state, "undo"), isHidden(state, "share")]).toEqual([false, true]);
  expect([isSettingLocked(state, "seed"), isSettingLocked(state, "preset")]).toEqual([true, false]);
  expect(isSettingLocked({ locks: { lock: ["settings"], hide: [] } }, "preset")).toBe(true);
});

it("joins what a link, a lesson and a step say", () => {
  expect(joined()).toEqual(NO_LOCKS);
  expect(joined({ lock: ["a"] }, { lock: ["b", "a"], hide: ["c"] }, {})).toEqual({ lock: ["a", "b"], hide: ["c"] });
});
