/** Words that guide a run, as people say them: the networks come when a run wants them, and never before. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { inspect } from "./a11y";
import { choose, DRAWINGS, give, idle, requestsElsewhere, ROOT, runButton, shoot, visit, type Visit } from "./browser";
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

it("guides a run by a network of one's own, and opens it again when it is gone", async () => {
  const data = (name: string): Buffer => readFileSync(join(ROOT, "tests/data/guidance", name));
  const described = { ...(JSON.parse(data("vit-tiny.json").toString()) as object), embeddings: [{ prompt: "a fish", vector: [1, ...Array<number>(15).fill(0)] }] };
  await page.locator("guide-fold summary").click();
  await page.getByText("A network of your own").click();
  await page.locator("model-shelf input[type=file]").setInputFiles([
    { name: "vit.json", mimeType: "", buffer: Buffer.from(JSON.stringify(described)) },
    { name: "vit.onnx", mimeType: "", buffer: data("vit-tiny.onnx") },
  ]);
  await page.getByRole("button", { name: "Open it" }).click();
  await page.getByText("vit-tiny is open on the processor.").waitFor();
  await page.getByLabel("Whose idea of the words counts").selectOption("vit-tiny");
  await page.getByLabel("Front", { exact: true }).fill("a fish");
  await page.getByLabel("Side", { exact: true }).fill("a dragon");
  await page.getByLabel("Side", { exact: true }).press("Enter");
  await page.getByRole("button", { name: /^Close/ }).click();
  await run();
  await page.locator("notice-list").getByText("“a dragon” (side) is no word that guides here. Its file knows: a fish.").waitFor();
  expect(await withoutWords().count()).toBe(0);
  expect(visited.faults).toEqual([]);
});

it("goes on without a word that nobody knows, and without networks that do not come", async () => {
  await page.context().route(/iconnet-a.*\.onnx$/, (route) => route.abort());
  await say("umbrella");
  await run();
  await withoutWords().waitFor();
});
