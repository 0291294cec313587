/** A sheet of ink to look at, and to draw on with mouse, pen, finger or keys. */

import { msg, str } from "@lit/localize";
import { html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Ink } from "../../../engine/protocol";
import { PAPER_PX } from "../paper";
import { PLAIN } from "../../../view/paint";
import { pageColours } from "../../../view/colours";
import { frameTurn } from "../../../view/frame-turn";
import { Part } from "../../../view/part";
import { controls } from "../../../ui/shared/shared";
import { inkCanvasStyle } from "./ink-canvas-style";

export interface Pen {
  readonly erase: boolean;
  readonly widthPx: number;
}

const sameInk = { attribute: false, hasChanged: (a: Ink | null, b: Ink | null | undefined) => a?.ink !== b?.ink };
/** A point closer to the last one adds nothing. */
const LEAST_STEP_PX = 1;
const STEP_PX = 8;
const BIG_STEP_PX = 32;
/** Of the hatching, in px of the sheet: its period and how much of that is filled. */
const HATCH_PX = 20;
const FILLED_PX = 11;
const BETWEEN = 0.3;
const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Fires `stroke` with the points of a finished stroke (x, y, … in px of the sheet). */
@customElement("ink-canvas")
export class InkCanvas extends Part {
  @property(sameInk) ink: Ink | null = null;
  /** The part of the ink that no object can show; hatched. */
  @property(sameInk) missing: Ink | null = null;
  /** Without a pen there is nothing to draw with. */
  @property({ attribute: false }) pen: Pen | null = null;
  /** Whether fingers draw, or are left to scroll and tap. */
  @property({ type: Boolean }) fingers = false;
  /** Whether the sheet takes the focus and draws with keys. */
  @property({ type: Boolean }) keys = false;
  @property() name = msg("Drawing");
  @state() private penDown = false;
  @state() private told = "";
  @query("#ink") private canvas!: HTMLCanvasElement;
  @query("#live") private live!: HTMLCanvasElement;
  @query(".cursor") private cursor!: HTMLElement | null;
  private points: number[] = [];
  private pointer: number | null = null;
  /** Whether the ink has changed since it was painted, and the painting that is to come. */
  private inked = false;
  private painting: Promise<void> | null = null;
  /** Whether there is anything on the sheet that strokes under way are drawn on. */
  private marked = false;
  private at: readonly [number, number] = [PAPER_PX / 2, PAPER_PX / 2];
  private readonly forced = matchMedia("(forced-colors: active)");

