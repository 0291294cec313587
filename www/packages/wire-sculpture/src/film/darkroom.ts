/**
 * Pictures and films of a wire, drawn on a canvas of its own at any size: in a worker, where nobody waits for them. What
 * is shown on the stage is left alone.
 */

import { Body, boundsOf, type BodyShape } from "../scene/body";
import { Easel } from "../scene/easel";
import type { Film, Moment } from "./film";
import { shown } from "../scene/gl";
import { tonesOf, type Look } from "../scene/looks";
import type { Mat4, Vec3 } from "../scene/matrix";
import { axesOf, cameraOf, directionOf, DIRECTIONS, framed, type Camera, type Pose, type Vantage } from "../scene/orbit";
import { Painter, WALL_AWAY } from "../scene/painter";
import { boxOf, cornersOf, ROOM_CORNERS, ROOM_SHARE, ROOM_SHARE_OF_BODIES, StageUnavailable, VIEW_SHARE } from "../scene/scene";
import type { WireShape } from "../scene/shape";
import { buildRings } from "../scene/tube";
import { Way } from "./way";

/** What stands before the camera. */
export interface Subject {
  /** The wires that it went through, the finished one last; at least that. */
  readonly wires: readonly WireShape[];
  readonly look: Look;
  readonly body: BodyShape | null;
  /** Whether the wire is seen through the body. */
  readonly through: boolean;
}

/** Pixels. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Behind everything. */
export type Ground = "wall" | "transparent";

/** Samples to a pixel of the longer side, and between which counts; a body needs as many times more. */
const SAMPLES_PER_PIXEL = 2.5;
const FEWEST_SAMPLES = 2600;
const MOST_SAMPLES = 9000;
const ON_BODY = 2.5;
/** Larger pictures are drawn in pieces: a graphics card needs 36 bytes for each pixel of a smooth-edged one. */
const PIECE_PX = 2048;
/** Directions that stand for a whole turn. */
const STEPS = 32;
/** How much of a film's picture is filled by all that comes into it at any time. */
const FILM_SHARE = 0.97;
/** The axes along which shadows fall. On a whole turn walls come and go, and only the floor stays: room enough for them. */
const WALLS = [0, 1, 2] as const;
const FLOOR = [1] as const;
const ROUND_SHARE = 0.8;

export class Darkroom {
  readonly canvas = new OffscreenCanvas(1, 1);
  private readonly gl: WebGL2RenderingContext;
  private readonly painter: Painter;
  private readonly easel: Easel;
  private way: Way;
  /** The place on the way that is loaded. */
  private placed = -1;
  private box: readonly Vec3[] = [];

  /** @throws StageUnavailable where there is no WebGL 2. */
  constructor(
    private readonly subject: Subject,
    size: Size,
  ) {
    const gl = this.canvas.getContext("webgl2", { antialias: false, alpha: true, premultipliedAlpha: true });
    if (!gl) throw new StageUnavailable("this browser cannot draw in 3D here (WebGL 2 is missing or switched off)");
    this.gl = gl;
    this.painter = new Painter(gl);
    this.easel = new Easel(gl);
    const samples = Math.max(FEWEST_SAMPLES, Math.min(MOST_SAMPLES, SAMPLES_PER_PIXEL * Math.max(size.width, size.height)));
    this.way = new Way(subject.wires, Math.round(subject.body ? ON_BODY * samples : samples));
    if (subject.body) {
      this.painter.body = new Body(gl);
      this.painter.body.load(subject.body);
    }
  }

  /** One picture: on the canvas in one piece, so for sizes of up to 2048 pixels a side. */
  draw(from: Vantage | Pose, size: Size, ground: Ground): void {
    this.place(1);
    this.paint(this.poseFrom(from, size), size, ground);
  }

  /** A picture of any size, finished. */
  async picture(from: Vantage | Pose, size: Size, ground: Ground, type = "image/png"): Promise<Blob> {
    this.place(1);
    const pose = this.poseFrom(from, size);
    const flat = new OffscreenCanvas(size.width, size.height);
    const context = flat.getContext("2d")!;
    const pieces = Math.ceil(Math.max(size.width, size.height) / PIECE_PX);
    const piece = { width: Math.ceil(size.width / pieces), height: Math.ceil(size.height / pieces) };
    for (let row = 0; row < pieces; row++) {
      for (let column = 0; column < pieces; column++) {
        const [left, top] = [column * piece.width, row * piece.height];
        this.paint(pose, size, ground, { ...piece, left, top });
        context.drawImage(this.canvas, left, top);
        // A turn for whoever else is here.
        await new Promise((resolve) => setTimeout(resolve));
      }
    }
    return flat.convertToBlob({ type });
  }

  /** A frame of a film, on the canvas. */
  frame(film: Film, { turnRad, way }: Moment, size: Size, ground: Ground = "wall"): void {
    // The last wire decides how all are framed.
    if (this.placed < 0) this.place(1);
    const pose = this.poseOf(film, size);
    this.place(way);
    this.paint(turned(pose, turnRad, this.axis), size, ground);
  }

