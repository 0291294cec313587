/** `<wire-sculpture>` on pages that know nothing of ours. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { BrowserContextOptions, Page } from "playwright-core";
import { expect, it } from "vitest";
import { axeFaults } from "./a11y";
import { launch, ROOT, shoot, visit, type VisitOptions } from "./browser";
import { LEND } from "./colours";
import { copperAt, heard, openForeign, pageWith } from "./foreign";
import { openSite } from "./site";

const { browser, site } = await openSite();
const foreign = await openForeign();
const elsewhere = await openForeign();
const SCRIPT = `${site.url}wire-sculpture.js`;
const CODE = readFileSync(join(ROOT, "www/src/tasks/multiview/example/wire.code"), "utf8").trim();
const OTHER = readFileSync(join(ROOT, "www/src/tasks/stroke/example/wire.code"), "utf8").trim();
const CLOSED = readFileSync(join(ROOT, "tests/wires/knot.json"));

const of = (id: string, attributes: string): string => `<wire-sculpture id="${id}" ${attributes}></wire-sculpture>`;
const open = (path: string, body: string, options: VisitOptions = {}, script = SCRIPT) => visit(browser, foreign.put(path, pageWith(body, script)), options);
const loaded = (page: Page, id: string) => expect.poll(() => heard(page, id), { timeout: 60_000 }).toContain("load");
/** It is there to be seen, and not only said to be. */
const shown = (page: Page, id: string) => expect.poll(() => copperAt(page, `#${id}`), { timeout: 60_000 }).toBeGreaterThan(0.003);
const state = (page: Page, id: string) => page.locator(`#${id}`).evaluate((element) => (element as unknown as { getState(): { view: string | null; camera: { azimuth: number; elevation: number; reach: number } | null } }).getState());
const azimuth = async (page: Page, id: string): Promise<number> => (await state(page, id)).camera?.azimuth ?? NaN;

it("shows three sculptures on another site's page, and lets people turn them", async () => {
  foreign.put("/knot.json", { body: CLOSED, headers: { "content-type": "application/json" } });
  const body = [
    of("first", `code="${CODE}" alt="A cat, a bird and a fish" camera-controls shadow views`),
    of("second", `src="/knot.json" camera-controls camera-orbit="10deg 20deg 120%"`),
    of("third", `code="${site.url}#w=${OTHER}" camera-controls touch-action="none" look="steel" color="rgb(200 110 40)"`),
  ].join("");
  const { page, faults } = await open("/three", body, { hasTouch: true, viewport: { width: 1040, height: 800 } });
  for (const id of ["first", "second", "third"]) {
    await loaded(page, id);
    await shown(page, id);
  }
  // Each is drawn aside, though a page may start no worker from another site's script.
  expect(page.workers().filter((worker) => worker.url().startsWith("blob:")).length).toBe(3);
  expect(await azimuth(page, "second")).toBeCloseTo(10, 3);

  // By mouse: to the left the camera goes to the right.
  const box = (await page.locator("#first").boundingBox())!;
  await page.mouse.move(box.x + 160, box.y + 120);
  await page.mouse.down();
  await page.mouse.move(box.x + 100, box.y + 120, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => azimuth(page, "first")).toBeGreaterThan(55);
  expect((await state(page, "first")).view).toBeNull();
  expect(await heard(page, "first")).toContain("view-change");

  // By a button, and by keys.
  await page.locator("#first").getByRole("button", { name: "Side" }).click();
  await expect.poll(() => page.locator("#first").getByRole("button", { name: "Side", pressed: true }).count()).toBe(1);
  await expect.poll(() => azimuth(page, "first")).toBeCloseTo(90, 3);
  await page.locator("#first").getByRole("application", { name: "A cat, a bird and a fish" }).focus();
  await page.keyboard.press("3");
  await expect.poll(async () => (await state(page, "first")).view).toBe("top");
  await page.keyboard.press("f");
  await expect.poll(async () => (await state(page, "first")).view).toBe("room");
  const before = await azimuth(page, "first");
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => azimuth(page, "first")).not.toBeCloseTo(before, 3);

  // By touch: one finger turns, two zoom.
  const third = (await page.locator("#third").boundingBox())!;
  const { azimuth: from, reach } = (await state(page, "third")).camera!;
  const touch = await page.context().newCDPSession(page);
  const fingers = (type: "touchStart" | "touchMove" | "touchEnd", ...xs: number[]) =>
    touch.send("Input.dispatchTouchEvent", { type, touchPoints: xs.map((x, id) => ({ x: third.x + x, y: third.y + 160, id })) });
  await fingers("touchStart", 100);
  for (const x of [120, 150, 180]) await fingers("touchMove", x);
  await fingers("touchEnd");
  await expect.poll(() => azimuth(page, "third")).toBeLessThan(from - 10);
  await fingers("touchStart", 120, 200);
  for (const spread of [60, 80, 100]) await fingers("touchMove", 160 - spread, 160 + spread);
  await fingers("touchEnd");
  await expect.poll(async () => (await state(page, "third")).camera!.reach).toBeLessThan(0.8 * reach);

  // What is left is found again.
  const moved = await state(page, "third");
  await page.locator("#second").evaluate((element, state) => (element as unknown as { setState(state: unknown): void }).setState(state), moved);
  await expect.poll(() => azimuth(page, "second")).toBeCloseTo(moved.camera!.azimuth, 3);
  await shoot(page, "element-three");
  expect(faults).toEqual([]);
  await page.context().close();
});

