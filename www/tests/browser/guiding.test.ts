/** A fit guided from JavaScript, without the page: on the processor and on a device that is a program. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { beforeAll, expect, it } from "vitest";
import { ROOT } from "./browser";
import { openCore, type Core } from "./core";

type Guidance = import("../../src/engine/wasm/wire4d").GuidanceFunction;

/** The example of the documentation, as it stands there. */
const EXAMPLE = /```js\n([^]*?)```/.exec(readFileSync(join(ROOT, "src/web/run.rs"), "utf8"))![1]!.replaceAll(/^ *\/\/\/ ?/gm, "");

const { page } = await openCore();

beforeAll(async () => {
  await page.evaluate(() => {
    const { core } = window as unknown as { core: Core };
    const side = 64;
    const drawings = new core.DrawingSet();
    const ring = (_: unknown, i: number) => (Math.abs(Math.hypot((i % side) - 31.5, Math.floor(i / side) - 31.5) - 20) < 3 ? 255 : 0);
    drawings.add("ring", side, side, Uint8Array.from({ length: side * side }, ring));
    drawings.add("again", side, side, Uint8Array.from({ length: side * side }, ring));
    const settings = (backend: string) =>
      JSON.stringify({ backend, preset: "fast", size: "32", iterations: "24", bend: "none", grid: "16", control_points: "24", samples: "2" });
    const none = () => undefined;
    const views = (...names: readonly string[]) => {
      const set = new core.DrawingSet();
      names.forEach((name) => set.guide(name));
      return set;
    };
    const begin = (backend: string, set = drawings) => core.Run.start(set, settings(backend), none, none);
    Object.assign(window, { begin, undrawn: (backend: string, ...names: readonly string[]) => begin(backend, views(...names)) });
  });
});

interface Came {
  readonly wire: number[];
  readonly troubles: string[];
  readonly kinds: string[];
  readonly done: boolean;
  readonly ink: number;
}

/** A run to its end, guided by what `code` sets up on `run`. */
const guided = (code: string, backend = "cpu", ...undrawn: readonly string[]): Promise<Came> =>
  page.evaluate(
    async ([code, backend, ...names]) => {
      type Begin = (backend: string, ...names: readonly string[]) => Promise<Core["Run"]["prototype"]>;
      const { begin, undrawn } = window as unknown as { begin: Begin; undrawn: Begin };
      const run = await (names.length ? undrawn(backend!, ...names) : begin(backend!));
      let ink = 0;
      const watch = ((images: readonly { ink: Float32Array }[]) => {
        ink = images.reduce((sum, image) => sum + image.ink.reduce((a, b) => a + b, 0) / image.ink.length, 0) / images.length;
        return { loss: 0, grad: images.map((image) => new Float32Array(image.ink.length)) };
      }) as unknown as Guidance;
      run.setGuidance("watch", 0, watch);
      new Function("run", code!)(run);
      const kinds: string[] = [];
      while (run.iteration < run.iterations) kinds.push(...(JSON.parse(await run.step(10)) as { kind: string }[]).map(({ kind }) => kind));
      return { wire: [...run.wire().control_points()], troubles: run.guidanceTroubles(), kinds, done: run.iteration === run.iterations, ink };
    },
    [code, backend, ...undrawn],
  );

it("pulls a wire where a function says, as the documentation's example does, on both engines", async () => {
  const alone = await guided("");
  const pulled = await guided(EXAMPLE);
  expect(pulled.troubles).toEqual([]);
  expect(Math.abs(pulled.ink - 0.1)).toBeLessThan(Math.abs(alone.ink - 0.1));
  expect(pulled.wire).toEqual((await guided(EXAMPLE)).wire);
  const onDevice = await guided(EXAMPLE, "gpu");
  expect(onDevice.troubles).toEqual([]);
  expect(Math.abs(onDevice.ink - pulled.ink)).toBeLessThan(0.01);
});

it("pulls a wire that nothing is drawn of, from a ring on, on both engines", async () => {
  const alone = await guided("", "cpu", "front", "top");
  const ends = [];
  for (const backend of ["cpu", "gpu"]) ends.push(await guided(EXAMPLE, backend, "front", "top"));
  const [pulled, onDevice] = ends as [Came, Came];
  expect([pulled.troubles, onDevice.troubles]).toEqual([[], []]);
  expect(Math.abs(pulled.ink - 0.1)).toBeLessThan(0.7 * Math.abs(alone.ink - 0.1));
  expect(Math.abs(onDevice.ink - pulled.ink)).toBeLessThan(0.01);
  expect(onDevice.wire.every(Number.isFinite)).toBe(true);
  await expect(guided("", "cpu", "back")).rejects.toThrow("back");
});

