/** Words that guide a run, as people say them: the networks come when a run wants them, and never before. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { inspect } from "./a11y";
import { choose, DRAWINGS, give, idle, phase, requestsElsewhere, ROOT, run as begin, runButton, shoot, visit, type Visit } from "./browser";
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

/** A run that has begun is not over yet. */
async function toTheEnd(): Promise<void> {
  await begin(page);
  await idle(page);
}

async function run(): Promise<void> {
  for (const [i, side] of ["front", "side"].entries()) await give(page, i, join(DRAWINGS, "p02-garden", `${side}.png`));
  await previewed(page);
  await choose(page, "preset", "fast");
  await choose(page, "iterations", "40");
  await toTheEnd();
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
  await expect.poll(() => withoutWords().count()).toBe(0);
});

const data = (name: string): Buffer => readFileSync(join(ROOT, "tests/data/guidance", name));
const json = (name: string, content: string | object) => ({ name, mimeType: "", buffer: Buffer.from(typeof content === "string" ? content : JSON.stringify(content)) });

/** Opens files as a network of one's own, and has it guide. */
async function own(name: string, ...texts: readonly ReturnType<typeof json>[]): Promise<void> {
  await page.locator("model-shelf input[type=file]").setInputFiles([...texts, { name: `${name}.onnx`, mimeType: "", buffer: data(`${name}.onnx`) }]);
  await page.getByRole("button", { name: "Open it" }).click();
  await page.getByText(`${name} is open on the processor.`).waitFor();
}

const VIT = { ...(JSON.parse(data("vit-tiny.json").toString()) as object), embeddings: ["a fish", "a wire"].map((prompt, i) => ({ prompt, vector: Array.from({ length: 16 }, (_, at) => Number(at === i)) })) };
const by = () => page.getByLabel("Whose idea of the words counts");

async function ofOnesOwn(): Promise<void> {
  await page.locator("guide-fold summary").click();
  await page.getByText("A network of your own").click();
}

async function front(word: string): Promise<void> {
  await page.getByLabel("Front", { exact: true }).fill(word);
  await page.getByLabel("Front", { exact: true }).press("Enter");
}

it("guides a run by a network of one's own, and opens it again when it is gone", async () => {
  await ofOnesOwn();
  await own("vit-tiny", json("vit.json", VIT));
  await by().selectOption("vit-tiny");
  await front("a fish");
  await page.getByLabel("Side", { exact: true }).fill("a dragon");
  await page.getByLabel("Side", { exact: true }).press("Enter");
  await page.getByRole("button", { name: /^Close/ }).click();
  await run();
  await page.locator("notice-list").getByText("“a dragon” (side) is no word that guides here. Its file knows: a fish, a wire.").waitFor();
  await expect.poll(() => withoutWords().count()).toBe(0);
  expect(visited.faults).toEqual([]);
});

it("has a network of one's own look at patches, from neutral words, also where a run goes on", async () => {
  await ofOnesOwn();
  await own("vit-tiny", json("vit.json", VIT));
  await by().selectOption("vit-tiny");
  await front("a fish");
  await page.getByLabel("At patches").check();
  await expect.poll(() => page.getByLabel("Neutral words").inputValue()).toBe("a wire");
  await expect.poll(() => page.locator("guide-panel output").textContent()).toBe("0.5");
  await inspect(page, "patches");
  await run();
  await expect.poll(() => withoutWords().count()).toBe(0);
  await page.getByLabel("Neutral words").fill("a dragon");
  await page.getByLabel("Neutral words").press("Enter");
  await toTheEnd();
  await page.locator("notice-list").getByText("“a dragon”, which the words are to differ from, is no word that guides here.").waitFor();
  expect(visited.faults).toHaveLength(1);
});

it("says that nothing is open any more when a run was called off", async () => {
  await ofOnesOwn();
  await own("vit-tiny", json("vit.json", VIT));
  await choose(page, "iterations", "5000");
  await runButton(page).click();
  await phase(page, "running");
  await page.getByRole("button", { name: "Reset", exact: true }).click();
  await idle(page);
  await expect.poll(() => page.getByText("vit-tiny is open").count()).toBe(0);
  await expect.poll(() => page.getByRole("button", { name: "Open vit-tiny" }).isEnabled()).toBe(true);
});

it("guides a run by a diffusion model of one's own that sees pixels", async () => {
  await ofOnesOwn();
  await own("eps-pixels-tiny", json("eps.json", data("eps-pixels-tiny.json").toString()));
  await by().selectOption("eps-pixels-tiny");
  await front("umbrella");
  await expect.poll(() => page.locator("guide-panel output").textContent()).toBe("1");
  await inspect(page, "diffusion");
  await run();
  await expect.poll(() => withoutWords().count()).toBe(0);
  expect(visited.faults).toEqual([]);
});

