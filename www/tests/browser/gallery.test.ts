/** The gallery: posters come as they are seen, a click opens a work, "Make it yours" leads to the app with all of it. */

import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import works from "../../gallery/works.json";
import { axeFaults, fits } from "./a11y";
import { DIST, settled, shoot, visit } from "./browser";
import { openSite } from "./site";

const PREFIX = "/some/where/";
const MOST_POSTER = 25_000;
const { browser, site } = await openSite(PREFIX);

const gallery = (hash = "", options = {}) => visit(browser, `${site.url}gallery.html${hash}`, options);
const postersIn = (requests: readonly string[]): string[] => requests.filter((url) => /gallery\/[\w-]+\.jpg$/.test(url));
const isDrawn = (page: Page): Promise<boolean> =>
  page.evaluate(() => !!document.querySelector("dialog[open] wire-sculpture")?.shadowRoot?.querySelector("canvas.live:not(.away)")?.clientHeight);

it("has a small poster of every work, by day and by night", () => {
  const posters = readdirSync(join(DIST, "gallery")).filter((name) => name.endsWith(".jpg"));
  for (const { name } of works) expect(posters).toEqual(expect.arrayContaining([`${name}.jpg`, `${name}-dark.jpg`]));
  for (const name of posters) expect(statSync(join(DIST, "gallery", name)).size).toBeLessThanOrEqual(MOST_POSTER);
});

it.each([[360, 740], [820, 1100], [1440, 900]])("lists its works %i px wide, posters as they are seen", async (width, height) => {
  site.sent.length = 0;
  const { page, requests, faults } = await gallery("", { viewport: { width, height } });
  await expect.poll(() => postersIn(requests).length).toBeGreaterThan(0);
  expect(await page.locator(".cards > li").count()).toBe(works.length);
  // Those far below are not asked for, and none of the other colours.
  expect(postersIn(requests).length).toBeLessThan(works.length);
  expect(postersIn(requests).some((url) => url.endsWith("-dark.jpg"))).toBe(false);
  expect(site.sent.some(({ file }) => file === "wire-sculpture.js")).toBe(false);
  await page.locator(".cards > li").last().scrollIntoViewIfNeeded();
  await expect.poll(() => postersIn(requests).some((url) => url.endsWith(`/${works.at(-1)!.name}.jpg`))).toBe(true);
  await page.getByRole("button", { name: "One picture" }).click();
  await expect.poll(() => page.locator(".cards > li:visible").count()).toBe(works.filter(({ task }) => task === "stroke").length);
  await shoot(page, `gallery ${width}`);
  await fits(page);
  expect(await axeFaults(page)).toEqual([]);
  expect(faults).toEqual([]);
});

it.each([[360, 740], [1440, 900]])("opens a work %i px wide, says what it is, and goes on to the next", async (width, height) => {
  const { page, faults } = await gallery("", { viewport: { width, height } });
  const [first, second] = works;
  await page.locator(".cards a").first().press("Enter");
  const dialog = page.getByRole("dialog", { name: first!.title });
  await expect.poll(() => dialog.isVisible()).toBe(true);
  await expect.poll(() => dialog.textContent()).toContain(first!.sentence);
  await expect.poll(() => dialog.locator(".inputs img").count()).toBe(2);
  await expect.poll(() => isDrawn(page)).toBe(true);
  // How it was found, with a button to see it again, where its file knows.
  const { replay } = JSON.parse(readFileSync(join(DIST, `gallery/works/${first!.name}.wire.json`), "utf8")) as { readonly replay?: string };
  await expect.poll(() => page.getByRole("slider", { name: "How it was found" }).count()).toBe(replay ? 1 : 0);
  await shoot(page, `gallery work ${width}`);
  expect(await axeFaults(page)).toEqual([]);
  await dialog.getByRole("link", { name: "Next" }).click();
  await expect.poll(() => page.getByRole("dialog", { name: second!.title }).isVisible()).toBe(true);
  await page.keyboard.press("Escape");
  await expect.poll(() => page.locator("dialog[open]").count()).toBe(0);
  await expect.poll(() => page.url()).toBe(`${site.url}gallery.html`);
  expect(faults).toEqual([]);
});

it("makes a work yours: the app opens with its wire and its drawings", async () => {
  const { page, faults } = await gallery("#love", { viewport: { width: 1440, height: 900 } });
  await page.getByRole("link", { name: "Make it yours" }).click();
  await expect.poll(() => page.getByRole("button", { name: "Remix" }).isEnabled()).toBe(true);
  expect(faults).toEqual([]);
});

it("hangs below the app for those who scroll there", async () => {
  const { page, requests, faults } = await visit(browser, site.url, { viewport: { width: 1440, height: 900 } });
  await expect.poll(() => page.getByRole("button", { name: "Make it again" }).isVisible()).toBe(true);
  expect(postersIn(requests)).toEqual([]);
  await page.evaluate(() => scrollTo(0, innerHeight));
  await expect.poll(() => page.locator(".below .cards > li").count()).toBe(works.length);
  await expect.poll(() => postersIn(requests).length).toBeGreaterThan(0);
  expect(postersIn(requests).length).toBeLessThan(works.length);
  expect(await axeFaults(page)).toEqual([]);
  await page.locator(".below .cards a").first().click();
  await expect.poll(() => page.getByRole("dialog", { name: works[0]!.title }).isVisible()).toBe(true);
  expect(faults).toEqual([]);
});

it("says so where there is no such work", async () => {
  const { page } = await visit(browser, `${site.url}#open=gallery/works/../../secret.json`);
  await expect.poll(() => page.getByText("There is no work").count()).toBe(1);
});

it("pushes nothing about as the app above it comes", async () => {
  const { page } = await visit(browser, site.url, { viewport: { width: 1440, height: 900 } });
  await settled(page);
  const shifted = await page.evaluate(
    () =>
      new Promise<number>((done) => {
        const sum = (entries: PerformanceEntryList): number => entries.reduce((sum, entry) => sum + (entry as PerformanceEntry & { readonly value: number }).value, 0);
        new PerformanceObserver((list) => done(sum(list.getEntries()))).observe({ type: "layout-shift", buffered: true });
        setTimeout(() => done(0), 500);
      }),
  );
  // What Lighthouse calls good.
  expect(shifted).toBeLessThan(0.1);
  await page.context().close();
});
