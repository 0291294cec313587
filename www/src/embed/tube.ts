/** Samples turned into rings: a frame that does not twist along the wire, and round caps at its ends. */

import type { Samples } from "./shape";

/** Floats for each ring: centre 3, radius, tangent 3, parameter, normal 3, tilt. See `shaders.ts`. */
export const RING_FLOATS = 12;
const CAP_RINGS = 5;

/** Rings in drawing order; a negative radius marks the last ring of a strip, from which nothing is drawn onwards. */
export interface Rings {
  readonly count: number;
  readonly data: Float32Array;
}

type Vector = [number, number, number];

/** Rings for every strip. `data` is reused when it is large enough, so a running fit allocates nothing much. */
export function buildRings(samples: Samples, reuse?: Float32Array): Rings {
  const count = samples.strips.reduce((sum, s) => sum + s.last - s.first + 1 + (s.closed ? 1 : 2 * CAP_RINGS), 0);
  const data = reuse && reuse.length >= count * RING_FLOATS ? reuse : new Float32Array(count * RING_FLOATS * 2);
  let at = 0;

  const put = (centre: Vector, radius: number, tangent: Vector, normal: Vector, parameter: number, tilt: number): void => {
    data.set([...centre, radius, ...tangent, parameter, ...normal, tilt], at);
    at += RING_FLOATS;
  };

  for (const strip of samples.strips) {
    const length = strip.last - strip.first + 1;
    const tangents = unitTangents(samples, strip.first, length);
    const normals = transportedNormals(tangents);
    const ring = (i: number): [Vector, number, number] => {
      const k = strip.first + i;
      const p = samples.points;
      return [[p[4 * k]!, p[4 * k + 1]!, p[4 * k + 2]!], p[4 * k + 3]!, samples.parameters[k]!];
    };
    const cap = (i: number, direction: 1 | -1): void => {
      const [centre, radius, parameter] = ring(i);
      const tangent = tangents[i]!;
      for (let step = 0; step < CAP_RINGS; step++) {
        // From the pole to the rim at the start of a strip, and back at its end.
        const angle = (Math.PI / 2) * (direction < 0 ? 1 - step / CAP_RINGS : (step + 1) / CAP_RINGS);
        const along = direction * radius * Math.sin(angle);
        const moved: Vector = [
          centre[0] + tangent[0] * along,
          centre[1] + tangent[1] * along,
          centre[2] + tangent[2] * along,
        ];
        put(moved, radius * Math.cos(angle), tangent, normals[i]!, parameter, direction * Math.sin(angle));
      }
    };

    if (!strip.closed) cap(0, -1);
    for (let i = 0; i < length; i++) {
      const [centre, radius, parameter] = ring(i);
      put(centre, radius, tangents[i]!, normals[i]!, parameter, 0);
    }
    if (strip.closed) {
      const [centre, radius] = ring(0);
      // The last frame, not the first: both lie on the same circle, and this one does not twist the last piece.
      put(centre, radius, tangents[0]!, normals[length - 1]!, 1, 0);
    } else {
      cap(length - 1, 1);
    }
    data[at - RING_FLOATS + 3] = -1 - Math.max(0, data[at - RING_FLOATS + 3]!);
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