it("takes a picture, on its walls or on nothing", async () => {
  const { page } = await open("/picture", of("one", `code="${CODE}" shadow`));
  await loaded(page, "one");
  const corner = (transparent: boolean) =>
    page.locator("#one").evaluate(async (element, transparent) => {
      const blob = await (element as unknown as { toBlob(options: unknown): Promise<Blob> }).toBlob({ width: 90, height: 60, transparent });
      const bitmap = await createImageBitmap(blob);
      const context = new OffscreenCanvas(90, 60).getContext("2d")!;
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, 90, 60);
      const alphas = data.filter((_, at) => at % 4 === 3);
      return [bitmap.width, bitmap.height, Math.min(...alphas), Math.max(...alphas)];
    }, transparent);
  expect(await corner(false)).toEqual([90, 60, 255, 255]);
  await page.locator("#one").evaluate((element) => element.removeAttribute("shadow"));
  expect(await corner(true)).toEqual([90, 60, 0, 255]);
  await page.context().close();
});

it("needs no permission but for its own script", async () => {
  const policy = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'";
  foreign.put("/own/wire-sculpture.js", { body: readFileSync(join(ROOT, "dist/wire-sculpture.js")), headers: { "content-type": "text/javascript" } });
  foreign.put("/knot.json", { body: CLOSED });
  const body = `<!doctype html><html lang="en"><title>Strict</title><script type="module" src="/own/wire-sculpture.js"></script>${of("one", `src="/knot.json" camera-controls controls views="front side"`)}</html>`;
  const { page, faults } = await visit(browser, foreign.put("/strict", { body, headers: { "content-security-policy": policy } }));
  await shown(page, "one");
  expect(page.workers().length).toBe(1);
  // Its style sheet holds.
  expect(await page.locator("#one").evaluate((element) => getComputedStyle(element).display)).toBe("flex");
  await page.locator("#one").getByRole("button", { name: "Front" }).click();
  await expect.poll(async () => (await state(page, "one")).view).toBe("front");
  expect(faults).toEqual([]);
  await page.context().close();
});

it.each([
  ["a page that lets no script of its own make workers", { "content-security-policy": `script-src ${new URL(site.url).origin} 'unsafe-inline'; worker-src 'none'` }, false],
  ["a frame without storage", {}, true],
] as const)("draws on the page's thread in %s", async (name, headers, framed) => {
  const inner = { body: pageWith(of("one", `code="${CODE}"`), SCRIPT), headers: { ...headers, ...(framed ? { "content-security-policy": "worker-src 'none'" } : {}) } };
  const url = foreign.put(framed ? "/framed" : "/workless", inner);
  const outer = framed ? foreign.put("/frame", `<!doctype html><title>Frame</title><iframe sandbox="allow-scripts" src="/framed" width=400 height=460></iframe>`) : url;
  const { page } = await visit(browser, outer);
  await expect.poll(() => copperAt(page, framed ? "iframe" : "#one"), { timeout: 60_000 }).toBeGreaterThan(0.003);
  expect(page.workers().length, name).toBe(0);
  await page.context().close();
});

it("draws as many of fifty as a browser can bear, and shows all of them", async () => {
  const body = Array.from({ length: 50 }, (_, at) => of(`s${at}`, `code="${CODE}" look="${at % 2 ? "copper" : "parameter"}"`)).join("");
  const { page, faults } = await open("/fifty", body, { viewport: { width: 720, height: 720 } });
  const most = async (): Promise<void> => expect(page.workers().length).toBeLessThanOrEqual(8);
  for (let at = 1; at < 50; at += 8) {
    await page.locator(`#s${at}`).scrollIntoViewIfNeeded();
    await shown(page, `s${at}`);
    await most();
  }
  // The first one has given back what it drew on, and is there all the same.
  await page.locator("#s1").scrollIntoViewIfNeeded();
  await shown(page, "s1");
  await most();
  expect(faults).toEqual([]);
  await page.context().close();
});

