/** The page for teachers: its list, its sheets on paper, and the sheet with a code. */

import { readdirSync } from "node:fs";
import { join } from "node:path";
import jsQR from "jsqr";
import type { Page } from "playwright-core";
import { afterEach, beforeEach, expect, it } from "vitest";
import { inspect } from "./a11y";
import { requestsElsewhere, ROOT, visit, type Visit } from "./browser";
import { openSite } from "./site";

const { browser, site } = await openSite("/some/where/wire4d/");
const IDS = readdirSync(join(ROOT, "www/lessons")).filter((name) => !name.includes("."));

let visited: Visit;
let page: Page;
beforeEach(async () => {
  visited = await visit(browser, `${site.url}teachers.html`);
  ({ page } = visited);
  await page.locator(".lessons.here").waitFor();
});
afterEach(async () => {
  expect(visited.faults).toEqual([]);
  expect(requestsElsewhere(visited)).toEqual([]);
  await page.context().close();
});

const pagesOf = (pdf: Buffer): number => pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g)!.length;

it("lists all lessons, each with links that lead there", async () => {
  const hrefs = await page.locator(".lessons a").evaluateAll((links) => links.map((link) => link.getAttribute("href")!));
  for (const id of IDS) expect(hrefs).toEqual(expect.arrayContaining([`./#lesson=${id}`, `./#lesson=${id}&lock=leave`, `#sheet=${id}`]));
  await inspect(page, "teachers");
  await page.emulateMedia({ colorScheme: "dark" });
  await inspect(page, "teachers-dark");
  await page.setViewportSize({ width: 360, height: 740 });
  await inspect(page, "teachers-phone");
  await page.locator('.lessons a[href="./#lesson=views"]').click();
  await page.locator("lesson-panel h3").waitFor();
});

it.each(["A4", "Letter"])("prints a sheet and a note, a page of %s each", async (format) => {
  for (const id of IDS) {
    await page.evaluate((id) => (location.hash = `#sheet=${id}`), id);
    await expect.poll(() => page.locator(".sheet h1").nth(1).textContent()).toMatch(/note for teachers$/);
    await expect.poll(() => page.locator(`.sheet .address`).textContent()).toMatch(new RegExp(`#lesson=${id}$`));
    expect([id, pagesOf(await page.pdf({ format }))]).toEqual([id, 2]);
  }
  await inspect(page, "sheet");
  await page.getByRole("link", { name: "All lessons" }).click();
  await expect.poll(() => page.getByRole("heading", { name: "For teachers" }).isVisible()).toBe(true);
});

it("prints the code of a class's link, which reads back as that link", async () => {
  const link = `${site.url}#v=1&lesson=views&lock=leave,seed&hide=settings&preset=fast`;
  await page.evaluate((link) => (location.hash = `#class=${encodeURIComponent(link)}`), link);
  await page.locator(".sheet .code").waitFor();
  const { data, width, height } = await page.locator(".sheet .code").evaluate(async (svg) => {
    const image = new Image();
    const text = new XMLSerializer().serializeToString(svg).replace("<svg", '<svg width="600" height="600"');
    image.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
    await image.decode();
    const context = new OffscreenCanvas(600, 600).getContext("2d")!;
    context.drawImage(image, 0, 0, 600, 600);
    return { data: [...context.getImageData(0, 0, 600, 600).data], width: 600, height: 600 };
  });
  expect(jsQR(new Uint8ClampedArray(data), width, height)?.data).toBe(link);
  expect(pagesOf(await page.pdf({ format: "A4" }))).toBe(1);
});
