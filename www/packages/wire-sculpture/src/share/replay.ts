/**
 * Opens a replay: how a wire was found. Twin of the reading half of `src/export/share/replay.rs`; bytes are
 * `[version][range-coded wires][CRC-32 of all before]`.
 */

import type { WireShape } from "../scene/shape";
import { crc32 } from "./base64";
import { wireProblem, type Form, MAX_CONTROL_POINTS } from "./check";
import { ShareCodeError } from "./code";
import { atMost, float32, FORMS, readMostlyUniformKnots, STEP_ZEROS, type KnotCode } from "./contents";
import { knotsFrom, pointsFrom } from "./knots";
import { Nonsense, RangeDecoder } from "./range";
import { Following, readPoints } from "./series";

/** A wire of a run, and the number of the iteration before which it was like this. */
export interface Moment {
  readonly iteration: number;
  readonly wire: WireShape;
}

const VERSION = 1;
const MAX_WIRES = 40;
const MAX_BYTES = 40 << 10;
/** Control points of all wires together: what takes a moment to read. */
const MAX_POINTS = 80_000;

/**
 * Its wires in order, the finished one last.
 * @throws ShareCodeError for anything that is damaged, foreign, too large or newer than this page.
 */
export function openReplay(bytes: Uint8Array): Moment[] {
  if (bytes.length < 5 || bytes.length > MAX_BYTES) throw damaged();
  const body = bytes.subarray(0, -4);
  const version = body[0]!;
  const checksum = new DataView(bytes.buffer, bytes.byteOffset).getUint32(body.length, true);
  if (crc32(body) !== checksum || version === 0) throw damaged();
  if (version > VERSION) throw new ShareCodeError("This replay was made by a newer Wire4D; reload the page to get it.");
  try {
    return readWires(new RangeDecoder(body.subarray(1)));
  } catch (error) {
    throw error instanceof Nonsense ? damaged() : error;
  }
}

const damaged = (): ShareCodeError => new ShareCodeError("This replay is damaged; ask for the file again.");

/** A wire in steps. */
interface Frame {
  readonly form: Form;
  readonly closed: boolean;
  readonly knots: KnotCode;
  readonly points: Int32Array;
}

function readWires(coder: RangeDecoder): Moment[] {
  const steps = [float32(coder, STEP_ZEROS), float32(coder, STEP_ZEROS)] as const;
  const count = coder.bits(6);
  if (count < 2 || count > MAX_WIRES) throw new Nonsense();
  const following = new Following();
  const moments: Moment[] = [];
  let [left, iteration] = [MAX_POINTS, 0];
  let before: Frame | null = null;
  for (let k = 0; k < count; k++) {
    const later = atMost(2 ** 32 - 1 - iteration, coder.whole());
    if (k > 0 && later === 0) throw new Nonsense();
    iteration += later;
    const frame = readFrame(coder, before);
    left -= frame.points.length / 4;
    if (left < 0) throw new Nonsense();
    if (before) following.read(coder, frame.points, asMany(before.points, frame.points.length / 4));
    else readPoints(coder, frame.points);
    moments.push({ iteration, wire: wireOf(frame, steps) });
    before = frame;
  }
  return moments;
}

/** All but where its points are; mostly as before. */
function readFrame(coder: RangeDecoder, before: Frame | null): Frame {
  if (coder.flag()) {
    if (!before) throw new Nonsense();
    return { ...before, points: new Int32Array(before.points.length) };
  }
  const closed = coder.flag();
  const form = FORMS[coder.bits(2)];
  const count = atMost(MAX_CONTROL_POINTS, coder.whole());
  if (!form || count < 4) throw new Nonsense();
  return { form, closed, knots: readMostlyUniformKnots(coder, closed ? count : count - 3), points: new Int32Array(4 * count) };
}

function wireOf({ form, closed, knots: code, points }: Frame, steps: readonly [number, number]): WireShape {
  const [knots, controlPoints] = [knotsFrom(code, closed), pointsFrom(points, steps)];
  if (wireProblem(form, closed, knots, controlPoints)) throw damaged();
  return { closed, knots, controlPoints };
}

/** A polyline with other corners: as many as given, evenly along it. */
function asMany(points: Int32Array, count: number): Int32Array {
  const given = points.length / 4;
  if (given === count) return points;
  const corners = new Int32Array(4 * count);
  const scale = (given - 1) / (count - 1);
  for (let k = 0; k < count; k++) {
    const along = k * scale;
    const at = Math.min(Math.floor(along), given - 2);
    const share = along - at;
    for (let c = 0; c < 4; c++) {
      const [from, to] = [points[4 * at + c]!, points[4 * at + 4 + c]!];
      corners[4 * k + c] = Math.floor(from + (to - from) * share + 0.5);
    }
  }
  return corners;
}
