/** The element: attributes and events outside, a stage and its buttons inside. */

import { Bar } from "./bar";
import type { BodyShape } from "../scene/body";
import { join, leave, settle, type Member } from "./crowd";
import { h, setAttribute } from "./dom";
import { LOOK_NAMES, lookOf, type LookName } from "../scene/looks";
import type { Vec3 } from "../scene/matrix";
import { DIRECTIONS, type ViewName } from "../scene/directions";
import { orbitOf } from "./orbit-text";
import { ATTRIBUTES, reflect, takeOver } from "./reflect";
import type { WireShape } from "../scene/shape";
import type { Replayer } from "./replayer";
import type { Sculpture } from "./source";
import { Stage, type Pose, type Vantage } from "../scene/stage";
import { styleSheet } from "./style";
import { colourAt, tintsAt } from "../scene/tints";
import type { View } from "../scene/view";
import { wordsOf, type Words } from "./words";

/** What `view-change` tells: null where a person has turned it by hand. */
export interface ViewChange {
  readonly view: string | null;
}

/** What a sculpture is like now, as plain JSON. */
export interface SculptureState {
  readonly view: string | null;
  /** Degrees; `reach` is from the middle to the nearer border, `target` what is looked at, both in world units. */
  readonly camera: { readonly azimuth: number; readonly elevation: number; readonly reach: number; readonly lens: number; readonly target: Vec3 } | null;
  readonly look: LookName;
  readonly shadow: boolean;
  readonly color: string | null;
  readonly widthScale: number;
}

/** What pictures are taken in, pixels. */
export interface PictureOptions {
  readonly width?: number;
  readonly height?: number;
  readonly transparent?: boolean;
  readonly mimeType?: string;
}

/** Elements are fetched and drawn when they are so near to what is seen. */
const NEAR = "200px";
/** How long after the wire is seen somebody is told that it can be turned. */
const PROMPT_MS = 2500;
/** One that was held until just now keeps its context. */
const HELD_MS = 3000;
/** Drawings without 3D follow each other no faster. */
const FLAT_MS = 120;
const DEGREE = Math.PI / 180;
const MAX_DENSITY = 2;

/** In a worker there are no elements, and nobody asks for one. */
const Base = (globalThis.HTMLElement ?? Object) as typeof HTMLElement;

export class WireSculpture extends Base implements Member {
  static readonly observedAttributes = ATTRIBUTES;
  /** Where the module lies that a worker is to run, where it does not lie under its own name. */
  static workerUrl: string | null = null;
  /** Starts a worker that draws; null where the page is to draw. */
  static startWorker: () => Worker | null = () => null;

  declare src: string | null;
  declare code: string | null;
  declare alt: string | null;
  declare poster: string | null;
  declare loading: "auto" | "lazy" | "eager";
  declare reveal: "auto" | "manual" | "interaction";
  declare cameraControls: boolean;
  declare controls: boolean;
  declare cameraOrbit: string | null;
  declare autoRotate: boolean;
  declare touchAction: string;
  declare interactionPrompt: "auto" | "none";
  declare views: string | null;
  declare look: LookName;
  declare color: string | null;
  declare widthScale: number;
  declare shadow: boolean;
  declare replay: boolean;
  /** JSON, or an object to be made that. */
  declare labels: string | null;

