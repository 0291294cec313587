/** The wire in hand: which control point is held, and what is done to it. */

import { msg, str } from "@lit/localize";
import type { WireShape } from "#sculpture/scene/shape";
import type { WireEdit } from "../../engine/protocol";
import { Store } from "../../state/common/store";
import { explain } from "../../words/sentences";
import { deskOf, type Made, type Studio } from "../../state/studio";
import { withDesk } from "../../state/keeping/document";
import { pageColours } from "../../view/colours";
import { onPicture } from "../../view/on-picture";
import type { WireStage } from "../stage/wire-stage";
import { paintHandles } from "./handles";

export type Point = readonly [x: number, y: number, z: number, width: number];

export interface HandsState {
  /** The wire that is in hand, as it is while it is dragged; null where there is none that may be. */
  readonly wire: WireShape | null;
  /** The control point that is held, from 0. */
  readonly held: number;
  /** The other end of a stretch to be smoothed or straightened. */
  readonly end: number;
  /** What the last edit did, in a sentence, or empty. */
  readonly said: string;
}

/** How near to a control point somebody has to point, CSS pixels; with a finger. */
const NEAR_PX = 14;
const NEAR_FINGER_PX = 24;
/** How many points a stretch is long at first. */
const STRETCH = 6;

export class Hands {
  readonly store = new Store<HandsState>({ wire: null, held: 0, end: STRETCH, said: "" });
  private readonly canvas = document.createElement("canvas");
  private painting = 0;
  private isBusy = false;

  constructor(
    readonly studio: Studio,
    private readonly stage: WireStage,
  ) {
    this.canvas.setAttribute("aria-hidden", "true");
    stage.lay(this.canvas);
    studio.store.watch(({ tool, phase, doc, looking }) => [tool, phase, looking, deskOf(doc).made], () => this.takeUp());
    this.store.follow(() => this.repaint());
    for (const event of ["camera-change", "look-change"]) stage.addEventListener(event, () => this.repaint());
    stage.addEventListener("pointerdown", (event) => this.grasp(event), { capture: true });
    new ResizeObserver(() => this.repaint()).observe(this.canvas);
    addEventListener("theme-change", () => this.repaint());
    this.takeUp();
  }

  get count(): number {
    return (this.store.get().wire?.controlPoints.length ?? 0) / 4;
  }

  point(index = this.store.get().held): Point {
    return [0, 1, 2, 3].map((c) => this.store.get().wire!.controlPoints[4 * index + c]!) as unknown as Point;
  }

  hold(index: number): void {
    const held = Math.max(0, Math.min(this.count - 1, index));
    const { end } = this.store.get();
    this.store.set({ held, end: Math.abs(end - held) < 2 ? this.within(held + STRETCH) : end, said: "" });
  }

  stretchTo(end: number): void {
    this.store.set({ end: this.within(end) });
  }

  /** Does it, as one step that undo takes back. */
  async edit(edit: WireEdit, label: string, say: (strayed: number) => string = () => ""): Promise<void> {
    const { bench } = this.studio;
    const { made } = this;
    if (!made || this.isBusy || bench.busy) return;
    this.isBusy = true;
    try {
      const { file, held, strayed } = await bench.engine.call("edit", { file: made.finished.file, edit });
      const opened = await bench.engine.call("open", { file, name: "wire.json" });
      if (this.made !== made) return;
      const finished = { ...opened, targets: made.finished.targets };
      const next: Made = { finished, source: "hand", track: null, stopped: false, seconds: 0 };
      this.store.set({ held });
      bench.store.batch(() => {
        bench.store.set({ ahead: null, lookingBack: null });
        bench.edit(label, withDesk(bench.doc, bench.doc.task, { made: next, loose: null }), edit.kind === "move" ? `hand ${edit.index}` : "");
      });
      this.store.set({ said: say(strayed) });
    } catch (error) {
      this.takeUp();
      bench.warn(explain(error, msg("The wire")));
    } finally {
      this.isBusy = false;
    }
  }

  private get made(): Made | null {
    return deskOf(this.studio.store.get().doc).made;
  }

  private get isOpen(): boolean {
    const { tool, phase, looking } = this.studio.store.get();
    return tool === "hands" && phase === "idle" && looking === null;
  }

  private within(index: number): number {
    return Math.max(0, Math.min(this.count - 1, index));
  }

  private takeUp(): void {
    const wire = this.isOpen ? (this.made?.finished.wire ?? null) : null;
    const most = wire ? wire.controlPoints.length / 4 - 1 : 0;
    const { wire: before, end } = this.store.get();
    const held = Math.min(this.store.get().held, most);
    this.store.set({ wire, held, end: Math.min(before ? end : held + STRETCH, most) });
  }

