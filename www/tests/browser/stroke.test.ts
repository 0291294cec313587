/** One picture to a wire that turns, as people make one: from a picture to a comparison, and everything back after a reload. */

import { join } from "node:path";
import type { Locator, Page } from "playwright-core";
import { expect, it } from "vitest";
import { inBothColours, inspect } from "./a11y";
import { choose, contextWithProfile, figure, idle, openPart, phase, requestsElsewhere, ROOT, runButton, shoot, visit } from "./browser";
import { drawStroke, dropFiles } from "./gestures";
import { inkOn, padsReady } from "./pads";
import { openSite } from "./site";

const STROKES = join(ROOT, "tests/strokes");

const { browser, site } = await openSite("/some/where/");

const job = (page: Page, name: "Three views" | "One picture") => page.getByRole("tab", { name });
const pad = (page: Page) => page.locator("subject-pad");
const verdict = (page: Page) => page.locator("result-panel .verdict").textContent();
const comparison = (page: Page) => page.locator("wire-comparison");

/** Turns to the second job, whose example is then there. */
async function toOnePicture(page: Page): Promise<void> {
  await job(page, "One picture").click();
  await pad(page).getByRole("button", { name: "Mark", exact: true }).waitFor();
  await page.getByText(/goes on round the back/).waitFor({ state: "attached" });
}

/** Puts a picture on the emptied pad and waits until its object is found. */
async function give(page: Page, file: string): Promise<void> {
  await page.getByRole("button", { name: "Use your own" }).click();
  await pad(page).getByText("Drop, paste or choose one picture").waitFor();
  await dropFiles(page, pad(page), [join(STROKES, file)]);
  await pad(page).locator(`subject-canvas[name*="${file}, its object in colour"]`).waitFor();
}

/** Settings that are quick on a slow machine. */
async function quick(page: Page, iterations = "30"): Promise<void> {
  await openPart(page, "Settings");
  await choose(page, "size", "64");
  await choose(page, "iterations", iterations);
  await openPart(page, "Run");
}

/** What each canvas shows, as a short number; 0 for an empty one. What nobody sees is not painted. */
async function drawn(page: Page, selector: string): Promise<number[]> {
  await page.locator(selector).first().scrollIntoViewIfNeeded();
  return page.locator(selector).evaluateAll((canvases) =>
    (canvases as HTMLCanvasElement[]).map((canvas) => {
      const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
      let [hash, ink] = [7, 0];
      for (let i = 3; i < data.length; i += 4) {
        hash = (31 * hash + data[i]!) | 0;
        ink += data[i]!;
      }
      return ink === 0 ? 0 : hash;
    }),
  );
}

/** All of them are drawn, and no two alike. */
async function allDiffer(page: Page, selector: string, count: number): Promise<void> {
  await expect
    .poll(async () => {
      const shown = await drawn(page, selector);
      return shown.includes(0) ? 0 : new Set(shown).size;
    }, { timeout: 30_000 })
    .toBe(count);
}

