/** Where runs are computed: what the page says of it, the setting, the address, and a tab that is hidden meanwhile. */

import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { inspect } from "./a11y";
import { choose, contextWithProfile, idle, phase, runButton, runSettings, shoot, visit } from "./browser";
import { padsReady } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite();

const device = (page: Page) => page.locator("run-panel [data-backend]");
const notice = (page: Page) => page.locator("notice-list .notice");

it("names the processor where there is no WebGPU, and says why", async () => {
  const { page, faults } = await visit(browser, site.url, { webgpu: "missing" });
  await padsReady(page);
  await device(page).waitFor();
  await expect.poll(() => device(page).textContent()).toBe("Will use: Processor");
  const setting = await runSettings(page);
  const why = (await setting.locator(".where p").last().textContent())!;
  expect(why).toMatch(/^[A-Z].*\.$/);
  await expect.poll(() => device(page).getAttribute("title")).toBe(`Processor. ${why}`);
  await inspect(page, "device");
  await choose(page, "preset", "fast");
  await runButton(page).click();
  await phase(page, "running");
  await expect.poll(() => page.locator("run-panel p").textContent(), { timeout: 60_000 }).toMatch(/Processor\s+Step [\d,]+ of 200\s+[\d.,]+ steps a second/);
  await idle(page);
  await expect.poll(() => device(page).getAttribute("data-backend")).toBe("cpu");
  await expect.poll(() => notice(page).count()).toBe(0);
  expect(faults).toEqual([]);
  await page.context().close();
});

it("says in place that a graphics card is not to be had, and runs all the same", async () => {
  const { page, faults } = await visit(browser, site.url, { webgpu: "missing" });
  await padsReady(page);
  await choose(page, "backend", "gpu");
  const refusal = page.locator("setting-control[data-setting=backend] .refusal");
  await refusal.waitFor();
  const words = (await refusal.textContent())!;
  expect(words).toMatch(/^[A-Z].*\. The processor is used instead\.$/);
  await page.locator("setting-control[data-setting=backend]").scrollIntoViewIfNeeded();
  await inspect(page, "device-refused");
  await expect.poll(() => device(page).textContent()).toBe("Will use: Processor");
  await choose(page, "preset", "fast");
  await runButton(page).click();
  await phase(page, "running");
  await expect.poll(() => notice(page).textContent()).toContain(words);
  await idle(page);
  await expect.poll(() => page.locator(".verdict").textContent()).toMatch(/match/);
  // It is what the person asked for, and stays so.
  expect(new URL(page.url()).hash).toContain("backend=gpu");
  expect(faults).toEqual([]);
  await page.context().close();
});