it("is told how far the fit is and from where each view is seen", async () => {
  const told = await page.evaluate(async () => {
    const { begin } = window as unknown as { begin(backend: string): Promise<Core["Run"]["prototype"]> };
    const run = await begin("cpu");
    const told: unknown[] = [];
    const watch = ((images: { width: number; height: number; ink: Float32Array; right: Float32Array }[], info: unknown) => {
      told.push(info, ...images.map(({ width, height, ink, right }) => [width * height === ink.length, right.length]));
      return { loss: 0, grad: images.map(({ ink }) => new Float32Array(ink.length)) };
    }) as unknown as Guidance;
    await run.step(3);
    run.setGuidance("watch", 1, watch);
    await run.step(1);
    run.stopGuidance("watch");
    await run.step(1);
    return told;
  });
  expect(told).toEqual([{ iteration: 3, iterations: 24 }, [true, 4], [true, 4]]);
});

it.each([
  ["throws", "throw new Error('the network went away.')", "the network went away"],
  ["rejects", "return Promise.reject('no memory')", "no memory"],
  ["answers with nothing", "return undefined", "its loss is no number"],
  ["has no gradient", "return { loss: 1 }", "its grad is no list"],
  ["has too few gradients", "return { loss: 1, grad: [] }", "one entry for each view"],
  ["has short gradients", "return { loss: 1, grad: [new Float32Array(1), new Float32Array(1)] }", "one value for each pixel"],
  ["has numbers that are none", "return { loss: 1, grad: images.map((i) => new Float32Array(i.ink.length).fill(NaN)) }", "no number"],
])("goes on without a function that %s in mid-run", async (_, body, words) => {
  const zero = "return { loss: 0, grad: images.map((i) => new Float32Array(i.ink.length)) };";
  const came = await guided(`run.setGuidance("cat", 1, (images, { iteration }) => { if (iteration > 11) { ${body} } ${zero} })`);
  expect(came.done).toBe(true);
  expect(came.troubles).toHaveLength(1);
  expect(came.troubles[0]).toMatch(new RegExp(`^cat: .*${words}.*; the wire goes on without it$`));
  expect(came.kinds).toContain("unguided");
  expect(came.wire.every(Number.isFinite)).toBe(true);
});

interface Batch {
  readonly images: number[];
  readonly source: number[];
  readonly target: number[];
  readonly weight: number[];
  readonly embedding: number[];
}

/** A network whose embedding says how dark a picture is, and the gradient of that. */
const DARKNESS = `
  const size = 8, all = 3 * size * size;
  const batches = [];
  const network = {
    size,
    embed: 2,
    async run({ images, source, target, weight }) {
      const n = weight.length;
      const [grad, cos, embedding] = [new Float32Array(images.length), new Float32Array(n), new Float32Array(2 * n)];
      let loss = 0;
      for (let row = 0; row < n; row++) {
        // From all white, [1, 0], to all black, [0, 1].
        const dark = 1 - images.subarray(row * all, (row + 1) * all).reduce((a, b) => a + b, 0) / all;
        const angle = dark * Math.PI / 2;
        embedding.set([Math.cos(angle), Math.sin(angle)], 2 * row);
        const d = [Math.cos(angle) - source[2 * row], Math.sin(angle) - source[2 * row + 1]];
        const far = Math.sqrt(d[0] ** 2 + d[1] ** 2 + 1e-6);
        const along = d[0] * target[2 * row] + d[1] * target[2 * row + 1];
        cos[row] = along / far;
        loss += weight[row] * (1 - cos[row]);
        const pull = (i) => -weight[row] * (target[2 * row + i] / far - along * d[i] / far ** 3);
        const dAngle = -pull(0) * Math.sin(angle) + pull(1) * Math.cos(angle);
        grad.fill(-dAngle * Math.PI / 2 / all, row * all, (row + 1) * all);
      }
      batches.push({ images, source, target, weight, embedding });
      return { loss, grad, cos, embedding };
    },
  };
  const words = Float32Array.of(0, 1), none = Float32Array.of(1, 0);
  const wire = run.wire();
  const from = { closed: wire.closed, knots: wire.knots(), controlPoints: wire.control_points() };`;

it("departs from its first wire as words differ from neutral ones, patch by patch", async () => {
  await guided(`${DARKNESS} window.batches = batches; run.guideByWords("dark", 1, [network], [[words, null]], { look: "patches", neutral: [none], from });`);
  const [reference, , first, , ...rest] = await page.evaluate(() => {
    const { batches } = window as unknown as { batches: Record<keyof Batch, Float32Array>[] };
    return batches.map((batch) => Object.fromEntries(Object.entries(batch).map(([name, all]) => [name, [...all]])) as unknown as Batch);
  });
  // Sixteen patches, eight at a time: at first those of the first wire, then those of what is drawn, which is the same.
  expect(reference!.weight).toEqual(Array(8).fill(0));
  expect(first!.weight.reduce((a, b) => a + b)).toBeCloseTo(0.5, 5);
  expect(first!.source).toEqual(reference!.embedding);
  const off = first!.images.reduce((sum, value, i) => sum + Math.abs(value - reference!.images[i]!), 0) / first!.images.length;
  expect(off).toBeLessThan(0.05);
  expect(first!.images.some((value) => value < 0.5)).toBe(true);
  for (const [i, value] of first!.target.entries()) expect(value).toBeCloseTo((i % 2 ? 1 : -1) * Math.SQRT1_2, 5);
  // Others each time.
  expect(rest.some(({ source }) => source.some((value, i) => Math.abs(value - first!.source[i]!) > 0.01))).toBe(true);
});

