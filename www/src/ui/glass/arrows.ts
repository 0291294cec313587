/** Arrows from control points, and the place that is looked at, over the stage's picture. */

import type { Mat4 } from "#sculpture/scene/matrix";
import { onPicture } from "../../view/on-picture";

/** A term's arrows as they are to be drawn. */
export interface Pulling {
  /** x, y, z, width for each control point: it is pulled the other way. */
  readonly gradient: Float32Array;
  readonly colour: string;
  readonly dash: readonly number[];
  /** CSS pixels across, where that is not the usual. */
  readonly wide?: number | undefined;
}

/** Most arrows are shorter than this, world units, where there are few of them, and shorter yet where there are many. */
const USUAL = 0.16;
const FEW = 150;
/** The longest ones are cut off at so many times that. */
const LONGEST = 2.5;
/** The share of arrows that are. */
const MOST = 0.95;
/** Shorter ones, CSS pixels, say nothing. */
const LEAST_PX = 2;
const HEAD_PX = 5;
const LINE_PX = 1.4;
const HALO_PX = 1.4;
const POINT_PX = 1.4;
/** Of more points than that none is marked: there would be nothing else to see. */
const MOST_POINTS = 1200;
const RING_PX = 8;

/** How long most arrows of so many points are, world units. */
const usualOf = (count: number): number => USUAL * Math.sqrt(Math.min(1, FEW / Math.max(1, count)));

/** World units for a unit of gradient, so that most arrows can be read; 0 where nothing pulls. */
export function scaleOf(gradients: readonly Float32Array[]): number {
  const lengths: number[] = [];
  for (const gradient of gradients) {
    for (let at = 0; at + 3 < gradient.length; at += 4) {
      const length = Math.hypot(gradient[at]!, gradient[at + 1]!, gradient[at + 2]!);
      if (length > 0) lengths.push(length);
    }
  }
  lengths.sort((a, b) => a - b);
  const usual = lengths[Math.floor(MOST * (lengths.length - 1))] ?? 0;
  return usual > 0 ? usualOf(Math.max(...gradients.map(({ length }) => length / 4))) / usual : 0;
}

/** From a control point down the gradient: x, y, z of both ends of each arrow, none longer than can be read. */
export function arrowsOf(points: ArrayLike<number>, gradient: ArrayLike<number>, scale: number): Float32Array {
  const count = Math.floor(Math.min(points.length, gradient.length) / 4);
  const ends = new Float32Array(6 * count);
  const longest = LONGEST * usualOf(count);
  for (let i = 0; i < count; i++) {
    const [x, y, z] = [0, 1, 2].map((c) => gradient[4 * i + c]! * scale) as [number, number, number];
    const shorter = Math.min(1, longest / (Math.hypot(x, y, z) || 1));
    [x, y, z].forEach((d, c) => {
      ends[6 * i + c] = points[4 * i + c]!;
      ends[6 * i + 3 + c] = points[4 * i + c]! - d * shorter;
    });
  }
  return ends;
}

export interface Overlay {
  /** Whose control points are pulled; nothing pulls without. */
  readonly points: ArrayLike<number> | null;
  readonly pulls: readonly Pulling[];
  /** Whether each term is drawn as long as it can be read, and not all on one scale. */
  readonly stretched: boolean;
  /** x, y, z of the place that is looked at. */
  readonly place: readonly [number, number, number] | null;
  readonly ink: string;
  readonly halo: string;
}

/** Draws all of it on a canvas that lies over the picture. */
export function paintOverlay(canvas: HTMLCanvasElement, clip: Mat4 | null, { points, pulls, stretched, place, ink, halo }: Overlay): void {
  const [width, height, density] = [canvas.clientWidth, canvas.clientHeight, devicePixelRatio || 1];
  const [wide, high] = [Math.round(width * density), Math.round(height * density)];
  if (canvas.width !== wide || canvas.height !== high) [canvas.width, canvas.height] = [wide, high];
  const context = canvas.getContext("2d")!;
  context.setTransform(density, 0, 0, density, 0, 0);
  context.clearRect(0, 0, width, height);
  if (!clip) return;
  const seen = (x: number, y: number, z: number) => onPicture(clip, width, height, x, y, z);
  context.lineCap = "butt";
  if (points) {
    const common = scaleOf(pulls.map(({ gradient }) => gradient));
    for (const { gradient, colour, dash, wide = LINE_PX } of pulls) {
      const ends = arrowsOf(points, gradient, stretched ? scaleOf([gradient]) : common);
      const [shafts, heads] = [new Path2D(), new Path2D()];
      for (let at = 0; at + 5 < ends.length; at += 6) {
        const from = seen(ends[at]!, ends[at + 1]!, ends[at + 2]!);
        const to = seen(ends[at + 3]!, ends[at + 4]!, ends[at + 5]!);
        if (from && to) addArrow(shafts, heads, from, to);
      }
      context.lineJoin = "round";
      context.setLineDash([]);
      context.strokeStyle = halo;
      context.lineWidth = wide + HALO_PX;
      context.stroke(shafts);
      context.stroke(heads);
      context.strokeStyle = context.fillStyle = colour;
      context.lineWidth = wide;
      context.setLineDash([...dash]);
      context.stroke(shafts);
      context.setLineDash([]);
      context.fill(heads);
    }
    context.fillStyle = ink;
    context.beginPath();
    const marked = pulls.length > 0 && points.length <= 4 * MOST_POINTS;
    for (let at = 0; marked && at + 3 < points.length; at += 4) {
      const [x, y] = seen(points[at]!, points[at + 1]!, points[at + 2]!) ?? [-9, -9];
      context.moveTo(x + POINT_PX, y);
      context.arc(x, y, POINT_PX, 0, 2 * Math.PI);
    }
    context.fill();
  }
  const at = place && seen(...place);
  if (at) {
    context.setLineDash([]);
    for (const [colour, line] of [[halo, 6], [ink, 2.5]] as const) {
      context.strokeStyle = colour;
      context.lineWidth = line;
      context.beginPath();
      context.arc(...at, RING_PX, 0, 2 * Math.PI);
      context.stroke();
    }
  }
}

function addArrow(shafts: Path2D, heads: Path2D, [x, y]: readonly [number, number], [toX, toY]: readonly [number, number]): void {
  const length = Math.hypot(toX - x, toY - y);
  if (length < LEAST_PX) return;
  const [alongX, alongY] = [(toX - x) / length, (toY - y) / length];
  const head = Math.min(HEAD_PX, 0.6 * length);
  const [backX, backY] = [toX - alongX * head, toY - alongY * head];
  shafts.moveTo(x, y);
  shafts.lineTo(backX, backY);
  heads.moveTo(toX, toY);
  heads.lineTo(backX - (alongY * head) / 2, backY + (alongX * head) / 2);
  heads.lineTo(backX + (alongY * head) / 2, backY - (alongX * head) / 2);
  heads.closePath();
}
