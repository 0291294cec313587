/** The whole way from a first visit to a file, without ever touching a mouse. */

import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { inspect } from "./a11y";
import { idle, phase, visit, settled } from "./browser";
import { downloaded } from "./gestures";
import { inkOn, padsReady } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite();

/** What has the focus, through shadow roots: its name for people, or its tag. */
function focused(page: Page): Promise<string> {
  return page.evaluate(() => {
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
    return (element?.getAttribute("aria-label") ?? (element?.textContent?.trim() || element?.tagName)) ?? "";
  });
}

/** Tabs on until the focus is on something of that name. */
async function tabTo(page: Page, name: RegExp, key = "Tab"): Promise<void> {
  for (let i = 0; i < 120; i++) {
    if (name.test(await focused(page))) return;
    await page.keyboard.press(key);
  }
  throw new Error(`Tab never comes to ${name}`);
}

it("draws, types, runs, looks round, and saves by keys alone", async () => {
  const { page, faults } = await visit(browser, site.url);
  await settled(page);
  await padsReady(page);

  // The first drawing with the pen: cursor keys move it, space puts it down.
  await tabTo(page, /^Draw your own/);
  await page.keyboard.press("Enter");
  await tabTo(page, /Front sheet/);
  await page.keyboard.press("Space");
  for (let i = 0; i < 12; i++) await page.keyboard.press("Shift+ArrowRight");
  for (let i = 0; i < 12; i++) await page.keyboard.press("Shift+ArrowDown");
  await page.keyboard.press("Space");
  await expect.poll(() => inkOn(page, 0)).toBeGreaterThan(0.002);
  await inspect(page, "keys-drawing");
  await tabTo(page, /^Done/);
  await page.keyboard.press("Enter");

  // The second as a letter.
  await tabTo(page, /^Type a word.*side/);
  await page.keyboard.press("Enter");
  await expect.poll(() => page.locator("pad-editor #text").count()).toBe(1);
  await tabTo(page, /^INPUT$/);
  await page.keyboard.type("Z");
  await page.keyboard.press("Enter");
  await expect.poll(() => inkOn(page, 1)).toBeGreaterThan(0.005);
  await page.keyboard.press("Escape");

  // A quick sketch, run and paused by space, ended by its button.
  await tabTo(page, /^Run/);
  await page.keyboard.press("Enter");
  await phase(page, "running");
  await tabTo(page, /^Stop/);
  await page.keyboard.press("Enter");
  await idle(page);

  // Views, help, and its end.
  await page.keyboard.press("2");
  await expect.poll(() => page.locator("wire-stage").getByRole("button", { name: "Side", pressed: true }).count()).toBe(1);
  await page.keyboard.press("f");
  await page.keyboard.press("?");
  await page.getByRole("dialog").filter({ hasText: /device/ }).waitFor();
  await inspect(page, "help");
  await page.keyboard.press("Escape");
  await expect.poll(() => page.getByRole("dialog").count()).toBe(0);

  await tabTo(page, /^GLB/);
  const { bytes } = await downloaded(page, () => page.keyboard.press("Enter"));
  expect(bytes.subarray(0, 4).toString()).toBe("glTF");
  expect(faults).toEqual([]);
  await page.context().close();
});

it("leaves the keys of fields alone, and lets people switch its own off", async () => {
  const { page } = await visit(browser, site.url);
  await settled(page);
  await padsReady(page);
  const undoable = async () => page.getByRole("button", { name: /^Undo:/ }).count();
  const field = page.locator("settings-panel input[type=number]").first();
  await expect.poll(async () => {
    if (!(await field.isVisible())) await page.locator("settings-panel summary").first().click();
    return field.isVisible();
  }).toBe(true);
  await field.focus();
  await page.keyboard.press("?");
  await expect.poll(() => page.getByRole("dialog").count()).toBe(0);
  await page.locator("top-bar").getByRole("button", { name: "Help" }).click();
  const dialog = page.getByRole("dialog");
  await dialog.waitFor();
  await dialog.getByRole("checkbox").uncheck();
  await page.keyboard.press("Escape");
  await page.locator("body").click({ position: { x: 640, y: 20 } });
  const before = await undoable();
  await page.keyboard.press("?");
  await page.keyboard.press("Space");
  await expect.poll(() => page.getByRole("dialog").count()).toBe(0);
  await expect.poll(() => page.locator("[data-phase=idle]").count()).toBeGreaterThan(0);
  await expect.poll(() => undoable()).toBe(before);
  await page.context().close();
});
