/** A photograph of the wire: chosen, looked at, given up, taken and saved. */

import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { inspect } from "./a11y";
import { requestsElsewhere, settled, visit } from "./browser";
import { openSite } from "./site";

const { browser, site } = await openSite();

const dialog = (page: Page) => page.locator("photograph-dialog");

/** The mean brightness of the photograph on the page, 0 to 255, and how much of it is copper, in shares. */
function seen(page: Page): Promise<{ readonly light: number; readonly copper: number; readonly shade: number }> {
  return dialog(page)
    .locator("canvas")
    .evaluate((canvas: HTMLCanvasElement) => {
      const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
      const count = data.length / 4;
      let [light, copper, shade] = [0, 0, 0];
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b] = [data[i]!, data[i + 1]!, data[i + 2]!];
        light += (r + g + b) / 3 / count;
        if (r > 1.6 * b && r > 60) copper += 1 / count;
        if (r < 90 && Math.abs(r - b) < 25) shade += 1 / count;
      }
      return { light, copper, shade };
    });
}

const isThere = async (page: Page): Promise<boolean> => (await seen(page)).light > 30;

async function open(page: Page): Promise<void> {
  await page.locator("save-panel button", { hasText: "With real lamps" }).click();
  await expect.poll(() => isThere(page)).toBe(true);
}

it("shows the wire in real light, and takes the photograph on request", async () => {
  const visited = await visit(browser, site.url, { acceptDownloads: true });
  const { page, faults } = visited;
  await settled(page);
  await open(page);
  const first = await seen(page);
  expect(first.copper).toBeGreaterThan(0.005);
  expect(first.shade).toBeGreaterThan(0.002);

  // Another finish is another picture.
  await dialog(page).getByRole("combobox", { name: "The wire is of" }).selectOption("white");
  await expect.poll(async () => (await seen(page)).copper).toBeLessThan(first.copper / 4);
  await dialog(page).getByRole("combobox", { name: "The wire is of" }).selectOption("copper");
  await inspect(page, "photograph");

  await dialog(page).getByRole("radio", { name: "Quick" }).check({ force: true });
  const [download] = await Promise.all([page.waitForEvent("download", { timeout: 150_000 }), dialog(page).getByRole("button", { name: "Take it" }).click()]);
  const png = readFileSync(await download.path());
  expect(download.suggestedFilename()).toMatch(/-photograph\.png$/);
  expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([1280, 720]);
  // It carries the wire, as every picture of the page does.
  expect(png.length).toBeGreaterThan(100_000);
  await dialog(page).getByText(/^Saved /).waitFor();
  expect((await seen(page)).copper).toBeCloseTo(first.copper, 2);
  expect(faults).toEqual([]);
  expect(requestsElsewhere(visited)).toEqual([]);
  await page.context().close();
});

it("is given up by a key, on a phone, and nothing is saved", async () => {
  const { page, faults } = await visit(browser, site.url, { viewport: { width: 360, height: 740 } });
  await settled(page);
  await page.locator(".tabs [role=tab]").nth(3).click();
  await open(page);
  await inspect(page, "photograph-phone");
  await dialog(page).getByRole("button", { name: "Take it" }).focus();
  await page.keyboard.press("Enter");
  await dialog(page).getByRole("progressbar").waitFor();
  await page.keyboard.press("Escape");
  await dialog(page).getByText("Cancelled. Nothing was saved.").waitFor();
  // What follows is taken as before.
  await dialog(page).getByRole("combobox", { name: "The wire is of" }).selectOption("brass");
  await expect.poll(() => isThere(page)).toBe(true);
  await page.keyboard.press("Escape");
  await expect.poll(() => dialog(page).count()).toBe(0);
  expect(faults).toEqual([]);
  await page.context().close();
});