it("guides a run by a latent diffusion model with its encoder and its file of contexts", async () => {
  const sidecar = JSON.parse(data("eps-tiny.json").toString()) as { nothing: number[] };
  const values = Buffer.from(Float32Array.from(sidecar.nothing, (v) => -v).buffer).toString("base64");
  const contexts = json("eps.contexts.json", { kind: "contexts-v1", shape: [5, 16], contexts: [{ prompt: "a fish", values }] });
  await ofOnesOwn();
  await own("eps-tiny", json("eps.json", sidecar), contexts);
  await by().selectOption("eps-tiny");
  await front("a fish");
  await run();
  await page.locator("notice-list").getByText("The diffusion model sees pictures through an encoder, and none is open.").waitFor();
  await own("vjp-tiny", json("vjp.json", data("vjp-tiny.json").toString()));
  await toTheEnd();
  await expect.poll(() => withoutWords().count()).toBe(0);
  await front("a dragon");
  await toTheEnd();
  await page.locator("notice-list").getByText("“a dragon” (front) is no word that guides here. Its file knows: a fish.").waitFor();
  // What was said of the encoder, and of the word.
  expect(visited.faults).toHaveLength(2);
});

it("goes on without a word that nobody knows, and without networks that do not come", async () => {
  await page.context().route(/iconnet-a.*\.onnx$/, (route) => route.abort());
  await say("umbrella");
  await run();
  await withoutWords().waitFor();
});

/** Lets a word pull a view where an icon could be chosen by it. */
async function pull(slot: string, word: string): Promise<void> {
  await page.getByRole("button", { name: `Take an icon, ${slot}` }).click();
  await page.getByPlaceholder(/^Search/).fill(word);
  await page.getByRole("button", { name: `Let “${word}” pull the wire` }).click();
  await page.getByText(`“${word}” pulls the ${slot} view.`).waitFor();
}

const done = () => page.getByRole("button", { name: "Done" }).click();
const fast = async (): Promise<void> => {
  await choose(page, "preset", "fast");
  await choose(page, "iterations", "40");
};

it("makes a wire of words alone, and says so", async () => {
  await page.getByRole("button", { name: "Draw your own" }).click();
  await done();
  await page.getByText("A wire needs at least two drawings.").waitFor();
  await pull("front", "umbrella");
  await done();
  await page.getByText("One more drawing, and a wire can be made.").waitFor();
  await pull("top", "cat");
  await inspect(page, "word-pulls");
  await done();
  await page.getByText("Words alone will pull the wire.").waitFor();
  await expect.poll(() => page.getByLabel("Front drawing", { exact: true }).textContent()).toContain("“umbrella” pulls here");
  await inspect(page, "words-alone");
  await fast();
  await toTheEnd();
  await page.locator(".verdict").getByText("Words alone pulled it, so there is no drawing to compare with.").waitFor();
  expect(visited.faults).toEqual([]);
  await expect.poll(() => withoutWords().count()).toBe(0);
  await expect.poll(() => page.locator("match-panels .match").allTextContents()).toEqual(["–", "–"]);
  await expect.poll(() => page.locator("match-panels .name").allTextContents()).toEqual(["front", "top"]);
  await inspect(page, "made-of-words");
  // They go with a link, and with undo.
  const address = page.url();
  expect(address).toContain("guide-front=umbrella&guide-top=cat");
  // The wire, two settings, and the last word.
  for (let step = 0; step < 4; step++) await page.getByRole("button", { name: /^Undo/ }).first().click();
  await expect.poll(() => page.url()).not.toContain("guide-top");
  const other = await visit(browser, address);
  await other.page.getByText("Words alone will pull the wire.").waitFor();
  await other.page.context().close();
});

it("makes nothing of words that nobody knows", async () => {
  await page.getByRole("button", { name: "Draw your own" }).click();
  await done();
  for (const slot of ["front", "side"]) {
    await page.getByRole("button", { name: `Take an icon, ${slot}` }).click();
    await page.getByPlaceholder(/^Search/).fill("qqqqq");
    await page.getByRole("button", { name: "Let “qqqqq” pull the wire" }).click();
    await page.getByText("“qqqqq” is no word that these networks know.").waitFor();
    await done();
  }
  await fast();
  await runButton(page).click();
  await page.getByText("None of the words could guide the wire.").waitFor();
  await idle(page);
});

it("draws one view and lets a word pull another, pauses and goes on", async () => {
  await page.getByRole("button", { name: "Draw your own" }).click();
  await done();
  await give(page, 0, join(DRAWINGS, "p02-garden", "front.png"));
  await pull("side", "flower");
  await done();
  await page.getByText("A word will pull where nothing is drawn.").waitFor();
  await fast();
  await choose(page, "iterations", "400");
  await runButton(page).click();
  await phase(page, "running");
  await page.getByRole("button", { name: "Pause" }).click();
  await phase(page, "paused");
  await page.getByRole("button", { name: "Go on", exact: true }).click();
  await phase(page, "running");
  await page.getByRole("button", { name: "Stop" }).click();
  await idle(page);
  await expect.poll(() => withoutWords().count()).toBe(0);
  await expect.poll(() => page.locator("match-panels .match").allTextContents()).toEqual([expect.stringMatching(/^\d+%$/), "–"]);
  expect(visited.faults).toEqual([]);
});

it("lets turned views be like the picture", async () => {
  await page.getByRole("tab", { name: "One picture" }).click();
  await page.locator("guide-fold summary").click();
  await page.getByLabel("Turned views are to be like the picture").check();
  await inspect(page, "like-picture");
  await fast();
  await toTheEnd();
  await expect.poll(() => withoutWords().count()).toBe(0);
  expect(fetched().filter((file) => /iconnet-.*onnx/.test(file)).length).toBeGreaterThan(0);
  expect(visited.faults).toEqual([]);
});
