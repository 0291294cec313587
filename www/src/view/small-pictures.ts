/** Small flat pictures of a wire that may change many times a second, painted a little a frame: none keeps the page from anything. */

import { Sampler, samplesPerSpan, type Samples, type WireShape } from "#sculpture/scene/shape";
import type { Ink, View } from "../engine/protocol";
import { pageColours } from "./colours";
import { paintInk, paintWire, PLAIN } from "./paint";

export const SMALL_PX = 192;
/** How long a frame paints; a slow device may need as long again for what it began. */
const SLICE_MS = 4;
/** Wires that follow each other closely are not all painted. */
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
  /** Whether the samples are of an older wire; whether the last step made them. */
  private stale = false;
  private sampled = false;
  private inks = new WeakMap<Ink, HTMLCanvasElement>();
  /** What is being painted now, whose turn is next, and how many are left to paint. */
  private painting: Generator<void, void> | null = null;
  private turn = 0;
  private left = 0;
  private waiting: ReturnType<typeof setTimeout> | null = null;
  private readonly aside = Object.assign(document.createElement("canvas"), { width: SMALL_PX, height: SMALL_PX });
  private frame = 0;

  /** `pictures` is asked whenever it is the next one's turn. */
  constructor(private readonly pictures: () => readonly SmallPicture[]) {}

  setWire(wire: WireShape | null): void {
    this.wire = wire;
    this.stale = true;
    this.waiting ??= setTimeout(() => {
      this.waiting = null;
      this.repaint();
    }, REST_MS);
  }

  repaint(): void {
    this.left = Math.max(1, this.pictures().length);
    this.frame ||= requestAnimationFrame(this.paintOn);
  }

  /** The colours changed. */
  recolour(): void {
    this.inks = new WeakMap();
    this.repaint();
  }

  rest(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
  }

  private readonly paintOn = (): void => {
    this.frame = 0;
    const until = performance.now() + SLICE_MS;
    do {
      this.painting ??= this.next();
      if (this.painting.next().done) this.painting = null;
    } while ((this.painting || this.left > 0) && performance.now() < until);
    if (this.painting || this.left > 0) this.frame = requestAnimationFrame(this.paintOn);
  };

  /** Paints one view, or samples the wire first if that is another: never twice in a row, or none would get painted. */
  private *next(): Generator<void, void> {
    if (this.stale && !this.sampled) {
      this.stale = false;
      this.sampled = true;
      this.samples = this.wire && this.sampler.sample(this.wire, samplesPerSpan(this.wire, SAMPLES, 1));
      return;
    }
    this.sampled = false;
    this.left--;
    const pictures = this.pictures();
    const picture = pictures[this.turn++ % Math.max(1, pictures.length)];
    if (!picture) return;
    const { canvas, view, under } = picture;
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
