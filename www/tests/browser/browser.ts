/** The built page on a local server and a Chromium to visit it, for all browser tests. */

import { createReadStream, existsSync } from "node:fs";
import { mkdir } from "node:fs/promises";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize, resolve } from "node:path";
import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";

const ROOT = resolve(import.meta.dirname, "../../..");
export const DIST = join(ROOT, "dist");
export const DRAWINGS = join(ROOT, "tests/drawings");
/** Where screenshots go, to be looked at. */
export const SHOTS = join(ROOT, "target/screenshots");

const TYPES: Readonly<Record<string, string>> = {
  ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm",
  ".png": "image/png", ".svg": "image/svg+xml", ".woff2": "font/woff2",
};

/** A plain static server, as any host is; everything lies under `prefix`, and nothing else is there. */
export async function serveDist(prefix: string): Promise<{ url: string; server: Server }> {
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname);
    const inside = path.startsWith(prefix) ? normalize(path.slice(prefix.length)) || "index.html" : "..";
    const file = join(DIST, inside.endsWith("/") || inside === "." ? "index.html" : inside);
    if (inside.startsWith("..") || !existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream" });
    createReadStream(file).pipe(response);
  });
  await new Promise<void>((ready) => server.listen(0, "127.0.0.1", ready));
  return { url: `http://127.0.0.1:${(server.address() as AddressInfo).port}${prefix}`, server };
}

export function launch(): Promise<Browser> {
  return chromium.launch({
    executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium",
    args: [
      "--no-sandbox", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
      "--disable-background-networking", "--disable-component-update", "--disable-sync",
    ],
  });
}

/** A page with a fresh profile. What it asks for and what goes wrong in it is written down. */
export interface Visit {
  readonly page: Page;
  readonly requests: string[];
  readonly faults: string[];
}

export async function visit(browser: Browser, url: string, options: BrowserContextOptions = {}): Promise<Visit> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", ...options });
  const page = await context.newPage();
  page.setDefaultTimeout(60_000);
  const requests: string[] = [];
  const faults: string[] = [];
  page.on("request", (request) => requests.push(request.url()));
  page.on("pageerror", (error) => faults.push(String(error)));
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(message.text());
  });
  await page.goto(url);
  return { page, requests, faults };
}

/** Puts a picture into a pad through its file field. */
export async function give(page: Page, pad: number, file: string | { name: string; mimeType: string; buffer: Buffer }): Promise<void> {
  await page.locator("drawing-pad").nth(pad).locator("input").setInputFiles(file);
}

export function pad(page: Page, index: number): ReturnType<Page["locator"]> {
  return page.locator("drawing-pad").nth(index);
}

/** Waits until all three pads hold ink. */
export async function padsReady(page: Page): Promise<void> {
  for (let i = 0; i < 3; i++) await pad(page, i).locator("canvas:not([hidden])").waitFor({ state: "visible" });
}

export async function choose(page: Page, setting: string, value: string): Promise<void> {
  await page.locator(`select[name=${setting}]`).selectOption(value);
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
