/** What a share code holds, and the order in which it is read. Twin of `src/export/share/contents.rs`. */

import type { View } from "../scene/view";
import { MAX_CONTROL_POINTS, type Form } from "./check";
import { clamp, MAX_NUMBER } from "./guess";
import { Models, Nonsense, numberModels, type RangeDecoder } from "./range";
import { readPoints } from "./series";

export interface Contents {
  readonly form: Form;
  readonly closed: boolean;
  /** World units of one step of x, y, z and of one step of width. */
  readonly steps: readonly [number, number];
  /** x, y, z, width for each control point, in steps. */
  readonly points: Int32Array;
  readonly knots: KnotCode;
  readonly views: readonly View[];
  readonly task: string;
  readonly seed: bigint;
}

/** Knot intervals in powers of two of the longest: 0 for an empty one, else 1 + k for `longest · 2^(-k / perOctave)`. */
export interface KnotCode {
  readonly start: number;
  readonly longest: number;
  readonly perOctave: number;
  readonly intervals: Int32Array;
}

export const FORMS = ["spline", "chain", "bag"] as const;
const MAX_VIEWS = 64;
const MAX_NAME_BYTES = 256;
/** What a task is mostly called; any other name is spelled. */
const TASKS = ["multiview", "stroke", "fill"] as const;
/** Low bits of a step that are 0 in version 2. */
export const STEP_ZEROS = 19;

/** How a column's next value is guessed from the three before: nothing, the last, half or all the way on a line, a parabola. */
const PREDICTORS: readonly ((a: number, b: number, c: number) => number)[] = [
  () => 0,
  (a) => a,
  (a, b) => a + Math.trunc((a - b) / 2),
  (a, b) => 2 * a - b,
  (a, b, c) => 3 * a - 3 * b + c,
];

/** Front, side and top are known by heart; the cosine of a quarter turn is not quite 0 here, as in the core. */
const COSINE = 6.123233995736766e-17;
const CANONICAL: readonly Pick<View, "name" | "eye" | "target" | "up">[] = [
  { name: "front", eye: [0, 0, 3], target: [0, 0, 0], up: [-0, 1, -0] },
  { name: "side", eye: [3, 0, 3 * COSINE], target: [0, 0, 0], up: [-0, 1, -0] },
  { name: "top", eye: [0, 3, 3 * COSINE], target: [0, 0, 0], up: [-0, COSINE, -1] },
];

/** @throws Nonsense */
export function readContents(coder: RangeDecoder, version: number): Contents {
  const form = FORMS[coder.bits(2)];
  if (!form) throw new Nonsense();
  const closed = coder.flag();
  const count = atMost(MAX_CONTROL_POINTS, coder.whole());
  const zeros = version === 1 ? 0 : STEP_ZEROS;
  const steps = [float32(coder, zeros), float32(coder, zeros)] as const;
  const points = new Int32Array(4 * count);
  const intervals = closed ? count : Math.max(0, count - 3);
  let knots: KnotCode;
  if (version === 1) {
    readColumns(coder, points, 0, 3);
    readColumns(coder, points, 3, 4);
    knots = readKnots(coder, intervals);
  } else {
    readPoints(coder, points);
    knots = readMostlyUniformKnots(coder, intervals);
  }
  const views: View[] = [];
  for (let left = atMost(MAX_VIEWS, coder.whole()); left > 0; left--) {
    views.push(readView(coder, version === 1 ? null : (views.at(-1) ?? USUAL_LENS)));
  }
  const task = (version === 1 ? undefined : TASKS[coder.bits(2)]) ?? text(coder);
  return { form, closed, steps, points, knots, views, task, seed: coder.whole() };
}

/** One bit says whether they are what most wires have. */
export function readMostlyUniformKnots(coder: RangeDecoder, count: number): KnotCode {
  return coder.flag() ? { start: 0, longest: 1, perOctave: 1, intervals: new Int32Array(count).fill(1) } : readKnots(coder, count);
}

/** Columns of the control points with one shared choice of predictor. */
function readColumns(coder: RangeDecoder, points: Int32Array, from: number, to: number): void {
  const predict = PREDICTORS[coder.bits(3)];
  if (!predict) throw new Nonsense();
  const models = numberModels();
  for (let at = 0; at < points.length; at += 4) {
    for (let c = at + from; c < at + to; c++) {
      const guess = predict(points[c - 4] ?? 0, points[c - 8] ?? 0, points[c - 12] ?? 0);
      points[c] = clamp(guess + coder.number(models));
    }
    if (coder.exhausted) throw new Nonsense();
  }
}

function readKnots(coder: RangeDecoder, count: number): KnotCode {
  const start = float(coder);
  const longest = float(coder);
  const perOctave = Math.min(MAX_NUMBER, Number(coder.whole()));
  const intervals = new Int32Array(count);
  const models = numberModels();
  const same = new Models(1);
  for (let k = 0; k < count; k++) {
    // Mostly the same as the one before.
    const before = k > 0 ? intervals[k - 1]! : 1;
    intervals[k] = coder.bit(same, 0) ? before : Math.max(0, Math.min(MAX_NUMBER, coder.number(models)));
    if (coder.exhausted) throw new Nonsense();
  }
  return { start, longest, perOctave, intervals };
}

type Lens = Pick<View, "projection" | "height_world" | "fov_y_rad" | "width_px" | "height_px">;

/** What most first views have. */
const USUAL_LENS: Lens = { projection: "orthographic", height_world: 2.2, width_px: 256, height_px: 256 };

/** From version 2 on a view's size and lens may be as those of the one before. */
function readView(coder: RangeDecoder, before: Lens | null): View {
  const lens = before && coder.flag() ? lensOf(before) : readLens(coder);
  const known = CANONICAL[coder.bits(2)];
  const place = known ?? { name: text(coder), eye: vector(coder), target: vector(coder), up: vector(coder) };
  return { ...place, ...lens };
}

function lensOf({ projection, height_world, fov_y_rad, width_px, height_px }: Lens): Lens {
  return projection === "perspective" ? { projection, fov_y_rad: fov_y_rad!, width_px, height_px } : { projection, height_world: height_world!, width_px, height_px };
}

function readLens(coder: RangeDecoder): Lens {
  const width_px = Number(coder.whole());
  const height_px = coder.flag() ? width_px : Number(coder.whole());
  const perspective = coder.flag();
  const extent = float(coder);
  return perspective
    ? { projection: "perspective", fov_y_rad: extent, width_px, height_px }
    : { projection: "orthographic", height_world: extent, width_px, height_px };
}

function vector(coder: RangeDecoder): [number, number, number] {
  return [float(coder), float(coder), float(coder)];
}

const scratch = new DataView(new ArrayBuffer(8));

export function float32(coder: RangeDecoder, zeros = 0): number {
  scratch.setUint32(0, coder.bits(32 - zeros) * 2 ** zeros);
  return scratch.getFloat32(0);
}

function float(coder: RangeDecoder): number {
  if (coder.flag()) return float32(coder);
  scratch.setUint32(0, coder.bits(32));
  scratch.setUint32(4, coder.bits(32));
  return scratch.getFloat64(0);
}

function text(coder: RangeDecoder): string {
  const bytes = new Uint8Array(atMost(MAX_NAME_BYTES, coder.whole()));
  for (let i = 0; i < bytes.length; i++) bytes[i] = coder.bits(8);
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    throw new Nonsense();
  }
}

export function atMost(most: number, count: bigint): number {
  if (count > most) throw new Nonsense();
  return Number(count);
}
