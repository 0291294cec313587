/** What axe finds wrong with a page for people who use it in other ways. */

import axe from "axe-core";
import type { Page } from "playwright-core";
import { expect } from "vitest";
import { shoot } from "./browser";

/** Serious and critical faults, a line each: the rule, what it asks for and the elements, through shadow roots. */
export async function axeFaults(page: Page, exclude: readonly string[] = []): Promise<string[]> {
  // Evaluated from outside the page, so that its content security policy stays as it is.
  await page.evaluate(axe.source);
  const violations = await page.evaluate(async (exclude) => {
    const { axe } = window as unknown as { axe: typeof import("axe-core") };
    const { violations } = await axe.run({ exclude: exclude.map((selector) => [selector]) }, { resultTypes: ["violations"] });
    return violations.map(({ id, impact, help, nodes }) => ({ id, impact, help, targets: nodes.map((node) => node.target) }));
  }, exclude);
  return violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .map(({ id, impact, help, targets }) => `${id} (${impact}): ${help}: ${targets.map((target) => target.flat().join(" >> ")).join(", ")}`);
}

/** Nothing is wider than the window and, where its parts scroll by themselves, the app ends where the window does. */
export async function fits(page: Page): Promise<void> {
  const [wide, tall] = await page.evaluate(() => {
    const { scrollWidth } = document.documentElement;
    const app = document.querySelector("wire-app");
    const divided = app !== null && getComputedStyle(app).overflowY === "hidden";
    return [scrollWidth - innerWidth, divided ? app.getBoundingClientRect().bottom + scrollY - innerHeight : 0];
  });
  expect(wide).toBeLessThanOrEqual(0);
  expect(tall).toBeLessThanOrEqual(0);
}

export const COLOURS = ["light", "dark"] as const;
export type Colours = (typeof COLOURS)[number];

/** Looks at states of a page that began in light, each in both colours; the next in the same colours as the last. */
export function inBothColours(look: (state: string, colours: Colours) => Promise<void>, page: Page): (state: string) => Promise<void> {
  let order: readonly Colours[] = COLOURS;
  return async (state) => {
    for (const [at, colorScheme] of order.entries()) {
      if (at > 0) {
        await page.emulateMedia({ colorScheme });
        // Colours fade, and the stage has a thread of its own.
        await page.waitForTimeout(300);
      }
      await look(state, colorScheme);
    }
    order = order.toReversed();
  };
}

/** Takes a picture of a state, to be looked at, and has axe look at it. */
export async function inspect(page: Page, state: string): Promise<void> {
  await shoot(page, state);
  await fits(page);
  expect(await axeFaults(page)).toEqual([]);
}
