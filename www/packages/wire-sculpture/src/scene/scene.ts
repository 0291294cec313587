/**
 * A room with a wire in it: three walls, on each the shadow the wire casts along that axis, and a camera. Draws only
 * when something changed. Touches nothing of a page but the canvas, so that it can be in a worker.
 */

import type { BodyShape } from "./body";
import { Easel } from "./easel";
import { drawnByProcessor } from "./gl";
import { tonesOf, type Look } from "./looks";
import type { Marks } from "./marks";
import type { Vec3 } from "./matrix";
import { axesOf, cameraOf, directionOf, framed, Orbit, type Vantage, type Pose, type ViewName } from "./orbit";
import { Pace } from "./pace";
import { Painter, WALL_AWAY } from "./painter";
import { Sampler, samplesPerSpan, type Samples, type WireShape } from "./shape";
import { buildRings } from "./tube";

/** About as many samples in all as a screen can tell apart. */
const SAMPLES = 2600;
/** The same where a wire turns again and again to cover a body. */
const SAMPLES_ON_BODY = 8000;
const MAX_DENSITY = 2;
const FLIGHT_MS = 650;
const STEP_MS = 220;
/** How long a tour takes to each of its places, and how long the picture stays where it has a name. */
const TOUR_FLIGHT_MS = 1500;
const TOUR_STAY_MS = 1000;
/** Where time is short, each wire casts a shadow on one of the walls, in turns. */
const WALLS = 3;
/** The idle camera moves so slowly that half of the frames do. */
const SWAY_FRAME_MS = 30;
/** How long after somebody moved the camera they may be about to do so again. */
const HELD_MS = 500;
/** Radians the idle camera sways either way, seconds it takes, and seconds until it does so fully. */
const SWAY_RAD = 0.26;
const SWAY_S = 26;
const SWAY_ONSET_S = 4;
/** Half of the square a shadow usually fills, and how much of the picture's smaller side the room and a view fill. */
const SHADOW_HALF = 0.8;
export const ROOM_SHARE = 0.94;
export const VIEW_SHARE = 0.84;
/** Bodies reach farther than the wires that a room is made for. */
export const ROOM_SHARE_OF_BODIES = 0.82;
const MAX_PICTURE_PX = 4096;

export class StageUnavailable extends Error {}

/** What the scene tells. */
export interface SceneEvents {
  /** The view that the camera is at or flies to; null where a person turned it by hand. */
  view(name: ViewName | null): void;
  /** The browser took the graphics card away, or gave it back. */
  lost(lost: boolean): void;
  /** Where the camera is, whenever that has changed. */
  camera(pose: Pose): void;
  /** A wire that had been set is seen for the first time. */
  drawn(): void;
}

export class Scene {
  private readonly gl: WebGL2RenderingContext;
  private readonly sampler = new Sampler();
  private painter: Painter;
  private easel: Easel;
  /** Whether what is on the easel or shown is out of date. */
  private stale = true;
  private wire: WireShape | null = null;
  private wireStale = true;
  private places: readonly Vec3[] | null = null;
  /** Once there were places to mark. */
  private marks: Marks | null = null;
  private body: BodyShape | null = null;
  private through = false;
  private loads = 0;
  /** Corners of the box round the wire. */
  private box: readonly Vec3[] = cornersOf([-SHADOW_HALF, -SHADOW_HALF, -SHADOW_HALF], [SHADOW_HALF, SHADOW_HALF, SHADOW_HALF]);
  private ringData: Float32Array<ArrayBuffer> | undefined;
  private view: ViewName | null = "room";
  /** Where the camera is or flies to; null where a person turned it by hand. */
  private vantage: Vantage | null = "room";
  private told = "";
  /** Whether the wire has not been seen. */
  private unseen = false;
  /** The first wire is framed anew. */
  private unframed = true;
  private paused = false;
  private readonly orbit: Orbit;
  private frame = 0;
  private lastFrameMs = 0;
  private paintedMs = 0;
  /** A while in which the machine is left to others. */
  private breath: ReturnType<typeof setTimeout> | undefined;
  private readonly pace: Pace;
  private heldMs = -Infinity;
  /** Whether the next picture is to be at its finest, since nothing has changed for a while. */
  private standsStill = false;
  private rest: ReturnType<typeof setTimeout> | undefined;
  private swaying = false;
  /** Round and round, and not to and fro. */
  private round = false;
  private swayStartMs = 0;
  private swayFrom = 0;
  /** Places still to come, and the wait at the present one. */
  private tourLeft: readonly Vantage[] = [];
  private tourStay: ReturnType<typeof setTimeout> | undefined;
  private swayAfterTour = false;
  /** For people who asked for less motion. */
  private still = false;
  /** Of the canvas, in CSS pixels, and how many of its own there are to one. */
  private width = 0;
  private height = 0;
  private density = 1;