  /** Keys that show views; null for digits, in the order of the buttons, and F. */
  viewKeys: Readonly<Record<string, string>> | null = null;
  protected stage: Stage | null = null;
  private shape: WireShape | null = null;
  private solid: BodyShape | null = null;
  private throughIt: boolean | null = null;
  private places: readonly Vec3[] | null = null;
  private ofWire: readonly View[] = [];
  private replayer: Replayer | null = null;
  private canvas = h("canvas", { class: "live" });
  private canvasUsed = false;
  private readonly still = h("canvas", { class: "still", hidden: "", "aria-hidden": "true" });
  private readonly image = h("img", { class: "poster", part: "poster", alt: "" });
  private readonly posterSlot = h("slot", { name: "poster", class: "poster" });
  private readonly about = h("p", { id: "about", class: "unseen" });
  private readonly seenFrom = h("p", { id: "view", class: "unseen" });
  private readonly keys = h("p", { id: "keys", class: "unseen" });
  private readonly probe = h("span", { class: "unseen", "aria-hidden": "true" });
  private readonly prompt = h("span", { class: "prompt", part: "prompt", "aria-hidden": "true", hidden: "" });
  private readonly box = h("div", { class: "view" }, this.still, this.canvas, this.posterSlot, this.prompt);
  private readonly bar = new Bar({
    view: (name) => this.flyTo(name),
    step: (turnRad, zoom) => this.stage?.step(turnRad, zoom),
    look: (look) => this.changeLook(look, this.shadow),
    room: () => this.changeLook(this.look, !this.shadow),
    through: () => this.tell("see-through"),
  });
  private message: HTMLElement | null = null;
  private revealer: HTMLElement | null = null;
  private drawing: SVGSVGElement | null = null;
  private changed = new Set<string>();
  private updating = false;
  private observers: readonly IntersectionObserver[] = [];
  private ending: AbortController | null = null;
  private reading: AbortController | null = null;
  private near = false;
  private inSight = false;
  private dismissed = false;
  private isDrawn = false;
  private toAnnounce = false;
  private heldMs = -Infinity;
  private prompting: ReturnType<typeof setTimeout> | undefined;
  /** Where the camera is: a view that has a name, or by itself. */
  private at: ViewName | null = "room";
  private custom: string | null = null;
  private wanted: Vantage | null = null;
  private pose: Pose | null = null;
  /** Whether a worker draws; where it turns out not to be able to, the page does. */
  private aside = true;
  private flat = false;
  private drawingSoon: ReturnType<typeof setTimeout> | undefined;
  private afterDrawn: (() => void)[] = [];

  constructor() {
    super();
    const root = this.attachShadow({ mode: "open" });
    root.adoptedStyleSheets = [styleSheet()];
    // A page may lay the element out as it likes: what is inside keeps its order.
    root.append(h("div", { class: "frame" }, this.box, h("div", { class: "ring" }), this.bar.element), this.about, this.seenFrom, this.keys, this.probe);
    for (const name of ["pointerenter", "pointerdown", "focusin"]) this.box.addEventListener(name, () => this.isResting && this.consider());
  }

  /** The wire, where a script gives one; otherwise that of `src` or `code`. */
  get wire(): WireShape | null {
    return this.shape;
  }

  set wire(wire: WireShape | null) {
    this.shape = wire;
    this.sendWire();
    if (this.stage) return;
    this.consider();
    if (this.flat) this.drawSoon();
  }

  /** What the wire covers: a solid that hides what is behind it. */
  set body(body: BodyShape | null) {
    if (body === this.solid) return;
    this.solid = body;
    this.stage?.setBody(body);
  }

  /** Whether the wire is seen through its body; null where there is to be no button for that. */
  set through(through: boolean | null) {
    this.throughIt = through;
    this.stage?.seeThrough(through === true);
    this.dress();
  }

  /** Rings round these places; null for none. */
  mark(places: readonly Vec3[] | null): void {
    this.places = places;
    this.stage?.mark(places);
  }

  /** The view by the name of its button; null where a person has turned it by hand. */
  get view(): string | null {
    if (this.custom) return this.custom;
    const { at } = this;
    return at === "side" && !this.buttons.includes("side") && this.buttons.includes("right") ? "right" : at;
  }

  set view(view: string | null) {
    setAttribute(this, "view", view);
  }

  /** To a view by its name, or to anywhere else. */
  flyTo(view: string | Vantage): void {
    this.go(view);
    this.hold();
  }

  /** Shows a sculpture whose `reveal` waits for that. */
  dismissPoster(): void {
    this.dismissed = true;
    this.dress();
    this.consider();
  }

  /** Plays how the wire was found, where its file says so. */
  play(): void {
    this.replayer?.play();
  }

  pause(): void {
    this.replayer?.pause();
  }

  /** Reads the colours anew, after a change of custom properties. */
  recolour(): void {
    this.stage?.setLook(this.lookNow());
  }

  /** A picture of what is seen: of the element's own size, and on the colour of its walls, unless told otherwise. */
  async toBlob({ width, height, transparent = false, mimeType = "image/png" }: PictureOptions = {}): Promise<Blob> {
    if (this.flat) throw new Error("This browser cannot draw in 3D here, so there is no picture to save.");
    if (!this.stage) {
      join(this);
      await new Promise<void>((drawn) => this.afterDrawn.push(drawn));
    }
    if (!this.stage) throw new Error("The picture could not be drawn.");
    return this.stage.picture(width ?? (this.canvas.clientWidth || 800), height ?? (this.canvas.clientHeight || 600), transparent, mimeType);
  }

