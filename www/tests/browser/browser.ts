/** The built page on a local server and a Chromium to visit it, for all browser tests. */

import { existsSync, readFileSync } from "node:fs";
import { mkdir } from "node:fs/promises";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize, resolve } from "node:path";
import { gzipSync } from "node:zlib";
import { chromium, type Browser, type BrowserContext, type BrowserContextOptions, type Locator, type Page } from "playwright-core";
import { NARROW } from "../../src/ui/shared/narrow";
import { suffer, type Hardship } from "./hardship";
import { throttle } from "./throttle";

export const ROOT = resolve(import.meta.dirname, "../../..");
/** The built page; the variable DIST names another one. */
export const DIST = process.env["DIST"] ?? join(ROOT, "dist");
export const DRAWINGS = join(ROOT, "tests/drawings");
/** Where screenshots go, to be looked at. */
export const SHOTS = join(ROOT, "target/screenshots");

const TYPES: Readonly<Record<string, string>> = {
  ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm",
  ".png": "image/png", ".svg": "image/svg+xml", ".woff2": "font/woff2", ".webp": "image/webp", ".json": "application/json", ".webmanifest": "application/manifest+json",
};
/** What a host need not compress once more. */
const PACKED = new Set([".png", ".woff2", ".webp"]);

/** One answer of the server: a file of the page and the bytes that its body took. */
export interface Sent {
  readonly file: string;
  readonly bytes: number;
}

export interface Site {
  readonly url: string;
  readonly server: Server;
  readonly sent: Sent[];
}

/** A plain static server that compresses and lets other pages read, as most hosts do; the folder lies under `prefix`, and nothing else is there. */
export async function serveDist(prefix: string, folder = DIST, port = 0): Promise<Site> {
  const sent: Sent[] = [];
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname);
    const inside = path.startsWith(prefix) ? normalize(path.slice(prefix.length)) || "index.html" : "..";
    const name = inside.endsWith("/") || inside === "." ? "index.html" : inside;
    const file = join(folder, name);
    if (inside.startsWith("..") || !existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    const kind = extname(file);
    const packs = !PACKED.has(kind) && /\bgzip\b/.test(String(request.headers["accept-encoding"] ?? ""));
    const body = packs ? gzipSync(readFileSync(file)) : readFileSync(file);
    sent.push({ file: name, bytes: body.length });
    const headers = { "content-type": TYPES[kind] ?? "application/octet-stream", "content-length": body.length, vary: "accept-encoding", "access-control-allow-origin": "*" };
    response.writeHead(200, packs ? { ...headers, "content-encoding": "gzip" } : headers).end(body);
  });
  await new Promise<void>((ready) => server.listen(port, "127.0.0.1", ready));
  return { url: `http://127.0.0.1:${(server.address() as AddressInfo).port}${prefix}`, server, sent };
}

export interface LaunchOptions {
  /** Off: a processor for which the browser refuses every wasm module that uses SIMD, also in workers. */
  readonly simd?: boolean;
  readonly args?: readonly string[];
}

export function launch({ simd = true, args = [] }: LaunchOptions = {}): Promise<Browser> {
  return chromium.launch({
    executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium",
    args: [
      "--no-sandbox", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
      "--disable-background-networking", "--disable-component-update", "--disable-sync",
      ...(simd ? [] : ["--js-flags=--no-enable-sse4-1"]),
      ...args,
    ],
  });
}

/** A page, and what it asks for and what goes wrong in it, written down. */
export interface Visit {
  readonly page: Page;
  readonly url: string;
  readonly requests: string[];
  readonly faults: string[];
}

/** Playwright's choices (viewport, colorScheme, forcedColors, locale, hasTouch…) and ours. */
export interface VisitOptions extends BrowserContextOptions, Hardship {
  /** How many times slower the page's own thread is; workers keep their speed. */
  readonly slower?: number;
}

/** A smallest window that must still do, in CSS pixels. */
export const SMALL = { width: 320, height: 480 } as const;

/** An engine's script that keeps its graphics devices at hand, as `self.devices`. */
export const KEEP_DEVICES = `
  const request = GPUAdapter.prototype.requestDevice;
  GPUAdapter.prototype.requestDevice = async function (...given) {
    const device = await request.apply(this, given);
    (self.devices ??= []).push(device);
    return device;
  };`;

/**
 * A visit with a fresh profile, or with a `contextWithProfile`'s; the latter has its own viewport and colours, so only
 * the hardships and `slower` count then.
 */
export async function visit(where: Browser | BrowserContext, url: string, options: VisitOptions = {}): Promise<Visit> {
  const context = "newContext" in where ? await contextWithProfile(where, options) : where;
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  const requests: string[] = [];
  const faults: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  page.on("websocket", (socket) => requests.push(socket.url()));
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(message.text());
  });
  await suffer(page, options);
  if (options.slower) await throttle(page, options.slower);
  await page.goto(url);
  return { page, url, requests, faults };
}

/** A profile that outlives its pages: what one visit keeps, the next one finds. */
export function contextWithProfile(browser: Browser, options: VisitOptions = {}): Promise<BrowserContext> {
  const { slower: _slower, rightToLeft: _rtl, storage: _storage, webgl2: _webgl2, worker: _worker, webgpu: _webgpu, inEngine: _inEngine, ...known } = options;
  // What a worker of the page's own answers, no test could stand in for.
  return browser.newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", serviceWorkers: "block", ...known });
}