  /** @throws StageUnavailable where the browser has no WebGL 2. */
  constructor(
    private readonly canvas: HTMLCanvasElement | OffscreenCanvas,
    private look: Look,
    private readonly events: SceneEvents,
  ) {
    const gl = canvas.getContext("webgl2", { antialias: false, alpha: true, premultipliedAlpha: true }) as WebGL2RenderingContext | null;
    if (!gl) throw new StageUnavailable("this browser cannot draw in 3D here (WebGL 2 is missing or switched off)");
    this.gl = gl;
    this.pace = new Pace(drawnByProcessor(gl));
    this.painter = new Painter(gl);
    this.easel = new Easel(gl);
    this.orbit = new Orbit(this.poseOf("room", this.aspect));
    canvas.addEventListener("webglcontextlost", this.lost);
    canvas.addEventListener("webglcontextrestored", this.restored);
  }

  /** To be told before anything is drawn. What is shown is stretched until the next picture is there, but never empty. */
  resize(width: number, height: number, density: number): void {
    [this.width, this.height, this.density] = [width, height, Math.min(MAX_DENSITY, density)];
    this.pace.resize(Math.max(width, height) * this.density);
    this.reframe();
    this.invalidate();
  }

  /** Nobody sees it: nothing is drawn until somebody does. */
  pause(paused: boolean): void {
    if (paused === this.paused) return;
    this.paused = paused;
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    if (this.breath === undefined) this.ask();
  }

  /**
   * Somebody else needs the processor: where that draws, this share of the time may go into pictures, above 0 to 1, and
   * the camera does not move by itself. Whoever holds it is answered at once all the same.
   */
  ration(share: number): void {
    const before = this.pace.rationed;
    this.pace.ration(share);
    if (this.pace.rationed || !before) return;
    this.beginSway();
    if (this.fineness < 1) this.refine();
    if (this.stale || this.swaying) this.hurry();
  }

  /** Whether nothing may move by itself. */
  keepStill(still: boolean): void {
    this.still = still;
    if (still) this.swaying = false;
  }

  setWire(wire: WireShape | null): void {
    // Another wire, and not the next step of the same: its shadows must not be the last one's.
    if (wire?.controlPoints.length !== this.wire?.controlPoints.length) this.loads = 0;
    this.wire = wire;
    this.unseen = wire !== null;
    this.unframed ||= !wire;
    this.wireStale = true;
    this.invalidate();
  }

  /** Rings round these places; null for none. */
  async mark(places: readonly Vec3[] | null): Promise<void> {
    this.places = places;
    if (places && !this.marks) {
      const { Marks } = await import("./marks");
      this.marks ??= new Marks(this.gl);
    }
    this.marks?.load(this.places ?? []);
    this.invalidate();
  }

  /** What the wire covers: a solid that hides what is behind it. */
  async setBody(body: BodyShape | null): Promise<void> {
    this.body = body;
    // On a body it is sampled more finely.
    this.wireStale = true;
    await this.loadBody();
    if (body === this.body && this.view === "room" && !this.touring) this.go("room", FLIGHT_MS);
  }

  /** Whether the wire is seen through the body. */
  seeThrough(through: boolean): void {
    this.through = through;
    this.invalidate();
  }

  setLook(look: Look): void {
    const roomChanged = look.room !== this.look.room;
    // Tones lie in the rings, and shadows are not cast where no wall is.
    if (roomChanged || look.colouring !== this.look.colouring) this.wireStale = true;
    this.look = look;
    if (roomChanged && this.view === "room" && !this.touring) this.go("room", FLIGHT_MS);
    this.invalidate();
  }

