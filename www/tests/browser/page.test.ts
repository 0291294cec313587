/** The page as a person uses it: from three pictures to a wire, a file and a link. */

import { readFile } from "node:fs/promises";
import { join } from "node:path";
import type { Browser, Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { choose, DRAWINGS, give, launch, padsReady, serveDist, shoot, visit, type Visit } from "./browser";
import { validateGlb } from "./glb";

let browser: Browser;
let site: Awaited<ReturnType<typeof serveDist>>;

beforeAll(async () => {
  browser = await launch();
  // Deep in a subpath: nothing on the page may count on lying at the root.
  site = await serveDist("/some/where/wire4d/");
});
afterAll(async () => {
  await browser.close();
  site.server.close();
});

async function idle(page: Page): Promise<void> {
  await page.locator("p[data-phase=idle]").waitFor({ timeout: 150_000 });
}

async function lossNow(page: Page): Promise<number | null> {
  const text = await page.locator("[data-loss]").getAttribute("data-loss");
  return text ? Number(text) : null;
}

/** Every loss that is shown from now on. */
async function watchLosses(page: Page): Promise<() => Promise<number[]>> {
  const seen = await page.locator("[data-loss]").evaluateHandle((element) => {
    const seen: number[] = [];
    new MutationObserver(() => seen.push(Number(element.getAttribute("data-loss")))).observe(element, { attributes: true });
    return seen;
  });
  return () => seen.evaluate((losses) => losses.filter((loss) => loss > 0));
}

async function downloaded(page: Page, button: string): Promise<Buffer> {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: button }).click()]);
  return readFile(await download.path());
}

