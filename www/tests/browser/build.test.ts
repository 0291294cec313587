/** How to build a wire: what the page says of it, the steps by keys, and the files to take along. */

import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { inspect } from "./a11y";
import { requestsElsewhere, settled, visit } from "./browser";
import { openSite } from "./site";

const { browser, site } = await openSite();

const dialog = (page: Page) => page.locator("build-dialog");

async function open(page: Page): Promise<void> {
  await page.locator("save-panel button", { hasText: "or print it" }).click();
  await dialog(page).getByText(/m of wire,/).waitFor();
}

async function saved(page: Page, name: RegExp): Promise<{ readonly name: string; readonly bytes: Buffer }> {
  const [download] = await Promise.all([page.waitForEvent("download", { timeout: 150_000 }), dialog(page).getByRole("button", { name }).click()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

it("says whether a wire can be bent, how much it takes, and makes the plan", async () => {
  const visited = await visit(browser, site.url, { acceptDownloads: true });
  const { page, faults } = visited;
  await settled(page);
  await open(page);
  await inspect(page, "build");
  const metres = async (): Promise<number> => Number(/([\d.]+) m of wire/.exec(await dialog(page).locator(".verdict").innerText())![1]);
  const before = await metres();

  // Twice as large takes twice the wire; far too thick cannot be bent, and something that would do is said.
  await dialog(page).locator("#sizeMm").fill("400");
  await expect.poll(metres).toBeCloseTo(2 * before, 1);
  await dialog(page).locator("#wireMm").fill("9");
  await dialog(page).getByText("It cannot be bent like this.").waitFor();
  await dialog(page).locator("#sizeMm").fill("0");
  await expect.poll(() => dialog(page).locator(".verdict").innerText()).toMatch(/longest side/i);
  await dialog(page).locator("#sizeMm").fill("200");
  await dialog(page).locator("#wireMm").fill("1.6");
  await expect.poll(metres).toBe(before);

  const pdf = await saved(page, /^Plan on paper/);
  expect(pdf.name).toMatch(/-plan\.pdf$/);
  expect(pdf.bytes.subarray(0, 5).toString()).toBe("%PDF-");
  const csv = await saved(page, /^Bend list for machines/);
  expect(csv.bytes.toString().split("\n").length).toBeGreaterThan(20);
  const print = await saved(page, /^The same as STL/);
  const triangles = print.bytes.readUInt32LE(80);
  expect(triangles).toBeGreaterThan(1000);
  expect(print.bytes.length).toBe(84 + 50 * triangles);
  expect(faults).toEqual([]);
  expect(requestsElsewhere(visited)).toEqual([]);
  await page.context().close();
});

it("goes through the steps by keys, on a phone", async () => {
  const { page, faults } = await visit(browser, site.url, { viewport: { width: 360, height: 740 } });
  await settled(page);
  await page.locator(".tabs [role=tab]").nth(3).click();
  await open(page);
  await inspect(page, "build-phone");
  const newest = (): Promise<string | null> => dialog(page).locator("path.new").getAttribute("d");
  await dialog(page).getByRole("slider", { name: "Step of bending" }).focus();
  const first = await newest();
  await page.keyboard.press("ArrowRight");
  await dialog(page).getByText(/^Step 2 of \d+/).waitFor();
  expect(await newest()).not.toBe(first);
  await page.keyboard.press("End");
  await expect.poll(() => dialog(page).getByRole("button", { name: "The next step" }).isDisabled()).toBe(true);
  await inspect(page, "build-phone-last");
  await page.keyboard.press("Escape");
  await expect.poll(() => dialog(page).count()).toBe(0);
  expect(faults).toEqual([]);
  await page.context().close();
});