  /** A view straight on, or the room as a whole. */
  flyTo(vantage: Vantage, durationMs = FLIGHT_MS): void {
    this.rouse();
    this.go(vantage, durationMs);
  }

  /** Where somebody has left it before, at once. */
  place(pose: Pose): void {
    this.rouse();
    this.orbit.flyTo(pose, 0, 0);
    this.vantage = null;
    this.setView(null);
    this.invalidate();
  }

  turn(azimuthRad: number, elevationRad: number): void {
    this.held(() => this.orbit.turn(azimuthRad, elevationRad));
  }

  zoom(factor: number): void {
    this.held(() => this.orbit.zoom(factor));
  }

  /** By shares of the picture's half height. */
  pan(right: number, up: number): void {
    this.held(() => this.orbit.pan(right, up));
  }

  /** A step by a button: radians to the right, and a factor of the distance. */
  step(turnRad: number, zoom: number): void {
    this.held(() => this.orbit.step(turnRad, zoom, performance.now(), this.still ? 0 : STEP_MS));
  }

  /** From vantage to vantage, until somebody takes hold; nothing for people who asked for less motion. */
  tour(places: readonly Vantage[]): void {
    if (this.still) return;
    const swayed = this.swaying;
    this.rouse();
    this.swayAfterTour = swayed;
    this.tourLeft = places;
    this.nextOfTour();
  }

  /** Whether the camera sways slowly by itself, or goes round; never for people who asked for less motion. */
  sway(on: boolean, round = this.round): void {
    this.round = round;
    if (this.touring) {
      this.swayAfterTour = on;
      return;
    }
    if (on === this.swaying || (on && this.still)) return;
    this.swaying = on;
    this.beginSway();
    this.invalidate();
  }

  /** From where it is. */
  private beginSway(): void {
    this.swayStartMs = performance.now();
    this.swayFrom = this.orbit.destination.azimuthRad;
  }

  /** What the stage shows as a picture of that size, on the colour of its walls or on nothing. */
  async picture(widthPx: number, heightPx: number, transparent = false, type = "image/png"): Promise<Blob> {
    const [width, height] = [widthPx, heightPx].map((size) => Math.max(1, Math.min(MAX_PICTURE_PX, Math.round(size)))) as [number, number];
    const flat = new OffscreenCanvas(width, height);
    const context = flat.getContext("2d")!;
    context.fillStyle = this.look.wall;
    if (!transparent) context.fillRect(0, 0, width, height);
    if (this.wireStale || this.fineness < 1) {
      this.pace.begin(true, false);
      this.loadWire();
    }
    // Shown and copied in the same task, or the browser would have cleared it; and nobody sees it at the wrong size.
    this.paint(width, height, this.vantage && !this.orbit.flying ? this.atAzimuth(this.poseOf(this.vantage, width / height)) : this.orbit.pose);
    this.easel.show();
    context.drawImage(this.canvas, 0, 0);
    this.paintCanvas();
    this.easel.show();
    return flat.convertToBlob({ type });
  }

