/** Waiting and clicking that asks seldom, and little: Playwright's own works in the page with every frame, where it would be measured. */

import type { Page } from "playwright-core";

const POLL_MS = 200;
export const IN_APP = `document.querySelector("wire-app")?.shadowRoot`;
export const inPart = (part: string, selector: string): string => `${IN_APP}?.querySelector("${part}")?.shadowRoot?.querySelector("${selector}")`;

/** Resolves when a condition holds, a script. */
export async function until(page: Page, condition: string): Promise<void> {
  while (!(await page.evaluate(condition))) await page.waitForTimeout(POLL_MS);
}

/** In the middle of an element, a script. */
export async function click(page: Page, element: string): Promise<void> {
  const [x, y] = (await page.evaluate(`(({ x, y, width, height }) => [x + width / 2, y + height / 2])(${element}.getBoundingClientRect())`)) as [number, number];
  await page.mouse.click(x, y);
}

/** From a click on Run to the finished wire, seconds. */
export async function runToItsEnd(page: Page): Promise<number> {
  const idle = inPart("run-panel", "[data-phase=idle]");
  const start = performance.now();
  await click(page, inPart("run-panel", ".primary"));
  await until(page, `!${idle}`);
  await until(page, `!!${idle}`);
  return (performance.now() - start) / 1000;
}
