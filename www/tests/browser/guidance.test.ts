/** Networks from files, in the built page's worker: opened, tried, asked, refused and kept. WebGPU is SwiftShader's: right, not fast. */

import { createHash } from "node:crypto";
import { readdirSync, readFileSync } from "node:fs";
import type { RequestListener } from "node:http";
import { join } from "node:path";
import type { Browser, BrowserContext } from "playwright-core";
import { describe, expect, it } from "vitest";
import type { CallName, Calls } from "../../src/engine/protocol";
import { norm } from "../../src/guidance/noise";
import { feedsOf } from "../../src/guidance/selftest";
import { readSidecar } from "../../src/guidance/sidecar";
import { message, withoutWeights } from "../../src/guidance/test-onnx";
import { inspect } from "./a11y";
import { contextWithProfile, DIST, KEEP_DEVICES, requestsElsewhere, ROOT, settled, visit, type VisitOptions } from "./browser";
import { openSite } from "./site";

const FOLDER = join(ROOT, "tests/data/guidance");
const read = (name: string): Buffer => readFileSync(join(FOLDER, name));
const ONNX = read("vit-tiny.onnx");
const SIDECAR = read("vit-tiny.json").toString();
const WORKER = `./assets/${readdirSync(join(DIST, "assets")).find((name) => /^worker-.*\.js$/.test(name))!}`;
/** What is fetched for guidance and for nothing else. */
const RUNTIME = /\/(ort|service)[.-][^/]*$/;