it("makes a wire of a picture, shows it from all sides, compares it with loose strokes, and brings all of it back", async () => {
  const context = await contextWithProfile(browser, { viewport: { width: 1440, height: 900 } });
  const visited = await visit(context, site.url);
  const { page } = visited;
  await padsReady(page);
  await toOnePicture(page);
  await allDiffer(page, "turned-views canvas", 6);
  const ofTheExample = await drawn(page, "turned-views canvas");
  await give(page, "face.png");
  await quick(page);
  await runButton(page).click();
  await phase(page, "running");
  await idle(page);
  const said = await verdict(page);
  expect(said).toMatch(/^\s*The front (matches well|does not match)/);
  expect(parseInt((await page.locator("[data-view=front]").textContent())!)).toBeGreaterThan(50);
  await expect.poll(() => figure(page, "Pieces")).toBe("1");
  await expect.poll(() => drawn(page, "turned-views canvas")).not.toEqual(ofTheExample);
  await allDiffer(page, "turned-views canvas", 6);

  // To look from one of them takes the camera off its named views.
  await page.locator("turned-views").getByRole("button", { name: /Back/i }).click();
  await expect.poll(() => page.locator("wire-stage [aria-pressed=true]").filter({ hasText: /Room|Front|Side|Top/i }).count()).toBe(0);

  await comparison(page).getByRole("button", { name: "Compare with loose strokes" }).click();
  await expect.poll(() => page.locator("run-panel p").textContent(), { timeout: 60_000 }).toMatch(/Loose strokes/);
  await comparison(page).locator("table").waitFor({ timeout: 150_000 });
  await idle(page);
  await allDiffer(page, "wire-comparison canvas", 4);
  const cells = async (row: string) => comparison(page).locator("tr", { has: page.getByRole("rowheader", { name: row }) }).locator("td").allTextContents();
  const [one, many] = await cells("Pieces");
  expect(one).toBe("1");
  expect(parseInt(many!.replace(",", ""))).toBeGreaterThan(1);
  await expect.poll(() => comparison(page).locator("p").textContent()).toMatch(/Loose strokes fall into .* the wire is one\./);
  const [mine, theirs] = (await cells("Points")).map((text) => parseInt(text.replace(",", "")));
  // Whole strokes of four points each.
  expect(mine! - theirs!).toBeGreaterThanOrEqual(0);
  expect(mine! - theirs!).toBeLessThan(4);
  await comparison(page).scrollIntoViewIfNeeded();
  await shoot(page, "stroke-compared");
  // The wire is on the stage again, and it is what is measured.
  await expect.poll(() => verdict(page)).toBe(said);
  await expect.poll(() => page.locator("time-line .marks li").count()).toBeGreaterThan(0);

  await page.waitForTimeout(600);
  await page.reload();
  await idle(page);
  await comparison(page).locator("table").waitFor();
  await expect.poll(() => job(page, "One picture").getAttribute("aria-selected")).toBe("true");
  await expect.poll(() => pad(page).locator("subject-canvas").getAttribute("name")).toContain("face.png, its object in colour");
  await expect.poll(() => verdict(page)).toBe(said);
  await expect.poll(() => cells("Pieces")).toEqual([one, many]);
  await allDiffer(page, "wire-comparison canvas", 4);
  await allDiffer(page, "turned-views canvas", 6);
  // The other tab was never touched: it has its example.
  await job(page, "Three views").click();
  await page.getByText(/Three pictures in one wire/).waitFor();
  expect(visited.faults).toEqual([]);
  expect(requestsElsewhere(visited)).toEqual([]);
  await context.close();
});

it("goes on while the other tab is looked at, and loses nothing of either", async () => {
  const { page, faults } = await visit(browser, site.url, { viewport: { width: 1440, height: 900 } });
  await padsReady(page);
  const views = await page.locator("[data-view]").count();
  await toOnePicture(page);
  await quick(page, "3000");
  await runButton(page).click();
  await phase(page, "running");
  await job(page, "Three views").click();
  await page.getByText(/Three views|One picture: /).first().waitFor();
  await expect.poll(() => page.locator("run-panel p").textContent()).toMatch(/^\s*One picture: /);
  await expect.poll(() => page.locator("[data-view]").count()).toBe(views);
  await expect.poll(() => page.locator("drawing-pad").count()).toBe(3);
  // Its wire is on the stage, with its numbers.
  expect(parseInt((await page.locator("[data-view=front]").textContent())!)).toBeGreaterThan(50);
  await page.getByText(/Three pictures in one wire/).waitFor();
  // It can be steered from here.
  await page.getByRole("button", { name: "Pause" }).click();
  await phase(page, "paused");
  await job(page, "One picture").click();
  await page.getByRole("button", { name: "Go on", exact: true }).click();
  await phase(page, "running");
  await job(page, "Three views").click();
  await page.getByRole("button", { name: "Stop" }).click();
  await idle(page);
  await page.getByText(/Three pictures in one wire/).waitFor();
  await job(page, "One picture").click();
  await expect.poll(() => verdict(page)).toMatch(/front|wire is in/i);
  await expect.poll(() => page.locator("time-line input[type=range]").count()).toBe(1);
  // Undo goes over both, and shows where it does.
  await page.getByRole("button", { name: "Undo: Make the wire" }).waitFor();
  await job(page, "Three views").click();
  await choose(page, "preset", "fast");
  await job(page, "One picture").click();
  await page.getByRole("button", { name: "Undo: Set preset" }).click();
  await expect.poll(() => job(page, "Three views").getAttribute("aria-selected")).toBe("true");
  await page.getByRole("button", { name: "Undo: Make the wire" }).click();
  await expect.poll(() => job(page, "One picture").getAttribute("aria-selected")).toBe("true");
  await page.getByText(/goes on round the back/).waitFor();
  await page.getByRole("button", { name: "Redo: Make the wire" }).click();
  await expect.poll(() => verdict(page)).toMatch(/front|wire is in/i);
  expect(faults).toEqual([]);
  await page.context().close();
});

