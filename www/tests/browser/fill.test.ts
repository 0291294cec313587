/** One wire all over a shape, as people make it: from a shape to a closed wire, and everything back after a reload. */

import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { inBothColours, inspect } from "./a11y";
import { choose, contextWithProfile, figure, idle, openPart, phase, picture, requestsElsewhere, visit } from "./browser";
import { dropFiles } from "./gestures";
import { openSite } from "./site";

const { browser, site } = await openSite("/some/where/");

const shape = (page: Page, name: string) => page.locator(`shape-pad input[value=${name}]`);
const style = (page: Page, name: string) => page.locator(`style-shelf input[value=${name}]`);
const cover = (page: Page) => page.getByRole("button", { name: /^\s*(Cover it|Make it again)\s*$/ });
const verdict = (page: Page) => page.locator("result-panel .verdict").textContent();

/** How the wire would run is shown, as it is set now. */
async function planned(page: Page): Promise<void> {
  // A change is looked at only after a moment.
  await page.waitForTimeout(400);
  await page.locator("fill-choices .laying:not(.busy)").getByText(/Shown as they/).waitFor({ state: "attached", timeout: 60_000 });
}

async function toAShape(page: Page): Promise<void> {
  await page.getByRole("tab", { name: "A shape" }).click();
  await shape(page, "sphere").waitFor({ state: "attached" });
  await page.getByText(/triangles\./).waitFor({ timeout: 60_000 });
}

/** Something to cover that is quick on a slow machine. */
async function quick(page: Page, iterations = "20"): Promise<void> {
  await shape(page, "sphere").check({ force: true });
  await page.locator("fill-choices #curve_spacing").fill("0.16");
  await planned(page);
  await openPart(page, "Run");
  await choose(page, "preset", "fast");
  await openPart(page, "Settings");
  // Smaller pictures have no room for a style.
  await choose(page, "size", "128");
  await choose(page, "iterations", iterations);
  await openPart(page, "Run");
}

/** A box as an OBJ file, so many faces a side. */
function box(): Buffer {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => `v ${i & 1} ${(i >> 1) & 1} ${i >> 2}`);
  const faces = ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"].map((corners) => `f ${corners}`);
  return Buffer.from([...corners, ...faces].join("\n"));
}

it("covers a shape, measures it, saves the closed wire, and brings all of it back", async () => {
  const context = await contextWithProfile(browser, { viewport: { width: 1440, height: 900 }, acceptDownloads: true });
  const visited = await visit(context, site.url);
  const { page } = visited;
  await toAShape(page);
  // Every style has its picture.
  await expect
    .poll(() =>
      page.locator("style-shelf canvas").evaluateAll((canvases) => {
        const shown = (canvases as HTMLCanvasElement[]).map((canvas) => canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height).data.reduce((sum, value, i) => (31 * sum + value * (i % 7)) | 0, 0));
        return new Set(shown).size;
      }),
    )
    .toBe(5);
  await quick(page);
  await style(page, "waves").check({ force: true });
  await cover(page).click();
  await phase(page, "running");
  await idle(page);
  const said = await verdict(page);
  expect(said).toMatch(/No spot is farther from it than \d+\.\d% of the shape’s size/);
  await expect.poll(() => figure(page, "Pieces")).toBe("1");
  expect(parseFloat((await figure(page, "Length"))!)).toBeGreaterThan(20);
  await expect.poll(() => figure(page, "Off the surface, on average")).toMatch(/^\d+\.\d%$/);
  await expect.poll(() => page.locator("covered-views canvas").count()).toBe(5);
  await page.locator("strand-histogram svg").waitFor();
  await expect.poll(() => page.locator("time-line .marks li").count()).toBeGreaterThan(0);
  await page.locator("covered-views").getByRole("button", { name: /left/i }).click();

  // The exports are of a closed wire: its last ring is its first, and nothing is capped.
  const saved = async (name: RegExp) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator("save-panel").getByRole("button", { name }).click()]);
    return readFileSync((await download.path())!);
  };
  await page.locator("save-panel summary").click();
  const wire = JSON.parse((await saved(/^\s*wire\.json/)).toString()) as { closed: boolean; views: { name: string }[] };
  expect(wire.closed).toBe(true);
  expect(wire.views.map(({ name }) => name)).toEqual(["front", "right", "back", "left", "top"]);
  expect((await saved(/^\s*GLB/)).subarray(0, 4).toString()).toBe("glTF");
  const stl = await saved(/^\s*STL/);
  expect(stl.length).toBe(84 + 50 * stl.readUInt32LE(80));
  expect(openEdges(stl)).toBe(0);
  // An SVG has the lines that the stage has.
  const drawn = (await saved(/^\s*SVG/)).toString();
  expect(drawn).toMatch(/<svg/);
  const through = (pressed: boolean) => page.locator("wire-stage").getByRole("button", { name: "Lines on the far side", pressed });
  await through(false).click();
  await through(true).waitFor();
  expect((await saved(/^\s*SVG/)).length).toBeGreaterThan(1.3 * drawn.length);
  await through(true).click();
  await through(false).waitFor();

  // Another spacing shows how it would run, and leaves what was made where it is.
  await page.locator("fill-choices #curve_spacing").fill("0.12");
  await planned(page);
  await expect.poll(() => verdict(page)).toMatch(/another way now/);
  await page.locator("save-panel").getByText(/of the wire that was made last/).waitFor();
  await page.getByRole("button", { name: /^Undo/ }).click();
  await expect.poll(() => verdict(page)).toBe(said);

  // What can only be seen on a new wire is said.
  const laying = page.locator("fill-choices .laying");
  await expect.poll(() => laying.textContent()).not.toMatch(/again/);
  await page.locator("fill-choices #density").fill("0.8");
  await laying.getByText("Cover it again to see that.").waitFor();
  await page.getByRole("button", { name: /^Undo/ }).click();
  await laying.getByText("Cover it again to see that.").waitFor({ state: "detached" });

  await page.waitForTimeout(600);
  await page.reload();
  await idle(page);
  await expect.poll(() => verdict(page), { timeout: 60_000 }).toBe(said);
  await expect.poll(() => shape(page, "sphere").isChecked()).toBe(true);
  await expect.poll(() => style(page, "waves").isChecked()).toBe(true);
  expect(visited.faults).toEqual([]);
  expect(requestsElsewhere(visited)).toEqual([]);
  await context.close();
});

