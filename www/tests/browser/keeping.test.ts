/** Work is kept: over reloads, crashes and tabs. */

import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { inspect } from "./a11y";
import { choose, contextWithProfile, figure, idle, pad, phase, runButton, visit } from "./browser";
import { drawStroke } from "./gestures";
import { inkOn, padsReady, previewed } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite();

const points = (page: Page) => figure(page, "Control points");

it("brings back drawings, settings and the wire after a reload", async () => {
  const context = await contextWithProfile(browser);
  const { page, faults } = await visit(context, site.url);
  await padsReady(page);
  await drawStroke(page, pad(page, 0).locator("ink-canvas"), [[0.1, 0.1], [0.9, 0.1]]);
  await choose(page, "preset", "fast");
  await runButton(page).click();
  await phase(page, "running");
  await idle(page);
  await previewed(page);
  const [ink, found] = [await inkOn(page, 0), await points(page)];
  await page.waitForTimeout(700);
  await page.reload();
  await previewed(page);
  await expect.poll(() => inkOn(page, 0)).toBeCloseTo(ink, 3);
  await expect.poll(() => points(page)).toBe(found);
  await expect.poll(() => page.locator("input[name=preset][value=fast]").isChecked()).toBe(true);
  // The way of the run is there, too.
  expect(Number(await page.getByLabel("The run, wire by wire").inputValue())).toBeGreaterThan(10);
  await inspect(page, "after-reload");
  expect(faults).toEqual([]);
  await context.close();
});

it("goes on with a run that a reload cut off", async () => {
  const context = await contextWithProfile(browser);
  const { page, faults } = await visit(context, site.url);
  await padsReady(page);
  await runButton(page).click();
  await phase(page, "running");
  const range = page.getByLabel("The run, wire by wire");
  await expect.poll(async () => ((await range.count()) ? Number(await range.inputValue()) : 0), { timeout: 60_000 }).toBeGreaterThan(4);
  await page.waitForTimeout(600);
  await page.reload();
  const notice = page.getByText(/A run was cut off at step/);
  await notice.waitFor();
  await inspect(page, "cut-off");
  const cut = parseInt(/step ([\d,]+)/.exec((await notice.textContent())!)![1]!.replaceAll(",", ""));
  expect(cut).toBeGreaterThan(0);
  await page.getByRole("button", { name: "Go on", exact: true }).click();
  await phase(page, "running");
  const step = async () => parseInt((/Step ([\d,]+) of/.exec((await page.locator("run-panel p").textContent())!)?.[1] ?? "0").replaceAll(",", ""));
  await expect.poll(step, { timeout: 30_000 }).toBeGreaterThanOrEqual(cut);
  await page.getByRole("button", { name: "Stop" }).click();
  await idle(page);
  await expect.poll(() => page.getByText(/A run was cut off/).count()).toBe(0);
  expect(faults).toEqual([]);
  await context.close();
});

it("offers to go on when the engine crashes in the middle of a run", async () => {
  const { page } = await visit(browser, site.url);
  await padsReady(page);
  await runButton(page).click();
  await phase(page, "running");
  const range = page.getByLabel("The run, wire by wire");
  await expect.poll(async () => ((await range.count()) ? Number(await range.inputValue()) : 0), { timeout: 60_000 }).toBeGreaterThan(2);
  const session = await page.context().newCDPSession(page);
  const { targetInfos } = await session.send("Target.getTargets");
  expect(targetInfos.some(({ type }) => type === "page")).toBe(true);
  await Promise.all(page.workers().map((worker) => worker.evaluate(() => setTimeout(() => { throw new WebAssembly.RuntimeError("unreachable"); })).catch(() => undefined)));
  await page.getByRole("alert").filter({ hasText: /engine stopped/i }).waitFor();
  await page.getByText(/A run was cut off at step/).waitFor();
  await inspect(page, "crashed");
  await page.getByRole("button", { name: "Go on", exact: true }).click();
  await phase(page, "running");
  await page.getByRole("button", { name: "Stop" }).click();
  await idle(page);
  await page.context().close();
});

it("lets one tab at a time keep the project, and says so in the other", async () => {
  const context = await contextWithProfile(browser);
  const first = await visit(context, site.url);
  await padsReady(first.page);
  await drawStroke(first.page, pad(first.page, 0).locator("ink-canvas"), [[0.1, 0.1], [0.9, 0.1]]);
  await first.page.waitForTimeout(700);
  const second = await visit(context, site.url);
  const elsewhere = (page: Page) => page.getByText("This project is open in another tab");
  await elsewhere(second.page).waitFor();
  await expect.poll(() => elsewhere(first.page).count()).toBe(0);
  await inspect(second.page, "two-tabs");
  await second.page.getByRole("button", { name: "Keep it here instead" }).click();
  await elsewhere(first.page).waitFor();
  await expect.poll(() => elsewhere(second.page).count()).toBe(0);
  expect([...first.faults, ...second.faults]).toEqual([]);
  await context.close();
});

it("works where the browser keeps nothing, and says that it does not", async () => {
  const { page, faults } = await visit(browser, site.url, { storage: "blocked" });
  await padsReady(page);
  await page.getByText("This browser keeps nothing between visits").first().waitFor({ state: "attached" });
  await choose(page, "preset", "fast");
  await runButton(page).click();
  await phase(page, "running");
  await idle(page);
  await expect.poll(() => page.locator(".verdict").textContent()).toMatch(/match/);
  await inspect(page, "storage-blocked");
  expect(faults).toEqual([]);
  await page.context().close();
});