/** What a visit asked of anybody but the folder that the page lies in. */
export function requestsElsewhere({ url, requests }: Visit): string[] {
  const home = new URL(".", url.replace(/[?#].*/, "")).href;
  return requests.filter((asked) => !asked.startsWith(home) && !/^(blob|data):/.test(asked));
}

/** Puts a picture into a pad through its file field. */
export async function give(page: Page, pad: number, file: string | { name: string; mimeType: string; buffer: Buffer }): Promise<void> {
  await page.locator("drawing-pad").nth(pad).locator("input").setInputFiles(file);
}

export function pad(page: Page, index: number): Locator {
  return page.locator("drawing-pad").nth(index);
}

/** Turns a narrow page to a part by its tab; a wide one shows them all. */
export async function openPart(page: Page, name: string): Promise<void> {
  // Nobody finds the tabs by what they are before the page has opened.
  if (await page.evaluate((narrow) => matchMedia(narrow).matches, NARROW)) await page.getByRole("tab", { name, exact: true }).click();
}

/** One of the numbers of the wire that was made. */
export async function figure(page: Page, name: string): Promise<string | null> {
  return page.locator("result-panel dl div", { has: page.getByText(name, { exact: true }) }).locator("dd").textContent();
}

/** Sets a setting: one of the row of radio buttons near Run, or a control of a folded group. */
export async function choose(page: Page, setting: string, value: string): Promise<void> {
  const radio = page.locator(`input[type=radio][name=${setting}][value="${value}"]`);
  const control = page.locator(`setting-control[data-setting=${setting}] #control`);
  // Whoever has just turned to another job sees its settings only when they are there.
  for (const tried = performance.now(); !(await control.count()); await page.waitForTimeout(20)) {
    if (await radio.count()) {
      // Nobody waits for what is forced: the part it is in may just be turning up.
      while (!(await radio.evaluate((element) => element.checkVisibility()))) await page.waitForTimeout(20);
      await radio.check({ force: true });
      return;
    }
    if (performance.now() - tried > 60_000) throw new Error(`There is no setting ${setting} with a choice ${value}.`);
    const folded = page.locator("settings-panel details:not([open]) > summary").first();
    if (await folded.isVisible()) await folded.click();
  }
  await control.waitFor();
  const kind = await control.evaluate((element) => (element as HTMLInputElement).type);
  if (kind === "checkbox") await control.setChecked(value === "on" || value === "true");
  else if (kind === "number") await control.fill(value).then(() => control.press("Tab"));
  else await control.selectOption(value);
}

/** The settings of where a run is computed, unfolded; on a narrow page their tab must be open. */
export async function runSettings(page: Page): Promise<Locator> {
  const setting = page.locator("setting-control[data-setting=backend]");
  await page.locator("settings-panel summary").filter({ hasText: /^\s*Run/ }).click();
  await setting.waitFor();
  return setting;
}

/** The button that starts a run. */
export function runButton(page: Page): Locator {
  return page.getByRole("button", { name: /^\s*(Run|Make it again)\s*$/ });
}

/** Starts a run and waits until it is under way. */
export async function run(page: Page): Promise<void> {
  await runButton(page).click();
  await page.locator("[data-phase]:not([data-phase=idle])").first().waitFor({ state: "attached" });
}

/** Waits until a run is that far. */
export async function phase(page: Page, name: string): Promise<void> {
  await page.locator(`[data-phase=${name}]`).first().waitFor({ state: "attached", timeout: 120_000 });
}

/** Waits until nothing runs. */
export async function idle(page: Page): Promise<void> {
  await page.locator("[data-phase=idle]").first().waitFor({ state: "attached", timeout: 150_000 });
}

/** Waits until a fresh visit has all it asks for and shows its wire. */
export async function settled(page: Page): Promise<void> {
  await idle(page);
  await page.waitForLoadState("networkidle");
  await page.evaluate(() => document.fonts.ready);
  await page.waitForTimeout(1000);
}

export async function shoot(page: Page, name: string): Promise<Buffer> {
  await mkdir(SHOTS, { recursive: true });
  return page.screenshot({ path: join(SHOTS, `${name}.png`) });
}

/** A PNG or JPEG of a size and shade, made in the page itself. */
export async function picture(page: Page, width: number, height: number, paint: "blank" | "full" | "cross", type = "image/png"): Promise<Buffer> {
  const base64 = await page.evaluate(
    async ([width, height, paint, type]) => {
      const canvas = new OffscreenCanvas(width, height);
      const context = canvas.getContext("2d")!;
      context.fillStyle = paint === "full" ? "#000" : "#fff";
      context.fillRect(0, 0, width, height);
      if (paint === "cross") {
        context.lineWidth = Math.max(width, height) / 20;
        context.moveTo(width * 0.1, height * 0.1);
        context.lineTo(width * 0.9, height * 0.9);
        context.moveTo(width * 0.9, height * 0.1);
        context.lineTo(width * 0.1, height * 0.9);
        context.stroke();
      }
      const bytes = new Uint8Array(await (await canvas.convertToBlob({ type })).arrayBuffer());
      let text = "";
      for (const byte of bytes) text += String.fromCharCode(byte);
      return btoa(text);
    },
    [width, height, paint, type] as const,
  );
  return Buffer.from(base64, "base64");
}
