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
    Object.assign(window, { begin: (backend: string) => core.Run.start(drawings, settings(backend), none, none) });
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
const guided = (code: string, backend = "cpu"): Promise<Came> =>
  page.evaluate(
    async ([code, backend]) => {
      const { begin } = window as unknown as { begin(backend: string): Promise<Core["Run"]["prototype"]> };
      const run = await begin(backend!);
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
    [code, backend],
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
