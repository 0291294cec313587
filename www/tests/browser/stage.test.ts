/** The stage: what is seen on it, drawn in a worker or, where that is not possible, in the page. */

import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { phase, runButton, visit, type VisitOptions } from "./browser";
import { coloursIn, LEND } from "./colours";
import { openSite } from "./site";

const { browser, site } = await openSite();

const canvas = (page: Page) => page.locator("wire-stage canvas.live");
const seen = (page: Page): Promise<Buffer> => canvas(page).screenshot();
const colours = async (page: Page) => coloursIn(page, (await seen(page)).toString("base64"));
const copper = async (page: Page): Promise<number> => (await colours(page)).copper;

/** The stage has drawn the wire, and drawn it fine. */
async function shown(page: Page): Promise<void> {
  await expect.poll(() => copper(page), { timeout: 60_000 }).toBeGreaterThan(0.003);
  await page.waitForTimeout(1500);
}

/** A page with a script where it draws, which can be told more. */
async function prepared(where: "worker" | "page", script: string, options: VisitOptions = {}): Promise<{ page: Page; tell(script: string): Promise<unknown> }> {
  const { page } = await visit(browser, "about:blank", options);
  if (where === "page") {
    await page.addInitScript(`delete HTMLCanvasElement.prototype.transferControlToOffscreen; ${script}`);
  } else {
    await page.route(/backstage-worker/, async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, body: `${script}\n${await response.text()}` });
    });
  }
  await page.goto(site.url);
  const drawing = () => page.workers().find((worker) => /backstage-worker/.test(worker.url()))!;
  return { page, tell: (script) => (where === "page" ? page.evaluate(script) : drawing().evaluate(script)) };
}

it("shows the example's wire in copper, and another picture from the front", async () => {
  const { page, faults } = await visit(browser, site.url);
  await shown(page);
  const before = await seen(page);
  await page.locator("wire-stage").getByRole("button", { name: "Front" }).click();
  await expect.poll(async () => (await seen(page)).equals(before), { timeout: 20_000 }).toBe(false);
  await shown(page);
  expect(faults).toEqual([]);
  await page.context().close();
});

it("shows no copper where there is no wire", async () => {
  const { page } = await visit(browser, "about:blank");
  await page.route("**/*.code", (route) => route.abort());
  await page.goto(site.url);
  // What lies over the stage has colours of its own.
  await page.getByRole("button", { name: "Close this message" }).click();
  await page.waitForTimeout(1500);
  await expect.poll(() => copper(page)).toBe(0);
  await page.context().close();
});

it("marks places, and takes the marks away", async () => {
  const { page } = await visit(browser, site.url, { reducedMotion: "reduce" });
  await shown(page);
  const mark = (places: readonly (readonly number[])[] | null) =>
    page.locator("wire-stage").evaluate((element, places) => (element as unknown as { mark(places: unknown): void }).mark(places), places);
  const marks = async (): Promise<number> => (await colours(page)).marks;
  await expect.poll(() => marks()).toBe(0);
  await mark([[0, 0, 0], [0.3, 0.3, 0.3]]);
  await expect.poll(marks).toBeGreaterThan(0.00005);
  await mark(null);
  await expect.poll(marks).toBe(0);
  await page.context().close();
});

describe.each(["worker", "page"] as const)("in a %s", (where) => {
  it("takes a picture with the wire in it, and survives the loss of its context", async () => {
    const { page, tell } = await prepared(where, LEND);
    await shown(page);
    const picture = await page.locator("wire-stage").evaluate(async (element) => {
      const blob = await (element as unknown as { picture(width: number, height: number): Promise<Blob> }).picture(800, 600);
      let text = "";
      for (const byte of new Uint8Array(await blob.arrayBuffer())) text += String.fromCharCode(byte);
      return btoa(text);
    });
    expect((await coloursIn(page, picture)).copper).toBeGreaterThan(0.003);
    await tell("lent.loseContext()");
    const notice = page.locator("wire-stage .lost");
    await notice.waitFor();
    await tell("lent.restoreContext()");
    await notice.waitFor({ state: "detached" });
    await shown(page);
    await page.context().close();
  });

  it("is never empty while the camera flies by itself", async () => {
    const { page } = await prepared(where, "", { reducedMotion: "no-preference" });
    await shown(page);
    await page.locator("wire-stage").evaluate((element) => (element as unknown as { tour(): void }).tour());
    let least = 1;
    // A round takes some nine seconds: what flew is seen on most of these.
    for (let i = 0; i < 12; i++) {
      least = Math.min(least, await copper(page));
      await page.waitForTimeout(400);
    }
    expect(least).toBeGreaterThan(0.003);
    await page.context().close();
  });
});

// That it sways otherwise is not tested here: on a machine too slow for it, it rests by itself.
it("stands still for people who asked for less motion", async () => {
  const { page } = await visit(browser, site.url, { reducedMotion: "reduce" });
  await shown(page);
  // What moves never stands still for a second; what only has to be drawn to its end does, be it late.
  const standsStill = async (): Promise<boolean> => {
    const before = await seen(page);
    await page.waitForTimeout(1000);
    return (await seen(page)).equals(before);
  };
  await expect.poll(standsStill, { timeout: 20_000 }).toBe(true);
  await page.context().close();
});

/** Counts pictures: each ends with a fence. */
const COUNT = `{
  globalThis.pictures = 0;
  const { prototype } = WebGL2RenderingContext;
  const fence = prototype.fenceSync;
  prototype.fenceSync = function (...given) {
    globalThis.pictures++;
    return fence.apply(this, given);
  };
}`;

/** Ways in which nobody sees the stage: out of it, and back. */
const AWAY: readonly { readonly how: string; go(page: Page): Promise<unknown>; back(page: Page): Promise<unknown> }[] = [
  { how: "it is scrolled away", go: (page) => page.evaluate(() => scrollTo(0, 1e5)), back: (page) => page.evaluate(() => scrollTo(0, 0)) },
  { how: "the tab is hidden", go: (page) => hide(page, true), back: (page) => hide(page, false) },
  { how: "something lies over it", go: (page) => cover(page, true), back: (page) => cover(page, false) },
];

/** As a browser tells it; to a headless one all tabs are in front. */
function hide(page: Page, hidden: boolean): Promise<void> {
  return page.evaluate((hidden) => {
    Object.defineProperty(document, "hidden", { value: hidden, configurable: true });
    document.dispatchEvent(new Event("visibilitychange"));
  }, hidden);
}

function cover(page: Page, covered: boolean): Promise<void> {
  return page.locator("wire-stage").evaluate((element, covered) => void Object.assign(element, { covered }), covered);
}

it.each(AWAY)("draws no run while $how", async ({ go, back }) => {
  // So low that the page scrolls.
  const { page, tell } = await prepared("worker", COUNT, { viewport: { width: 400, height: 500 } });
  await shown(page);
  await runButton(page).click();
  await phase(page, "running");
  const pictures = async (): Promise<number> => Number(await tell("pictures"));
  const step = (): Promise<string | null> => page.locator("run-panel .steps").textContent();
  const drawsOn = async (): Promise<void> => {
    const before = await pictures();
    await expect.poll(pictures, { timeout: 30_000 }).toBeGreaterThan(before);
  };
  await drawsOn();
  await go(page);
  // What had been begun is drawn to its end.
  await page.waitForTimeout(500);
  const [before, stepBefore] = [await pictures(), await step()];
  await page.waitForTimeout(1500);
  await expect.poll(step).not.toBe(stepBefore);
  expect(await pictures()).toBe(before);
  await back(page);
  await drawsOn();
  await page.context().close();
});