  /** The nearest control point that somebody points at. */
  private at({ clientX, clientY, pointerType }: PointerEvent): number | null {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const clip = this.stage.clipFromWorld(width, height);
    if (!clip) return null;
    let [nearest, at]: [number, number | null] = [pointerType === "touch" ? NEAR_FINGER_PX : NEAR_PX, null];
    for (let i = 0; i < this.count; i++) {
      const [x, y, z] = this.point(i);
      const seen = onPicture(clip, width, height, x, y, z);
      const away = seen ? Math.hypot(seen[0] + left - clientX, seen[1] + top - clientY) : Infinity;
      // Of two in one place the one that is held stays.
      if (away < nearest || (away === nearest && i === this.store.get().held)) [nearest, at] = [away, i];
    }
    return at;
  }

  /** Whoever points at a control point drags it in the picture's plane; beside them the camera is held. */
  private grasp(event: PointerEvent): void {
    if (!this.isOpen || event.button !== 0 || !this.store.get().wire || this.isBusy) return;
    const index = this.at(event);
    if (index === null) return;
    event.preventDefault();
    event.stopPropagation();
    this.hold(index);
    const from = this.point(index);
    const move = this.dragging(from, event);
    let to: Point = from;
    const stop = new AbortController();
    const { signal } = stop;
    this.stage.setPointerCapture(event.pointerId);
    this.stage.addEventListener("pointermove", (moved) => {
      moved.stopPropagation();
      if (moved.pointerId === event.pointerId && move) this.preview(index, (to = move(moved)));
    }, { signal, capture: true });
    const drop = (ended: PointerEvent): void => {
      if (ended.pointerId !== event.pointerId) return;
      stop.abort();
      if (ended.type === "pointerup" && to !== from) void this.edit({ kind: "move", index, to }, msg(str`Move point ${index + 1}`));
      else this.preview(index, from);
    };
    for (const end of ["pointerup", "pointercancel"] as const) this.stage.addEventListener(end, drop, { signal, capture: true });
  }

  /** From where the pointer is to where the point goes: along the picture's right and up through where it was. */
  private dragging([x, y, z, width]: Point, began: PointerEvent): ((moved: PointerEvent) => Point) | null {
    const box = this.canvas.getBoundingClientRect();
    const clip = this.stage.clipFromWorld(box.width, box.height);
    const camera = this.stage.getState().camera;
    if (!clip || !camera) return null;
    const [a, e] = [camera.azimuth, camera.elevation].map((degrees) => (degrees * Math.PI) / 180) as [number, number];
    const right = [Math.cos(a), 0, -Math.sin(a)] as const;
    const up = [-Math.sin(a) * Math.sin(e), Math.cos(e), -Math.cos(a) * Math.sin(e)] as const;
    const seen = (by: number): readonly [number, number] | null => onPicture(clip, box.width, box.height, x + by * right[0], y + by * right[1], z + by * right[2]);
    const [here, there] = [seen(0), seen(0.01)];
    if (!here || !there) return null;
    const worldPerPx = 0.01 / Math.max(1e-6, Math.hypot(there[0] - here[0], there[1] - here[1]));
    return ({ clientX, clientY }) => {
      const [dx, dy] = [(clientX - began.clientX) * worldPerPx, (began.clientY - clientY) * worldPerPx];
      return [x + dx * right[0] + dy * up[0], y + dx * right[1] + dy * up[1], z + dx * right[2] + dy * up[2], width];
    };
  }

  /** On the stage alone: what is dropped becomes a step. */
  private preview(index: number, to: Point): void {
    const { wire } = this.store.get();
    if (!wire) return;
    const controlPoints = Float32Array.from(wire.controlPoints);
    controlPoints.set(to, 4 * index);
    const moved = { ...wire, controlPoints };
    this.store.set({ wire: moved });
    this.stage.setWire(moved);
  }

  private repaint(): void {
    this.painting ||= requestAnimationFrame(() => {
      this.painting = 0;
      const { wire, held, end } = this.store.get();
      this.canvas.hidden = !wire;
      if (!wire) return;
      const { clientWidth, clientHeight } = this.canvas;
      const { ink } = pageColours();
      const halo = getComputedStyle(this.stage).getPropertyValue("--stage");
      paintHandles(this.canvas, this.stage.clipFromWorld(clientWidth, clientHeight), { points: wire.controlPoints, held, end, ink, halo });
    });
  }
}
