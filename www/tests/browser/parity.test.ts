/** The engine on a browser's device against the processor's, without the page: wire by wire, and when the device is lost. */

import { expect, it } from "vitest";
import { openCore, type Core } from "./core";

interface Parity {
  readonly wire: string;
  readonly coverage: number;
  readonly loss: number;
  readonly dCoverage: number;
  readonly gradient: number;
}

interface Place {
  readonly backend: string;
  readonly why: string;
}

const { browser, page } = await openCore();

const parities = (skew: number) =>
  page.evaluate(async (skew) => JSON.parse(await (window as unknown as { core: Core }).core.parities(skew)) as Parity[], skew);

it("computes what the processor does, on a spiral and on hostile wires", async () => {
  const within = ({ coverage, loss, dCoverage, gradient }: Parity) => coverage <= 1e-3 && loss <= 1e-4 && dCoverage <= 1e-3 && gradient <= 1e-3;
  const found = await parities(1);
  console.log(found);
  expect(found.length).toBeGreaterThan(5);
  expect(found.filter((parity) => !within(parity))).toEqual([]);
  // Sibling: other level weights are seen on every wire.
  expect((await parities(1.02)).filter(within)).toEqual([]);
});

it("goes on from where it was on a new device when one is lost, and on the processor the second time", async () => {
  const devtools = await browser.newBrowserCDPSession();
  await page.evaluate(async () => {
    const { core } = window as unknown as { core: Core };
    const side = 64;
    const drawing = (inked: (x: number, y: number) => boolean) =>
      Uint8Array.from({ length: side * side }, (_, i) => (inked((i % side) - side / 2 + 0.5, Math.floor(i / side) - side / 2 + 0.5) ? 255 : 0));
    const drawings = new core.DrawingSet();
    drawings.add("ring", side, side, drawing((x, y) => Math.abs(Math.hypot(x, y) - 20) < 3));
    drawings.add("cross", side, side, drawing((x, y) => Math.min(Math.abs(x), Math.abs(y)) < 3 && Math.hypot(x, y) < 24));
    const settings = { backend: "gpu", preset: "fast", size: "32", iterations: "24", bend: "none", grid: "16", control_points: "24", samples: "2" };
    Object.assign(window, { run: await core.Run.start(drawings, JSON.stringify(settings), () => undefined, () => undefined) });
  });
  const stepTo = (iteration: number): Promise<Place & { iteration: number }> =>
    page.evaluate(async (iteration) => {
      const { run } = window as unknown as { run: Core["Run"]["prototype"] };
      while (run.iteration < iteration) await run.step(iteration - run.iteration);
      return { ...(JSON.parse(run.place()) as Place), iteration: run.iteration };
    }, iteration);
  expect(await stepTo(4)).toMatchObject({ backend: "gpu", iteration: 4 });
  await devtools.send("Browser.crashGpuProcess");
  const again = await stepTo(8);
  expect(again).toMatchObject({ backend: "gpu", iteration: 8 });
  expect(again.why).toContain("lost for a moment");
  await devtools.send("Browser.crashGpuProcess");
  const last = await stepTo(24);
  expect(last).toMatchObject({ backend: "cpu", iteration: 24 });
  expect(last.why).toContain("the processor has taken over");
});
