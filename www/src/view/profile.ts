/** How a wire bends and how thick it is along its way. */

import { basis, type WireShape } from "#sculpture/scene/shape";

/** Samples of a wire, in order. */
export interface Profile {
  readonly count: number;
  /** x, y, z for each, world units. */
  readonly places: Float32Array;
  /** Full diameter, world units. */
  readonly widths: Float32Array;
  /** One over the bend's radius, a world unit. */
  readonly curvatures: Float32Array;
  /** Share of the whole length before it, 0 to 1. */
  readonly shares: Float32Array;
  /** World units. */
  readonly length: number;
}

const DEGREE = 3;
/** In all, about. */
const SAMPLES = 2000;
/** How far apart a span's slopes are compared, as a share of what a sample stands for. They lie on a parabola: the second derivative comes out exact. */
const APART = 0.25;
/** Slower than this share of the mean speed the curve stands still, and has no curvature. */
const STANDSTILL = 1e-3;

export function profileOf(wire: WireShape): Profile {
  const { knots } = wire;
  const controls = Math.floor(wire.controlPoints.length / 4);
  const control = Float64Array.from(wire.controlPoints);
  const lastSpan = wire.closed ? controls + DEGREE - 1 : controls - 1;
  const spans = Array.from({ length: Math.max(0, lastSpan - DEGREE + 1) }, (_, k) => k + DEGREE).filter((span) => knots[span + 1]! > knots[span]!);
  const perSpan = Math.max(4, Math.min(16, Math.round(SAMPLES / Math.max(1, spans.length))));
  const count = spans.length * perSpan;
  const [places, widths, curvatures, shares] = [new Float32Array(3 * count), new Float32Array(count), new Float32Array(count), new Float32Array(count)];
  const speeds = new Float64Array(count);
  const [weights, slopes] = [new Float64Array(4), new Float64Array(4)];

  const combined = (span: number, by: Float64Array): [number, number, number, number] => {
    const sum: [number, number, number, number] = [0, 0, 0, 0];
    for (let k = 0; k < 4; k++) {
      const at = 4 * ((span - DEGREE + k) % controls);
      for (let c = 0; c < 4; c++) sum[c]! += by[k]! * control[at + c]!;
    }
    return sum;
  };
  const slopeAt = (span: number, t: number): [number, number, number, number] => {
    basis(knots, span, t, weights, slopes);
    return combined(span, slopes);
  };

  let at = 0;
  let length = 0;
  for (const span of spans) {
    const [low, part] = [knots[span]!, (knots[span + 1]! - knots[span]!) / perSpan];
    for (let k = 0; k < perSpan; k++, at++) {
      const t = low + part * (k + 0.5);
      const h = APART * part;
      const [before, after] = [slopeAt(span, t - h), slopeAt(span, t + h)];
      const [x, y, z] = slopeAt(span, t);
      const place = combined(span, weights);
      const [ax, ay, az] = [0, 1, 2].map((c) => (after[c]! - before[c]!) / (2 * h)) as [number, number, number];
      const speed = Math.hypot(x, y, z);
      places.set(place.slice(0, 3), 3 * at);
      widths[at] = Math.max(0, place[3]);
      curvatures[at] = speed > 0 ? Math.hypot(y * az - z * ay, z * ax - x * az, x * ay - y * ax) / speed ** 3 : 0;
      speeds[at] = speed;
      shares[at] = length + (speed * part) / 2;
      length += speed * part;
    }
  }
  const mean = speeds.reduce((sum, speed) => sum + speed, 0) / Math.max(1, count);
  for (let i = 0; i < count; i++) {
    shares[i]! /= length || 1;
    if (speeds[i]! < STANDSTILL * mean) curvatures[i] = 0;
  }
  return { count, places, widths, curvatures, shares, length };
}

/** The sample nearest to a share of the length. */
export function sampleAt({ shares, count }: Profile, share: number): number {
  let [low, high] = [0, Math.max(0, count - 1)];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (shares[middle]! < share) low = middle + 1;
    else high = middle;
  }
  return low > 0 && share - shares[low - 1]! < shares[low]! - share ? low - 1 : low;
}

/** The bend's radius in the wire's own diameters; infinite where it is straight, or where it has no width. */
export function radiusInDiameters({ widths, curvatures }: Profile, at: number): number {
  const tightness = widths[at]! * curvatures[at]!;
  return tightness > 0 ? 1 / tightness : Infinity;
}