const { browser, site } = await openSite("/", { args: ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"] });

/** The page without its scripts, so that each test has a fast page; what it may do is the same. */
const BARE = readFileSync(join(DIST, "index.html"), "utf8").replace(/<script[^>]*><\/script>|<link rel="modulepreload"[^>]*>/g, "");

/** Models lie on the site; of the one that breaks, half comes; the slow one never ends. */
const [servePage] = site.server.listeners("request") as RequestListener[];
site.server.removeAllListeners("request");
site.server.on("request", (request, response) => {
  const [, name, ending] = /^\/models\/([\w-]+)\.([\w.]+)$/.exec(request.url ?? "") ?? [];
  // To compress it takes longer than all else.
  if (request.url?.endsWith(".wasm")) delete request.headers["accept-encoding"];
  if (request.url === "/bare") return void response.writeHead(200, { "content-type": "text/html" }).end(BARE);
  if (!name) return void servePage!(request, response);
  if (name === "absent") return void response.writeHead(404).end();
  const body = read(`${name === "text-tiny" ? name : "vit-tiny"}.${ending}`);
  if (ending !== "onnx" || name.endsWith("-tiny")) return void response.writeHead(200, { "content-length": body.length }).end(body);
  response.writeHead(200, { "content-length": body.length });
  response.write(body.subarray(0, body.length / 2), () => name === "broken" && setTimeout(() => response.destroy(), 500));
});

type Json = { [key: string]: unknown };
/** Of what goes into a call, arrays of numbers and files, which travel to the page as text and lists. */
const f32 = (numbers: ArrayLike<number>) => ({ f32: Array.from(numbers) });
const u8 = (numbers: ArrayLike<number>) => ({ u8: Array.from(numbers) });
const file = (name: string, bytes: Uint8Array | string) => ({ name, base64: Buffer.from(bytes as Uint8Array).toString("base64") });
const files = (onnx: Uint8Array = ONNX, sidecar = SIDECAR) => ({ files: [file("vit.onnx", onnx), file("vit.json", sidecar)] });
/** A sidecar for other bytes, and whatever else is different. */
const sidecarFor = (onnx: Uint8Array, change: (sidecar: Json) => void = () => undefined): string => {
  const sidecar = { ...(JSON.parse(SIDECAR) as Json), bytes: onnx.length, sha256: createHash("sha256").update(onnx).digest("hex") };
  change(sidecar);
  return JSON.stringify(sidecar);
};
const renamed = (from: string, to: string): Buffer => Buffer.from(ONNX.toString("latin1").replaceAll(from, to), "latin1");
const off = (found: ArrayLike<number>, wanted: ArrayLike<number>): number => norm(Array.from(found, (v, i) => v - wanted[i]!)) / norm(wanted);

/** An engine of its own: calls, and what it told meanwhile. */
async function engine(options: VisitOptions = {}, path = "bare", where: Browser | BrowserContext = browser) {
  const visited = await visit(where, site.url + path, options);
  const { page } = visited;
  await page.evaluate((url) => {
    const worker = new Worker(url, { type: "module", name: "tried" });
    const waiting = new Map<number, (message: Json) => void>();
    const news: string[] = [];
    worker.onmessage = ({ data }: MessageEvent<Json>) => ("news" in data ? news.push(data["words"] as string) : waiting.get(data["id"] as number)!(data));
    let id = 0;
    const call = (request: Json): Promise<Json> =>
      new Promise((resolve) => {
        waiting.set(++id, resolve);
        worker.postMessage({ id, ...request });
      });
    Object.assign(window, { engineCall: call, engineNews: news });
  }, WORKER);
  const call = async <K extends CallName>(name: K, given: object): Promise<Calls[K]["answer"]> => {
    const said = await page.evaluate(
      async ([name, given]) => {
        const typed = (value: unknown): unknown => {
          if (typeof value !== "object" || value === null) return value;
          if (Array.isArray(value)) return value.map(typed);
          const { f32, i32, u8, name, base64 } = value as { f32?: number[]; i32?: number[]; u8?: number[]; name?: string; base64?: string };
          if (f32) return Float32Array.from(f32);
          if (u8) return Uint8ClampedArray.from(u8);
          if (i32) return Int32Array.from(i32);
          if (base64 !== undefined) return new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name!);
          return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, typed(inner)]));
        };
        const plain = (value: unknown): unknown => {
          if (value instanceof Float32Array || value instanceof Uint8Array || value instanceof Uint8ClampedArray) return Array.from(value);
          if (typeof value !== "object" || value === null) return value;
          return Array.isArray(value) ? value.map(plain) : Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner)]));
        };
        const { engineCall } = window as unknown as { engineCall(request: Json): Promise<Json> };
        return plain(await engineCall({ call: name, ...(typed(given) as Json) })) as { answer: unknown; problem?: string };
      },
      [name, given] as const,
    );
    if (said.problem !== undefined) throw new Error(said.problem);
    return said.answer as Calls[K]["answer"];
  };
  const open = (from: object, { prefer = "wasm", keep = false } = {}) => call("openGuidance", { from, prefer, keep });
  const problem = (asked: Promise<unknown>): Promise<string> => asked.then(() => "", (error: Error) => error.message);
  const news = (): Promise<string[]> => page.evaluate(() => (window as unknown as { engineNews: string[] }).engineNews);
  const own = async () => {
    for (const worker of page.workers()) if ((await worker.evaluate(() => self.name)) === "tried") return worker;
    throw new Error("there is no such worker");
  };
  return { ...visited, call, open, problem, news, own };
}

it("costs a visit nothing until it is asked for", async () => {
  site.sent.length = 0;
  const { page, open, ...visited } = await engine({}, "");
  await settled(page);
  const runtime = () => site.sent.filter(({ file }) => RUNTIME.test(`/${file}`)).length;
  expect(site.sent.length).toBeGreaterThan(20);
  expect(runtime()).toBe(0);
  await expect.poll(() => page.locator("guide-panel").count()).toBe(0);
  await open(files());
  expect(runtime()).toBe(3);
  expect(requestsElsewhere({ page, ...visited })).toEqual([]);
  expect(visited.faults).toEqual([]);
  await page.context().close();
});

