import { expect, it } from "vitest";
import { readAsked, writeAsked } from "./asked";

it("reads what an address asks of a lesson, beside all else", () => {
  expect(readAsked("#v=1&lesson=views&step=3&lock=seed,preset,,seed&hide=share, settings&kiosk=1&job=fill&seed=7")).toEqual({
    lesson: "views",
    step: 3,
    lock: ["seed", "preset"],
    hide: ["share", "settings"],
    kiosk: true,
  });
  expect(readAsked("#seed=7")).toEqual({ lesson: null, step: null, lock: [], hide: [], kiosk: false });
  expect(readAsked("#step=two").step).toBeNaN();
});

it("writes it anew and leaves the rest of the address alone", () => {
  const asked = { lesson: "views", step: 2, lock: ["leave"], hide: [], kiosk: false };
  const hash = writeAsked("#v=1&lesson=cover&step=9&seed=7", asked);
  expect(hash).toBe("#v=1&lesson=views&step=2&lock=leave&seed=7");
  expect(readAsked(hash)).toEqual(asked);
  expect(writeAsked("#v=1&seed=7", readAsked(""))).toBe("#v=1&seed=7");
  expect(writeAsked("", readAsked(""))).toBe("");
});