it("carries the job, the wire and its settings in a link", async () => {
  const { page, faults } = await visit(browser, site.url);
  await padsReady(page);
  await toOnePicture(page);
  await choose(page, "seed", "7");
  await expect.poll(() => new URL(page.url()).hash).toBe("#v=1&job=stroke&seed=7");
  await page.getByRole("button", { name: "Share" }).click();
  await expect.poll(() => new URL(page.url()).hash).toMatch(/^#v=1&job=stroke&w=[\w-]{1000,}&seed=7$/);
  const link = page.url();
  expect(faults).toEqual([]);
  await page.context().close();
  const { page: other, faults: otherFaults } = await visit(browser, link);
  await expect.poll(() => job(other, "One picture").getAttribute("aria-selected")).toBe("true");
  await allDiffer(other, "turned-views canvas", 6);
  await expect.poll(() => verdict(other), { timeout: 60_000 }).toMatch(/One piece of wire/);
  await choose(other, "seed", "8");
  await expect.poll(() => new URL(other.url()).hash).toMatch(/&seed=8$/);
  expect(otherFaults).toEqual([]);
  await other.context().close();
});

it("brings back what was kept before there was a second job, and its run that was cut off", async () => {
  const context = await contextWithProfile(browser);
  const { page: before } = await visit(context, `${site.url}icon.svg`);
  await before.evaluate(async () => {
    const request = indexedDB.open("wire4d", 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore("document");
      request.result.createObjectStore("run");
      request.result.createObjectStore("snapshots", { keyPath: "iteration" });
    };
    await new Promise((resolve) => (request.onsuccess = resolve));
    const transaction = request.result.transaction(["document", "run"], "readwrite");
    const bar = (from: number): Uint8Array => new Uint8Array(512 * 512).map((_, i) => (i % 512 >= from && i % 512 < from + 60 && i > 512 * 100 && i < 512 * 400 ? 255 : 0));
    const paper = (label: string, from: number) => ({ label, layers: [{ kind: "stamp", label, ink: bar(from) }] });
    const [front, side] = [paper("Left", 180), paper("Right", 260)];
    const parts = { front, side, top: null, settings: { seed: "5", preset: "fast" }, made: null };
    for (const [name, part] of Object.entries(parts)) transaction.objectStore("document").put(part, name);
    const sheets = [{ slot: "front", paper: front }, { slot: "side", paper: side }];
    transaction.objectStore("run").put({ sheets, settings: parts.settings, iterations: 0, losses: [], events: [] }, "now");
    await new Promise((resolve) => (transaction.oncomplete = resolve));
    request.result.close();
  });
  await before.close();
  const { page, faults } = await visit(context, site.url);
  await page.getByText("A run was cut off before its first wire.").waitFor();
  await expect.poll(() => job(page, "Three views").getAttribute("aria-selected")).toBe("true");
  await expect.poll(() => inkOn(page, 0)).toBeGreaterThan(0.02);
  await expect.poll(() => inkOn(page, 1)).toBeGreaterThan(0.02);
  await page.getByRole("button", { name: "Go on", exact: true }).click();
  await phase(page, "running");
  await idle(page);
  await page.getByText(/views? match|matches/).first().waitFor();
  await expect.poll(() => page.locator("input[type=radio][name=preset][value=fast]").isChecked()).toBe(true);
  await job(page, "One picture").click();
  await page.getByText(/goes on round the back/).waitFor();
  expect(faults).toEqual([]);
  await context.close();
});

it("does it all by keys", async () => {
  const { page, faults } = await visit(browser, site.url, { viewport: { width: 1440, height: 900 } });
  await padsReady(page);
  const focused = () =>
    page.evaluate(() => {
      let at = document.activeElement;
      while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
      return `${at?.id ?? ""} ${at?.className ?? ""} ${at?.getAttribute("aria-label") ?? ""} ${at?.textContent?.trim() ?? ""}`;
    });
  const tabTo = async (what: RegExp, key = "Tab") => {
    for (let i = 0; i < 80 && !what.test(await focused()); i++) await page.keyboard.press(key);
    await expect.poll(() => focused()).toMatch(what);
  };
  await tabTo(/tab-multiview/);
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => focused()).toMatch(/tab-stroke/);
  await pad(page).getByRole("button", { name: "Mark", exact: true }).waitFor();
  await page.getByText(/goes on round the back/).waitFor();
  await tabTo(/Use your own/);
  await page.keyboard.press("Enter");
  // The focus is where the picture is to come from.
  await expect.poll(focused).toMatch(/Choose picture/);
  await tabTo(/Try the key/);
  await page.keyboard.press("Enter");
  await pad(page).locator('subject-canvas[name*="Key, its object in colour"]').waitFor();
  await tabTo(/^auto|auto /);
  await page.keyboard.press("Space");
  await tabTo(/points/);
  const points = () => page.locator("stroke-choices .points").getAttribute("aria-valuetext");
  await page.keyboard.press("Home");
  await expect.poll(points).toBe("40 control points");
  await page.keyboard.press("ArrowRight");
  await expect.poll(points).toBe("50 control points");
  await tabTo(/low/);
  const widths = () => page.locator("stroke-choices two-ended input").evaluateAll((inputs) => inputs.map((input) => (input as HTMLInputElement).value));
  for (const low of ["1.5", "2", "2.5", "3"]) {
    await page.keyboard.press("ArrowRight");
    await expect.poll(widths).toEqual([low, "20"]);
  }
  await tabTo(/constant/, "Shift+Tab");
  await page.keyboard.press("Space");
  await expect.poll(async () => (await widths()).length).toBe(1);
  await quick(page, "3000");
  await page.locator("body").click({ position: { x: 720, y: 20 } });
  await page.keyboard.press("Space");
  await phase(page, "running");
  await page.keyboard.press("Space");
  await phase(page, "paused");
  await tabTo(/Stop/);
  await page.keyboard.press("Enter");
  await idle(page);
  // As few points as were asked for.
  expect(Number(await figure(page, "Control points"))).toBe(50);
  await tabTo(/Look at it: .*back/i);
  await page.keyboard.press("Enter");
  expect(faults).toEqual([]);
  await page.context().close();
});