  getState(): SculptureState {
    const { pose, view, look, shadow, color, widthScale } = this;
    const camera = pose && { azimuth: pose.azimuthRad / DEGREE, elevation: pose.elevationRad / DEGREE, reach: pose.reach, lens: pose.fovYRad / DEGREE, target: pose.target };
    return { view, camera, look, shadow, color, widthScale };
  }

  /** Takes what `getState` gave; what is missing, or is none, stays as it is. */
  setState(state: Partial<SculptureState>): void {
    const { view, camera, look, shadow, color, widthScale } = state;
    if (LOOK_NAMES.some((name) => name === look)) this.look = look!;
    if (typeof shadow === "boolean") this.shadow = shadow;
    if (color === null || typeof color === "string") this.color = color;
    if (typeof widthScale === "number") this.widthScale = widthScale;
    if (typeof view === "string") {
      this.go(view, 0);
    } else if (camera) {
      const { azimuth, elevation, reach, lens, target } = camera;
      if (![azimuth, elevation, reach, lens, ...(target ?? [NaN])].every(Number.isFinite) || target.length !== 3) return;
      const within = (least: number, x: number, most: number): number => Math.max(least, Math.min(most, x));
      this.pose = {
        azimuthRad: azimuth * DEGREE,
        elevationRad: within(-1.45, elevation * DEGREE, Math.PI / 2),
        reach: within(0.15, reach, 4),
        fovYRad: within(0.02, lens * DEGREE, 1),
        target: target.map((x) => within(-1.5, x, 1.5)) as unknown as Vec3,
      };
      this.wanted = null;
      this.moved(null);
      this.stage?.place(this.pose);
    }
  }

  connectedCallback(): void {
    takeOver(this);
    this.ending = new AbortController();
    const { signal } = this.ending;
    for (const query of ["(prefers-color-scheme: dark)", "(forced-colors: active)"]) {
      matchMedia(query).addEventListener("change", () => this.recolour(), { signal });
    }
    document.addEventListener("visibilitychange", () => this.rouse(), { signal });
    const observe = (rootMargin: string, tell: (on: boolean) => void): IntersectionObserver => {
      const observer = new IntersectionObserver(([...entries]) => tell(entries.at(-1)!.isIntersecting), { rootMargin });
      observer.observe(this);
      return observer;
    };
    this.observers = [observe(NEAR, (near) => this.approach(near)), observe("0px", (inSight) => this.sight(inSight))];
    this.update();
  }

  disconnectedCallback(): void {
    this.ending?.abort();
    for (const observer of this.observers) observer.disconnect();
    this.reading?.abort();
    this.replayer?.pause();
    clearTimeout(this.prompting);
    this.near = this.inSight = false;
    this.stop();
    leave(this);
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (before === after) return;
    // Also what is set elsewhere counts, when it comes into the page.
    if (!this.updating && this.isConnected) {
      this.updating = true;
      queueMicrotask(() => this.isConnected && this.update());
    }
    this.changed.add(name);
  }

  // What the crowd wants to know.

  get seen(): boolean {
    return this.near;
  }

  get rests(): boolean {
    return !this.shape || (this.isDrawn && performance.now() - this.heldMs > HELD_MS);
  }

  wake(): void {
    if (this.canvasUsed) this.renewCanvas();
    this.canvasUsed = true;
    const events = {
      hold: () => this.hold(),
      view: (view: ViewName | null) => this.moved(view),
      camera: (pose: Pose) => {
        this.pose = pose;
        this.tell("camera-change", this.getState().camera);
      },
      lost: (lost: boolean) => this.say(lost ? this.wording.lost : null, "lost"),
      drawn: () => this.drawn(),
      unavailable: () => this.undrawable(),
    };
    const { startWorker } = this.constructor as typeof WireSculpture;
    const worker = this.aside && "transferControlToOffscreen" in this.canvas ? startWorker() : null;
    this.aside = worker !== null;
    const stage = (this.stage = new Stage(this.canvas, this.lookNow(), this.grip, events, worker));
    if (this.solid) stage.setBody(this.solid);
    stage.seeThrough(this.throughIt === true);
    this.sendWire();
    if (this.places) stage.mark(this.places);
    if (this.wanted) stage.flyTo(this.wanted, 0);
    else if (this.pose) stage.place(this.pose);
    this.move();
    this.rouse();
  }