  /** Waits until what is on the canvas is drawn, as whoever takes it would: to read a pixel is the one way that does wait. */
  develop(): void {
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  dispose(): void {
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  /** Loads the wire at a place on its way. */
  private place(way: number): void {
    if (way === this.placed) return;
    const samples = this.way.at(way);
    if (samples.count > 0) this.painter.load(buildRings(samples, tonesOf(this.subject.look.colouring, samples)));
    if (this.subject.look.room) this.painter.castShadows();
    if (this.placed < 0) this.box = samples.count > 0 ? boxOf(samples) : this.subject.body ? cornersOf(...boundsOf(this.subject.body)) : ROOM_CORNERS;
    this.placed = way;
  }

  private poseFrom(from: Vantage | Pose, { width, height }: Size): Pose {
    if (typeof from === "object" && "reach" in from) return from;
    const { room } = this.subject.look;
    const whole = room && from === "room";
    return framed(directionOf(from), whole ? ROOM_CORNERS : this.box, width / height, whole ? this.share : VIEW_SHARE);
  }

  private get share(): number {
    return this.subject.body ? ROOM_SHARE_OF_BODIES : ROOM_SHARE;
  }

  /** Where a film looks from, with room for all of its turn: nothing jumps nearer or farther on the way. */
  private poseOf({ swingRad }: Film, { width, height }: Size): Pose {
    const { room } = this.subject.look;
    const round = swingRad > Math.PI / 2;
    const seen = room ? [...this.box, ...this.box.flatMap((corner) => shadowsOf(corner, round ? FLOOR : WALLS))] : this.box;
    const swept = Array.from({ length: STEPS + 1 }, (_, i) => swingRad * ((2 * i) / STEPS - 1)).flatMap((by) => seen.map((corner) => turnedPoint(corner, by, this.axis)));
    return framed(DIRECTIONS.room, swept, width / height, !room ? VIEW_SHARE : round ? ROUND_SHARE : FILM_SHARE);
  }

  /** What a film turns round: the room's middle, or the wire's own. */
  private get axis(): Vec3 {
    if (this.subject.look.room) return [0, 0, 0];
    const [low, high] = [this.box[0]!, this.box[7]!];
    return [(low[0] + high[0]) / 2, 0, (low[2] + high[2]) / 2];
  }

  /** `piece`: the part of the picture that is drawn; all of it by itself. */
  private paint(pose: Pose, size: Size, ground: Ground, piece = { ...size, left: 0, top: 0 }): void {
    const { gl, painter, easel, subject } = this;
    if (gl.isContextLost()) throw new Error("the graphics card was taken away");
    const camera = pieceOf(cameraOf(pose, size.width, size.height), size, piece);
    painter.ground = ground === "wall" ? [...shown(subject.look.wall), 1] : [0, 0, 0, 0];
    easel.draw(piece.width, piece.height, () => painter.paint(camera, axesOf(pose).back, subject.look, piece.width, piece.height, subject.through, false));
    easel.show();
  }
}

/** The camera that sees a piece of the picture. */
function pieceOf(camera: Camera, size: Size, piece: Size & { readonly left: number; readonly top: number }): Camera {
  const clipFromWorld = camera.clipFromWorld.slice() as Mat4;
  const [across, up] = [size.width / piece.width, size.height / piece.height];
  const right = across - 1 - (2 * piece.left) / piece.width;
  const down = up - 1 - (2 * piece.top) / piece.height;
  for (let column = 0; column < 4; column++) {
    const at = 4 * column;
    clipFromWorld[at]! = across * clipFromWorld[at]! + right * clipFromWorld[at + 3]!;
    clipFromWorld[at + 1]! = up * clipFromWorld[at + 1]! - down * clipFromWorld[at + 3]!;
  }
  return { ...camera, clipFromWorld };
}

/** Where the shadows of a point are. */
function shadowsOf(point: Vec3, axes: readonly number[]): Vec3[] {
  return axes.map((axis) => point.map((x, c) => (c === axis ? -WALL_AWAY : x)) as unknown as Vec3);
}

/** A point turned to the right about an upright axis. */
function turnedPoint([x, y, z]: Vec3, byRad: number, axis: Vec3): Vec3 {
  const [sin, cos] = [Math.sin(byRad), Math.cos(byRad)];
  const [dx, dz] = [x - axis[0], z - axis[2]];
  return [axis[0] + cos * dx + sin * dz, y, axis[2] - sin * dx + cos * dz];
}

/** A camera turned with what it looks at. */
export function turned(pose: Pose, byRad: number, axis: Vec3): Pose {
  return { ...pose, azimuthRad: pose.azimuthRad + byRad, target: turnedPoint(pose.target, byRad, axis) };
}
