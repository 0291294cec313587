// Does one fast run in the page's wasm module, outside a browser, and prints the seconds of start and fit.
// Arguments: the module's folder, then `multiview` and NAME WIDTH HEIGHT RGBA_FILE for each picture, or `fill` and a
// shape's and a pattern's word.
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, task, ...given] = process.argv.slice(2);
const wasm = await import(pathToFileURL(join(folder, "wire4d.js")).href);
wasm.initSync({ module: await readFile(join(folder, "wire4d_bg.wasm")) });
const nobody = () => {};

async function multiview(pictures) {
  const drawings = new wasm.DrawingSet();
  for (let i = 0; i < pictures.length; i += 4) {
    const [name, width, height, file] = pictures.slice(i, i + 4);
    const rgba = new Uint8Array(await readFile(file));
    const ink = wasm.read_ink(name, Number(width), Number(height), rgba, "auto", 0).ink();
    drawings.add(name, ink.width, ink.height, ink.bytes());
  }
  return () => wasm.Run.start(drawings, JSON.stringify({ preset: "fast", bend: "none" }), nobody, nobody);
}

function fill([shape, pattern]) {
  const surface = wasm.Surface.built_in(shape);
  surface.set_pattern(pattern);
  return () => wasm.Run.start_fill(surface, JSON.stringify({ preset: "fast" }), nobody, nobody);
}

const start = task === "fill" ? fill(given) : await multiview(given);
const begin = performance.now();
const run = await start();
const middle = performance.now();
while (run.iteration < run.iterations) await run.step(20);
const end = performance.now();
console.log(JSON.stringify({ start_s: (middle - begin) / 1000, optimize_s: (end - middle) / 1000 }));
