import { expect, it } from "vitest";
import { PLAIN_TITLE, pageTitle } from "./page-title";

it("follows a run, and stays on Done until somebody looks", () => {
  expect(pageTitle("idle", 0, false)).toBe(PLAIN_TITLE);
  expect(pageTitle("running", 0.468, false)).toBe("47% · Wire4D");
  expect(pageTitle("paused", 0.468, false)).toBe("Paused · Wire4D");
  expect(pageTitle("idle", 0, true)).toBe("Done · Wire4D");
});