describe.each(["wasm", "webgpu"] as const)("on %s", (prefer) => {
  it("answers as Python does", async () => {
    const { page, call, open, news, faults } = await engine();
    const about = await open(files(), { prefer });
    expect(about).toMatchObject({ kind: "guidance-v1", name: "vit-tiny", licence: "made up for tests: as this repository", bytes: ONNX.length, provider: prefer, note: null, unkept: null });
    expect(await news()).toEqual(expect.arrayContaining(["Reading the file…", "Checking the file…", "Fetching the guidance runtime…", "Opening the model…", "Trying the model…"]));
    const { selftest, contract } = readSidecar(SIDECAR, "vit-tiny.json");
    const { arrays } = JSON.parse(read("vit-tiny.expected.json").toString()) as { arrays: { case: string; output: string; at: number }[] };
    const bytes = read("vit-tiny.expected.bin");
    const wanted = new Float32Array(new Uint8Array(bytes).buffer);
    const errors: Record<string, number> = {};
    for (const one of selftest.cases) {
      const inputs = Object.fromEntries(Object.entries(feedsOf(one, contract, selftest.batch)).map(([name, numbers]) => [name, f32(numbers)]));
      const answers = (await call("askGuidance", { question: { kind: "guidance-v1", inputs } })) as unknown as Record<string, number[]>;
      for (const { output, at } of arrays.filter((array) => array.case === one.name)) {
        errors[`${one.name} ${output}`] = off(answers[output]!, wanted.subarray(at, at + answers[output]!.length));
      }
    }
    expect(Object.keys(errors)).toHaveLength(8);
    for (const [what, error] of Object.entries(errors)) expect(error, what).toBeLessThan(1e-4);
    expect(faults).toEqual([]);
    await page.context().close();
  });
});

/** The engine's graphics card computes square roots of its own. */
const MISCOUNTS = `
  const create = GPUDevice.prototype.createShaderModule;
  GPUDevice.prototype.createShaderModule = function ({ code, ...rest }) {
    return create.call(this, { ...rest, code: code.replace(/\\b(inverseSqrt|sqrt)\\(/g, "0.5 * $1(") });
  };`;

it.each([
  ["there is no card", { webgpu: "adapterless" as const }, /^This browser gives no graphics card/],
  ["the card computes wrongly", { inEngine: MISCOUNTS }, /^The graphics card cannot be used for it.*“vit\.onnx” fails its self-test/],
  ["the card gives no device", { inEngine: `GPUAdapter.prototype.requestDevice = async () => { throw new Error("no device today"); };` }, /^This browser gives no graphics card/],
])("uses the processor where %s", async (_, options, said) => {
  const { page, open } = await engine(options);
  const { provider, note } = await open(files(), { prefer: "webgpu" });
  expect(provider).toBe("wasm");
  expect(note).toMatch(said);
  await page.context().close();
});

it("says that a card was lost, and opens the model again on another", async () => {
  const { page, call, open, problem, own } = await engine({ inEngine: KEEP_DEVICES });
  const openOnCard = () => open({ files: ["onnx", "json"].map((ending) => file(`text-tiny.${ending}`, read(`text-tiny.${ending}`))) }, { prefer: "webgpu" });
  await openOnCard();
  const ask = (): Promise<unknown> => call("askGuidance", { question: { kind: "text-v1", inputs: { ids: { i32: Array.from({ length: 16 }, (_, i) => i) } } } });
  expect(await problem(ask())).toBe("");
  await (await own()).evaluate(() => (self as unknown as { devices: { destroy(): void }[] }).devices.at(-1)!.destroy());
  expect(await problem(ask())).toMatch(/^“text-tiny” could not be computed \(.*\)\. Open it again/);
  expect((await openOnCard()).provider).toBe("webgpu");
  expect(await problem(ask())).toBe("");
  await page.context().close();
});

