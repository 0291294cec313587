/**
 * A canvas on which a wire hangs in its room, and a camera that people hold. Knows control points and knots and nothing
 * of the rest of the page.
 */

import { inPage, inWorker, type Backstage, type PictureOrder } from "./backstage";
import type { BodyShape } from "./body";
import { listen, type Grip } from "./controls";
import type { Look } from "./looks";
import type { Vec3 } from "./matrix";
import type { Pose, Vantage } from "./orbit";
import type { SceneEvents } from "./scene";
import type { WireShape } from "./shape";

export type { Pose, Vantage, ViewName } from "./orbit";

/** What the stage tells. */
export interface StageEvents extends SceneEvents {
  /** A person took hold of the camera. */
  hold(): void;
  /** It cannot draw, and is of no use; where a worker was to, one without, on another canvas, may be. */
  unavailable(): void;
}

const NOTHING = (): void => undefined;

export class Stage {
  private readonly backstage: Backstage;
  private readonly ending = new AbortController();
  private readonly hold: () => void;

  /** With a worker that serves (`serving.ts`), everything is drawn there. */
  constructor(canvas: HTMLCanvasElement, look: Look, grip: Grip, events: Partial<StageEvents> = {}, worker: Worker | null = null) {
    const { hold = NOTHING, view = NOTHING, lost = NOTHING, camera = NOTHING, drawn = NOTHING, unavailable = NOTHING } = events;
    this.hold = hold;
    const told = { view, lost, camera, drawn };
    this.backstage = worker ? inWorker(worker, canvas, look, told, unavailable) : inPage(canvas, look, told, unavailable);
    const { signal } = this.ending;
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    const calm = (): void => this.backstage.act("keepStill", still.matches);
    still.addEventListener("change", calm, { signal });
    calm();
    const observer = new ResizeObserver(() => this.backstage.act("resize", canvas.clientWidth, canvas.clientHeight, devicePixelRatio || 1));
    observer.observe(canvas);
    const holds = {
      turn: (azimuthRad: number, elevationRad: number) => this.held(() => this.backstage.act("turn", azimuthRad, elevationRad)),
      zoom: (factor: number) => this.held(() => this.backstage.act("zoom", factor)),
      pan: (right: number, up: number) => this.held(() => this.backstage.act("pan", right, up)),
    };
    const stopListening = listen(canvas, holds, grip);
    signal.addEventListener("abort", () => {
      observer.disconnect();
      stopListening();
    });
  }

  setWire(wire: WireShape | null): void {
    this.backstage.act("setWire", wire);
  }

  /** Rings round these places; null for none. */
  mark(places: readonly Vec3[] | null): void {
    this.backstage.act("mark", places);
  }

  /** What the wire covers: a solid that hides what is behind it. */
  setBody(body: BodyShape | null): void {
    this.backstage.act("setBody", body);
  }

  /** Whether the wire is seen through the body. */
  seeThrough(through: boolean): void {
    this.backstage.act("seeThrough", through);
  }

  setLook(look: Look): void {
    this.backstage.act("setLook", look);
  }

  /** A view straight on, or the room as a whole; `durationMs` 0 is at once. */
  flyTo(vantage: Vantage, durationMs?: number): void {
    this.backstage.act("flyTo", vantage, durationMs);
  }

  /** A step by a button: radians to the right, and a factor of the distance. */
  step(turnRad: number, zoom: number): void {
    this.held(() => this.backstage.act("step", turnRad, zoom));
  }

  /** From vantage to vantage, until somebody takes hold; nothing for people who asked for less motion. */
  tour(places: readonly Vantage[]): void {
    this.backstage.act("tour", places);
  }

  /** Whether the camera sways slowly by itself; never for people who asked for less motion. */
  sway(on: boolean, round = false): void {
    this.backstage.act("sway", on, round);
  }

  /** Where somebody has left it before, at once. */
  place(pose: Pose): void {
    this.backstage.act("place", pose);
  }

  /** Whether nobody sees it. */
  pause(paused: boolean): void {
    this.backstage.act("pause", paused);
  }

  /** Somebody else needs the processor: where that draws, this share of the time may go into pictures; above 0 to 1, no limit. */
  ration(share: number): void {
    this.backstage.act("ration", share);
  }

  /** What the stage shows as a picture of that size, on the colour of its walls or on nothing. */
  picture(...of: PictureOrder): Promise<Blob> {
    return this.backstage.picture(...of);
  }

  dispose(): void {
    this.ending.abort();
    this.backstage.dispose();
  }

  private held(action: () => void): void {
    action();
    this.hold();
  }
}
