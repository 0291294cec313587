/** The stage: what is seen on it, drawn in a worker or, where that is not possible, in the page. */

import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { visit } from "./browser";
import { coloursIn, LEND } from "./colours";
import { openSite } from "./site";

const { browser, site } = await openSite();

const canvas = (page: Page) => page.locator("wire-stage canvas");
const seen = (page: Page): Promise<Buffer> => canvas(page).screenshot();
const colours = async (page: Page) => coloursIn(page, (await seen(page)).toString("base64"));
const copper = async (page: Page): Promise<number> => (await colours(page)).copper;

/** The stage has drawn the wire, and drawn it fine. */
async function shown(page: Page): Promise<void> {
  await expect.poll(() => copper(page), { timeout: 60_000 }).toBeGreaterThan(0.003);
  await page.waitForTimeout(1500);
}

/** A page whose context can be taken away by the script that comes with it. */
async function lender(where: "worker" | "page"): Promise<{ page: Page; tell(script: string): Promise<unknown> }> {
  const { page } = await visit(browser, "about:blank");
  if (where === "page") {
    await page.addInitScript(`delete HTMLCanvasElement.prototype.transferControlToOffscreen; ${LEND}`);
  } else {
    await page.route(/backstage-worker/, async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, body: `${LEND}\n${await response.text()}` });
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
    const { page, tell } = await lender(where);
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
