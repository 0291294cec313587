/**
 * A canvas on which a wire hangs in its room, and a camera that people hold. Knows control points and knots and nothing
 * of the rest of the page.
 */

import { inPage, inWorker, type Backstage } from "./backstage";
import type { BodyShape } from "./body";
import { listen } from "./controls";
import type { Look } from "./looks";
import type { Vec3 } from "./matrix";
import type { Vantage } from "./orbit";
import type { SceneEvents } from "./scene";
import type { WireShape } from "./shape";

export type { Vantage, ViewName } from "./orbit";
export { StageUnavailable } from "./scene";

/** What the stage tells. */
export interface StageEvents extends SceneEvents {
  /** A person took hold of the camera. */
  hold(): void;
  /** The worker cannot draw. This stage is of no use; one without a worker, on another canvas, may be. */
  unavailable(): void;
}

const NOTHING = (): void => undefined;

export class Stage {
  private readonly backstage: Backstage;
  private readonly ending = new AbortController();
  private readonly hold: () => void;

  /**
   * With a worker that runs `backstage-worker.ts`, everything is drawn there.
   * @throws StageUnavailable where the browser has no WebGL 2; with a worker, `unavailable` tells.
   */
  constructor(canvas: HTMLCanvasElement, look: Look, events: Partial<StageEvents> = {}, worker: Worker | null = null) {
    const { hold = NOTHING, view = NOTHING, lost = NOTHING, unavailable = NOTHING } = events;
    this.hold = hold;
    const told = { view, lost };
    this.backstage = worker ? inWorker(worker, canvas, look, told, unavailable) : inPage(canvas, look, told);
    const { signal } = this.ending;
    const still = matchMedia("(prefers-reduced-motion: reduce)");
    const calm = (): void => this.backstage.act("keepStill", still.matches);
    still.addEventListener("change", calm, { signal });
    calm();
    const observer = new ResizeObserver(() => this.backstage.act("resize", canvas.clientWidth, canvas.clientHeight, devicePixelRatio || 1));
    observer.observe(canvas);
    const stopListening = listen(canvas, {
      turn: (azimuthRad, elevationRad) => this.held(() => this.backstage.act("turn", azimuthRad, elevationRad)),
      zoom: (factor) => this.held(() => this.backstage.act("zoom", factor)),
      pan: (right, up) => this.held(() => this.backstage.act("pan", right, up)),
      view: (name) => this.held(() => this.flyTo(name)),
    });
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

  /** A view straight on, or the room as a whole. */
  flyTo(vantage: Vantage): void {
    this.backstage.act("flyTo", vantage);
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
  sway(on: boolean): void {
    this.backstage.act("sway", on);
  }

  /** What the stage shows as a PNG of that size, on the colour of its walls. */
  picture(widthPx: number, heightPx: number): Promise<Blob> {
    return this.backstage.picture(widthPx, heightPx);
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
