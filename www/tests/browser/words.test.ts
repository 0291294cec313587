/** Words that guide a run, as people say them: the networks come when a run wants them, and never before. */

import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { inspect } from "./a11y";
import { choose, DRAWINGS, give, idle, requestsElsewhere, runButton, shoot, visit, type Visit } from "./browser";
import { padsReady, previewed } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite("/");
let visited: Visit;
let page: Page;
beforeEach(async () => {
  visited = await visit(browser, site.url);
  ({ page } = visited);
  await padsReady(page);
});
afterEach(async () => {
  expect(requestsElsewhere(visited)).toEqual([]);
  await page.context().close();
});

const GUIDANCE = /assets\/(ort|iconnet|words-|guide-panel|guiding|service-)/;
const fetched = (): string[] => site.sent.map(({ file }) => file).filter((file) => GUIDANCE.test(file));

/** Opens the fold and says what the front is to look like. */
async function say(word: string): Promise<void> {
  await page.locator("guide-fold summary").click();
  const field = page.getByLabel("Front", { exact: true });
  await field.fill(word);
  await field.press("Enter");
}

const withoutWords = () => page.locator("notice-list").getByText("The wire goes on without it.");

async function run(): Promise<void> {
  for (const [i, side] of ["front", "side"].entries()) await give(page, i, join(DRAWINGS, "p02-garden", `${side}.png`));
  await previewed(page);
  await choose(page, "preset", "fast");
  await choose(page, "iterations", "40");
  await runButton(page).click();
  await idle(page);
}

it("guides a run by a word, and fetches nothing for that before", async () => {
  expect(fetched()).toEqual([]);
  await say("umbrela");
  await page.getByText("Taken for “umbrella”").waitFor();
  await inspect(page, "words");
  await shoot(page, "words");
  expect(fetched().filter((file) => /ort|iconnet-.*onnx/.test(file))).toEqual([]);
  await run();
  expect(fetched().filter((file) => /iconnet-.*onnx/.test(file))).toHaveLength(2);
  expect(fetched().filter((file) => /asyncify/.test(file))).toEqual([]);
  expect(visited.faults).toEqual([]);
  expect(await withoutWords().count()).toBe(0);
});

it("goes on without a word that nobody knows, and without networks that do not come", async () => {
  await page.context().route(/iconnet-a.*\.onnx$/, (route) => route.abort());
  await say("umbrella");
  await run();
  await withoutWords().waitFor();
});
