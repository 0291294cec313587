/** A run as people steer it: run, pause, step, look back, go on from there, stop, reset. */

import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { inspect } from "./a11y";
import { choose, DRAWINGS, figure, give, idle, phase, requestsElsewhere, runButton, shoot, visit, type Visit } from "./browser";
import { padsReady, previewed } from "./pads";
import { openSite } from "./site";

// Deep in a subpath: nothing on the page may count on lying at the root.
const { browser, site } = await openSite("/some/where/wire4d/");
let visited: Visit;
let page: Page;
beforeEach(async () => {
  visited = await visit(browser, site.url);
  ({ page } = visited);
  await padsReady(page);
});
afterEach(async () => {
  expect(visited.faults).toEqual([]);
  expect(requestsElsewhere(visited)).toEqual([]);
  await page.context().close();
});

const button = (name: string | RegExp) => page.getByRole("button", { name });
const pieces = () => figure(page, "Pieces");
const step = async () => parseInt((/Step ([\d,]+) of/.exec((await page.locator("run-panel p").textContent())!)?.[1] ?? "-1").replaceAll(",", ""));
const range = () => page.getByLabel("The run, wire by wire");
/** The step whose wire is on the stage. */
const looked = async () => ((await range().count()) ? Number(await range().inputValue()) : 0);

it("turns three drawings into one wire: the loss falls, every view matches, a sentence says how well", async () => {
  // The example's wire has come to stay: undo is to bring it back.
  await expect.poll(() => page.locator(".verdict").textContent()).toMatch(/Make it again/);
  for (const [i, side] of ["front", "side", "top"].entries()) await give(page, i, join(DRAWINGS, "t07-outlines", `${side}.png`));
  await previewed(page);
  await choose(page, "preset", "fast");
  const seen = await page.locator("[data-loss]").evaluateHandle((element) => {
    const seen: number[] = [];
    new MutationObserver(() => seen.push(Number(element.getAttribute("data-loss")))).observe(element, { attributes: true });
    return seen;
  });
  await runButton(page).click();
  await phase(page, "running");
  await shoot(page, "running");
  await expect.poll(() => page.title()).toMatch(/^\d+% · Wire4D/);
  await idle(page);
  const losses = (await seen.jsonValue()).filter((loss) => loss > 0);
  expect(losses.length).toBeGreaterThan(2);
  expect(Math.min(...losses)).toBeLessThan(0.7 * losses[0]!);
  for (const view of ["front", "side", "top"]) {
    expect(parseInt((await page.locator(`[data-view=${view}]`).textContent())!)).toBeGreaterThan(50);
  }
  await expect.poll(() => pieces()).toBe("1");
  await expect.poll(() => page.locator(".verdict").textContent()).toMatch(/match|ink/);
  await expect.poll(() => figure(page, "Bends")).toMatch(/tighter than a hand can bend/);
  await expect.poll(() => figure(page, "Strands")).toMatch(/nowhere through itself|passes through itself in [\d,]+ places?/);
  await inspect(page, "after-run");
  // …and undo brings the example's wire back.
  await button(/^Undo: Make the wire/).click();
  await expect.poll(() => page.locator(".verdict").textContent()).toMatch(/Make it again/);
});

it("pauses, steps one by one, and goes on", async () => {
  await runButton(page).click();
  await phase(page, "running");
  await expect.poll(step, { timeout: 60_000 }).toBeGreaterThan(5);
  await button("Pause").click();
  await phase(page, "paused");
  await page.waitForTimeout(400);
  const held = await step();
  await page.waitForTimeout(600);
  expect(await step()).toBe(held);
  for (let i = 1; i <= 3; i++) {
    await button("Step").click();
    await expect.poll(step).toBe(held + i);
  }
  await page.locator("body").click({ position: { x: 640, y: 20 } });
  await page.keyboard.press("Space");
  await phase(page, "running");
  await expect.poll(step, { timeout: 30_000 }).toBeGreaterThan(held + 3);
  await button("Stop").click();
  await idle(page);
  await expect.poll(() => button(/^GLB/).isEnabled()).toBe(true);
  await expect.poll(() => pieces()).toBe("1");
});

it("looks back at the wires of a run, and goes on from one of them", async () => {
  await runButton(page).click();
  await phase(page, "running");
  await expect.poll(looked, { timeout: 60_000 }).toBeGreaterThan(40);
  // Looking back pauses a run.
  await range().fill("20");
  await phase(page, "paused");
  await page.getByText(/Looking back at/).waitFor();
  await expect.poll(() => looked()).toBeLessThan(30);
  await inspect(page, "looking-back");
  await page.getByRole("button", { name: "Go on", exact: true }).click();
  await expect.poll(looked).toBeGreaterThan(30);
  await button("Reset").click();
  await idle(page);
  await choose(page, "preset", "fast");
  await runButton(page).click();
  await phase(page, "running");
  await idle(page);
  await expect.poll(() => looked()).toBe(200);
  const full = await page.locator("[data-view=front]").textContent();
  const marks = await page.locator("time-line .marks li").allTextContents();
  expect(marks.some((mark) => /step 200/i.test(mark))).toBe(true);
  // From the midst of the finished run, with the same settings: bit for bit the same wire, so the same match.
  await range().fill("80");
  const from = await looked();
  expect(from).toBeLessThan(200);
  await button("Go on from here").click();
  await phase(page, "running");
  await expect.poll(step).toBeGreaterThanOrEqual(from);
  await idle(page);
  await expect.poll(() => looked()).toBe(200);
  await expect.poll(() => page.locator("[data-view=front]").textContent()).toBe(full);
});

it("goes back to what was before, by reset and while the first wire is still sought", async () => {
  const files = button(/^GLB/);
  await expect.poll(() => files.isEnabled(), { timeout: 60_000 }).toBe(true);
  await runButton(page).click();
  // Each part of the page is drawn in a turn of its own.
  await expect.poll(() => files.isEnabled()).toBe(false);
  await button("Stop").click();
  await idle(page);
  await expect.poll(() => files.isEnabled()).toBe(true);
  await runButton(page).click();
  await phase(page, "running");
  await button("Reset").click();
  await idle(page);
  await expect.poll(() => files.isEnabled()).toBe(true);
  await expect.poll(() => button(/^Undo/).first().isEnabled()).toBe(false);
});

it("goes on in a hidden tab", async () => {
  await choose(page, "preset", "fast");
  await runButton(page).click();
  await phase(page, "running");
  const other = await page.context().newPage();
  await other.bringToFront();
  await idle(page);
  await other.close();
  await expect.poll(() => pieces()).toBe("1");
});