/** Edges of an STL's triangles that are not in two of them. */
function openEdges(stl: Buffer): number {
  const edges = new Map<string, number>();
  for (let at = 84; at < stl.length; at += 50) {
    const corners = [0, 1, 2].map((k) => stl.subarray(at + 12 + 12 * k, at + 24 + 12 * k).toString("hex"));
    for (let k = 0; k < 3; k++) {
      const key = [corners[k]!, corners[(k + 1) % 3]!].toSorted().join();
      edges.set(key, (edges.get(key) ?? 0) + 1);
    }
  }
  return [...edges.values()].filter((count) => count % 2 !== 0).length;
}

it("takes a mesh and a picture of one's own, keeps them, and says what is wrong with others", async () => {
  const context = await contextWithProfile(browser, { viewport: { width: 1440, height: 900 } });
  const { page, faults } = await visit(context, site.url);
  await toAShape(page);
  await dropFiles(page, page.locator("wire-stage"), [{ name: "box.obj", buffer: box() }]);
  await page.locator("shape-pad #open.chosen").getByText("box.obj").waitFor();
  await page.locator("shape-pad").getByText(/^\s*12 triangles/).waitFor();
  await dropFiles(page, page.locator("wire-stage"), [{ name: "cross.png", buffer: await picture(page, 200, 200, "cross") }]);
  await page.locator("style-shelf #own.chosen").getByText("cross.png").waitFor();
  await page.locator("fill-choices #curve_spacing").fill("0.16");
  await planned(page);

  for (const [name, bytes] of [["broken.obj", "v 0 0"], ["empty.stl", ""], ["archive.obj", "PK\u0003\u0004 and so on"], ["scene.blend", "BLENDER"]] as const) {
    await dropFiles(page, page.locator("wire-stage"), [{ name, buffer: Buffer.from(bytes) }]);
    await page.locator("shape-pad").getByRole("alert").getByText(name.split(".")[0]!, { exact: false }).waitFor();
    await page.locator("shape-pad").getByRole("button", { name: "Close this message" }).click();
  }
  await page.locator("shape-pad #open.chosen").getByText("box.obj").waitFor();

  // They come back, and do not travel.
  await page.waitForTimeout(600);
  await page.reload();
  await page.locator("shape-pad #open.chosen").getByText("box.obj").waitFor();
  await page.locator("style-shelf #own.chosen").getByText("cross.png").waitFor();
  await page.locator("shape-pad").getByText(/^\s*12 triangles/).waitFor({ timeout: 60_000 });
  await page.locator("save-panel").getByText(/Your mesh and your picture stay on this device/).waitFor();
  expect(new URL(page.url()).hash).not.toMatch(/shape=|style=/);
  expect(faults).toEqual([]);
  await context.close();
});

