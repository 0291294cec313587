/** Samples turned into rings: a frame that does not twist along the wire, and round caps at its ends. */

import type { Samples } from "./shape";

/** Floats for each ring: centre 3, radius, tangent 3, parameter, normal 3, lean. See `shaders.ts`. */
export const RING_FLOATS = 12;
const CAP_RINGS = 5;

/**
 * Rings in drawing order, each joined to the next. Every strip begins and ends in a pole of radius 0, so what joins
 * two strips has no area.
 */
export interface Rings {
  readonly count: number;
  readonly data: Float32Array<ArrayBuffer>;
}

type Vector = [number, number, number];

/**
 * Rings for every strip. The lean of the surface along the wire is the sine of its angle: ±1 at the poles, minus the
 * growth of the radius elsewhere. `data` is `reuse` where that is large enough.
 */
export function buildRings(samples: Samples, reuse?: Float32Array<ArrayBuffer>): Rings {
  const count = samples.strips.reduce((sum, s) => sum + s.last - s.first + 1 + (s.closed ? 1 : 2 * CAP_RINGS), 0);
  const data = reuse && reuse.length >= count * RING_FLOATS ? reuse : new Float32Array(count * RING_FLOATS * 2);
  let at = 0;

  const put = (centre: Vector, radius: number, tangent: Vector, normal: Vector, parameter: number, lean: number): void => {
    data.set([...centre, radius, ...tangent, parameter, ...normal, lean], at);
    at += RING_FLOATS;
  };
  const { points } = samples;
  const centreOf = (k: number): Vector => [points[4 * k]!, points[4 * k + 1]!, points[4 * k + 2]!];
  const radiusOf = (k: number): number => points[4 * k + 3]!;
  const taper = (a: number, b: number): number => {
    const run = Math.hypot(points[4 * b]! - points[4 * a]!, points[4 * b + 1]! - points[4 * a + 1]!, points[4 * b + 2]! - points[4 * a + 2]!);
    return Math.max(-0.9, Math.min(0.9, (radiusOf(a) - radiusOf(b)) / Math.max(run, 1e-6)));
  };

  for (const { first, last, closed } of samples.strips) {
    const tangents = unitTangents(samples, first, last - first + 1);
    const normals = transportedNormals(tangents);
    const cap = (k: number, direction: 1 | -1): void => {
      const [centre, radius, tangent] = [centreOf(k), radiusOf(k), tangents[k - first]!];
      for (let step = 0; step < CAP_RINGS; step++) {
        // From the pole to the rim at the start of a strip, and back at its end.
        const angle = (Math.PI / 2) * (direction < 0 ? 1 - step / CAP_RINGS : (step + 1) / CAP_RINGS);
        const [out, along] = [Math.cos(angle) * radius, direction * Math.sin(angle)];
        const moved = centre.map((c, i) => c + tangent[i]! * along * radius) as Vector;
        const pole = Math.abs(along) > 1 - 1e-9;
        put(moved, pole ? 0 : out, tangent, normals[k - first]!, samples.parameters[k]!, pole ? direction : along);
      }
    };

    if (!closed) cap(first, -1);
    for (let k = first; k <= last; k++) {
      const lean = taper(closed || k > first ? (k > first ? k - 1 : last) : k, closed || k < last ? (k < last ? k + 1 : first) : k);
      put(centreOf(k), radiusOf(k), tangents[k - first]!, normals[k - first]!, samples.parameters[k]!, lean);
    }
    // A closed strip ends with the last frame, not the first: both lie on the same circle, and this one does not twist.
    if (closed) put(centreOf(first), radiusOf(first), tangents[0]!, normals.at(-1)!, 1, 0);
    else cap(last, 1);
  }
  return { count: at / RING_FLOATS, data };
}

/** Where the curve stands still its direction is taken from the neighbours, and failing that kept from before. */
function unitTangents(samples: Samples, first: number, length: number): Vector[] {
  const unit: Vector[] = [];
  let previous: Vector = [1, 0, 0];
  for (let i = 0; i < length; i++) {
    const k = first + i;
    let t: Vector = [samples.tangents[3 * k]!, samples.tangents[3 * k + 1]!, samples.tangents[3 * k + 2]!];
    let norm = Math.hypot(...t);
    if (!(norm > 1e-9)) {
      const [a, b] = [first + Math.max(0, i - 1), first + Math.min(length - 1, i + 1)];
      t = [0, 1, 2].map((c) => samples.points[4 * b + c]! - samples.points[4 * a + c]!) as Vector;
      norm = Math.hypot(...t);
    }
    previous = norm > 1e-9 ? [t[0] / norm, t[1] / norm, t[2] / norm] : previous;
    unit.push(previous);
  }
  return unit;
}

/** Each normal is the one before it made perpendicular again: on a fine curve that turns with it and does not twist. */
function transportedNormals(tangents: readonly Vector[]): Vector[] {
  const normals: Vector[] = [];
  let normal: Vector = [0, 0, 0];
  for (const t of tangents) {
    let n = perpendicular(normal, t);
    if (!n) {
      // Any axis that is far from the tangent.
      const axis: Vector = Math.abs(t[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
      n = perpendicular(axis, t) ?? [0, 0, 1];
    }
    normal = n;
    normals.push(n);
  }
  return normals;
}

function perpendicular(v: Vector, t: Vector): Vector | null {
  const along = v[0] * t[0] + v[1] * t[1] + v[2] * t[2];
  const n: Vector = [v[0] - along * t[0], v[1] - along * t[1], v[2] - along * t[2]];
  const norm = Math.hypot(...n);
  return norm > 0.05 ? [n[0] / norm, n[1] / norm, n[2] / norm] : null;
}
