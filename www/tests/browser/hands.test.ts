/** The wire in hand: by mouse, by finger and by keys, and back. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Locator, Page } from "playwright-core";
import { expect, it } from "vitest";
import { settled, shoot, visit } from "./browser";
import { dropFiles } from "./gestures";
import { openSite } from "./site";

const { browser, site } = await openSite();

/** Ten control points, as a file: a lesson's. */
const LOOP = { name: "loop.wire.json", buffer: readFileSync(join(import.meta.dirname, "../../lessons/spline/loop.wire.json")) };

async function inHand(options = {}): Promise<{ page: Page; panel: Locator; faults: readonly string[] }> {
  const { page, faults } = await visit(browser, site.url, options);
  await settled(page);
  await dropFiles(page, page.locator("wire-stage"), [LOOP]);
  await expect.poll(() => points(page), { timeout: 30_000 }).toBe(10);
  await page.locator("wire-stage").getByRole("button", { name: "Front" }).click();
  await page.getByRole("button", { name: "Hands on" }).click();
  const panel = page.locator("hands-panel");
  await panel.locator("#point").waitFor();
  await page.waitForTimeout(800);
  return { page, panel, faults };
}

type Shape = { controlPoints: Float32Array };
const points = (page: Page): Promise<number> => page.locator("wire-stage").evaluate((stage) => ((stage as unknown as { wire: Shape | null }).wire?.controlPoints.length ?? 0) / 4);
const place = (panel: Locator): Promise<string[]> => Promise.all(["x", "y", "z", "width"].map((name) => panel.locator(`#${name}`).inputValue()));

/** Chooses a point by its number. */
async function hold(page: Page, panel: Locator, number: number): Promise<void> {
  await panel.locator("#point").fill(String(number));
  await panel.locator("#point").press("Tab");
  const x = await page.locator("wire-stage").evaluate((stage, index) => (stage as unknown as { wire: Shape }).wire.controlPoints[4 * index]!.toFixed(3), number - 1);
  await expect.poll(() => panel.locator("#x").inputValue()).toBe(x);
}

/** Where a control point is seen, CSS pixels of the page. */
const seen = (page: Page, index: number): Promise<{ x: number; y: number }> =>
  page.locator("wire-stage").evaluate((element, index) => {
    const stage = element as unknown as { wire: Shape; clipFromWorld(width: number, height: number): number[]; shadowRoot: ShadowRoot };
    const { left, top, width, height } = stage.shadowRoot.querySelector("canvas.over")!.getBoundingClientRect();
    const clip = stage.clipFromWorld(width, height);
    const [x, y, z] = stage.wire.controlPoints.slice(4 * index, 4 * index + 3) as unknown as [number, number, number];
    const row = (k: number): number => clip[k]! * x + clip[k + 4]! * y + clip[k + 8]! * z + clip[k + 12]!;
    return { x: left + ((1 + row(0) / row(3)) * width) / 2, y: top + ((1 - row(1) / row(3)) * height) / 2 };
  }, index);

it("drags a point in the picture's plane, and undo takes it back in one step", async () => {
  const { page, panel, faults } = await inHand();
  const { x, y } = await seen(page, 3);
  await hold(page, panel, 4);
  const [, , deep] = await place(panel);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 5; k++) await page.mouse.move(x + 12 * k, y - 8 * k);
  await page.mouse.up();
  await expect.poll(() => panel.locator("#point").inputValue()).toBe("4");
  const undo = page.locator("top-bar").getByRole("button", { name: "Undo: Move point 4" });
  await undo.waitFor();
  const after = await seen(page, 3);
  expect(Math.hypot(after.x - x - 60, after.y - y + 40)).toBeLessThan(2);
  // Seen from the front it stays as deep as it was.
  expect((await place(panel))[2]).toBe(deep);
  await shoot(page, "hands-dragged");
  await undo.click();
  await expect.poll(async () => Math.hypot((await seen(page, 3)).x - x, (await seen(page, 3)).y - y)).toBeLessThan(0.5);
  // Beside the points the camera turns.
  const azimuth = (): Promise<number> => page.locator("wire-stage").evaluate((stage) => (stage as unknown as { getState(): { camera: { azimuth: number } } }).getState().camera.azimuth);
  const before = await azimuth();
  const box = (await page.locator("wire-stage").boundingBox())!;
  await page.mouse.move(box.x + 40, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 120, box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  await expect.poll(azimuth).not.toBe(before);
  expect(faults).toEqual([]);
  await page.context().close();
});

it("does all of it by keys and numbers: chooses, moves, inserts, takes away, smooths, straightens", async () => {
  const { page, panel, faults } = await inHand();
  const said = panel.getByRole("status");
  await hold(page, panel, 5);
  const [x] = await place(panel);
  await panel.locator("#x").focus();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Tab");
  await expect.poll(async () => Number((await place(panel))[0])).toBeCloseTo(Number(x) + 0.01, 3);
  await panel.locator("#insert").press("Enter");
  await expect.poll(() => said.textContent()).toContain("the curve is where it was");
  expect(await points(page)).toBe(11);
  await panel.locator("#remove").press("Enter");
  await expect.poll(() => said.textContent()).toContain("moved by 0.000");
  expect(await points(page)).toBe(10);
  await hold(page, panel, 2);
  await panel.locator("#end").fill("7");
  await panel.locator("#end").press("Tab");
  await panel.locator("#smooth").press("Enter");
  await expect.poll(() => said.textContent()).toContain("bends less");
  await panel.locator("#straighten").press("Enter");
  await expect.poll(() => said.textContent()).toContain("straight");
  // A wire that is edited is a wire: it has a link, and comes back after a reload.
  await page.waitForTimeout(1000);
  await page.reload();
  await expect.poll(() => points(page), { timeout: 30_000 }).toBe(10);
  // An end may not go, and that is said.
  await page.keyboard.press("e");
  await panel.locator("#point").waitFor();
  await hold(page, panel, 1);
  await panel.locator("#remove").click();
  await page.getByText("holds an end").waitFor();
  expect(faults).toEqual([]);
  await page.context().close();
});

it("fits a phone, and a finger drags a point there", async () => {
  const { page, panel, faults } = await inHand({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  expect(overflow).toBeLessThanOrEqual(0);
  const small = await panel.evaluate((element) => [...element.shadowRoot!.querySelectorAll("button, input")].filter((control) => control.getBoundingClientRect().height < 44).map((control) => control.outerHTML));
  expect(small).toEqual([]);
  const { x, y } = await seen(page, 5);
  const tools = await page.context().newCDPSession(page);
  const touch = (type: "touchStart" | "touchMove" | "touchEnd", dx: number) => tools.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x: x + dx, y }] });
  await touch("touchStart", 0);
  for (const dx of [6, 14, 24]) await touch("touchMove", dx);
  await touch("touchEnd", 24);
  await expect.poll(() => panel.locator("#point").inputValue()).toBe("6");
  await expect.poll(async () => (await seen(page, 5)).x - x).toBeGreaterThan(15);
  await shoot(page, "hands-phone");
  expect(faults).toEqual([]);
  await page.context().close();
});