  static override styles = [controls, inkCanvasStyle];

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("theme-change", this.repaint);
    this.forced.addEventListener("change", this.repaint);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("theme-change", this.repaint);
    this.forced.removeEventListener("change", this.repaint);
  }

  override render() {
    const drawable = this.pen !== null;
    const keys = drawable && this.keys;
    return html`<div
        class="sheet ${drawable ? "drawing" : ""} ${drawable && this.fingers ? "fingers" : ""}"
        role=${keys ? "application" : "img"}
        aria-label=${this.name}
        aria-description=${keys ? msg("Arrow keys move the pen, with Shift in larger steps. Space puts it down and lifts it. Escape takes the stroke back.") : nothing}
        tabindex=${keys ? 0 : nothing}
        @pointerenter=${this.enter}
        @pointerdown=${this.down}
        @pointermove=${this.move}
        @pointerup=${this.up}
        @pointercancel=${this.cancel}
        @keydown=${keys ? this.key : nothing}
        @blur=${this.finish}
      >
        <canvas id="ink"></canvas>
        <canvas id="live" width=${PAPER_PX} height=${PAPER_PX}></canvas>
        ${keys ? html`<div class="cursor ${this.penDown ? "down" : ""}"></div>` : nothing}
      </div>
      ${keys ? html`<p class="unseen" role="status">${this.told}</p>` : nothing}`;
  }

  protected override updated(changed: PropertyValues<this>): void {
    this.inked ||= changed.has("ink");
    if (changed.has("ink") || changed.has("missing")) this.repaint();
    if (changed.has("pen") && !this.pen) this.cancel();
  }

  private readonly repaint = (): void => {
    this.painting ??= frameTurn().then(() => {
      this.painting = null;
      const { ink, amber } = pageColours();
      paintSheet(this.canvas, this.ink, this.missing, ink, amber);
      // What was drawn by hand is in the ink now, unless the hand is drawing on.
      if (this.inked && this.pointer === null && !this.penDown) this.clearLive();
      this.inked = false;
    });
  };

  /** A pen that comes near is about to draw; a finger may want to scroll. */
  private enter(event: PointerEvent): void {
    this.live.parentElement!.style.touchAction = event.pointerType === "pen" && this.pen ? "none" : "";
  }

  private down(event: PointerEvent): void {
    const draws = this.pen && event.button === 0 && event.isPrimary && (this.fingers || event.pointerType !== "touch");
    if (!draws || this.pointer !== null) return;
    this.finish();
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    this.pointer = event.pointerId;
    this.addPoint(this.place(event));
  }

  private move(event: PointerEvent): void {
    if (event.pointerId !== this.pointer) return;
    const events = event.getCoalescedEvents?.() ?? [];
    for (const part of events.length > 0 ? events : [event]) this.addPoint(this.place(part));
  }

  private up(event: PointerEvent): void {
    if (event.pointerId !== this.pointer) return;
    this.addPoint(this.place(event));
    this.finish();
  }

  private key(event: KeyboardEvent): void {
    const arrow = ARROWS[event.key];
    if (arrow && !event.ctrlKey && !event.metaKey && !event.altKey) {
      const step = event.shiftKey ? BIG_STEP_PX : STEP_PX;
      const moved = [0, 1].map((axis) => Math.min(PAPER_PX, Math.max(0, this.at[axis]! + step * arrow[axis]!)));
      this.at = moved as [number, number];
      this.cursor?.style.setProperty("left", `${(100 * this.at[0]) / PAPER_PX}%`);
      this.cursor?.style.setProperty("top", `${(100 * this.at[1]) / PAPER_PX}%`);
      if (this.penDown) this.addPoint(this.at);
    } else if (event.key === " " && !event.repeat) {
      const where = msg(str`${Math.round((100 * this.at[0]) / PAPER_PX)}% across, ${Math.round((100 * this.at[1]) / PAPER_PX)}% down`);
      if (this.penDown) {
        this.finish();
        this.told = msg(str`Pen lifted at ${where}.`);
      } else {
        this.penDown = true;
        this.addPoint(this.at);
        this.told = msg(str`Pen down at ${where}.`);
      }
    } else if (event.key === "Escape" && this.penDown) {
      this.cancel();
      this.told = msg("Stroke taken back.");
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private place(event: PointerEvent): readonly [number, number] {
    const { left, top, width, height } = this.getBoundingClientRect();
    return [((event.clientX - left) / width) * PAPER_PX, ((event.clientY - top) / height) * PAPER_PX];
  }

  private addPoint([x, y]: readonly [number, number]): void {
    const { points, pen } = this;
    const count = points.length;
    if (!pen || (count > 0 && Math.hypot(x - points[count - 2]!, y - points[count - 1]!) < LEAST_STEP_PX)) return;
    points.push(x, y);
    const context = this.live.getContext("2d")!;
    this.marked = true;
    if (count === 0) {
      const style = getComputedStyle(this);
      context.strokeStyle = pen.erase ? style.getPropertyValue("--raised") : style.color;
      context.lineWidth = pen.widthPx;
      context.lineCap = "round";
    }
    context.beginPath();
    context.moveTo(points[Math.max(0, count - 2)]!, points[Math.max(1, count - 1)]!);
    context.lineTo(x, y);
    context.stroke();
  }

  private finish(): void {
    const { points } = this;
    this.points = [];
    this.pointer = null;
    this.penDown = false;
    if (points.length > 0) this.dispatchEvent(new CustomEvent("stroke", { detail: Float32Array.from(points) }));
  }

  private cancel(): void {
    this.points = [];
    this.pointer = null;
    this.penDown = false;
    this.clearLive();
  }

  private clearLive(): void {
    if (this.marked) this.live.getContext("2d")!.clearRect(0, 0, PAPER_PX, PAPER_PX);
    this.marked = false;
  }
}

/** Ink in one colour; what cannot be shown, hatched in another, so that it is told apart without colours too. */
function paintSheet(canvas: HTMLCanvasElement, ink: Ink | null, missing: Ink | null, colour: string, amber: string): void {
  canvas.width = ink?.width ?? PAPER_PX;
  canvas.height = ink?.height ?? PAPER_PX;
  if (!ink) return;
  const { width, height } = ink;
  const context = canvas.getContext("2d", PLAIN)!;
  const pixels = context.createImageData(width, height);
  const { data } = pixels;
  const lost = missing?.ink.length === ink.ink.length ? missing.ink : null;
  const [black, gold] = [rgbOf(colour), rgbOf(amber)];
  const unit = PAPER_PX / width;
  for (let y = 0, i = 0; y < height; y++) {
    for (let x = 0; x < width; x++, i++) {
      const all = ink.ink[i]!;
      if (all === 0) continue;
      const gone = lost ? lost[i]! : 0;
      const kept = all - gone;
      const hatch = gone > 0 && ((x + y) * unit) % HATCH_PX < FILLED_PX ? gone : BETWEEN * gone;
      const opacity = kept + hatch;
      for (let c = 0; c < 3; c++) data[4 * i + c] = (black[c]! * kept + gold[c]! * hatch) / opacity;
      data[4 * i + 3] = opacity;
    }
  }
  context.putImageData(pixels, 0, 0);
}

const seen = new Map<string, Uint8ClampedArray>();
/** Any colour of CSS as red, green and blue. */
function rgbOf(colour: string): Uint8ClampedArray {
  let rgb = seen.get(colour);
  if (!rgb) {
    const context = new OffscreenCanvas(1, 1).getContext("2d", PLAIN)!;
    context.fillStyle = colour;
    context.fillRect(0, 0, 1, 1);
    rgb = context.getImageData(0, 0, 1, 1).data;
    seen.set(colour, rgb);
  }
  return rgb;
}
