/** The built page's engine alone, without a stage: what it makes of the examples. */

import { readdirSync } from "node:fs";
import { join } from "node:path";
import { DIST } from "./browser";
import { openSite } from "./site";

const asset = (name: string): string => `assets/${readdirSync(join(DIST, "assets")).find((file) => new RegExp(`^${name}-[^.]*\\.(js|webp)$`).test(file))}`;

export interface Order {
  readonly task: "multiview" | "stroke" | "fill";
  /** Pictures of the examples. */
  readonly pictures: readonly string[];
  readonly settings: Readonly<Record<string, string>>;
}

const PICTURES = { multiview: ["front", "side", "top"], stroke: ["front"], fill: [] } as const;

/** The example of a task. */
export function example(task: Order["task"], settings: Order["settings"]): Order {
  return { task, settings, pictures: PICTURES[task].map(asset) };
}

export interface Made {
  readonly code: string;
  /** By how many it was computed, one after the other. */
  readonly workers: readonly number[];
  /** From the first wire to the last. */
  readonly fitS: number;
}

/** A blank page beside the engine; what it makes in a worker that runs `prelude` before all else. */
export async function openEngine() {
  const { browser, site } = await openSite();
  const made = async (order: Order, prelude = ""): Promise<Made> => {
    const page = await browser.newPage();
    await page.route("**/engine.html", (route) => route.fulfill({ contentType: "text/html", body: `<!doctype html><link rel="icon" href="data:,">` }));
    await page.goto(`${site.url}engine.html`);
    const made = await page.evaluate(make, { ...order, prelude, script: `${site.url}${asset("worker")}` });
    await page.close();
    return made;
  };
  return { made };
}

/** In the page. */
async function make({ task, pictures, settings, prelude, script }: Order & { readonly prelude: string; readonly script: string }): Promise<Made> {
  const module = (text: string): string => URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
  const worker = new Worker(module(`import "${module(prelude)}"; import "${script}";`), { type: "module" });
  const workers: number[] = [];
  const at = { first: 0, last: 0 };
  const calls: ((message: { answer?: unknown; problem?: string }) => void)[] = [];
  worker.onmessage = ({ data }) => {
    if (data.news === "place") workers.push(data.place.workers ?? 1);
    if (data.news === "targets") at.first = performance.now();
    if (data.news === "progress") at.last = performance.now();
    if ("id" in data) calls[data.id]!(data);
  };
  const call = <T>(call: string, given: object): Promise<T> =>
    new Promise((resolve, reject) => {
      worker.onerror = ({ message }) => reject(new Error(message));
      const id = calls.push(({ answer, problem }) => (problem ? reject(new Error(problem)) : resolve(answer as T))) - 1;
      worker.postMessage({ id, call, ...given });
    });
  const works = {
    multiview: async () => {
      const drawings = [];
      for (const name of pictures) drawings.push({ name, ...(await call<object>("sheet", { drawing: await (await fetch(name)).blob() })) });
      return { drawings, guided: [] };
    },
    stroke: async () => {
      const bitmap = await createImageBitmap(await (await fetch(pictures[0]!)).blob());
      const { width, height } = bitmap;
      const context = new OffscreenCanvas(width, height).getContext("2d")!;
      context.drawImage(bitmap, 0, 0);
      const picture = { name: "picture", width, height, rgba: context.getImageData(0, 0, width, height).data };
      return { key: 1, picture, mask: null, hints: { box: null, marks: [] }, depth: null };
    },
    fill: async () => ({ mesh: { shape: "creature" }, style: null }),
  };
  const work = await works[task]();
  const { code } = await call<{ code: string }>("run", { task, work, settings, from: null, first: null, guide: null });
  worker.terminate();
  return { code, workers, fitS: (at.last - at.first) / 1000 };
}