it("obeys the address for a visit, and puts it nowhere else", async () => {
  const context = await contextWithProfile(browser, { permissions: ["clipboard-read", "clipboard-write"] });
  const { page, faults } = await visit(context, `${site.url}?renderer=cpu`);
  await padsReady(page);
  const setting = await runSettings(page);
  await setting.getByText("For this visit the address decides (?renderer=cpu).").waitFor();
  await expect.poll(() => setting.locator("select").inputValue()).toBe("cpu");
  await expect.poll(() => setting.locator("select").isDisabled()).toBe(true);
  await expect.poll(() => device(page).textContent()).toBe("Will use: Processor");
  await inspect(page, "device-by-address");
  // A step of the person's own, so that something is kept.
  await choose(page, "preset", "fast");
  await page.getByRole("button", { name: "Copy link" }).click();
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toMatch(/#v=1&w=/);
  expect(await page.evaluate(() => navigator.clipboard.readText())).not.toMatch(/renderer|backend/);
  expect(page.url()).toMatch(/\?renderer=cpu#v=1&w=/);
  await page.waitForTimeout(700);
  await page.goto(site.url);
  await padsReady(page);
  const later = await runSettings(page);
  await expect.poll(() => page.locator("input[name=preset][value=fast]").isChecked()).toBe(true);
  await expect.poll(() => later.locator("select").inputValue()).toBe("auto");
  await expect.poll(() => later.locator("select").isEnabled()).toBe(true);
  expect(faults).toEqual([]);
  await context.close();
});

it("says so where the address asks for what there is not", async () => {
  const { page, faults } = await visit(browser, `${site.url}?renderer=x`);
  await padsReady(page);
  await expect.poll(() => notice(page).textContent()).toMatch(/“x”.*auto, webgpu or cpu/);
  const setting = await runSettings(page);
  await expect.poll(() => setting.locator("select").inputValue()).toBe("auto");
  await expect.poll(() => setting.locator("select").isEnabled()).toBe(true);
  await inspect(page, "device-bad-address");
  await page.getByRole("button", { name: "Close this message" }).click();
  await expect.poll(() => notice(page).count()).toBe(0);
  expect(faults).toEqual([]);
  await page.context().close();
});

/** The engine says that it is on a card, and after so many looks that it is there no more. */
const LOSES_A_CARD = `
  const parse = JSON.parse;
  let looks = 0;
  JSON.parse = (text, ...rest) => {
    const value = parse(text, ...rest);
    if (value?.backend !== "cpu" || !("why" in value)) return value;
    if (++looks < 12) return { backend: "gpu", device: "Made-up card", why: "The graphics card does the work." };
    return { ...value, why: "the graphics card was lost; the processor goes on" };
  };`;

it("names the card while there is one, and tells when it is lost on the way", async () => {
  const { page, faults } = await visit(browser, site.url, { webgpu: "missing", inEngine: LOSES_A_CARD });
  await padsReady(page);
  await device(page).waitFor();
  await expect.poll(() => device(page).textContent()).toBe("Will use: Graphics card · Made-up card");
  await runButton(page).click();
  await phase(page, "running");
  await notice(page).waitFor();
  await expect.poll(async () => (await notice(page).textContent())!.trim()).toBe("The graphics card was lost; the processor goes on.");
  await expect.poll(() => device(page).textContent()).toBe("Processor");
  await inspect(page, "device-lost");
  await page.getByRole("button", { name: "Stop" }).click();
  await idle(page);
  expect(faults).toEqual([]);
  await page.context().close();
});

/** Chromium without a window hides no tab by itself. */
async function hide(page: Page, hidden: boolean): Promise<void> {
  await page.evaluate((hidden) => {
    Object.defineProperty(document, "hidden", { configurable: true, get: () => hidden });
    document.dispatchEvent(new Event("visibilitychange"));
  }, hidden);
}

it("rests in a hidden tab if asked to, also after a reload", async () => {
  const context = await contextWithProfile(browser);
  const { page, faults } = await visit(context, site.url);
  await padsReady(page);
  await choose(page, "when_hidden", "pause");
  await page.reload();
  await padsReady(page);
  await runSettings(page);
  const choice = page.locator("setting-control[data-setting=when_hidden] select");
  await expect.poll(() => choice.inputValue()).toBe("pause");
  await runButton(page).click();
  await phase(page, "running");
  await hide(page, true);
  await phase(page, "paused");
  await shoot(page, "device-resting");
  await hide(page, false);
  await phase(page, "running");
  await page.getByRole("button", { name: "Pause" }).click();
  await phase(page, "paused");
  await hide(page, true);
  await hide(page, false);
  await page.waitForTimeout(500);
  await phase(page, "paused");
  // Not a setting of the run: it can be changed at any time.
  await choice.selectOption("go");
  await page.getByRole("button", { name: "Go on", exact: true }).click();
  await phase(page, "running");
  await hide(page, true);
  await page.waitForTimeout(500);
  await phase(page, "running");
  await hide(page, false);
  await page.getByRole("button", { name: "Stop" }).click();
  await idle(page);
  expect(faults).toEqual([]);
  await context.close();
});
