/** Small flat pictures of a wire that may change many times a second, painted a little at a time: none keeps the page from anything. */

import { Sampler, samplesPerSpan, type Samples, type WireShape } from "#sculpture/scene/shape";
import type { Ink, View } from "../engine/protocol";
import { nextTurn } from "../state/common/next-turn";
import { pageColours } from "./colours";
import { paintInk, paintWire, PLAIN } from "./paint";

export const SMALL_PX = 192;
/** How long is painted at a time; a slow device may need as long again for what it began. */
const SLICE_MS = 4;
/** Wires that follow each other closely are not all painted: so that it takes this share of the time, and no faster than can be seen. */
const SHARE = 0.04;
const REST_MS = 100;
/** Fewer than on the stage: these are small. */
const SAMPLES = 1600;

export interface SmallPicture {
  readonly canvas: HTMLCanvasElement;
  readonly view: View;
  /** Drawn in copper below the wire: copper that is left over is missing from it. */
  readonly under?: Ink | undefined;
}

export class SmallPictures {
  private readonly sampler = new Sampler();
  private wire: WireShape | null = null;
  private samples: Samples | null = null;
  /** Whether the samples are of an older wire. */
  private stale = false;
  /** Whether there is anything new to paint, and whether somebody is at it. */
  private due = false;
  private painting = false;
  /** Whether they are where people see them. */
  private seen = false;
  private inks = new WeakMap<Ink, HTMLCanvasElement>();
  private readonly aside = Object.assign(document.createElement("canvas"), { width: SMALL_PX, height: SMALL_PX });

  /** They are in `host`; which they are is asked before they are painted. */
  constructor(
    host: Element,
    private readonly pictures: () => readonly SmallPicture[],
  ) {
    new IntersectionObserver(([...entries]) => {
      this.seen = entries.at(-1)!.isIntersecting;
      void this.paint();
    }).observe(host);
  }

  setWire(wire: WireShape | null): void {
    this.wire = wire;
    this.stale = true;
    this.repaint();
  }

  repaint(): void {
    this.due = true;
    void this.paint();
  }

  /** The colours changed. */
  recolour(): void {
    this.inks = new WeakMap();
    this.repaint();
  }

  /** Round by round, as long as there is anything new that somebody sees. */
  private async paint(): Promise<void> {
    if (this.painting) return;
    this.painting = true;
    while (this.due && this.seen) {
      // In a hidden tab there is no frame.
      await new Promise(requestAnimationFrame);
      this.due = false;
      const tookMs = await inSlices(this.round());
      await new Promise((rested) => setTimeout(rested, Math.max(REST_MS, tookMs * (1 / SHARE - 1))));
    }
    this.painting = false;
  }

  private *round(): Generator<void, void> {
    if (this.stale) {
      this.stale = false;
      this.samples = this.wire && this.sampler.sample(this.wire, samplesPerSpan(this.wire, SAMPLES, 1));
      yield;
    }
    for (const picture of this.pictures()) {
      yield* this.one(picture);
      yield;
    }
  }

  private *one({ canvas, view, under }: SmallPicture): Generator<void, void> {
    // Aside, and shown when it is whole.
    const aside = this.aside.getContext("2d", PLAIN)!;
    const { ink: dark, copper } = pageColours();
    aside.clearRect(0, 0, SMALL_PX, SMALL_PX);
    if (under) {
      let ink = this.inks.get(under);
      if (!ink) {
        ink = document.createElement("canvas");
        paintInk(ink, under, copper, 0.6);
        this.inks.set(under, ink);
        yield;
      }
      aside.drawImage(ink, 0, 0, SMALL_PX, SMALL_PX);
    }
    if (this.samples) yield* paintWire(aside, this.samples, view, SMALL_PX, dark);
    const context = canvas.getContext("2d", PLAIN)!;
    context.clearRect(0, 0, SMALL_PX, SMALL_PX);
    context.drawImage(this.aside, 0, 0);
  }
}

/** Does it a little at a time; what it took in all, ms. */
async function inSlices(work: Generator<void, void>): Promise<number> {
  let tookMs = 0;
  for (let done = false; !done; await nextTurn()) {
    const from = performance.now();
    do done = work.next().done === true;
    while (!done && performance.now() - from < SLICE_MS);
    tookMs += performance.now() - from;
  }
  return tookMs;
}
