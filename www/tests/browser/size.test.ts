/** What travels to a person stays within its budgets; `cargo xtask budget` measures these and the slower ones. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { ELEMENT_KB, elementBytes, firstView, FIRST_VIEW_KB, GALLERY_KB, galleryPage, FILES_KB, MESH_KB, PHOTOGRAPH_KB, RUNTIME_KB, runtimeBytes, total, WASM_KB, wasmBytes, WORKSHOP_KB } from "../budget/sizes";
import { DIST } from "./browser";

it("a first view without wasm", async () => {
  const sent = await firstView();
  // It was a whole visit: the page, a script, its styles and a font.
  for (const kind of [/\.html$/, /\.js$/, /\.css$/, /\.woff2$/]) expect(sent.some(({ file }) => kind.test(file))).toBe(true);
  expect(total(sent)).toBeLessThanOrEqual(1000 * FIRST_VIEW_KB);
});

it("the wasm modules", () => {
  expect(wasmBytes("wire4d")).toBeLessThanOrEqual(1000 * WASM_KB);
  expect(wasmBytes("wire4d_model")).toBeLessThanOrEqual(1000 * MESH_KB);
  expect(wasmBytes("wire4d_files")).toBeLessThanOrEqual(1000 * FILES_KB);
  expect(wasmBytes("wire4d_photograph")).toBeLessThanOrEqual(1000 * PHOTOGRAPH_KB);
  expect(wasmBytes("wire4d_workshop")).toBeLessThanOrEqual(1000 * WORKSHOP_KB);
});

it("the runtimes for networks", () => {
  for (const name of ["ort.wasm", "ort.webgpu"] as const) expect(runtimeBytes(name)).toBeLessThanOrEqual(1000 * RUNTIME_KB[name]);
});

it("the element, which is one module", () => {
  expect(elementBytes()).toBeLessThanOrEqual(1000 * ELEMENT_KB);
  // It fetches nothing more, in no page and in no worker.
  const module = readFileSync(join(DIST, "wire-sculpture.js"), "utf8");
  expect(module.match(/\bimport\s*\(|\bfrom\s*["']/g)).toBeNull();
});

it("the gallery's page without its posters", async () => {
  const sent = await galleryPage();
  for (const kind of [/\.html$/, /\.js$/, /\.css$/]) expect(sent.some(({ file }) => kind.test(file))).toBe(true);
  expect(total(sent)).toBeLessThanOrEqual(1000 * GALLERY_KB);
});
