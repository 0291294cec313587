/** How a wire was found: its earlier shapes one after the other, with a button and a slider. Loaded where there is any. */

import { h, icon, setAttribute } from "./dom";
import { openReplay } from "../share/replay";
import type { WireShape } from "../scene/shape";
import type { Words } from "./words";

/** How long all of it takes. */
const LENGTH_MS = 7000;
/** The slider's steps between two wires. */
const FINE = 20;

export class Replayer {
  readonly element: HTMLElement;
  private readonly button: HTMLButtonElement;
  private readonly slider: HTMLInputElement;
  private frame = 0;
  private begun = false;
  private startMs = 0;
  private readonly still = matchMedia("(prefers-reduced-motion: reduce)");

  /** Null where the bytes are none: a sculpture without its past is one all the same. */
  static of(bytes: Uint8Array, last: WireShape, words: Words, show: (wire: WireShape) => void): Replayer | null {
    try {
      const wires = openReplay(bytes).map(({ wire }) => wire);
      return wires.length > 1 ? new Replayer([...wires.slice(0, -1), last], words, show) : null;
    } catch (error) {
      console.warn(error);
      return null;
    }
  }

  constructor(
    private readonly wires: readonly WireShape[],
    private readonly words: Words,
    private readonly show: (wire: WireShape) => void,
  ) {
    this.button = h("button", { type: "button", class: "square", part: "button", onclick: () => (this.playing ? this.pause() : this.play()) });
    this.slider = h("input", { type: "range", part: "slider", min: 0, max: (wires.length - 1) * FINE, "aria-label": words.howFound, oninput: () => this.seek() });
    this.slider.value = this.slider.max;
    this.element = h("div", { class: "group replay", part: "group", role: "group", "aria-label": words.howFound }, this.button, this.slider);
    this.refresh();
  }

  /** Once, when the wire is seen; by itself nothing moves for people who asked for less motion. */
  begin(): void {
    if (this.begun) return;
    this.begun = true;
    if (!this.still.matches) this.play();
  }

  play(): void {
    this.begun = true;
    cancelAnimationFrame(this.frame);
    const most = Number(this.slider.max);
    const from = this.slider.value === this.slider.max ? 0 : timeOf(Number(this.slider.value) / most);
    this.startMs = performance.now() - from * LENGTH_MS;
    this.frame = requestAnimationFrame(this.advance);
    this.refresh();
  }

  pause(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    this.refresh();
  }

  /** For good. */
  end(): void {
    this.pause();
    this.element.remove();
  }

  private get playing(): boolean {
    return this.frame !== 0;
  }

  private readonly advance = (nowMs: number): void => {
    const share = Math.min(1, Math.max(0, nowMs - this.startMs) / LENGTH_MS);
    this.slider.value = String(Math.round(placeOf(share) * Number(this.slider.max)));
    this.draw(placeOf(share));
    this.frame = share < 1 ? requestAnimationFrame(this.advance) : 0;
    if (share === 1) this.refresh();
  };

  private seek(): void {
    this.pause();
    this.draw(Number(this.slider.value) / Number(this.slider.max));
  }

  /** Where people asked for less motion, from wire to wire and not between them. */
  private draw(share: number): void {
    const place = share * (this.wires.length - 1);
    const at = Math.min(this.wires.length - 2, Math.floor(place));
    const between = place - at;
    this.show(mixed(this.wires[at]!, this.wires[at + 1]!, this.still.matches ? Math.round(between) : between));
  }

  private refresh(): void {
    const { button, playing, words } = this;
    const label = playing ? words.pause : words.play;
    setAttribute(button, "aria-label", label);
    setAttribute(button, "title", label);
    button.replaceChildren(icon(playing ? "pause" : "play"));
  }
}

/** The first tangle is quickly seen; what it becomes takes its time, and so does the end. */
const placeOf = (share: number): number => share * share * (3 - 2 * share);

/** Its inverse. */
const timeOf = (place: number): number => 0.5 - Math.sin(Math.asin(1 - 2 * Math.max(0, Math.min(1, place))) / 3);

/** Wires of one make blend; where points have been added, one follows the other. */
function mixed(before: WireShape, after: WireShape, share: number): WireShape {
  const alike = before.closed === after.closed && before.controlPoints.length === after.controlPoints.length && before.knots.length === after.knots.length;
  if (share <= 0 || (!alike && share < 0.5)) return before;
  if (share >= 1 || !alike) return after;
  const mix = (a: ArrayLike<number>, b: ArrayLike<number>): Float64Array => Float64Array.from(a, (x, at) => x + (b[at]! - x) * share);
  return { closed: after.closed, knots: mix(before.knots, after.knots), controlPoints: mix(before.controlPoints, after.controlPoints) };
}
