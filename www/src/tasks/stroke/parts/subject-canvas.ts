/** A picture with its object in full colour and all else veiled; to be tapped, or pointed at and painted on with mouse, pen, finger or keys. */

import { msg, str } from "@lit/localize";
import { html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Ink } from "../../../engine/protocol";
import type { KeptPicture } from "../../../state/picture/picture";
import type { FoundObject } from "../protocol";
import { maskOf, maskSize, maskStroke, paint, placesOf, type Box, type Brush, type MaskStroke, type Subject } from "../given";
import { PLAIN } from "../../../view/paint";
import { Part } from "../../../view/part";
import { controls } from "../../../ui/shared/shared";
import { outline, SOFT_LEVEL, softened } from "./outline";
import { subjectCanvasStyle } from "./subject-canvas-style";

/** What a hand does on it: choose a thing by a tap or a box, drag a box, mark what is meant, paint the mask. */
export type Tool = { readonly kind: "choose" | "box" } | { readonly kind: "mark" | "paint"; readonly brush: Brush };

/** A spot in the picture, in shares of its width and height. */
export type Spot = readonly [x: number, y: number];

/** More numbers than this would hide the picture. */
export const MOST_NUMBERS = 9;
/** A point closer to the last one adds nothing, px of the mask. */
const LEAST_STEP_PX = 1;
/** Of the keys, shares of the longer side. */
const STEP = 1 / 64;
const BIG_STEP = 1 / 16;
/** How much of the picture the veil hides: of the ground, and of what else was found. */
const VEIL = 0.82;
const THIN_VEIL = 0.5;
/** Between two lines of the ground's hatching, CSS px. */
const HATCH_PX = 7;
/** Marks are seen in a small picture, too, CSS px. */
const LEAST_MARK_PX = 5;
const ARROWS: Readonly<Record<string, Spot>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** A drag shorter than this is a tap, CSS px. */
const LEAST_DRAG_PX = 10;

/** Fires `tap` (a Spot), `box` (a Box that was dragged) and `stroke` (a MaskStroke, when it is finished), as its tool is. */
@customElement("subject-canvas")
export class SubjectCanvas extends Part {
  @property({ attribute: false }) subject: Subject | null = null;
  /** Without a tool nothing happens. */
  @property({ attribute: false }) tool: Tool | null = null;
  /** What a mark would have found that is still being drawn. */
  @property({ attribute: false }) foresee: ((mark: MaskStroke) => Promise<FoundObject | null>) | null = null;
  /** What went wrong with the last mark, or empty. */
  @property() problem = "";
  @property() name = msg("Picture");
  /** Whether a finger's drag makes a box, too; else it scrolls. */
  @property({ type: Boolean }) asks = false;
  /** Where a box began, and as far as it was dragged. */
  @state() private dragged: { readonly from: Spot; readonly to: Spot } | null = null;
  @state() private painting = false;
  @state() private told = "";
  @query(".frame") private frame!: HTMLElement;
  @query("#picture") private picture!: HTMLCanvasElement;
  @query("#over") private over!: HTMLCanvasElement;
  @query("#marks") private marks!: HTMLCanvasElement;
  @query(".ring") private ring!: HTMLElement | null;
  @query(".box") private dragBox!: HTMLElement | null;
  /** The mask with the stroke under way, or with one that is not in the subject yet. */
  private live: Ink | null = null;
  /** What was found with the mark under way, or with those that are not in the subject yet. */
  private foreseen: FoundObject | null = null;
  private foreseeing = false;
  /** Marks that are not in the subject yet. */
  private pending: readonly MaskStroke[] = [];
  /** px of the mask. */
  private points: number[] = [];
  private pointer: number | null = null;
  /** The brush's place, for the keys. */
  private at: Spot = [0.5, 0.5];
  private frameDue = 0;
  private justDragged = false;
  private shown: KeptPicture | null = null;
  private readonly sizes = new ResizeObserver(() => this.repaint());
  private readonly forced = matchMedia("(forced-colors: active)");