it("carries the shape, the style, the wire and its settings in a link", async () => {
  const { page, faults } = await visit(browser, site.url);
  await toAShape(page);
  await quick(page);
  await style(page, "leaves").check({ force: true });
  await expect.poll(() => new URL(page.url()).hash).toMatch(/^#v=1&job=fill&shape=sphere&style=leaves&/);
  await cover(page).click();
  await phase(page, "running");
  await idle(page);
  await page.getByRole("button", { name: "Share" }).click();
  await expect.poll(() => new URL(page.url()).hash).toMatch(/^#v=1&job=fill&shape=sphere&style=leaves&w=[\w-]{300,}&/);
  const link = page.url();
  // One's own wire comes back with all that it came from, though the address is a link to it.
  const marks = () => page.locator("time-line .marks li").count();
  const [said, made] = [await verdict(page), await marks()];
  await page.waitForTimeout(600);
  await page.reload();
  await expect.poll(() => verdict(page), { timeout: 60_000 }).toBe(said);
  await expect.poll(marks).toBe(made);
  expect(page.url()).toBe(link);
  // Another shape is not put into the link beside it.
  await shape(page, "vase").check({ force: true });
  await planned(page);
  await page.getByRole("button", { name: "Share" }).click();
  await expect.poll(() => page.url()).toBe(link);
  expect(faults).toEqual([]);
  await page.context().close();
  const { page: other, faults: otherFaults } = await visit(browser, link);
  await expect.poll(() => other.getByRole("tab", { name: "A shape" }).getAttribute("aria-selected")).toBe("true");
  await expect.poll(() => shape(other, "sphere").isChecked()).toBe(true);
  await expect.poll(() => style(other, "leaves").isChecked()).toBe(true);
  await expect.poll(() => verdict(other), { timeout: 60_000 }).toMatch(/One closed wire/);
  await expect.poll(() => other.locator("fill-choices #curve_spacing").inputValue()).toBe("0.16");
  await expect.poll(() => figure(other, "Pieces")).toBe("1");
  // It stays a link for whoever passes it on.
  expect(other.url()).toBe(link);
  expect(otherFaults).toEqual([]);
  await other.context().close();
});

it("does it all by keys", async () => {
  const { page, faults } = await visit(browser, site.url, { viewport: { width: 1440, height: 900 } });
  const focused = () =>
    page.evaluate(() => {
      let at = document.activeElement;
      while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
      return `${at?.id ?? ""} ${(at as HTMLInputElement | null)?.value ?? ""} ${at?.getAttribute("aria-label") ?? ""} ${at?.textContent?.trim() ?? ""}`;
    });
  const tabTo = async (what: RegExp) => {
    for (let i = 0; i < 80 && !what.test(await focused()); i++) await page.keyboard.press("Tab");
    await expect.poll(() => focused()).toMatch(what);
  };
  await idle(page);
  await tabTo(/tab-multiview/);
  // Both presses fall into one frame: the second must not go by what is drawn.
  await page.evaluate(() => {
    for (let press = 0; press < 2; press++) {
      let at = document.activeElement;
      while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
      at!.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true, composed: true, cancelable: true }));
    }
  });
  await expect.poll(focused).toMatch(/tab-fill/);
  await page.getByText(/triangles\./).waitFor({ timeout: 60_000 });
  await tabTo(/creature/);
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => shape(page, "sphere").isChecked()).toBe(true);
  await tabTo(/petals/);
  await page.keyboard.press("ArrowLeft");
  await expect.poll(() => style(page, "none").isChecked()).toBe(true);
  await tabTo(/curve_spacing/);
  await page.keyboard.press("End");
  await planned(page);
  await tabTo(/density/);
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => page.locator("fill-choices #density").getAttribute("aria-valuetext")).toBe("55% wire");
  await tabTo(/Lines on the far side/);
  await page.keyboard.press("Enter");
  await page.locator("wire-stage").getByRole("button", { name: "Lines on the far side", pressed: true }).waitFor();
  await page.locator("body").click({ position: { x: 720, y: 20 } });
  await page.keyboard.press("2");
  await page.locator("wire-stage").getByRole("button", { name: "Right", exact: true, pressed: true }).waitFor();
  await tabTo(/Cover it/);
  await page.keyboard.press("Enter");
  await phase(page, "running");
  await tabTo(/^\s*Stop/);
  await page.keyboard.press("Enter");
  await idle(page);
  await expect.poll(() => verdict(page)).toMatch(/stopped early/);
  expect(faults).toEqual([]);
  await page.context().close();
});

for (const [width, height] of [[1440, 900], [820, 1180], [360, 740]] as const) {
  it(`is free of faults at ${width} px, light and dark`, async () => {
    const { page, faults } = await visit(browser, site.url, { viewport: { width, height }, hasTouch: width < 900 });
    const look = inBothColours((state, colours) => inspect(page, `fill-${state}-${width}-${colours}`), page);
    await page.evaluate(() => document.fonts.ready);
    await toAShape(page);
    await page.waitForTimeout(4000);
    await look("first-visit");
    await page.locator("fill-choices").scrollIntoViewIfNeeded();
    await look("choices");
    await quick(page);
    await cover(page).click();
    await phase(page, "running");
    await idle(page);
    await page.waitForTimeout(3000);
    await look("finished");
    await page.locator("result-panel").evaluate((element) => element.scrollIntoView({ block: "end" }));
    await look("measured");
    await openPart(page, "Settings");
    await page.locator("settings-panel summary").filter({ hasText: /^\s*Surface/ }).click();
    await page.locator("setting-control[data-setting=surface_pull]").scrollIntoViewIfNeeded();
    await look("settings");
    expect(faults).toEqual([]);
    await page.context().close();
  });
}
