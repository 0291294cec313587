/** Every state of the page at the widths and in the colours people have: kept as pictures, and free of serious faults. */

import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { fits, inBothColours, inspect } from "./a11y";
import { choose, idle, launch, openPart, phase, runButton, shoot, SMALL, visit } from "./browser";
import { padsReady, previewed } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite();

const SIZES = [[1440, 900], [820, 1180], [360, 740]] as const;

for (const [width, height] of SIZES) {
  it(`from a first visit to a finished wire at ${width} px, light and dark`, async () => {
    const { page, faults } = await visit(browser, site.url, { viewport: { width, height }, hasTouch: width < 900 });
    const look = inBothColours(async (state, colours) => {
      await inspect(page, `${state}-${width}-${colours}`);
      const background = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
      expect(background).toBe(colours === "dark" ? "rgb(22, 21, 19)" : "rgb(246, 243, 238)");
    }, page);
    await padsReady(page);
    await page.evaluate(() => document.fonts.ready);
    await look("first-visit");
    const run = (await runButton(page).boundingBox())!;
    expect(run.height).toBeGreaterThanOrEqual(44);
    // The stage, the pads and the button are all within the first screen.
    expect(run.y + run.height).toBeLessThanOrEqual(height);
    await openPart(page, "Settings");
    await page.locator("settings-panel summary").first().click();
    await look("settings");
    await openPart(page, "Share");
    await look("share");
    await openPart(page, "Pictures");
    await openEditor(page);
    for (const [panel, state] of [["Draw", "draw"], ["Type", "type"], ["Icons", "icons"], ["Picture", "picture"]] as const) {
      await page.locator("pad-editor").getByRole("tab", { name: panel }).click();
      if (panel === "Icons") await page.locator("icon-shelf .grid").waitFor();
      await look(`editor-${state}`);
    }
    await page.locator("pad-editor").getByRole("button", { name: "Done" }).click();
    await openPart(page, "Run");
    await choose(page, "preset", "fast");
    await runButton(page).click();
    await phase(page, "running");
    await page.waitForTimeout(300);
    await shoot(page, `running-${width}`);
    await idle(page);
    await page.waitForTimeout(300);
    await look("finished");
    expect(faults).toEqual([]);
    await page.context().close();
  });
}

async function openEditor(page: Page): Promise<void> {
  const front = page.locator("drawing-pad").first();
  await front.getByRole("button", { name: /^More/ }).click();
  await page.getByRole("menuitem", { name: /^Draw/ }).click();
  await page.locator("pad-editor dialog[open]").waitFor();
}

describe("in hard places", () => {
  it("says so where there is no WebGL 2, and everything else works", async () => {
    const { page, faults } = await visit(browser, site.url, { webgl2: false });
    await page.getByText(/WebGL 2/).first().waitFor();
    await padsReady(page);
    await choose(page, "preset", "fast");
    await runButton(page).click();
    await phase(page, "running");
    await idle(page);
    await expect.poll(() => page.locator(".verdict").textContent()).toMatch(/match/);
    await inspect(page, "no-webgl");
    expect(faults.filter((fault) => !/WebGL/.test(fault))).toEqual([]);
    await page.context().close();
  });

  it("says so where there is no worker, and shows the example all the same", async () => {
    const { page } = await visit(browser, site.url, { worker: false });
    await page.locator("notice-list").getByText(/worker|engine/i).first().waitFor();
    await expect.poll(() => page.locator("[data-view]").count()).toBe(3);
    await inspect(page, "no-worker");
    await page.context().close();
  });

  it("says so where wasm has no SIMD", async () => {
    const plain = await launch({ simd: false });
    const { page } = await visit(plain, site.url);
    await page.locator("notice-list").getByText(/SIMD/).first().waitFor();
    await expect.poll(() => page.locator("[data-view]").count()).toBe(3);
    await shoot(page, "no-simd");
    await plain.close();
  });

  it("reads from right to left", async () => {
    const { page, faults } = await visit(browser, site.url, { rightToLeft: true, viewport: { width: 1440, height: 900 } });
    await padsReady(page);
    await shoot(page, "right-to-left");
    await fits(page);
    // The pads have gone to the other side.
    expect((await page.locator("drawing-pad").first().boundingBox())!.x).toBeGreaterThan(720);
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("loses nothing in a very small window", async () => {
    const { page, faults } = await visit(browser, site.url, { viewport: SMALL });
    await padsReady(page);
    await shoot(page, "small");
    await fits(page);
    await runButton(page).scrollIntoViewIfNeeded();
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("keeps its edges in forced colours", async () => {
    const { page } = await visit(browser, site.url, { forcedColors: "active", colorScheme: "dark" });
    await padsReady(page);
    await inspect(page, "forced-colours");
    await page.context().close();
  });

  it("bears very long names, and never takes one for markup", async () => {
    const { page, faults } = await visit(browser, site.url);
    await padsReady(page);
    const name = `${"Donaudampfschifffahrtsgesellschaftskapitän".repeat(4)}<img src=x onerror=alert(1)>.png`;
    const cross = Buffer.from(await page.evaluate(async () => {
      const canvas = new OffscreenCanvas(64, 64);
      const context = canvas.getContext("2d")!;
      context.fillStyle = "#fff";
      context.fillRect(0, 0, 64, 64);
      context.fillStyle = "#000";
      context.fillRect(10, 28, 44, 8);
      return [...new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())];
    }));
    await page.locator("drawing-pad").first().locator("input").setInputFiles({ name, mimeType: "image/png", buffer: cross });
    await page.getByRole("button", { name: /^Undo: Put Donau/ }).waitFor();
    await previewed(page);
    await fits(page);
    await shoot(page, "long-name");
    await expect.poll(() => page.locator("img").count()).toBe(0);
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("speaks at most once in three seconds", async () => {
    const { page } = await visit(browser, site.url);
    await padsReady(page);
    const heard = await page.locator("live-region").evaluateHandle((host) => {
      const heard: number[] = [];
      new MutationObserver(() => heard.push(performance.now())).observe(host.shadowRoot ?? host, { childList: true, characterData: true, subtree: true });
      return heard;
    });
    await choose(page, "preset", "fast");
    await runButton(page).click();
    await phase(page, "running");
    await idle(page);
    await page.waitForTimeout(3500);
    const times = (await heard.jsonValue()) as number[];
    expect(times.length).toBeGreaterThan(0);
    // What one message changes in the page counts once.
    const messages = times.filter((time, i) => i === 0 || time - times[i - 1]! > 100);
    for (let i = 1; i < messages.length; i++) expect(messages[i]! - messages[i - 1]!).toBeGreaterThan(2900);
    await page.context().close();
  });
});