it("says what is wrong with what it is given, and keeps what was there", async () => {
  const { page, faults } = await visit(browser, site.url);
  await padsReady(page);
  await toOnePicture(page);
  await dropFiles(page, pad(page), [{ name: "notes.png", buffer: Buffer.from("no picture at all") }]);
  await pad(page).getByRole("alert").waitFor();
  await expect.poll(() => pad(page).getByRole("alert").textContent()).toMatch(/notes\.png/i);
  await expect.poll(() => pad(page).locator("subject-canvas").getAttribute("name")).toContain("Mug");
  await dropFiles(page, page.locator("wire-stage"), [join(STROKES, "face.png"), join(STROKES, "pear.png")]);
  await page.locator("notice-list").getByText(/One picture at a time/).waitFor();
  await pad(page).locator('subject-canvas[name*="face.png"]').waitFor();
  await pad(page).getByRole("button", { name: "Clear" }).click();
  await runButton(page).click();
  await page.locator("notice-list").getByText("A wire needs a picture.").waitFor();
  expect(faults).toEqual([]);
  await page.context().close();
});

for (const [width, height] of [[1440, 900], [360, 740]] as const) {
  it(`is free of faults at ${width} px, light and dark`, async () => {
    const { page, faults } = await visit(browser, site.url, { viewport: { width, height }, hasTouch: width < 900 });
    const look = inBothColours((state, colours) => inspect(page, `stroke-${state}-${width}-${colours}`), page);
    await padsReady(page);
    await page.evaluate(() => document.fonts.ready);
    await toOnePicture(page);
    await page.waitForTimeout(500);
    await look("first-visit");
    await openPart(page, "Run");
    await look("choices");
    await quick(page, "20");
    await runButton(page).click();
    await phase(page, "running");
    await idle(page);
    await comparison(page).getByRole("button").click();
    await comparison(page).locator("table").waitFor({ timeout: 150_000 });
    await idle(page);
    await page.locator("turned-views").scrollIntoViewIfNeeded();
    await look("finished");
    await comparison(page).evaluate((element) => element.scrollIntoView({ block: "end" }));
    await page.waitForTimeout(500);
    await look("compared");
    await openPart(page, "Settings");
    await page.locator("settings-panel summary").filter({ hasText: /^\s*Stroke/ }).click();
    await page.locator("setting-control[data-setting=roundness]").scrollIntoViewIfNeeded();
    await look("settings");
    await openPart(page, "Picture");
    await page.getByRole("button", { name: "Start over" }).click();
    await pad(page).getByText("Or try one of these").waitFor();
    await look("empty");
    expect(faults).toEqual([]);
    await page.context().close();
  });
}

