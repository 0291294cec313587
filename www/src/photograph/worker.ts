/** The worker that photographs are taken in: a small picture at once, then the whole, which gets better with every pass. */

import init, { Photograph } from "../engine/wasm/wire4d_photograph";
import moduleUrl from "../engine/wasm/wire4d_photograph_bg.wasm?url";
import type { Order, Pixels, Rest, Told, Wishes } from "./orders";

/** Of the small picture, px, and how often it is exposed. */
const SMALL_PX = 560;
const SMALL_PASSES = 8;
/** From here on the whole picture is clearer than the small one. */
const CLEARER = 4;

let newest = 0;
let rested: Promise<void> = Promise.resolve();
let wake = (): void => undefined;

onmessage = ({ data }: MessageEvent<Order | Rest>) => {
  if (!("rests" in data)) return void take(data);
  wake();
  if (data.rests) rested = new Promise((resolve) => (wake = resolve));
};

async function take(order: Order): Promise<void> {
  const { id, file, wishes, passes } = order;
  newest = id;
  try {
    await init({ module_or_path: moduleUrl });
    await exposed(file, small(wishes), SMALL_PASSES, id, (photograph, size) => {
      const pass = photograph.passes();
      if (isWorthALook(pass)) show({ id, pixels: developed(photograph, size, pass === SMALL_PASSES), passes: 0 });
    });
    if (passes === 0) return;
    await exposed(file, wishes, passes, id, (photograph, size) => {
      const pass = photograph.passes();
      if (pass === passes) show({ id, done: developed(photograph, size, true) });
      else if (pass >= CLEARER && isWorthALook(pass)) show({ id, pixels: developed(photograph, size, false), passes: pass });
      else show({ id, passes: pass });
    });
  } catch (error) {
    console.warn(error);
    show({ id, problem: error instanceof Error ? error.message : String(error) });
  }
}

/** Exposes as often as that, unless something newer is wanted meanwhile. */
async function exposed(file: Uint8Array, wishes: Wishes, passes: number, id: number, each: (photograph: Photograph, wishes: Wishes) => void): Promise<void> {
  const { size, ...rest } = wishes;
  const photograph = new Photograph(file, JSON.stringify({ ...rest, size: [size.width, size.height] }));
  try {
    for (let pass = 0; pass < passes && id === newest; pass++) {
      photograph.expose();
      each(photograph, wishes);
      await new Promise((resolve) => setTimeout(resolve));
      await rested;
    }
  } finally {
    photograph.free();
  }
}

/** Exposed twice as often, a picture has visibly less noise. */
const isWorthALook = (passes: number): boolean => (passes & (passes - 1)) === 0;

function developed(photograph: Photograph, { size }: Wishes, calmed: boolean): Pixels {
  return { ...size, rgba: new Uint8ClampedArray(photograph.picture(calmed) as Uint8Array<ArrayBuffer>) };
}

function small(wishes: Wishes): Wishes {
  const { width, height } = wishes.size;
  const scale = Math.min(1, SMALL_PX / Math.max(width, height));
  return { ...wishes, size: { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) } };
}

function show(told: Told): void {
  const pixels = "done" in told ? told.done : "pixels" in told ? told.pixels : null;
  postMessage(told, { transfer: pixels ? [pixels.rgba.buffer] : [] });
}