it("survives the loss of its context", async () => {
  const { page } = await visit(browser, "about:blank");
  await page.addInitScript(`delete HTMLCanvasElement.prototype.transferControlToOffscreen; ${LEND}`);
  await page.goto(foreign.put("/loss", pageWith(of("one", `code="${CODE}"`), SCRIPT)));
  await shown(page, "one");
  await page.evaluate("lent.loseContext()");
  const notice = page.locator("#one .lost");
  await notice.waitFor();
  await page.evaluate("lent.restoreContext()");
  await notice.waitFor({ state: "detached" });
  await shown(page, "one");
  await page.context().close();
});

it("is a drawing where there is no WebGL 2", async () => {
  const { page } = await open("/flat", of("one", `code="${CODE}" views`), { webgl2: false });
  await loaded(page, "one");
  const lines = () => page.locator("#one svg.flat").evaluate((drawing) => [...drawing.querySelectorAll("path")].map((path) => path.getAttribute("d")).join(""));
  const front = await lines();
  expect(front.length).toBeGreaterThan(5000);
  await page.locator("#one").getByRole("button", { name: "Side" }).click();
  await expect.poll(lines).not.toBe(front);
  await shown(page, "one");
  expect(await axeFaults(page)).toEqual([]);
  await shoot(page, "element-flat");
  await page.context().close();
});

it("says in a sentence why there is nothing to show, and harms nothing", async () => {
  const script = `<img src=x onerror="harmed = true">`;
  const wire = { format: "wire4d", version: 1, closed: false, knots: [0, 0, 0, 0, 1, 1, 1, 1], control_points: [[0, 0, 0, 1], [1, 0, 0, 1], [1, 1, 0, 1], [0, 1, 0, 1]], views: [] };
  const json = (path: string, value: unknown): string => foreign.put(path, { body: JSON.stringify(value), headers: { "content-type": "application/json" } });
  foreign.put("/page.html", `<h1>${script}</h1>`);
  foreign.put("/huge.json", { body: Buffer.alloc(17 * 1024 * 1024, " ") });
  json("/newer.json", { ...wire, version: 9 });
  json("/nan.json", { ...wire, control_points: [[0, 0, 0, "1"]] });
  json("/flood.json", { ...wire, closed: script, views: [{ name: script }] });
  json("/views.json", { ...wire, views: [{ name: script, projection: "orthographic", eye: [0, 0, 3], target: [0, 0, 0], up: [0, 1, 0], height_world: 2, width_px: 256, height_px: 256 }] });
  const far = elsewhere.put("/far.json", { body: JSON.stringify(wire) });
  const cases = {
    gone: [`src="/gone.json"`, /not where it should be \(status 404\)/],
    html: [`src="/page.html"`, /holds no wire/],
    huge: [`src="/huge.json"`, /larger than 16 MB/],
    newer: [`src="/newer.json"`, /newer Wire4D/],
    nan: [`src="/nan.json"`, /incomplete/],
    flood: [`src="/flood.json"`, /incomplete/],
    far: [`src="${far}"`, /could not be fetched/],
    scheme: [`src="javascript:harmed=true"`, /could not be fetched/],
    code: [`code="nonsense"`, /damaged or incomplete/],
    words: [`code="${CODE.slice(0, 300)}" labels="{" alt='${script}'`, /damaged or incomplete/],
  } as const;
  const body = Object.entries(cases).map(([id, [attributes]]) => of(id, `${attributes} loading="eager" poster="/icon.svg"`)).join("");
  foreign.put("/icon.svg", { body: readFileSync(join(ROOT, "dist/icon.svg")), headers: { "content-type": "image/svg+xml" } });
  const { page } = await open("/hostile", body + of("fine", `src="/views.json" views loading="eager"`));
  for (const [id, [, sentence]] of Object.entries(cases)) {
    await expect.poll(() => page.locator(`#${id} .message`).textContent(), { message: id }).toMatch(sentence);
    expect(await heard(page, id)).toEqual(expect.arrayContaining(["error"]));
    await page.locator(`#${id} img.poster`).waitFor();
  }
  // The views' names are text, or none at all.
  await loaded(page, "fine");
  expect(await page.evaluate(() => "harmed" in globalThis)).toBe(false);
  await page.getByRole("heading", { name: "Works" }).waitFor();
  await shoot(page, "element-hostile");

  // A better one takes its place.
  await page.locator("#gone").evaluate((element) => ((element as unknown as { src: string }).src = "/views.json"));
  await page.locator("#gone").scrollIntoViewIfNeeded();
  await loaded(page, "gone");
  await expect.poll(() => page.locator("#gone .message").count()).toBe(0);
  await page.context().close();
});