it("cuts out what a box is round and marks are on, again at each mark, and takes each back", async () => {
  const { page, faults } = await visit(browser, site.url, { viewport: { width: 1440, height: 900 } });
  await padsReady(page);
  await toOnePicture(page);
  await page.getByRole("button", { name: "Use your own" }).click();
  await dropFiles(page, pad(page), [{ name: "two.png", buffer: await twoThings(page) }]);
  await pad(page).locator(`subject-canvas[name*="two.png"]`).waitFor();
  await pad(page).getByRole("button", { name: "Mark", exact: true }).click();
  const editor = page.locator("mask-editor");
  const frame = editor.locator("subject-canvas .frame");
  const choose = (tool: string) => editor.locator(`input[value=${tool}]`).check({ force: true });
  const left = () => veiledAt(frame, 0.35);
  const right = () => veiledAt(frame, 0.65);
  await choose("box");
  await drawStroke(page, frame, [[0.12, 0.15], [0.88, 0.85]]);
  await editor.getByText("Found, by a box").waitFor();
  await expect.poll(async () => [await left(), await right()]).toEqual([false, false]);
  await choose("not-this");
  await drawStroke(page, frame, [[0.65, 0.4], [0.66, 0.6]]);
  await editor.getByText("by a box and 1 mark").waitFor();
  await expect.poll(async () => [await left(), await right()]).toEqual([false, true]);
  await inspect(page, "stroke-marked");
  await editor.getByRole("button", { name: /^Undo/ }).click();
  await expect.poll(async () => [await left(), await right()]).toEqual([false, false]);
  // The same by keys.
  await frame.focus();
  const down = async (key: string, times: number): Promise<void> => {
    for (let i = 0; i < times; i++) await page.keyboard.press(key);
  };
  await frame.hover({ position: { x: 5, y: 5 } });
  await down("Shift+ArrowRight", 10);
  await down("Shift+ArrowDown", 6);
  await page.keyboard.press("Space");
  await down("ArrowDown", 3);
  await page.keyboard.press("Space");
  await expect.poll(async () => [await left(), await right()]).toEqual([false, true]);
  await editor.getByRole("button", { name: "Clear marks" }).click();
  await expect.poll(async () => [await left(), await right()]).toEqual([false, false]);
  await choose("box");
  await editor.getByRole("button", { name: "Remove the box" }).click();
  await editor.getByText("In colour: what was found").waitFor();
  // All of it painted away is said, with a way on.
  await choose("fine");
  await editor.locator("input[value=remove]").check({ force: true });
  await editor.locator("#width").fill("25");
  for (const y of [0.1, 0.3, 0.5, 0.7, 0.9]) await drawStroke(page, frame, [[0.02, y], [0.98, y]]);
  await editor.getByRole("button", { name: "Done" }).click();
  await runButton(page).click();
  await page.getByText(/shows no object.*paint more of the object/).first().waitFor();
  expect(faults).toEqual([]);
  await page.context().close();
});

/** A red and a blue disc that touch, on a grey ground with grain. */
async function twoThings(page: Page): Promise<Buffer> {
  const base64 = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(480, 360);
    const context = canvas.getContext("2d")!;
    const pixels = context.createImageData(480, 360);
    for (let i = 0; i < pixels.data.length; i += 4) {
      const [x, y] = [(i / 4) % 480, Math.floor(i / 4 / 480)];
      const on = (cx: number): boolean => Math.hypot(x - cx, y - 180) < 74;
      const grain = (x * 7919 + y * 104729) % 23;
      const colour = on(168) ? [170, 50, 40] : on(312) ? [40, 60, 150] : [165, 165, 160];
      pixels.data.set([...colour.map((value) => value + grain), 255], i);
    }
    context.putImageData(pixels, 0, 0);
    const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  });
  return Buffer.from(base64, "base64");
}

/** Whether the picture is veiled at a share of its width, half way down. */
function veiledAt(frame: Locator, x: number): Promise<boolean> {
  return frame.locator("canvas#over").evaluate((element, x) => {
    const canvas = element as HTMLCanvasElement;
    const [alpha] = canvas.getContext("2d")!.getImageData(Math.round(x * canvas.width), Math.round(canvas.height / 2), 1, 1).data.subarray(3);
    return alpha! > 127;
  }, x);
}
