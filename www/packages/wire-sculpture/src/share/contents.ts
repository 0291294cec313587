/** What a share code holds, and the order in which it is read. Twin of `src/export/share/contents.rs`. */

import type { View } from "../view";
import { MAX_CONTROL_POINTS, type Form } from "./check";
import { numberModels, Models, type RangeDecoder } from "./range";

/** The code says something no wire has. */
export class Nonsense extends Error {}

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

const FORMS = ["spline", "chain", "bag"] as const;
const MAX_VIEWS = 64;
const MAX_NAME_BYTES = 256;
/** Numbers stay within this, whatever a damaged code says. */
const MAX_NUMBER = 2 ** 27;

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
export function readContents(coder: RangeDecoder): Contents {
  const form = FORMS[coder.bits(2)];
  if (!form) throw new Nonsense();
  const closed = coder.flag();
  const count = atMost(MAX_CONTROL_POINTS, coder.whole());
  const steps = [float32(coder), float32(coder)] as const;
  const points = new Int32Array(4 * count);
  readColumns(coder, points, 0, 3);
  readColumns(coder, points, 3, 4);
  const knots = readKnots(coder, closed ? count : Math.max(0, count - 3));
  const views = Array.from({ length: atMost(MAX_VIEWS, coder.whole()) }, () => readView(coder));
  return { form, closed, steps, points, knots, views, task: text(coder), seed: coder.whole() };
}

/** Columns of the control points with one shared choice of predictor. */
function readColumns(coder: RangeDecoder, points: Int32Array, from: number, to: number): void {
  const predict = PREDICTORS[coder.bits(3)];
  if (!predict) throw new Nonsense();
  const models = numberModels();
  for (let at = 0; at < points.length; at += 4) {
    for (let c = at + from; c < at + to; c++) {
      const guess = predict(points[c - 4] ?? 0, points[c - 8] ?? 0, points[c - 12] ?? 0);
      points[c] = Math.max(-MAX_NUMBER, Math.min(MAX_NUMBER, guess + coder.number(models)));
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

function readView(coder: RangeDecoder): View {
  const width_px = Number(coder.whole());
  const height_px = coder.flag() ? width_px : Number(coder.whole());
  const perspective = coder.flag();
  const extent = float(coder);
  const lens = perspective
    ? ({ projection: "perspective", fov_y_rad: extent } as const)
    : ({ projection: "orthographic", height_world: extent } as const);
  const known = CANONICAL[coder.bits(2)];
  const place = known ?? { name: text(coder), eye: vector(coder), target: vector(coder), up: vector(coder) };
  return { ...place, ...lens, width_px, height_px };
}

function vector(coder: RangeDecoder): [number, number, number] {
  return [float(coder), float(coder), float(coder)];
}

const scratch = new DataView(new ArrayBuffer(8));

function float32(coder: RangeDecoder): number {
  scratch.setUint32(0, coder.bits(32));
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

function atMost(most: number, count: bigint): number {
  if (count > most) throw new Nonsense();
  return Number(count);
}
