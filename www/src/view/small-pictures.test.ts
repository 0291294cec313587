import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { WireShape } from "#sculpture/scene/shape";
import { SmallPictures } from "./small-pictures";
import { viewFrom } from "./heading";

vi.mock("./colours", () => ({ pageColours: () => ({ ink: "black", copper: "brown" }) }));

/** Says whether the host is where people see it. */
let tellSeen: (isIntersecting: boolean) => void;
/** How long the clock says that painting one picture takes, and pictures shown so far. */
let paintMs: number;
let shown = 0;

/** A canvas on which nothing is seen, and which costs time where it is shown. */
function canvas(visible: boolean): HTMLCanvasElement {
  const nothing = (): void => undefined;
  const drawImage = (): void => {
    if (!visible) return;
    shown++;
    vi.setSystemTime(Date.now() + paintMs);
  };
  const context = { clearRect: nothing, beginPath: nothing, moveTo: nothing, lineTo: nothing, stroke: nothing, drawImage };
  return { getContext: () => context } as unknown as HTMLCanvasElement;
}

const wire = (x: number): WireShape => ({ closed: false, knots: [0, 0, 0, 0, 1, 1, 1, 1], controlPoints: [x, 0, 0, 0.02, 0, 1, 0, 0.02, 0, 0, 1, 0.02, 1, 0, 0, 0.02] });

/** So much time goes by, with a new wire every so often. */
async function pass(forMs: number, change: () => void = () => undefined): Promise<void> {
  for (let ms = 0; ms < forMs; ms += 20) {
    change();
    await vi.advanceTimersByTimeAsync(20);
    // Turns are taken by messages, which no clock moves.
    await new Promise((done) => setImmediate(done));
  }
}

beforeEach(() => {
  vi.useFakeTimers({ toFake: ["setTimeout", "Date"] });
  vi.spyOn(performance, "now").mockImplementation(() => Date.now());
  [paintMs, shown] = [1, 0];
  vi.stubGlobal("document", { createElement: () => canvas(false) });
  vi.stubGlobal("requestAnimationFrame", (draw: () => void) => setTimeout(draw, 16));
  vi.stubGlobal(
    "IntersectionObserver",
    class {
      constructor(tell: (entries: { isIntersecting: boolean }[]) => void) {
        tellSeen = (isIntersecting) => tell([{ isIntersecting }]);
      }
      observe(): void {}
    },
  );
});

afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

const three = (): SmallPictures => {
  const pictures = [0, 90, 180].map((azimuth) => ({ canvas: canvas(true), view: viewFrom({ azimuth, elevation: 0 }, "") }));
  return new SmallPictures({} as Element, () => pictures);
};

it("paints what changed, once, and only where somebody sees it", async () => {
  const pictures = three();
  pictures.setWire(wire(1));
  await pass(500);
  expect(shown).toBe(0);
  tellSeen(true);
  await pass(500);
  expect(shown).toBe(3);
  await pass(1000);
  expect(shown).toBe(3);
  tellSeen(false);
  pictures.setWire(wire(2));
  await pass(500);
  expect(shown).toBe(3);
  tellSeen(true);
  await pass(500);
  expect(shown).toBe(6);
});

it("follows a wire that changes all the time, within its share of the time", async () => {
  const pictures = three();
  tellSeen(true);
  let x = 0;
  const change = (): void => pictures.setWire(wire(++x));
  await pass(2000, change);
  // Quick ones come as fast as can be seen.
  expect(shown).toBeGreaterThan(3 * 10);
  [paintMs, shown] = [10, 0];
  const before = Date.now();
  await pass(4000, change);
  expect((shown * paintMs) / (Date.now() - before)).toBeLessThan(0.06);
  expect(shown).toBeGreaterThanOrEqual(3 * 3);
});
