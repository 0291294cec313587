/** The glass box: what pulls, what each view sees, the wire from end to end, and what would be without. */

import type { Page } from "playwright-core";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { fits, inspect } from "./a11y";
import { idle, phase, requestsElsewhere, runButton, settled, shoot, visit, type Visit, type VisitOptions } from "./browser";
import { example, openEngine, type Order } from "./engine";
import { openSite } from "./site";

const { browser, site } = await openSite();
const QUICK = "#v=1&preset=fast&iterations=400&backend=cpu";
let visited: Visit;
let page: Page;

async function begin(options: VisitOptions = {}): Promise<void> {
  visited = await visit(browser, `${site.url}${QUICK}`, options);
  ({ page } = visited);
  await settled(page);
}
afterEach(async () => {
  if (!visited) return;
  expect(visited.faults).toEqual([]);
  expect(requestsElsewhere(visited)).toEqual([]);
  await page.context().close();
});

const box = () => page.locator("glass-panel");
const button = (name: string | RegExp) => page.getByRole("button", { name, exact: typeof name === "string" });
const open = async (): Promise<void> => {
  await button("Glass box").click();
  await box().waitFor();
};
const step = async (): Promise<number> => Number(/Step ([\d,]+)/.exec((await box().locator("> p").first().textContent())!)?.[1]?.replaceAll(",", "") ?? -1);
const terms = () => box().locator(".legend li");
const strip = () => page.getByRole("slider", { name: /Along the wire/ });
/** Pixels of the canvas over the stage that somebody sees; those of a colour, within rounding, where one is given. */
const over = (colour: readonly number[] | null = null): Promise<number> =>
  page.locator("wire-stage canvas.over").evaluate((element, colour) => {
    const canvas = element as HTMLCanvasElement;
    if (canvas.hidden || !canvas.width) return 0;
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    let seen = 0;
    for (let i = 0; i < data.length; i += 4) seen += data[i + 3]! > 200 && (!colour || colour.every((value, c) => Math.abs(value - data[i + c]!) < 24)) ? 1 : 0;
    return seen;
  }, colour);
const BLUE = [0x00, 0x63, 0xb0];

/** Runs until the first look into the run is there, and pauses. */
async function paused(): Promise<void> {
  await runButton(page).click();
  await phase(page, "running");
  await expect.poll(() => terms().count()).toBeGreaterThan(5);
  await button("Pause").click();
  await phase(page, "paused");
}

