/** Making drawings as people do: with pen and eraser, words, icons and pictures; and what the page makes of them. */

import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { inspect } from "./a11y";
import { choose, DRAWINGS, give, pad, picture, serveDist, visit } from "./browser";
import { drawStroke, pasteFile } from "./gestures";
import { hatchedOn, inkOn, padsReady, previewed } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite();
let page: Page;
let faults: string[];
beforeEach(async () => {
  ({ page, faults } = await visit(browser, site.url));
  await padsReady(page);
});
afterEach(async () => {
  expect(faults).toEqual([]);
  await page.context().close();
});

const button = (name: string | RegExp) => page.getByRole("button", { name });
const sheet = (index: number) => pad(page, index).locator("ink-canvas");
const editor = () => page.locator("pad-editor");

async function startOver(): Promise<void> {
  await button("Draw your own").click();
  await editor().getByRole("button", { name: "Done" }).click();
  await expect.poll(() => inkOn(page, 0)).toBe(0);
}

describe("with the mouse, on the pad itself", () => {
  it("draws strokes, and undoes and redoes them one by one", async () => {
    await startOver();
    await drawStroke(page, sheet(0), [[0.2, 0.2], [0.8, 0.8]]);
    await expect.poll(() => inkOn(page, 0)).toBeGreaterThan(0.01);
    const one = await inkOn(page, 0);
    await drawStroke(page, sheet(0), [[0.8, 0.2], [0.2, 0.8]]);
    await expect.poll(() => inkOn(page, 0)).toBeGreaterThan(1.5 * one);
    await page.keyboard.press("z");
    await expect.poll(() => inkOn(page, 0)).toBeCloseTo(one, 3);
    await button(/^Undo/).first().click();
    await expect.poll(() => inkOn(page, 0)).toBe(0);
    await page.keyboard.press("Shift+Z");
    await expect.poll(() => inkOn(page, 0)).toBeCloseTo(one, 3);
    // Back to before the pads were emptied: the example's cat.
    for (let i = 0; i < 2; i++) await page.keyboard.press("Control+z");
    await expect.poll(() => inkOn(page, 1)).toBeGreaterThan(0.02);
  });
});

describe("in the editor", () => {
  it("draws with a width, erases, and clears", async () => {
    await startOver();
    await pad(page, 1).getByRole("button", { name: /^Draw/ }).click();
    const large = editor().locator("ink-canvas");
    await drawStroke(page, large, [[0.2, 0.5], [0.8, 0.5]]);
    await expect.poll(() => inkOn(page, 1)).toBeGreaterThan(0.005);
    const thin = await inkOn(page, 1);
    await editor().locator("input[type=number]").fill("60");
    await editor().locator("input[type=number]").press("Tab");
    await drawStroke(page, large, [[0.2, 0.5], [0.8, 0.5]]);
    await expect.poll(() => inkOn(page, 1)).toBeGreaterThan(2.5 * thin);
    const thick = await inkOn(page, 1);
    await editor().locator("input[name=tool][value=eraser]").check({ force: true });
    await drawStroke(page, large, [[0.5, 0.2], [0.5, 0.8]]);
    await expect.poll(() => inkOn(page, 1)).toBeLessThan(0.95 * thick);
    await inspect(page, "editor-draw");
    await editor().getByRole("button", { name: "Clear the sheet" }).click();
    await expect.poll(() => inkOn(page, 1)).toBe(0);
  });

  it("writes a word, long words and other scripts too, and says when there are no letters for it", async () => {
    await pad(page, 0).getByRole("button", { name: /^Type/ }).click();
    const text = editor().locator("#text");
    for (const word of ["love", "Donaudampfschifffahrtsgesellschaftskapitän", "سلام", "two words here"]) {
      await text.fill(word);
      await expect.poll(() => editor().locator(".status").textContent()).toMatch(/Not on the sheet yet|no letters/);
    }
    await text.fill("love");
    await expect.poll(() => editor().locator(".status").textContent()).toContain("Not on the sheet yet");
    await text.press("Enter");
    await expect.poll(() => pad(page, 0).locator(".line").innerText()).toMatch(/love|shown/);
    await inspect(page, "editor-type");
    // Not assigned to any letter: no font has them.
    await text.fill("\u{0378}\u{0379}");
    await expect.poll(() => editor().locator(".status").textContent()).toContain("no letters");
    await editor().getByRole("button", { name: "Done" }).click();
    await button(/^Undo: Write “love”/).waitFor();
  });

  it("takes an icon for a word", async () => {
    await pad(page, 2).getByRole("button", { name: /^Take an icon/ }).click();
    const search = editor().getByRole("searchbox");
    await search.fill("bicycle");
    await editor().getByRole("button", { name: "bike", exact: true }).click();
    await button(/^Undo: Take the icon bike/).first().waitFor();
    await search.fill("qqqqzz");
    await editor().getByText("No icon for “qqqqzz”").waitFor();
    await inspect(page, "editor-icons-none");
    await search.fill("love");
    await editor().getByRole("button", { name: "heart", exact: true }).waitFor();
    await editor().getByText("Icons: Lucide, ISC licence").click();
    await editor().getByText(/Permission to use, copy, modify/).waitFor();
    await inspect(page, "editor-icons");
    await editor().getByRole("button", { name: "Done" }).click();
    await expect.poll(() => pad(page, 2).locator(".line").innerText()).toMatch(/bike|shown/);
  });

  it("never asks for the icons before the shelf is opened", async () => {
    expect(site.sent.some(({ file }) => file.includes("shelf"))).toBe(true);
    const fresh = await serveDist("/fresh/");
    const other = await visit(browser, fresh.url);
    await padsReady(other.page);
    expect(fresh.sent.filter(({ file }) => file.includes("shelf"))).toEqual([]);
    await other.page.context().close();
    fresh.server.close();
  });

  it("finds the ink of a picture in another way", async () => {
    await give(page, 0, { name: "cross.png", mimeType: "image/png", buffer: await picture(page, 300, 300, "cross") });
    await expect.poll(() => pad(page, 0).locator(".line").innerText()).toMatch(/cross|shown/);
    await previewed(page);
    const dark = await inkOn(page, 0);
    await pad(page, 0).getByRole("button", { name: /^More/ }).click();
    await page.getByRole("menuitem", { name: "Swap ink and ground" }).click();
    await expect.poll(() => inkOn(page, 0)).toBeGreaterThan(2 * dark);
    await pad(page, 0).getByRole("button", { name: /^More/ }).click();
    await page.getByRole("menuitem", { name: "Set how dark ink is" }).click();
    await editor().locator("input[name=ink][value=dark]").check({ force: true });
    await expect.poll(() => inkOn(page, 0)).toBeLessThan(1.5 * dark);
    await inspect(page, "editor-picture");
  });
});