  static override styles = [controls, subjectCanvasStyle];

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("theme-change", this.repaint);
    this.forced.addEventListener("change", this.repaint);
    if (this.hasUpdated) this.sizes.observe(this.frame);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("theme-change", this.repaint);
    this.forced.removeEventListener("change", this.repaint);
    this.sizes.disconnect();
  }

  override render() {
    const { subject, tool, brush } = this;
    const works = subject && tool && tool.kind !== "choose";
    const keys = msg(str`Arrow keys move the ${brush ? "brush" : "corner"}, with Shift in larger steps. Space starts and ends a ${brush ? "stroke" : "box"}. Escape takes it back.`);
    return html`<div
        part="frame"
        class="frame ${works ? "workable" : tool ? "tappable" : ""} ${this.asks ? "asks" : ""}"
        ?hidden=${!subject}
        role=${works ? "application" : "img"}
        aria-label=${this.name}
        aria-description=${works ? keys : nothing}
        tabindex=${works ? 0 : nothing}
        @click=${works ? nothing : this.tapped}
        @pointerdown=${this.down}
        @pointermove=${this.move}
        @pointerup=${this.up}
        @pointercancel=${this.cancel}
        @keydown=${works ? this.key : nothing}
        @blur=${this.finish}
      >
        <canvas id="picture"></canvas>
        <canvas id="over"></canvas>
        <canvas id="marks"></canvas>
        ${this.dragged || subject?.box ? html`<div class="box ${this.dragged ? "under-way" : ""}"></div>` : nothing}
        ${works ? html`<div class="ring ${brush ? (brush.adds ? "adds" : "takes") : "corner"}"></div>` : nothing}
      </div>
      ${works ? html`<p class="unseen" role="status">${this.told}</p>` : nothing}`;
  }

  protected override firstUpdated(): void {
    this.sizes.observe(this.frame);
  }

  protected override updated(changed: PropertyValues<this>): void {
    const { subject, tool } = this;
    if (changed.has("tool") && changed.get("tool")?.kind !== tool?.kind) this.cancel();
    if (changed.has("subject")) {
      // What was painted by hand is in the subject now, unless the hand paints on.
      if (this.points.length === 0) this.live = this.foreseen = null;
      // What is not in it was given up with it.
      const known = this.pending.findLastIndex((mark) => subject?.marks?.includes(mark));
      this.pending = known < 0 ? [] : this.pending.slice(known + 1);
      if (subject && subject.picture !== this.shown) void this.show(subject.picture);
      this.repaint();
    }
    if (changed.has("problem") && this.problem) {
      this.pending = [];
      this.foreseen = null;
      this.repaint();
    }
    this.placeRing();
    this.placeBox();
  }

  private async show(picture: KeptPicture): Promise<void> {
    this.shown = picture;
    const { width, height, rgba } = picture;
    this.frame.style.setProperty("--aspect", String(width / height));
    const data = new Uint8ClampedArray(await rgba.arrayBuffer());
    if (this.shown !== picture) return;
    this.picture.width = width;
    this.picture.height = height;
    this.picture.getContext("2d", PLAIN)!.putImageData(new ImageData(data, width, height), 0, 0);
  }

  /** At most once a frame. */
  private readonly repaint = (): void => {
    if (this.frameDue) return;
    this.frameDue = requestAnimationFrame(() => {
      this.frameDue = 0;
      const { over, frame, subject } = this;
      const scale = devicePixelRatio;
      over.width = Math.round(frame.clientWidth * scale);
      over.height = Math.round(frame.clientHeight * scale);
      const seen = subject && (this.foreseen ? { ...subject, found: this.foreseen } : subject);
      const mask = this.live ?? (seen && maskOf(seen));
      if (mask && over.width && over.height) paintOver(over, scale, mask, seen!, getComputedStyle(this), this.tool?.kind === "choose");
      this.repaintMarks();
    });
  };

  /** The marks alone: they follow the hand. */
  private repaintMarks(): void {
    const { marks, frame, subject, tool, points } = this;
    const scale = devicePixelRatio;
    marks.width = Math.round(frame.clientWidth * scale);
    marks.height = Math.round(frame.clientHeight * scale);
    if (!subject) return;
    const { width, height } = maskSize(subject);
    const under = points.length > 0 && tool?.kind === "mark" ? [{ ...tool.brush, points: points.map((px, i) => px / (i % 2 ? height : width)) }] : [];
    paintMarks(marks, [...(subject.marks ?? []), ...this.pending, ...under], getComputedStyle(this));
  }

  private get brush(): Brush | null {
    return this.tool && "brush" in this.tool ? this.tool.brush : null;
  }

  private spot({ clientX, clientY }: MouseEvent): Spot {
    const { left, top, width, height } = this.frame.getBoundingClientRect();
    return [(clientX - left) / width, (clientY - top) / height];
  }

  private get box(): Box | null {
    if (!this.dragged) return null;
    const { from, to } = this.dragged;
    const inside = (share: number): number => Math.min(1, Math.max(0, share));
    const along = (axis: 0 | 1): [number, number] => [inside(Math.min(from[axis], to[axis])), inside(Math.max(from[axis], to[axis]))];
    const [[left, right], [top, bottom]] = [along(0), along(1)];
    const { clientWidth, clientHeight } = this.frame;
    return Math.min((right - left) * clientWidth, (bottom - top) * clientHeight) < LEAST_DRAG_PX ? null : [left, top, right, bottom];
  }

  private placeBox(): void {
    const { dragBox } = this;
    const box = this.dragged ? this.box : this.subject?.box;
    if (!dragBox) return;
    dragBox.hidden = !box;
    if (!box) return;
    const [left, top, right, bottom] = box.map((share) => 100 * share) as [number, number, number, number];
    Object.assign(dragBox.style, { left: `${left}%`, top: `${top}%`, width: `${right - left}%`, height: `${bottom - top}%` });
  }

  private tapped(event: MouseEvent): void {
    // A drag ends with a click.
    if (this.justDragged) this.justDragged = false;
    else if (this.subject && this.tool) this.dispatchEvent(new CustomEvent<Spot>("tap", { detail: this.spot(event) }));
  }

  private down(event: PointerEvent): void {
    this.justDragged = false;
    const { subject, tool } = this;
    if (!subject || !tool || event.button !== 0 || !event.isPrimary) return;
    if (tool.kind === "box" || (tool.kind === "choose" && (this.asks || event.pointerType !== "touch"))) {
      this.frame.setPointerCapture(event.pointerId);
      const spot = this.spot(event);
      this.painting = false;
      this.dragged = { from: spot, to: spot };
    }
    if (!this.brush || this.pointer !== null) return;
    this.finish();
    this.frame.setPointerCapture(event.pointerId);
    this.pointer = event.pointerId;
    this.goTo(this.spot(event), true);
  }

  private move(event: PointerEvent): void {
    if (this.dragged && !this.painting) this.dragged = { ...this.dragged, to: this.spot(event) };
    if (!this.tool || this.tool.kind === "choose" || this.painting) return;
    const paints = event.pointerId === this.pointer;
    const parts = paints ? (event.getCoalescedEvents?.() ?? []) : [];
    for (const part of parts.length > 0 ? parts : [event]) this.goTo(this.spot(part), paints);
  }

  private up(event: PointerEvent): void {
    if (!this.painting && this.dragged) this.justDragged = this.endBox();
    if (event.pointerId !== this.pointer) return;
    this.goTo(this.spot(event), true);
    this.finish();
  }

  /** Whether there was one. */
  private endBox(): boolean {
    const { box } = this;
    this.dragged = null;
    if (box) this.dispatchEvent(new CustomEvent<Box>("box", { detail: box }));
    return !!box;
  }

  private key(event: KeyboardEvent): void {
    const arrow = ARROWS[event.key];
    if (arrow && !event.ctrlKey && !event.metaKey && !event.altKey) {
      const { width, height } = this.subject!.picture;
      const step = (event.shiftKey ? BIG_STEP : STEP) * Math.max(width, height);
      const [x, y] = [this.at[0] + (step * arrow[0]) / width, this.at[1] + (step * arrow[1]) / height];
      this.goTo([Math.min(1, Math.max(0, x)), Math.min(1, Math.max(0, y))], this.painting);
      if (this.painting && this.dragged) this.dragged = { ...this.dragged, to: this.at };
    } else if (event.key === " " && !event.repeat) {
      const where = msg(str`${Math.round(100 * this.at[0])}% across, ${Math.round(100 * this.at[1])}% down`);
      const { painting, brush } = this;
      if (!brush) {
        this.painting = !painting;
        if (!painting) this.dragged = { from: this.at, to: this.at };
        const done = painting && this.endBox();
        this.told = !painting ? msg(str`One corner at ${where}.`) : done ? msg(str`The other corner at ${where}.`) : msg("That box has no area. Start it again.");
      } else if (painting) {
        this.finish();
        this.told = msg(str`Brush lifted at ${where}.`);
      } else {
        this.painting = true;
        this.goTo(this.at, true);
        this.told = msg(str`Brush down at ${where}.`);
      }
    } else if (event.key === "Escape" && (this.points.length > 0 || this.dragged)) {
      this.told = this.dragged ? msg("Box taken back.") : msg("Stroke taken back.");
      this.cancel();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Brings the brush to a place, painting on the way or not. */
  private goTo(spot: Spot, paints: boolean): void {
    this.at = spot;
    this.placeRing();
    if (paints && this.brush) this.addPoint(spot);
  }

  private placeRing(): void {
    const { ring, at, subject, brush } = this;
    if (!ring || !subject) return;
    const { width, height } = subject.picture;
    ring.style.setProperty("left", `${100 * at[0]}%`);
    ring.style.setProperty("top", `${100 * at[1]}%`);
    ring.style.setProperty("width", `${(100 * (brush?.width ?? 0) * Math.max(width, height)) / width}%`);
  }

  private addPoint([x, y]: Spot): void {
    const { points, brush, subject } = this;
    if (!brush || !subject) return;
    const { width, height } = maskSize(subject);
    const [px, py] = [x * width, y * height];
    const count = points.length;
    if (count > 0 && Math.hypot(px - points[count - 2]!, py - points[count - 1]!) < LEAST_STEP_PX) return;
    if (this.tool!.kind === "mark") {
      points.push(px, py);
      this.repaintMarks();
      void this.lookAhead();
      return;
    }
    if (!this.live) {
      const ink = maskOf(subject)?.ink.slice() ?? new Uint8Array(width * height);
      this.live = { width, height, ink };
    }
    const from = count > 0 ? [points[count - 2]! / width, points[count - 1]! / height] : [];
    paint(this.live, { ...brush, points: [...from, x, y] });
    points.push(px, py);
    this.repaint();
  }

  /** Shows what the mark under way would find, again and again as long as it grows. */
  private async lookAhead(): Promise<void> {
    if (this.foreseeing) return;
    this.foreseeing = true;
    for (let [seen, count] = [this.points, 0]; this.points.length > 0 && (this.points !== seen || this.points.length > count); ) {
      [seen, count] = [this.points, this.points.length];
      const { subject, brush } = this;
      const found = subject && brush && (await this.foresee?.(maskStroke(seen, maskSize(subject), brush)));
      // Another hand, or none: it is for the subject to say.
      if (!found || this.points !== seen) continue;
      this.foreseen = found;
      this.repaint();
    }
    this.foreseeing = false;
  }

  private finish(): void {
    const { points, brush, subject, tool } = this;
    this.rest();
    if (points.length === 0 || !brush || !subject) return;
    const stroke = maskStroke(points, maskSize(subject), brush);
    if (tool?.kind === "mark") this.pending = [...this.pending, stroke];
    this.dispatchEvent(new CustomEvent<MaskStroke>("stroke", { detail: stroke }));
  }

  private cancel(): void {
    this.dragged = null;
    this.rest();
    this.live = this.foreseen = null;
    this.repaint();
  }

  private rest(): void {
    this.points = [];
    this.pointer = null;
    this.painting = false;
  }
}

/** What lies over the picture: a hatched veil on all that is not the object, outlines, and numbers where there is a choice. */
function paintOver(canvas: HTMLCanvasElement, scale: number, mask: Ink, { found, object }: Subject, style: CSSStyleDeclaration, numbered: boolean): void {
  const { width, height } = canvas;
  const colour = (name: string): string => style.getPropertyValue(`--${name}`);
  const context = canvas.getContext("2d", PLAIN)!;
  const others = found && found.count > 1 ? otherThings(found, object, mask) : null;
  context.drawImage(veil(mask, others), 0, 0, width, height);
  context.globalCompositeOperation = "source-in";
  context.fillStyle = colour("paper");
  context.fillRect(0, 0, width, height);
  context.globalCompositeOperation = "source-atop";
  context.globalAlpha = 0.3;
  hatch(context, width, height, HATCH_PX * scale);
  context.strokeStyle = colour("line-strong");
  context.lineWidth = scale;
  context.stroke();
  context.globalCompositeOperation = "source-over";
  const line = (ink: Ink, inner: string, innerPx: number): void => {
    const path = pathOf(outline(softened(ink), SOFT_LEVEL), width / ink.width, height / ink.height);
    context.lineCap = "round";
    for (const [stroke, alpha, px] of [[colour("raised"), 0.85, innerPx + 2], [inner, 1, innerPx]] as const) {
      context.globalAlpha = alpha;
      context.strokeStyle = stroke;
      context.lineWidth = px * scale;
      context.stroke(path);
    }
  };
  if (others) line(others, colour("quiet"), 1);
  line(mask, colour("copper"), 2);
  if (found && found.count > 1 && numbered) numbers(context, scale, found, object, colour);
}

function otherThings({ labels, width, height }: FoundObject, object: number, { ink }: Ink): Ink {
  return { width, height, ink: labels.map((label, i) => (label !== 0 && label !== object && ink[i]! < 128 ? 255 : 0)) };
}

/** Opaque where the picture is to be hidden. */
function veil({ width, height, ink }: Ink, others: Ink | null): OffscreenCanvas {
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d", PLAIN)!;
  const pixels = context.createImageData(width, height);
  for (let i = 0; i < ink.length; i++) pixels.data[4 * i + 3] = (others?.ink[i] ? THIN_VEIL : VEIL) * (255 - ink[i]!);
  context.putImageData(pixels, 0, 0);
  return canvas;
}

/** Marks in the picture: whole lines on the object, dashed ones beside it. */
function paintMarks(canvas: HTMLCanvasElement, marks: readonly MaskStroke[], style: CSSStyleDeclaration): void {
  const { width, height } = canvas;
  const context = canvas.getContext("2d", PLAIN)!;
  const colour = (name: string): string => style.getPropertyValue(`--${name}`);
  const longer = Math.max(width, height);
  context.lineCap = context.lineJoin = "round";
  for (const { adds, width: share, points } of marks) {
    const path = new Path2D();
    path.moveTo(points[0]! * width, points[1]! * height);
    // A line to where it is would be none.
    for (let i = 0; i < points.length; i += 2) path.lineTo(points[i]! * width + 0.01, points[i + 1]! * height);
    const px = Math.max(share * longer, LEAST_MARK_PX * devicePixelRatio);
    context.setLineDash([]);
    context.strokeStyle = colour("raised");
    context.lineWidth = px;
    context.stroke(path);
    context.setLineDash(adds ? [] : [0.01, 1.1 * px]);
    context.strokeStyle = colour(adds ? "copper" : "ink");
    context.lineWidth = 0.6 * px;
    context.stroke(path);
  }
}

function hatch(context: CanvasRenderingContext2D, width: number, height: number, period: number): void {
  context.beginPath();
  for (let x = -height; x < width; x += period * Math.SQRT2) {
    context.moveTo(x, height);
    context.lineTo(x + height, 0);
  }
}

function pathOf(segments: Float32Array, across: number, down: number): Path2D {
  const path = new Path2D();
  for (let i = 0; i < segments.length; i += 4) {
    path.moveTo(across * segments[i]!, down * segments[i + 1]!);
    path.lineTo(across * segments[i + 2]!, down * segments[i + 3]!);
  }
  return path;
}

function numbers(context: CanvasRenderingContext2D, scale: number, found: FoundObject, object: number, colour: (name: string) => string): void {
  const radius = 10 * scale;
  context.font = `600 ${12 * scale}px Figtree, system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = 1.5 * scale;
  for (const [i, [x, y]] of placesOf(found).slice(0, MOST_NUMBERS).entries()) {
    const chosen = i + 1 === object;
    const at = [x * context.canvas.width, y * context.canvas.height] as const;
    context.beginPath();
    context.arc(...at, radius, 0, 2 * Math.PI);
    context.fillStyle = chosen ? colour("ink") : colour("raised");
    context.fill();
    context.strokeStyle = colour(chosen ? "raised" : "ink");
    context.stroke();
    context.fillStyle = colour(chosen ? "raised" : "ink");
    context.fillText(String(i + 1), at[0], at[1] + 0.5 * scale);
  }
}