it("sees the object where nobody points, and how near things are", async () => {
  const { page, call, open } = await engine();
  const [side, count] = [96, 96 * 96];
  // Coarse grain all over, red in the lower right quarter.
  let state = 7;
  const random = (): number => (state = (state * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
  const grain = Array.from({ length: count / 9 }, random);
  const isRed = (i: number): boolean => i % side >= side / 2 && Math.floor(i / side) >= side / 2;
  const rgba = Array.from({ length: count }, (_, i) => {
    const light = 60 + 150 * grain[Math.floor(Math.floor(i / side) / 3) * (side / 3) + Math.floor((i % side) / 3)]!;
    return isRed(i) ? [Math.min(255, light + 110), light / 3, light / 3, 255] : [light, light, light, 255];
  }).flat();
  const picture = { name: "grain.jpg", width: side, height: side, rgba: u8(rgba) };
  const find = async (key: number) => (await call("find", { key, picture, object: 1, hints: { box: null, marks: [] } }))!;
  const shares = ({ mask, width, height }: { mask: ArrayLike<number>; width: number; height: number }) => {
    const inside = (isThere: (x: number, y: number) => boolean): number => {
      const found = Array.from(mask).filter((_, i) => isThere((i % width) / width, Math.floor(i / width) / height));
      return found.reduce((sum, value) => sum + value / 255, 0) / found.length;
    };
    return [inside((x, y) => x >= 0.53 && y >= 0.53), inside((x, y) => x < 0.47 || y < 0.47)] as const;
  };
  expect(await call("guessDepth", { picture })).toBeNull();
  expect((await find(1)).notes.join()).not.toContain("network");
  const opened = async (name: string) => open({ files: ["onnx", "json"].map((ending) => file(`${name}.${ending}`, read(`${name}.${ending}`))) });
  await opened("mask-tiny");
  const found = await find(2);
  expect(found.notes[0]).toBe("The object is as the network mask-tiny sees it.");
  const [red, rest] = shares(found);
  expect(red).toBeGreaterThan(0.95);
  expect(rest).toBeLessThan(0.05);
  // Whoever points means what they point at.
  const blue = { ...picture, rgba: u8(rgba.map((_, i) => rgba[i % 4 === 3 ? i : i - (i % 4) + 2 - (i % 4)]!)) };
  const unseen = (await call("find", { key: 3, picture: blue, object: 1, hints: { box: null, marks: [] } }))!;
  expect(unseen.notes[0]).toMatch(/The object is found without the network\.$/);
  const pointed = await call("find", { key: 2, picture, object: 1, hints: { box: [36, 36, 92, 92], marks: [] } });
  expect(pointed!.notes.join()).not.toContain("mask-tiny");
  await opened("depth-tiny");
  const near = (await call("guessDepth", { picture }))!;
  expect([near.name, near.width, near.height]).toEqual(["grain.jpg, as depth-tiny sees it", side, side]);
  const [nearRed, nearRest] = shares({ ...near, mask: near.rgba.filter((_, i) => i % 4 === 0) });
  expect(nearRed).toBeGreaterThan(0.9);
  expect(nearRest).toBeLessThan(0.1);
  await page.context().close();
});

it("reads words with a text encoder and its tokenizer", async () => {
  const { page, call, open, problem } = await engine();
  const { texts } = JSON.parse(read("text-tiny.expected.json").toString()) as { texts: { text: string; embedding: number[] }[] };
  const question = { texts: texts.map(({ text }) => text) };
  const [onnx, json, tokenizer] = ["onnx", "json", "tokenizer.json"].map((ending) => file(`text-tiny.${ending}`, read(`text-tiny.${ending}`)));
  await open({ files: [onnx, json] });
  expect(await problem(call("askGuidance", { question }))).toBe("“text-tiny” has no tokenizer, so it cannot read words. Choose its .tokenizer.json together with it.");
  const { tokenizer: longer } = JSON.parse(read("formulas.json").toString()) as { tokenizer: object };
  expect(await problem(open({ files: [onnx, json, file("other.json", JSON.stringify(longer))] }))).toMatch(/^The tokenizer of “text-tiny\.onnx” makes 24 tokens of a text, and it takes 16/);
  await open({ files: [tokenizer, json, onnx] });
  const { embedding } = (await call("askGuidance", { question })) as unknown as { embedding: number[] };
  expect(off(embedding, texts.flatMap(({ embedding }) => embedding))).toBeLessThan(1e-4);
  await page.context().close();
});

describe("what cannot be", async () => {
  const ready = engine();
  const flipped = Buffer.from(ONNX);
  flipped[ONNX.length >> 1]! ^= 1;
  const longer = Buffer.concat([ONNX, Buffer.from(message(14, [...message(1, "key"), ...message(2, "value")]))]);
  // Weights are float32 of the order of 0.1; a stretch of them in the middle becomes NaN.
  const spoilt = Buffer.from(ONNX);
  for (let at = ONNX.length >> 1; at < (ONNX.length >> 1) + 1024; at += 4) spoilt.writeUInt32LE(0x7fc07fc0, at);
  const otherNames = renamed("embedding", "embeddinG");
  const unknown = renamed("MatMul", "MatMuX");
  const CASES: Readonly<Record<string, [object, RegExp]>> = {
    "no model": [{ files: [file("vit.json", SIDECAR)] }, /^There is no model among these files\. Choose the \.onnx/],
    "no sidecar": [{ files: [file("vit.onnx", ONNX)] }, /^“vit\.onnx” lacks its description\. Choose the \.json/],
    "a sidecar that is none": [files(ONNX, "<html>"), /^“vit\.json” cannot be used: it is not JSON\./],
    "no ONNX": [files(Buffer.from("<!doctype html><title>Not found</title>")), /^“vit\.onnx” is not a whole ONNX file/],
    "one that was cut off": [files(ONNX.subarray(0, 60_000)), /^“vit\.onnx” is not a whole ONNX file/],
    "another length": [files(longer), /^“vit\.onnx” has 114 kB and its description says 114 kB: it is damaged|^“vit\.onnx” has .*: it is damaged, or belongs to another \.json/],
    "another checksum": [files(flipped), /^“vit\.onnx” is not the file that its description is of \(their checksums differ\)/],
    "other names": [files(otherNames, sidecarFor(otherNames)), /^“vit\.onnx” is not what its description says\. The output embedding\[batch, 16\] float32 is missing\. Export it again/],
    "other shapes": [
      files(ONNX, sidecarFor(ONNX, (sidecar) => Object.assign(sidecar, JSON.parse(JSON.stringify(sidecar).replaceAll('"batch",3,32,32', '"batch",3,64,64')), { size: 64 }))),
      /^“vit\.onnx” is not what its description says\. The input is image\[batch, 3, 32, 32\] float32 and must be image\[batch, 3, 64, 64\] float32\./,
    ],
    "unknown operators": [files(unknown, sidecarFor(unknown)), /^“vit\.onnx” cannot be opened \(.*MatMuX.*\)\. Export it again/],
    "weights that are not finite": [files(spoilt, sidecarFor(spoilt)), /^“vit\.onnx” fails its self-test: in the case “plain” loss has numbers that are not finite\./],
    "a self-test that fails": [
      files(ONNX, sidecarFor(ONNX, (sidecar) => Object.assign(sidecar, JSON.parse(JSON.stringify(sidecar).replace('"l2":0.0472514998', '"l2":0.05'))))),
      /^“vit\.onnx” fails its self-test: in the case “plain” grad has length 0\.04725 and should have 0\.05000/,
    ],
    "weights in another file": [files(withoutWeights(), sidecarFor(withoutWeights())), /^“vit\.onnx” lacks its weights: they lie in another file/],
    "more than the memory": [files(ONNX, sidecarFor(ONNX, (sidecar) => Object.assign(sidecar, { bytes: 1.9e9, weights: "int8" }))), /^“vit\.onnx” needs about 35 GB of memory to be opened, and that is more than a browser can give/],
    "what is not there": [{ url: "http://127.0.0.1:9/models/x.onnx" }, /^“x\.json” lies on another site/],
    "what is not kept": [{ kept: "0".repeat(64) }, /^The model is not kept any more/],
  };
  it.each(Object.entries(CASES))("%s", async (_, [from, said]) => {
    const { open, problem } = await ready;
    expect(await problem(open(from))).toMatch(said);
  });

  it("nothing of it is open, and a good one is then", async () => {
    const { call, open, problem, news, page, faults } = await ready;
    const { selftest, contract } = readSidecar(SIDECAR, "vit-tiny.json");
    const feeds = feedsOf(selftest.cases[0]!, contract, 2);
    const inputs = Object.fromEntries(Object.entries(feeds).map(([name, numbers]) => [name, f32(numbers)])) as Record<"image" | "source" | "target" | "weight", { f32: number[] }>;
    const ask = (change: object = {}) => call("askGuidance", { question: { kind: "guidance-v1", inputs: { ...inputs, ...change } } });
    expect(await problem(ask())).toBe("No guidance-v1 model is open. Open one first.");
    await open(files());
    expect(await problem(ask())).toBe("");
    // It is open: nothing is read again.
    const told = (await news()).length;
    await open(files());
    expect((await news()).length).toBe(told);
    expect(await problem(ask({ image: f32(inputs.image.f32.with(5, NaN)) }))).toMatch(/^“vit-tiny” answered with numbers that are not finite \((loss|grad|cos|embedding)\)\./);
    expect(await problem(ask({ image: f32(inputs.image.f32.slice(1)) }))).toBe("“vit-tiny” was given 6143 numbers as image, which are no whole rows.");
    expect(await problem(ask({ weight: f32([1]) }))).toBe("“vit-tiny” was given inputs of different batches (2, 2, 2, 1).");
    expect(await problem(ask({ weight: { i32: [1, 1] } }))).toBe("“vit-tiny” was not given weight.");
    expect(await problem(ask({ weight: null }))).toBe("“vit-tiny” was not given weight.");
    // Rows are on their own: the second one alone answers the same.
    const both = (await ask()) as unknown as { embedding: number[] };
    const second = Object.fromEntries(Object.entries(inputs).map(([name, { f32: all }]) => [name, f32(all.slice(all.length / 2))]));
    const alone = (await ask(second)) as unknown as { embedding: number[] };
    expect(off(alone.embedding, both.embedding.slice(16))).toBeLessThan(1e-5);
    await call("closeGuidance", {});
    expect(await problem(ask())).toMatch(/^No guidance-v1 model is open/);
    expect(faults.filter((fault) => !/onnxruntime|ERROR_CODE|MatMuX/.test(fault))).toEqual([]);
    await page.context().close();
  });
});

describe("on the way from the site", () => {
  it("comes with its tokenizer, and says what is missing", async () => {
    const { page, open, problem, call } = await engine();
    const at = (name: string) => ({ url: `${site.url}models/${name}.onnx` });
    expect(await call("lookAtGuidance", { from: at("text-tiny") })).toMatchObject({ kind: "text-v1", name: "text-tiny", bytes: 65_369 });
    await open(at("text-tiny"));
    expect(await problem(call("askGuidance", { question: { texts: ["a cat"] } }))).toBe("");
    expect(await problem(open(at("absent")))).toBe("“absent.json” is not there (404). Look at its address.");
    expect(await problem(open(at("broken"), { keep: true }))).toMatch(/^“broken\.onnx” could not be fetched: the connection broke after \d+ kB\. Nothing of it was kept/);
    expect(await call("guidanceShelf", { drop: null })).toEqual([]);
    await page.context().close();
  });

  it("is given up when it is closed meanwhile, and can be asked for again", async () => {
    const { page, open, problem, call, news } = await engine();
    const opening = problem(open({ url: `${site.url}models/slow.onnx` }, { keep: true }));
    await expect.poll(news).toContain("Fetching the model…");
    await call("closeGuidance", {});
    expect(await opening).toBe("The model was not opened, as you asked.");
    expect(await call("guidanceShelf", { drop: null })).toEqual([]);
    expect((await open({ url: `${site.url}models/vit-tiny.onnx` })).name).toBe("vit-tiny");
    await page.context().close();
  });
});

describe("the shelf", () => {
  it("keeps a model for the next visit, until it is dropped", async () => {
    const context = await contextWithProfile(browser);
    const first = await engine({}, "bare", context);
    expect((await first.open(files(), { keep: true })).unkept).toBeNull();
    await first.page.close();
    const { open, call } = await engine({}, "bare", context);
    const [kept, ...others] = await call("guidanceShelf", { drop: null });
    expect(others).toEqual([]);
    expect(kept).toMatchObject({ name: "vit-tiny", bytes: ONNX.length, licence: "made up for tests: as this repository" });
    expect(Math.abs(kept!.date - Date.now())).toBeLessThan(600_000);
    expect((await open({ kept: kept!.sha256 })).name).toBe("vit-tiny");
    expect(await call("guidanceShelf", { drop: kept!.sha256 })).toEqual([]);
    await context.close();
  });

  it.each([
    ["is full", `Cache.prototype.put = async () => { throw new DOMException("full", "QuotaExceededError"); };`, /^“vit\.onnx” is used without being kept, since this browser has no room for 114 kB more\./],
    ["is missing", `Reflect.deleteProperty(WorkerGlobalScope.prototype, "caches");`, /^“vit\.onnx” is used without being kept, since this browser keeps nothing/],
  ])("is done without where it %s", async (_, inEngine, said) => {
    const { page, open, call } = await engine({ inEngine });
    const { name, unkept } = await open(files(), { keep: true });
    expect(name).toBe("vit-tiny");
    expect(unkept).toMatch(said);
    expect(await call("guidanceShelf", { drop: null })).toEqual([]);
    await page.context().close();
  });
});

it("needs no more memory after 64 runs, nor to be opened again", async () => {
  const KEEP_MEMORIES = `
    const { Memory } = WebAssembly;
    self.memories = [];
    WebAssembly.Memory = class extends Memory { constructor(given) { super(given); self.memories.push(this); } };`;
  const { page, call, open, own } = await engine({ inEngine: KEEP_MEMORIES });
  const megabytes = async (): Promise<number> => (await own()).evaluate(() => Math.max(...(self as unknown as { memories: WebAssembly.Memory[] }).memories.map(({ buffer }) => buffer.byteLength)) / 2 ** 20);
  /** 32 pictures each: what stayed of their inputs and gradients would be 50 MB in the end. */
  const ask = (times: number): Promise<void> =>
    page.evaluate(async (times) => {
      const rows = (width: number) => new Float32Array(32 * width).fill(0.5);
      const question = { kind: "guidance-v1", inputs: { image: rows(3 * 32 * 32), source: rows(16), target: rows(16), weight: rows(1) } };
      const { engineCall } = window as unknown as { engineCall(request: Json): Promise<Json> };
      for (let i = 0; i < times; i++) await engineCall({ call: "askGuidance", question });
    }, times);
  await open(files());
  await ask(4);
  const before = await megabytes();
  expect(before).toBeGreaterThan(1);
  await ask(64);
  expect(await megabytes()).toBe(before);
  for (let i = 0; i < 8; i++) {
    await call("closeGuidance", {});
    await open(files());
  }
  expect(await megabytes()).toBe(before);
  await page.context().close();
});

it("says what a model is before it is used, and what there is to do with it", async () => {
  const { page, faults } = await visit(browser, site.url);
  const panel = page.locator("model-shelf");
  await settled(page);
  await page.locator("guide-fold summary").first().click();
  await page.getByText("A network of your own").click();
  const field = panel.locator("input[type=file]");
  const problem = panel.getByRole("alert");
  await field.setInputFiles([{ name: "vit.onnx", mimeType: "", buffer: ONNX }]);
  await expect.poll(() => problem.textContent()).toMatch(/^“vit\.onnx” lacks its description/);
  await field.setInputFiles([{ name: "vit.json", mimeType: "", buffer: Buffer.from(SIDECAR.replace('"vit-tiny"', '"<img src=x onerror=alert(1)>"')) }, { name: "vit.onnx", mimeType: "", buffer: ONNX }]);
  await panel.getByText("<img src=x onerror=alert(1)>").waitFor();
  await field.setInputFiles([{ name: "vit.json", mimeType: "", buffer: Buffer.from(SIDECAR) }, { name: "vit.onnx", mimeType: "", buffer: ONNX }]);
  await panel.getByText("vit-tiny", { exact: true }).waitFor();
  expect((await panel.locator("p").allTextContents()).join(" ")).toMatch(/114 kB, and about 617 kB of memory.*Licence: made up for tests.*From: random numbers, seeded/s);
  await expect.poll(() => problem.count()).toBe(0);
  await panel.scrollIntoViewIfNeeded();
  await inspect(page, "guidance-chosen");
  await panel.getByRole("button", { name: "Open it" }).click();
  await panel.getByText("vit-tiny is open on the processor.").waitFor();
  await panel.getByText(/^Kept on /).waitFor();
  await panel.scrollIntoViewIfNeeded();
  await inspect(page, "guidance-open");
  await expect.poll(() => panel.getByRole("button", { name: "Open vit-tiny" }).isDisabled()).toBe(true);
  await panel.getByRole("button", { name: /^Close/ }).click();
  await panel.getByRole("button", { name: "Open vit-tiny" }).click();
  await panel.getByText("vit-tiny is open on the processor.").waitFor();
  await panel.getByRole("button", { name: "Delete vit-tiny" }).click();
  await expect.poll(() => panel.getByText("Kept in this browser").count()).toBe(0);
  expect(faults).toEqual([]);
  await page.context().close();
});

it("computes on the very card that runs are computed on, and leaves it alone", async () => {
  const { page, call, open, problem, own } = await engine({ inEngine: KEEP_DEVICES });
  const devices = async (): Promise<number> => (await own()).evaluate(() => (self as unknown as { devices: unknown[] }).devices.length);
  expect(await call("place", { backend: "gpu" })).toMatchObject({ backend: "gpu" });
  const before = await devices();
  expect(await open(files(), { prefer: "webgpu" })).toMatchObject({ provider: "webgpu", note: null });
  expect(await devices()).toBe(before);
  const [image, row] = [f32(new Array(3 * 32 * 32).fill(0.5)), f32(new Array(16).fill(0.25))];
  const question = { kind: "guidance-v1", inputs: { image, source: row, target: row, weight: f32([1]) } };
  expect(await problem(call("askGuidance", { question }))).toBe("");
  await call("closeGuidance", {});
  // Still the same one, and it is not lost.
  expect(await call("place", { backend: "gpu" })).toMatchObject({ backend: "gpu" });
  expect(await devices()).toBe(before);
  expect(await open(files(), { prefer: "webgpu" })).toMatchObject({ provider: "webgpu" });
  expect(await devices()).toBe(before);
  await page.context().close();
});

it.each([
  ["eps-tiny", "eps-v1"],
  ["eps-pixels-tiny", "eps-v1"],
  ["vjp-tiny", "vjp-v1"],
])("opens %s on both", async (name, kind) => {
  const { page, open } = await engine();
  for (const prefer of ["wasm", "webgpu"] as const) {
    expect(await open(files(read(`${name}.onnx`), read(`${name}.json`).toString()), { prefer })).toMatchObject({ kind, provider: prefer, note: null });
  }
  await page.context().close();
});
