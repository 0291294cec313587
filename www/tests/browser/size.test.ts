/** What travels to a person stays within its budgets; `cargo xtask budget` measures these and the slower ones. */

import { expect, it } from "vitest";
import { firstView, FIRST_VIEW_KB, MESH_KB, FILES_KB, RUNTIME_KB, runtimeBytes, STAGE_KB, stageBytes, total, WASM_KB, wasmBytes } from "../budget/sizes";

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
});

it("the runtimes for networks", () => {
  for (const name of ["ort.wasm", "ort.webgpu"] as const) expect(runtimeBytes(name)).toBeLessThanOrEqual(1000 * RUNTIME_KB[name]);
});

it("the stage alone", async () => {
  expect(await stageBytes()).toBeLessThanOrEqual(1000 * STAGE_KB);
});