describe("a visit", () => {
  let visited: Visit;
  let link: string;
  let controls: number;

  it("starts with three drawings and one clear button", async () => {
    visited = await visit(browser, site.url);
    await padsReady(visited.page);
    expect(await visited.page.getByRole("button", { name: "Run" }).isEnabled()).toBe(true);
    // …and a wire made of them before, which can be taken along.
    await visited.page.getByText("An example, made from these three drawings.").waitFor();
    expect(await visited.page.getByRole("button", { name: "Copy link" }).isEnabled()).toBe(true);
    expect(await visited.page.locator("select[name=preset] option").allTextContents()).toEqual(["Best wire", "Quick sketch", "As in the paper"]);
    await shoot(visited.page, "first-visit");
  });

  it("takes three other pictures, runs, and the loss falls", async () => {
    const { page } = visited;
    for (const [i, side] of ["front", "side", "top"].entries()) await give(page, i, join(DRAWINGS, "t07-outlines", `${side}.png`));
    await choose(page, "preset", "fast");
    const lossesSoFar = await watchLosses(page);
    await page.getByRole("button", { name: "Run" }).click();
    await page.getByRole("button", { name: "Stop" }).waitFor();
    await idle(page);
    const losses = await lossesSoFar();
    await shoot(page, "after-run");
    expect(losses.length).toBeGreaterThan(2);
    expect(Math.min(...losses)).toBeLessThan(0.7 * losses[0]!);
    for (const view of ["front", "side", "top"]) {
      expect(parseInt((await page.locator(`[data-view=${view}]`).textContent())!)).toBeGreaterThan(50);
    }
    expect(await page.locator(".verdict").textContent()).toMatch(/^One piece of wire/);
  });

  it("saves a GLB that the Khronos validator accepts", async () => {
    const glb = await downloaded(visited.page, "GLB");
    const report = await validateGlb(glb);
    expect(report.messages).toEqual([]);
    expect(report.triangles).toBeGreaterThan(1000);
    // The check can fail: the same file with a broken index.
    const broken = Buffer.from(glb);
    broken.writeUInt32LE(0xffff_fff0, broken.length - 8);
    expect((await validateGlb(broken)).errors).toBeGreaterThan(0);
  });

  it("saves the wire.json that the command line reads", async () => {
    const wire = JSON.parse((await downloaded(visited.page, "wire.json")).toString()) as Record<string, unknown>;
    expect(wire["format"]).toBe("wire4d");
    expect(wire["version"]).toBe(1);
    controls = (wire["control_points"] as number[]).length;
    expect((wire["knots"] as number[]).length).toBe(controls + 4);
    expect((wire["views"] as { name: string }[]).map((view) => view.name)).toEqual(["front", "side", "top"]);
  });

  it("makes a link that opens the same wire in a fresh browser", async () => {
    const { page } = visited;
    await page.getByRole("button", { name: "Copy link" }).click();
    await page.waitForURL(/#w=/);
    link = page.url();
    // 2,000 characters for 220 control points.
    expect(link.length - site.url.length).toBeLessThan(200 + (2000 / 220) * controls);
    const other = await visit(browser, link);
    await other.page.getByRole("button", { name: "Copy link" }).and(other.page.locator(":enabled")).waitFor();
    await shoot(other.page, "from-link");
    expect(await other.page.locator(".verdict").textContent()).toContain("from a link");
    const [here, there] = await Promise.all([page, other.page].map(async (p) => JSON.parse((await downloaded(p, "wire.json")).toString())));
    const [a, b] = [here, there].map((wire) => (wire as { control_points: number[][] }).control_points);
    expect(b!.length).toBe(a!.length);
    const off = a!.map((point, i) => Math.hypot(...[0, 1, 2].map((c) => point[c]! - b![i]![c]!)));
    expect(Math.max(...off)).toBeLessThan(0.01);
    expect(other.faults).toEqual([]);
    await other.page.context().close();
  });

  it("asked nobody else for anything, and nothing went wrong", () => {
    const elsewhere = visited.requests.filter((url) => !url.startsWith(site.url) && !url.startsWith("blob:"));
    expect(elsewhere).toEqual([]);
    expect(visited.faults).toEqual([]);
  });

  it("says so when a link is damaged, and still runs", async () => {
    const middle = Math.floor((site.url.length + link.length) / 2);
    const damaged = link.slice(0, middle) + (link[middle] === "A" ? "B" : "A") + link.slice(middle + 1);
    for (const bad of [damaged, link.slice(0, -9), `${site.url}#w=`, `${site.url}#w=${"%00<b>x".repeat(50)}`]) {
      const { page, faults } = await visit(browser, bad);
      const message = page.getByRole("alert");
      await message.waitFor();
      expect(await message.textContent()).toMatch(/[Ss]hare code|[Ll]ink/);
      await padsReady(page);
      expect(await page.getByRole("button", { name: "Run" }).isEnabled()).toBe(true);
      expect(faults).toEqual([]);
      await page.context().close();
    }
  });
});

describe("a run", () => {
  it("pauses, goes on, and stops with what it has", async () => {
    const { page, faults } = await visit(browser, site.url);
    await padsReady(page);
    await page.getByRole("button", { name: "Run" }).click();
    const pause = page.getByRole("button", { name: "Pause" }).and(page.locator(":enabled"));
    await pause.click({ timeout: 120_000 });
    await page.getByText("Paused").waitFor();
    await page.waitForTimeout(300);
    const held = await lossNow(page);
    await page.waitForTimeout(500);
    expect(await lossNow(page)).toBe(held);
    await page.getByRole("button", { name: "Go on" }).click();
    await expect.poll(() => lossNow(page), { timeout: 30_000 }).not.toBe(held);
    await page.getByRole("button", { name: "Stop" }).click();
    await idle(page);
    expect(await page.locator(".verdict").textContent()).toMatch(/wire/);
    expect(await page.getByRole("button", { name: "GLB" }).isEnabled()).toBe(true);
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("can be stopped while the first wire is still sought, keeps the last wire, and starts again", async () => {
    const { page, faults } = await visit(browser, site.url);
    await padsReady(page);
    const hasWire = () => page.getByRole("button", { name: "GLB" }).isEnabled();
    await expect.poll(hasWire, { timeout: 120_000 }).toBe(true);
    await page.getByRole("button", { name: "Run" }).click();
    expect(await hasWire()).toBe(false);
    await page.getByRole("button", { name: "Stop" }).click();
    await idle(page);
    await expect.poll(hasWire, { timeout: 120_000 }).toBe(true);
    await page.getByRole("button", { name: "Run" }).click();
    await page.locator("p[data-phase=running]").waitFor({ timeout: 120_000 });
    expect(faults).toEqual([]);
    await page.context().close();
  });
});