describe("on a desk", () => {
  beforeEach(() => begin());

  it("opens by its key, in its turn takes the pads' place, and gives it back", async () => {
    await page.keyboard.press("g");
    await box().waitFor();
    await expect.poll(() => page.locator("#part-pictures").isVisible()).toBe(false);
    await inspect(page, "glass-idle");
    await button("Close the glass box").click();
    await expect.poll(() => box().count()).toBe(0);
    await expect.poll(() => page.locator("#part-pictures").isVisible()).toBe(true);
  });

  it("draws arrows of each term on the control points, in step with the run", async () => {
    await open();
    await paused();
    expect(await terms().count()).toBeGreaterThanOrEqual(8);
    await expect.poll(() => over()).toBeGreaterThan(100);
    // All together, the only ones that are drawn at first, are black: none is blue until the front's are wanted.
    expect(await over(BLUE)).toBe(0);
    await box().getByLabel(/Match: front/).check();
    await expect.poll(() => over(BLUE)).toBeGreaterThan(30);
    await box().getByLabel(/All together/).uncheck();
    await box().getByLabel(/Match: front/).uncheck();
    await expect.poll(() => over()).toBe(0);
    await box().getByLabel(/Bend little/).check();
    await box().getByLabel(/Stretch each colour/).check();
    await expect.poll(() => over()).toBeGreaterThan(10);

    // Shares of the pull are all of it.
    const shares = (await box().locator(".legend .share").allTextContents()).map((text) => parseInt(/(\d+)%/.exec(text)?.[1] ?? "0"));
    const sum = shares.reduce((a, b) => a + b, 0);
    expect(sum).toBeGreaterThan(90);
    expect(sum).toBeLessThan(110);

    const before = await step();
    await button("Step").click();
    await expect.poll(step).toBe(before + 1);
    // Looking back, no arrow stands where the wire is not.
    await box().locator(".events button").first().click();
    await expect.poll(() => over()).toBe(0);
    await inspect(page, "glass-paused");
  });

  it("shows every view at every scale of the loss, and how far it is off", async () => {
    await open();
    await paused();
    const levels = page.locator("level-views");
    expect(await levels.locator("h4").allTextContents()).toEqual(["front", "side", "top"]);
    const count = await levels.locator(".level").count();
    expect(count % 3).toBe(0);
    expect(count).toBeGreaterThanOrEqual(12);
    const shade = (): Promise<number[]> =>
      levels.locator("figure canvas").evaluate((element) => {
        const canvas = element as HTMLCanvasElement;
        const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
        let sum = 0;
        for (let i = 0; i < data.length; i += 4) sum += data[i]!;
        return [canvas.width, Math.round(sum / (data.length / 4))];
      });
    const [width, difference] = (await shade()) as [number, number];
    await levels.locator(".level").nth(2).click();
    await expect.poll(async () => (await shade())[0]).toBe(width / 4);
    await levels.getByLabel("The picture").check({ force: true });
    await expect.poll(async () => (await shade())[1]).not.toBe(difference);
    expect(await levels.locator("figcaption").textContent()).toMatch(/front, \d+ × \d+ pixels: \d+% of what this view is off by/);
    await shoot(page, "glass-levels");
  });

  it("goes along the wire from end to end, by keys and by pointing at the stage", async () => {
    await open();
    await strip().focus();
    await page.keyboard.press("Home");
    await expect.poll(() => strip().getAttribute("aria-valuetext")).toMatch(/^0% along · .* thick$/);
    await expect.poll(() => over()).toBeGreaterThan(20);
    for (let i = 0; i < 4; i++) await page.keyboard.press("PageUp");
    await expect.poll(() => strip().getAttribute("aria-valuenow")).toBe("20");
    await button("Tightest bend").click();
    await expect.poll(() => strip().getAttribute("aria-valuetext")).toMatch(/bend radius [\d.]+ diameters \([\d.]+ px, [\d.]+ mm\)/);
    const tightest = await strip().getAttribute("aria-valuetext");
    // Somewhere across the middle of the stage the wire is met.
    const stage = (await page.locator("wire-stage canvas.over").boundingBox())!;
    for (let i = 0; i <= 30; i++) await page.mouse.move(stage.x + stage.width * (0.3 + 0.013 * i), stage.y + stage.height * 0.45);
    await expect.poll(() => strip().getAttribute("aria-valuetext")).not.toBe(tightest);
  });

  it("runs the same but for one thing, and lays both side by side", async () => {
    await open();
    expect(await page.locator("what-if option").allTextContents()).toContain("the last picture is left out");
    await page.locator("what-if select").selectOption({ label: "only the finest scale counts" });
    await button("Run it and lay it beside").click();
    // First the wire itself, for the example is of no run; then the other.
    await expect.poll(() => page.locator("what-if wire-pair").count(), { timeout: 150_000 }).toBe(1);
    await idle(page);
    const pair = page.locator("what-if wire-pair");
    expect(await pair.locator("thead th").allTextContents()).toEqual(["What", "As it is", "only the finest scale counts"]);
    const match = (await pair.locator("tbody tr").filter({ hasText: "Match" }).locator("td").allTextContents()).map((text) => parseInt(text));
    expect(match).toHaveLength(2);
    expect(match[0]).toBeGreaterThan(50);
    expect(match[1]).not.toBe(match[0]);
    await expect.poll(() => page.locator("wire-comparison wire-pair").count()).toBe(0);
    await inspect(page, "glass-pair");
  });
});

it("is a part of the sheet on a phone", async () => {
  await begin({ viewport: { width: 360, height: 740 }, hasTouch: true });
  await open();
  await paused();
  await expect.poll(() => over()).toBeGreaterThan(50);
  expect(await strip().isVisible()).toBe(true);
  await fits(page);
  await inspect(page, "glass-phone");
  await page.getByRole("tab", { name: "Run" }).click();
  await expect.poll(() => box().count()).toBe(0);
});

it("keeps to the colours that people force", async () => {
  await begin({ forcedColors: "active" });
  await open();
  await paused();
  await box().getByLabel(/Match: front/).check();
  await expect.poll(() => over()).toBeGreaterThan(100);
  expect(await over(BLUE)).toBe(0);
  await shoot(page, "glass-forced");
});

describe("a run that is looked into again and again", async () => {
  const { made } = await openEngine();
  /** Asks twenty times a second, takes the answers itself, and tells by a word that they came. */
  const CURIOUS = `
    let looked = 0;
    const post = self.postMessage.bind(self);
    self.postMessage = (message, options) => {
      if (message.id !== 9999) post(message, options);
      else if (message.answer && ++looked === 3) post({ news: "place", place: { workers: 99 } });
    };
    setInterval(() => self.onmessage?.({ data: { id: 9999, call: "insight" } }), 50);`;
  const orders: readonly Order[] = [
    example("multiview", { preset: "fast", backend: "cpu" }),
    example("stroke", { preset: "fast", backend: "cpu" }),
    example("fill", { preset: "fast", backend: "cpu", iterations: "100" }),
  ];

  it.each(orders)("comes to the same wire, bit for bit: $task", async (order) => {
    const [asked, unasked] = [await made(order, CURIOUS), await made(order)];
    expect(asked.workers).toContain(99);
    expect(asked.code).toBe(unasked.code);
  });
});