it("waits behind its poster until it is wanted", async () => {
  const poster = `poster="/icon.svg"`;
  foreign.put("/icon.svg", { body: readFileSync(join(ROOT, "dist/icon.svg")), headers: { "content-type": "image/svg+xml" } });
  const { page } = await open("/posters", of("click", `code="${CODE}" ${poster} reveal="interaction"`) + of("script", `code="${OTHER}" ${poster} reveal="manual"`) + `<p style="height: 3000px"></p>` + of("late", `src="/late.json"`));
  await page.locator("#click").getByRole("button", { name: "Show in 3D" }).waitFor();
  await page.waitForTimeout(500);
  expect(page.workers().length).toBe(0);
  await page.locator("#click").getByRole("button", { name: "Show in 3D" }).click();
  await loaded(page, "click");
  await expect.poll(() => page.locator("#click img.poster").isVisible()).toBe(false);
  expect(await page.locator("#script img.poster").isVisible()).toBe(true);
  await page.locator("#script").evaluate((element) => (element as unknown as { dismissPoster(): void }).dismissPoster());
  await loaded(page, "script");
  // What is far below is not fetched.
  expect(await heard(page, "late")).toEqual([]);
  await page.locator("#late").scrollIntoViewIfNeeded();
  await expect.poll(() => heard(page, "late")).toEqual(["error"]);
  await page.context().close();
});

const LOOKS: readonly [string, BrowserContextOptions][] = [
  ["360", { viewport: { width: 360, height: 740 } }],
  ["820", { viewport: { width: 820, height: 1000 }, colorScheme: "dark" }],
  ["1440", { viewport: { width: 1440, height: 900 } }],
  ["forced", { viewport: { width: 820, height: 700 }, forcedColors: "active" }],
];

it.each(LOOKS)("can be used by everybody: %s", async (name, options) => {
  const labels = JSON.stringify({ front: "أمام", side: "جانب", room: "غرفة", top: "فوق" });
  const body = `<style>:root { color-scheme: light dark } main { display: grid; gap: 16px } wire-sculpture { width: 100%; height: 420px }</style>${of("one", `code="${CODE}" alt="A cat" shadow camera-controls controls views`)}${of("two", `code="${OTHER}" dir="rtl" labels='${labels}' views="room front side top"`)}`;
  const { page } = await open(`/everybody-${name}`, body, options);
  await loaded(page, "one");
  expect(await axeFaults(page)).toEqual([]);
  const stage = page.locator("#one").getByRole("application", { name: "A cat" });
  const described = await stage.evaluate((canvas) => canvas.getAttribute("aria-describedby")!.split(" ").map((id) => (canvas.getRootNode() as ShadowRoot).getElementById(id)!.textContent).join(" "));
  expect(described).toMatch(/One wire.*front, side, top.*Seen as a whole.*Arrow keys/);
  await page.locator("#two").getByRole("button", { name: "أمام" }).waitFor();
  await page.keyboard.press("Tab");
  expect(await page.locator("#one .ring").isVisible()).toBe(true);
  await shoot(page, `element-${name}`);
  await page.context().close();
});

it("stands still for people who asked for less motion", async () => {
  const { page } = await open("/still", of("one", `code="${CODE}" auto-rotate`), { reducedMotion: "reduce" });
  await shown(page, "one");
  const at = await azimuth(page, "one");
  await page.waitForTimeout(1200);
  expect(await azimuth(page, "one")).toBe(at);
  await page.context().close();
  const moving = await open("/turning", of("one", `code="${CODE}" auto-rotate`), { reducedMotion: "no-preference" });
  await shown(moving.page, "one");
  await expect.poll(() => azimuth(moving.page, "one")).not.toBe(await azimuth(moving.page, "one"));
  await moving.page.context().close();
});

it("does without a graphics card's interface altogether", async () => {
  const poor = await launch({ args: ["--disable-3d-apis"] });
  const { page } = await visit(poor, foreign.put("/poor", pageWith(of("one", `code="${CODE}"`), SCRIPT)));
  await page.locator("#one svg.flat").waitFor();
  await poor.close();
});