  async rest(): Promise<void> {
    const { stage, canvas, still } = this;
    if (!stage) return;
    try {
      const density = Math.min(MAX_DENSITY, devicePixelRatio || 1);
      const bitmap = await createImageBitmap(await stage.picture(canvas.clientWidth * density, canvas.clientHeight * density, true));
      [still.width, still.height] = [bitmap.width, bitmap.height];
      still.getContext("2d")?.drawImage(bitmap, 0, 0);
      still.hidden = false;
    } catch {
      // It comes back without.
    }
    if (this.stage === stage) this.stop();
  }

  /** What the camera does by itself. */
  protected get moves(): { readonly on: boolean; readonly round: boolean } {
    return { on: this.autoRotate, round: true };
  }

  /** Tells the stage. */
  protected move(): void {
    const { on, round } = this.moves;
    this.stage?.sway(on, round);
  }

  /** Whether somebody can see it now. */
  protected get isSeen(): boolean {
    return this.inSight && !document.hidden;
  }

  /** To be called when that may have changed: what nobody sees is not drawn, unless it is for the first time, or for a picture. */
  protected rouse(): void {
    const first = this.near && !this.isDrawn;
    this.stage?.pause(!(this.isSeen || first || this.afterDrawn.length > 0));
  }

  protected tell(name: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  private readonly grip = ((element: WireSculpture) => ({
    get turns() {
      return element.cameraControls;
    },
    get wheel() {
      // Whoever scrolls past is not to be caught.
      return element.touchAction === "none" || element.shadowRoot!.activeElement === element.canvas;
    },
    key: (key: string) => element.press(key),
  }))(this);

  private get wording(): Words {
    return wordsOf(this.labels);
  }

  private get buttons(): readonly string[] {
    const { views } = this;
    if (views === null) return [];
    const named = views.split(/\s+/).filter((name) => name in DIRECTIONS || this.ofWire.some((view) => view.name === name));
    return named.length > 0 ? named : this.ofWire.length > 0 ? ["room", ...this.ofWire.map(({ name }) => name)] : [];
  }

  private get isResting(): boolean {
    return !this.stage && this.isDrawn;
  }

  private get revealed(): boolean {
    return this.dismissed || this.reveal === "auto" || !(this.reveal === "manual" || this.reveal === "interaction");
  }

  private get isGiven(): boolean {
    return this.src !== null || this.code !== null;
  }

  private approach(near: boolean): void {
    this.near = near;
    this.rouse();
    this.consider();
    if (!near && !this.stage) leave(this);
  }

  private sight(inSight: boolean): void {
    this.inSight = inSight;
    this.rouse();
  }

  /** Reads and shows what there is, if the time has come. */
  private consider(): void {
    if (!this.isConnected) return;
    if (this.changed.has("to read") && (this.near || this.loading === "eager")) {
      this.changed.delete("to read");
      void this.read();
    }
    if (!this.near || !this.revealed || this.flat) return;
    if (this.shape || !this.isGiven) join(this);
  }

  private update(): void {
    const { changed } = this;
    this.updating = false;
    this.changed = new Set(changed.has("to read") || changed.has("src") || changed.has("code") ? ["to read"] : []);
    if (changed.has("look") || changed.has("color") || changed.has("shadow")) this.recolour();
    if (changed.has("width-scale")) this.sendWire();
    if (changed.has("auto-rotate")) this.move();
    const orbit = changed.has("camera-orbit") && this.cameraOrbit ? orbitOf(this.cameraOrbit) : null;
    const view = changed.has("view") ? this.getAttribute("view") : null;
    if (orbit) this.go(orbit);
    else if (view) this.go(view);
    this.dress();
    this.consider();
  }

  private async read(): Promise<void> {
    this.reading?.abort();
    const { signal } = (this.reading = new AbortController());
    const { src, code } = this;
    this.say(null);
    if (!this.isGiven) return;
    try {
      const { fromCode, fromFile } = await import("./source");
      const sculpture = code !== null ? fromCode(code) : await fromFile(new URL(src!, document.baseURI).href, signal);
      if (!signal.aborted) await this.show(sculpture, signal);
    } catch (error) {
      if (!signal.aborted) this.fail(error);
    }
  }

  private async show({ wire, views, replay }: Sculpture, signal: AbortSignal): Promise<void> {
    this.replayer?.end();
    this.replayer = null;
    this.ofWire = views;
    this.toAnnounce = true;
    const view = this.getAttribute("view");
    // Only now it is known where that is.
    if (view && !(view in DIRECTIONS)) this.go(view, 0);
    if (this.stage) this.stage.setWire(null);
    this.wire = wire;
    this.dress();
    if (!this.replay || !replay) return;
    const { Replayer } = await import("./replayer");
    if (signal.aborted) return;
    this.replayer = Replayer.of(replay, wire, this.wording, (wire) => this.setShape(wire));
    this.dress();
    if (this.isDrawn) this.replayer?.begin();
  }

  private setShape(wire: WireShape): void {
    this.shape = wire;
    this.sendWire();
  }

  private fail(error: unknown): void {
    const known = error instanceof Error && error.name === "SourceError";
    if (!known) console.error(error);
    const sentence = known ? error.message : "The sculpture could not be read.";
    this.shape = null;
    this.isDrawn = false;
    this.stage?.setWire(null);
    this.say(sentence, this.poster ? "failed low" : "failed");
    this.dress();
    this.tell("error", { sentence });
  }

  private sendWire(): void {
    const { shape, widthScale } = this;
    if (!this.stage || !shape || widthScale === 1) {
      this.stage?.setWire(shape);
      return;
    }
    const controlPoints = Float64Array.from(shape.controlPoints, (x, at) => (at % 4 === 3 ? x * widthScale : x));
    this.stage.setWire({ ...shape, controlPoints });
  }

  private lookNow() {
    const { probe, color } = this;
    const metal = color && CSS.supports("color", color) ? colourAt(probe, color) : null;
    const look = LOOK_NAMES.find((name) => name === this.look) ?? "copper";
    return lookOf(look, tintsAt(probe), this.shadow, metal);
  }

  private changeLook(look: LookName, room: boolean): void {
    this.look = look;
    this.shadow = room;
    this.tell("look-change", { look, room });
  }

  private go(view: string | Vantage, durationMs?: number): void {
    const found = typeof view === "string" && !(view in DIRECTIONS) ? this.ofWire.find(({ name }) => name === view) : null;
    if (found === undefined) return;
    const vantage = found ? vantageOf(found) : (view as Vantage);
    this.custom = found ? found.name : null;
    this.wanted = vantage;
    this.pose = null;
    if (this.stage) this.stage.flyTo(vantage, durationMs);
    else this.moved(typeof vantage === "string" ? vantage : null);
    if (this.isResting) this.consider();
    if (this.flat) this.drawSoon();
  }

  private press(key: string): boolean {
    const views = this.buttons.filter((name) => name !== "room");
    const view = this.viewKeys ? this.viewKeys[key.toLowerCase()] : key.toLowerCase() === "f" ? "room" : views[Number(key) - 1];
    if (view) this.flyTo(view);
    return !!view;
  }

  private moved(view: ViewName | null): void {
    this.at = view;
    if (view) this.custom = null;
    this.dress();
    this.tell("view-change", { view: this.view } satisfies ViewChange);
  }

  /** A person took hold. */
  private hold(): void {
    this.heldMs = performance.now();
    clearTimeout(this.prompting);
    this.prompt.hidden = true;
    this.tell("hold");
  }

  private drawn(): void {
    if (!this.isDrawn) performance.mark("wire-sculpture drawn");
    this.isDrawn = true;
    this.still.hidden = true;
    this.posterSlot.classList.add("away");
    for (const tell of this.afterDrawn.splice(0)) tell();
    this.rouse();
    if (this.toAnnounce) this.announce();
    this.replayer?.begin();
    settle();
  }

  private announce(): void {
    this.toAnnounce = false;
    this.tell("load");
    if (!this.cameraControls || this.interactionPrompt === "none" || this.flat || this.heldMs > 0) return;
    clearTimeout(this.prompting);
    this.prompting = setTimeout(() => (this.prompt.hidden = false), PROMPT_MS);
  }

  private stop(): void {
    this.stage?.dispose();
    this.stage = null;
  }

  /** If the worker cannot draw, the page may; if neither can, there is a drawing. */
  private undrawable(): void {
    this.stop();
    if (this.aside) {
      this.aside = false;
      this.wake();
      return;
    }
    this.flat = true;
    leave(this);
    // A drawing has no depth: from straight on it says most.
    if (this.wanted) this.drawSoon();
    else this.go("front");
  }

  private renewCanvas(): void {
    const focused = this.shadowRoot!.activeElement === this.canvas;
    const canvas = h("canvas", { class: "live" });
    this.canvas.replaceWith(canvas);
    this.canvas = canvas;
    this.dress();
    if (focused) canvas.focus();
  }

  private drawSoon(): void {
    this.drawingSoon ??= setTimeout(() => {
      this.drawingSoon = undefined;
      void this.draw();
    }, FLAT_MS);
  }

  /** Without WebGL 2. */
  private async draw(): Promise<void> {
    const { shape } = this;
    const { drawingOf } = await import("./flat");
    if (shape !== this.shape) return;
    const drawing = shape && drawingOf(shape, this.wanted!);
    this.drawing?.remove();
    this.drawing = drawing;
    if (drawing) {
      drawing.classList.add("flat");
      this.canvas.before(drawing);
      this.posterSlot.classList.add("away");
    }
    if (!this.message) this.say(this.wording.flat, "flat-note low");
    this.dress();
    if (shape && this.toAnnounce) this.announce();
  }

  /** A sentence over what is seen; null takes it away. */
  private say(sentence: string | null, kind = ""): void {
    this.message?.remove();
    this.message = sentence ? h("p", { class: `message ${kind}`, part: "message", role: "status" }, h("span", {}, sentence)) : null;
    if (this.message) this.box.append(this.message);
  }

  /** All that is about the picture: names, buttons, poster. */
  private dress(): void {
    if (!this.isConnected) return;
    const { wording: words, canvas, shape, view, image } = this;
    const holds = this.cameraControls && !this.flat;
    const name = this.alt || words.sculpture;
    const spoken = words as Partial<Record<string, string>>;
    setAttribute(canvas, "role", holds ? "application" : "img");
    setAttribute(canvas, "tabindex", holds ? 0 : null);
    setAttribute(canvas, "aria-label", name);
    setAttribute(canvas, "aria-describedby", holds ? "about view keys" : "about view");
    canvas.classList.toggle("held", holds);
    canvas.style.touchAction = holds ? (/^(pan-x|pan-y|none)$/.test(this.touchAction) ? this.touchAction : "pan-y") : "";
    const madeFor = this.ofWire.map(({ name }) => (spoken[name] ?? name).toLowerCase()).join(", ");
    this.about.textContent = shape ? [shape.closed ? words.closed : words.open, madeFor && `${words.madeFor} ${madeFor}.`].filter(Boolean).join(" ") : "";
    this.seenFrom.textContent = view ? (spoken[`seen${view[0]!.toUpperCase()}${view.slice(1)}`] ?? view) : words.turned;
    this.keys.textContent = words.keys;
    this.prompt.textContent = words.prompt;
    const { poster } = this;
    if (poster !== image.getAttribute("src")) setAttribute(image, "src", poster);
    if (poster && !image.isConnected) this.posterSlot.append(image);
    else if (!poster) image.remove();
    this.posterSlot.classList.toggle("away", this.isDrawn || this.drawing !== null);
    this.offerReveal(words);
    const parts = { words, views: this.buttons, controls: this.controls && !this.flat, farSide: this.throughIt !== null };
    this.bar.show(parts, { view, look: this.look, room: this.shadow, through: this.throughIt === true }, this.replayer?.element ?? null);
  }

  private offerReveal(words: Words): void {
    const offered = this.reveal === "interaction" && !this.revealed;
    if (offered && !this.revealer) {
      this.revealer = h("button", { type: "button", class: "reveal", part: "reveal", onclick: () => this.dismissPoster() }, h("span", {}, words.reveal));
      this.box.append(this.revealer);
    } else if (!offered) {
      this.revealer?.remove();
      this.revealer = null;
    }
  }
}

if (globalThis.HTMLElement) reflect(WireSculpture.prototype);

/** Where a view of the wire is looked at from. */
function vantageOf({ name, eye, target }: View): Vantage {
  if (name in DIRECTIONS) return name as ViewName;
  const [x, y, z] = [eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]];
  return { azimuthRad: Math.atan2(x, z), elevationRad: Math.atan2(y, Math.hypot(x, z)) };
}

declare global {
  interface HTMLElementTagNameMap {
    "wire-sculpture": WireSculpture;
  }
}