it("has each patch be like the words where none are neutral", async () => {
  const by = (vector: string) => guided(`${DARKNESS} run.guideByWords("words", 200, [network], [[${vector}, ${vector}]], { look: "patches" });`);
  const [dark, light] = [await by("words"), await by("none")];
  expect([dark.troubles, light.troubles]).toEqual([[], []]);
  expect(dark.ink).toBeGreaterThan(1.2 * light.ink);
});

it.each([
  ["neutral vectors that are missing", `{ neutral: [], from }`, "neutral vector for each network"],
  ["neutral words that are the words", `{ neutral: [words], from }`, "where the neutral words are"],
  ["no wire to depart from", `{ neutral: [none] }`, "no wire"],
  ["a wire that is none", `{ neutral: [none], from: { ...from, knots: from.knots.slice(1) } }`, "knots"],
])("refuses %s", async (_, options, words) => {
  await expect(guided(`${DARKNESS} run.guideByWords("x", 1, [network], [[words, words]], ${options});`)).rejects.toThrow(words);
});

/** The best denoiser there is for one picture, ink in the left half, where the context says so. */
const LEFT = (channels: number) => `
  const size = 16, each = ${channels} * size * size;
  const levels = Array.from({ length: 1001 }, (_, t) => Math.cos((t / 1000 + 0.008) / 1.008 * Math.PI / 2) ** 2);
  const times = [];
  const denoiser = {
    shape: [${channels}, size, size],
    context: 1,
    async run({ x_t, t, contexts }) {
      times.push(t);
      const left = levels[t] / levels[0];
      const wanted = (i) => (i % size < size / 2 ? -1 : 1);
      return { eps: x_t.map((x, i) => (x - Math.sqrt(left) * contexts[Math.floor(i / each)] * wanted(i)) / Math.sqrt(1 - left)) };
    },
  };
  const told = { context: Float32Array.of(1), nothing: Float32Array.of(0) };
  const options = { schedule: { kind: "cosine", steps: 1000, from: 0, to: 0 }, scale: 1 };
  let sides = [0, 0];
  run.setGuidance("sides", 0, (images) => {
    sides = [0, 1].map((side) => images[0].ink.reduce((sum, ink, i) => sum + (i % images[0].width < images[0].width / 2 === (side === 0) ? ink : 0), 0));
    window.sides = sides;
    window.times = times;
    return { loss: 0, grad: images.map((i) => new Float32Array(i.ink.length)) };
  });`;

/** How much of the ink is in the left half of the first view in the end, and when the denoiser was asked. */
const looked = () =>
  page.evaluate(() => {
    const { sides: [left, right], times, encoded } = window as unknown as { sides: [number, number]; times: number[]; encoded: number };
    return { share: left / (left + right), times, encoded };
  });

it.each([1, 3])("becomes what a diffusion model of %s channels thinks its context is of", async (channels) => {
  await guided(LEFT(channels));
  const before = await looked();
  const { troubles } = await guided(`${LEFT(channels)} run.guideByDiffusion("left", 30, denoiser, null, [told, null], options);`);
  expect(troubles).toEqual([]);
  const after = await looked();
  expect(after.share).toBeGreaterThan(before.share + 0.05);
  expect(after.times).toHaveLength(24);
  expect(after.times.every((t) => t >= 1 && t <= 1000)).toBe(true);
});

it("asks an encoder for latents, there and back", async () => {
  // Latents are pixels, made by somebody else.
  const encoder = `
    window.encoded = 0;
    const encoder = { size, async run({ image, cotangent }) { window.encoded++; return { latent: image.map((v) => 2 * v - 1), grad: cotangent.map((d) => 2 * d) }; } };`;
  await guided(LEFT(3));
  const before = await looked();
  const { troubles } = await guided(`${LEFT(3)} ${encoder} run.guideByDiffusion("left", 30, denoiser, encoder, [told, null], options);`);
  expect(troubles).toEqual([]);
  const after = await looked();
  expect(after.share).toBeGreaterThan(before.share + 0.05);
  expect(after.encoded).toBe(48);
});

it.each([
  ["a context of another size", `denoiser, null, [{ ...told, context: new Float32Array(2) }, null], options`, "its context has 2 numbers, not 1"],
  ["latents without an encoder", `{ ...denoiser, shape: [4, 8, 8] }, null, [told, null], options`, "no encoder"],
  ["shapes that are none", `{ ...denoiser, shape: [1, 1e9, 16] }, null, [told, null], options`, "no number from 1 to 512"],
  ["another schedule", `denoiser, null, [told, null], { ...options, schedule: { kind: "square", steps: 10 } }`, "none of linear"],
  ["betas that are none", `denoiser, null, [told, null], { ...options, schedule: { kind: "linear", steps: 10, from: 2, to: 3 } }`, "between 0 and 1"],
])("refuses of a diffusion model %s", async (_, given, words) => {
  await expect(guided(`${LEFT(1)} run.guideByDiffusion("x", 1, ${given});`)).rejects.toThrow(words);
});