it("takes a pasted picture into the first empty pad", async () => {
  await startOver();
  await give(page, 0, join(DRAWINGS, "t07-outlines/front.png"));
  await expect.poll(() => inkOn(page, 0)).toBeGreaterThan(0);
  await pasteFile(page, "pasted.png", "image/png", await picture(page, 200, 200, "cross"));
  await expect.poll(() => inkOn(page, 1)).toBeGreaterThan(0);
});

describe("before a run", () => {
  it("shows the ink that no object can show, and what each remedy gains comes true", async () => {
    for (const [i, side] of ["front", "side", "top"].entries()) await give(page, i, join(DRAWINGS, "t07-outlines", `${side}.png`));
    // Spoil the arrangement, and forbid the page to mend it by itself.
    await page.locator("settings-panel summary", { hasText: "Views" }).click();
    await choose(page, "arrange", "off");
    await pad(page, 0).getByRole("button", { name: /^More/ }).click();
    await page.getByRole("menuitem", { name: "Turn left" }).click();
    await previewed(page);
    await expect.poll(() => hatchedOn(page, 0)).toBeGreaterThan(0);
    await inspect(page, "remedies");
    const remedies = page.locator("remedy-list ul[aria-label='What would help'] button");
    await expect.poll(() => remedies.count()).toBeGreaterThan(0);
    const promised = parseInt(/→\s*(\d+)%/.exec((await remedies.first().textContent())!)![1]!);
    await remedies.first().click();
    await previewed(page);
    const now = await page.locator("remedy-list .sum").textContent();
    const got = /All of/.test(now!) ? 100 : parseInt(/(\d+)%/.exec(now!)![1]!);
    expect(Math.abs(got - promised)).toBeLessThanOrEqual(1);
  });

  it("says what arranging gained, and puts the drawings back on request", async () => {
    await previewed(page);
    const arranged = page.locator("remedy-list .arranged");
    const [before, after] = [...(await arranged.textContent())!.matchAll(/(\d+)%/g)].map(([, share]) => Number(share));
    expect(after).toBeGreaterThan(before!);
    await arranged.getByRole("button").click();
    await previewed(page);
    expect(parseInt(/(\d+)%/.exec((await page.locator("remedy-list .sum").textContent())!)![1]!)).toBe(before);
    await expect.poll(() => page.locator("remedy-list ul[aria-label='What would help'] button", { hasText: "Arrange for me" }).count()).toBe(1);
  });

  it("offers to bend, with the match both ways", async () => {
    for (const [i, side] of ["front", "side", "top"].entries()) await give(page, i, join(DRAWINGS, "t07-outlines", `${side}.png`));
    await previewed(page);
    const freely = page.locator("remedy-list ul[aria-label=Bending] button", { hasText: /free/i });
    await expect.poll(() => freely.textContent()).toMatch(/\d+\.\d of 256 px; \d+% matches what was drawn/);
    await freely.click();
    await expect.poll(() => freely.getAttribute("aria-pressed")).toBe("true");
    await expect.poll(() => page.locator("input[name=bend][value=free]").isChecked()).toBe(true);
  });
});