  dispose(): void {
    cancelAnimationFrame(this.frame);
    for (const timer of [this.rest, this.tourStay, this.breath]) clearTimeout(timer);
    this.canvas.removeEventListener("webglcontextlost", this.lost);
    this.canvas.removeEventListener("webglcontextrestored", this.restored);
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  private readonly lost = (event: Event): void => {
    event.preventDefault();
    this.events.lost(true);
  };

  private readonly restored = (): void => {
    this.painter = new Painter(this.gl);
    void this.loadBody();
    this.easel = new Easel(this.gl);
    this.wireStale = true;
    this.marks = null;
    void this.mark(this.places);
    this.events.lost(false);
  };

  /** The module comes with the first body. */
  private async loadBody(): Promise<void> {
    const { body } = this;
    if (body) {
      const { Body, boundsOf } = await import("./body");
      if (body !== this.body) return;
      this.painter.body ??= new Body(this.gl);
      if (!this.wire) this.box = cornersOf(...boundsOf(body));
    }
    this.painter.body?.load(body);
    this.invalidate();
  }

  private get aspect(): number {
    return this.width > 0 && this.height > 0 ? this.width / this.height : 1.5;
  }

  private get touring(): boolean {
    return this.tourLeft.length > 0;
  }

  private poseOf(vantage: Vantage, aspect: number): Pose {
    const room = vantage === "room" && this.look.room;
    const pose = framed(directionOf(vantage), room ? ROOM_CORNERS : this.box, aspect, room ? (this.body ? ROOM_SHARE_OF_BODIES : ROOM_SHARE) : VIEW_SHARE);
    return typeof vantage === "string" ? pose : { ...pose, reach: pose.reach * (vantage.away ?? 1) };
  }

  /** Where the camera is, for another size or another wire. */
  private reframe(): void {
    if (this.vantage && !this.orbit.flying) this.orbit.flyTo(this.atAzimuth(this.poseOf(this.vantage, this.aspect)), 0, 0);
  }

  /** The same frame, seen from where the swaying camera is. */
  private atAzimuth(pose: Pose): Pose {
    return this.view === "room" || this.swaying ? { ...pose, azimuthRad: this.orbit.pose.azimuthRad } : pose;
  }

  private go(vantage: Vantage, durationMs: number): void {
    this.orbit.flyTo(this.poseOf(vantage, this.aspect), performance.now(), this.still ? 0 : durationMs);
    this.vantage = vantage;
    this.setView(typeof vantage === "string" ? vantage : null);
    this.invalidate();
  }

  private setView(view: ViewName | null): void {
    if (view === this.view) return;
    this.view = view;
    this.events.view(view);
  }

  /** Ends whatever the camera does by itself. */
  private rouse(): void {
    this.swaying = false;
    this.tourLeft = [];
    clearTimeout(this.tourStay);
    this.tourStay = undefined;
  }

  private held(action: () => void): void {
    this.rouse();
    action();
    this.vantage = null;
    this.setView(null);
    this.heldMs = performance.now();
    this.hurry();
  }

  private readonly nextOfTour = (): void => {
    this.tourStay = undefined;
    const [next] = this.tourLeft;
    if (next) this.go(next, TOUR_FLIGHT_MS);
  };

  /** The tour's flight has landed. */
  private stay(): void {
    this.tourLeft = this.tourLeft.slice(1);
    // Past places without a name it only comes by.
    if (this.touring) this.tourStay = setTimeout(this.nextOfTour, this.view ? TOUR_STAY_MS : 0);
    else this.sway(this.swayAfterTour);
  }

  private invalidate(): void {
    this.stale = true;
    this.standsStill = false;
    if (this.breath === undefined) this.ask();
  }

  /** Others have had their time. */
  private hurry(): void {
    clearTimeout(this.breath);
    this.breath = undefined;
    this.invalidate();
  }

  private get fineness(): number {
    return this.pace.fineness;
  }

  /** Whether the camera sways now, and not only while nobody needs the time for it. */
  private get sways(): boolean {
    return this.swaying && !this.pace.rationed;
  }

  private readonly ask = (): void => {
    this.breath = undefined;
    if (!this.paused) this.frame ||= requestAnimationFrame(this.draw);
  };

  private readonly draw = (nowMs: number): void => {
    this.frame = 0;
    if (this.gl.isContextLost()) return;
    if (this.easel.busy) {
      if (!this.easel.ready) {
        this.ask();
        return;
      }
      this.easel.show();
      if (this.unseen && !this.wireStale) {
        this.unseen = false;
        this.events.drawn();
      }
      const breathMs = this.pace.end(performance.now() - this.paintedMs, this.stale, this.holding);
      if (this.pace.overtaxed && !this.pace.rationed) this.swaying = false;
      this.refineSoon();
      if (breathMs > 0) {
        this.breath = setTimeout(this.ask, breathMs);
        return;
      }
    }
    if (!this.stale) return;
    const moving = this.wireStale || this.orbit.flying;
    if (this.sways && !moving && nowMs - this.lastFrameMs < SWAY_FRAME_MS) {
      this.invalidate();
      return;
    }
    this.lastFrameMs = nowMs;
    const flew = this.orbit.flying;
    const flying = this.orbit.advance(nowMs);
    if (this.sways && !flying) {
      const seconds = Math.max(0, nowMs - this.swayStartMs) / 1000;
      const onset = Math.min(1, seconds / SWAY_ONSET_S);
      const share = (seconds / SWAY_S) * 2 * Math.PI;
      this.orbit.pose.azimuthRad = this.swayFrom + onset * (this.round ? share : SWAY_RAD * Math.sin(share));
    }
    this.pace.begin(this.standsStill, this.holding);
    this.standsStill = false;
    if (this.wireStale) this.loadWire();
    this.paintCanvas();
    this.tellCamera();
    if (flew && !flying && this.touring) this.stay();
    this.stale = flying || this.sways;
    this.ask();
  };

  private tellCamera(): void {
    const now = JSON.stringify(this.orbit.pose);
    if (now === this.told) return;
    this.told = now;
    this.events.camera({ ...this.orbit.pose });
  }

  /** Whether somebody moves the camera, or has just sent it somewhere. */
  private get holding(): boolean {
    return this.orbit.flying || performance.now() - this.heldMs < HELD_MS;
  }

  /** Fine again after a rest. */
  private refineSoon(): void {
    clearTimeout(this.rest);
    if (this.fineness < 1) this.rest = setTimeout(this.refine, this.pace.refineMs);
  }

  private readonly refine = (): void => {
    if (this.stale || this.easel.busy) {
      this.refineSoon();
      return;
    }
    this.wireStale = true;
    this.invalidate();
    this.standsStill = true;
  };

  private loadWire(): void {
    this.wireStale = false;
    const samples = this.wire && this.sampler.sample(this.wire, this.perSpan(this.wire));
    if (samples && samples.count > 0) {
      const rings = buildRings(samples, tonesOf(this.look.colouring, samples), this.ringData);
      this.ringData = rings.data;
      this.box = boxOf(samples);
      if (this.unframed) this.reframe();
      this.unframed = false;
      this.painter.load(rings);
    } else {
      this.painter.load({ count: 0, data: new Float32Array(0) });
    }
    // Where time is short the shadows follow more slowly; the fine picture at rest has them right.
    if (this.look.room) this.castShadows();
  }

  private castShadows(): void {
    const first = this.loads++ === 0;
    if (this.fineness < 1) this.painter.castShadows(true, first ? null : this.loads % WALLS);
    else this.painter.castShadows();
  }

  private perSpan(wire: WireShape): number {
    const fine = samplesPerSpan(wire, this.body ? SAMPLES_ON_BODY : SAMPLES);
    return this.fineness < 1 ? Math.max(1, fine >> 1) : fine;
  }

  private paintCanvas(): void {
    const density = this.density * this.fineness;
    const [width, height] = [this.width, this.height].map((size) => Math.max(1, Math.round(size * density)));
    this.paint(width!, height!, this.orbit.pose);
  }

  private paint(width: number, height: number, pose: Pose): void {
    this.paintedMs = performance.now();
    const camera = cameraOf(pose, width, height);
    this.easel.draw(width, height, () => {
      this.painter.paint(camera, axesOf(pose).back, this.look, width, height, this.through, this.fineness < 1);
      this.marks?.paint(camera.clipFromWorld, width / (this.width || width), this.look.mark, this.look.wall);
    });
  }
}

export function cornersOf(low: Vec3, high: Vec3): Vec3[] {
  return Array.from({ length: 8 }, (_, i) => [0, 1, 2].map((c) => (i & (1 << c) ? high : low)[c]!) as unknown as Vec3);
}

export function boxOf({ points, count }: Samples): Vec3[] {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at < 4 * count; at += 4) {
    for (let c = 0; c < 3; c++) {
      const x = points[at + c]!;
      if (x < low[c]!) low[c] = x;
      if (x > high[c]!) high[c] = x;
    }
  }
  return cornersOf(low, high);
}

/** What should be in the picture of the room: the three shadows, and so the wire between them. */
export const ROOM_CORNERS: readonly Vec3[] = [0, 1, 2].flatMap((wall) =>
  cornersOf([-SHADOW_HALF, -SHADOW_HALF, -SHADOW_HALF], [SHADOW_HALF, SHADOW_HALF, SHADOW_HALF]).map(
    (corner) => corner.map((x, c) => (c === wall ? -WALL_AWAY : x)) as unknown as Vec3,
  ),
);
