/** How many bytes travel: gzipped as a plain host does it, pictures and fonts as they are. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import type { Page } from "playwright-core";
import { DIST, launch, serveDist, settled, visit, type Sent } from "../browser/browser";
import type { Account, Row } from "./budget";

export const FIRST_VIEW_KB = 200;
/** The main module, which every visit fetches. */
export const WASM_KB = 780;
/** The module that reads mesh files, which is fetched when somebody brings one. */
export const MESH_KB = 165;
/** The module that writes files and simpler links, which is fetched when somebody saves or shares. */
export const FILES_KB = 165;
/** The modules that take photographs, and that plan and write what building takes: each is fetched when it is opened. */
export const PHOTOGRAPH_KB = 140;
export const WORKSHOP_KB = 380;
export const GALLERY_KB = 60;
/** What computes networks from files, a script and a module: on the processor, and on a graphics card. Fetched when one is opened. */
export const RUNTIME_KB = { "ort.wasm": 3_900, "ort.webgpu": 6_800 } as const;
/** `<wire-sculpture>`, in one module. */
export const ELEMENT_KB = 40;

/** Every file but the main wasm that a fresh visit asks for until its wire is shown and nothing more comes; largest first. */
export const firstView = (): Promise<Sent[]> => sentTo("", settled, (file) => !/wire4d_bg-[^/]*\.wasm$/.test(file));

/** The same of the gallery's page, without its posters. */
export const galleryPage = (): Promise<Sent[]> => sentTo("gallery.html", (page) => page.waitForLoadState("networkidle"), (file) => !file.endsWith(".jpg"));

async function sentTo(path: string, done: (page: Page) => Promise<unknown>, counts: (file: string) => boolean): Promise<Sent[]> {
  const site = await serveDist("/");
  const browser = await launch();
  try {
    const { page } = await visit(browser, site.url + path);
    await done(page);
    return site.sent.filter(({ file }) => counts(file)).sort((a, b) => b.bytes - a.bytes);
  } finally {
    await browser.close();
    site.server.close();
  }
}

export function total(sent: readonly Sent[]): number {
  return sent.reduce((sum, { bytes }) => sum + bytes, 0);
}

/** Of the module with that name, gzipped. */
export function wasmBytes(name: "wire4d" | "wire4d_model" | "wire4d_files" | "wire4d_photograph" | "wire4d_workshop"): number {
  const file = readdirSync(join(DIST, "assets")).find((file) => file.startsWith(`${name}_bg-`) && file.endsWith(".wasm"));
  if (!file) throw new Error(`there is no ${name} in ${DIST}; \`cargo xtask build\` makes it`);
  return gzipSync(readFileSync(join(DIST, "assets", file))).length;
}

/** Of one of the two runtimes for networks, gzipped. */
export function runtimeBytes(name: keyof typeof RUNTIME_KB): number {
  const [script, module] = { "ort.wasm": [/^ort\.wasm\./, /^ort-wasm-simd-threaded-/], "ort.webgpu": [/^ort\.webgpu\./, /^ort-wasm-simd-threaded\.asyncify-/] }[name] as [RegExp, RegExp];
  const files = readdirSync(join(DIST, "assets")).filter((file) => script.test(file) || module.test(file));
  if (files.length !== 2) throw new Error(`${name} is not in ${DIST}; \`cargo xtask build\` makes it`);
  return files.reduce((sum, file) => sum + gzipSync(readFileSync(join(DIST, "assets", file))).length, 0);
}

/** The element's module, which somebody else's page embeds. */
export function elementBytes(): number {
  return gzipSync(readFileSync(join(DIST, "wire-sculpture.js"))).length;
}

export async function sizes(): Promise<Account> {
  const sent = await firstView();
  const rows = [
    row("first view without wasm, gzipped", FIRST_VIEW_KB, total(sent)),
    row("wasm, gzipped", WASM_KB, wasmBytes("wire4d")),
    row("wasm for mesh files, gzipped", MESH_KB, wasmBytes("wire4d_model")),
    row("wasm that writes files, gzipped", FILES_KB, wasmBytes("wire4d_files")),
    row("wasm that takes photographs, gzipped", PHOTOGRAPH_KB, wasmBytes("wire4d_photograph")),
    row("wasm for building, gzipped", WORKSHOP_KB, wasmBytes("wire4d_workshop")),
    row("guidance runtime, gzipped, fetched when guidance is switched on", RUNTIME_KB["ort.wasm"], runtimeBytes("ort.wasm")),
    row("the same for a graphics card", RUNTIME_KB["ort.webgpu"], runtimeBytes("ort.webgpu")),
    row("the element, gzipped", ELEMENT_KB, elementBytes()),
    row("the gallery's page without its posters, gzipped", GALLERY_KB, total(await galleryPage())),
  ];
  return { rows, notes: ["First view:", ...sent.map(({ file, bytes }) => `- ${kb(bytes)} ${file}`), ""] };
}

function row(budget: string, limit: number, bytes: number): Row {
  return { budget, limit: `${limit} kB`, measured: kb(bytes), ok: bytes <= 1000 * limit };
}

function kb(bytes: number): string {
  return `${(bytes / 1000).toFixed(1)} kB`;
}
