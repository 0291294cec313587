/** What the stage draws: the wire as control points and knots, and nothing about where it came from. */

/** A cubic B-spline in 4D. Open: n + 4 knots, clamped. Closed: n + 7, and the first three control points follow again. */
export interface WireShape {
  readonly closed: boolean;
  readonly knots: ArrayLike<number>;
  /** x, y, z, width for each control point; world units, width is the full diameter. */
  readonly controlPoints: ArrayLike<number>;
}

/** Points along the wire with what a tube needs to know at each. */
export interface Samples {
  readonly count: number;
  /** x, y, z, radius for each sample. */
  readonly points: Float32Array;
  /** Direction of travel, not normalised, for each sample. */
  readonly tangents: Float32Array;
  /** Position along the whole wire, 0 to 1. */
  readonly parameters: Float32Array;
  /** First sample of each unbroken run, and last one. */
  readonly strips: readonly { readonly first: number; readonly last: number; readonly closed: boolean }[];
}

const DEGREE = 3;

/** Samples a span so that there are about `total` in all: from 2, which still looks smooth where spans are many, to 8. */
export function samplesPerSpan(wire: WireShape, total: number): number {
  return Math.max(2, Math.min(8, Math.round(total / Math.max(1, wire.controlPoints.length / 4))));
}

/** `perSpan` samples on every span of the knots, by de Boor's basis functions and their derivatives. */
export function sampleWire(wire: WireShape, perSpan: number): Samples {
  const { knots, controlPoints } = wire;
  const controls = Math.floor(controlPoints.length / 4);
  const lastSpan = wire.closed ? controls + DEGREE - 1 : controls - 1;
  const spans: number[] = [];
  for (let span = DEGREE; span <= lastSpan; span++) {
    if (knots[span + 1]! > knots[span]!) spans.push(span);
  }
  const points: number[] = [];
  const tangents: number[] = [];
  const parameters: number[] = [];
  const strips: { first: number; last: number; closed: boolean }[] = [];
  const start = knots[DEGREE]!;
  const length = knots[lastSpan + 1]! - start || 1;
  const weights = new Float64Array(4);
  const slopes = new Float64Array(4);
  let first = 0;

  const add = (span: number, t: number): void => {
    basis(knots, span, t, weights, slopes);
    const point = [0, 0, 0, 0];
    const tangent = [0, 0, 0];
    for (let k = 0; k < 4; k++) {
      const at = ((span - DEGREE + k) % controls) * 4;
      for (let c = 0; c < 4; c++) point[c]! += weights[k]! * controlPoints[at + c]!;
      for (let c = 0; c < 3; c++) tangent[c]! += slopes[k]! * controlPoints[at + c]!;
    }
    points.push(point[0]!, point[1]!, point[2]!, Math.max(0, point[3]! / 2));
    tangents.push(tangent[0]!, tangent[1]!, tangent[2]!);
    parameters.push((t - start) / length);
  };

  spans.forEach((span, index) => {
    const low = knots[span]!;
    const high = knots[span + 1]!;
    for (let k = 0; k < perSpan; k++) add(span, low + ((high - low) * k) / perSpan);
    const next = spans[index + 1];
    // Four equal knots break the curve: the baselines of independent pieces are drawn as such.
    const breaks = next !== undefined && next - span > DEGREE;
    if (breaks || (next === undefined && !wire.closed)) {
      add(span, high);
      strips.push({ first, last: parameters.length - 1, closed: false });
      first = parameters.length;
    } else if (next === undefined) {
      strips.push({ first, last: parameters.length - 1, closed: true });
    }
  });
  return {
    count: parameters.length,
    points: Float32Array.from(points),
    tangents: Float32Array.from(tangents),
    parameters: Float32Array.from(parameters),
    strips,
  };
}

/** The four cubic basis functions that do not vanish on the span, and their derivatives by t (The NURBS Book, A2.2). */
export function basis(
  knots: ArrayLike<number>,
  span: number,
  t: number,
  weights: Float64Array,
  slopes: Float64Array,
): void {
  const left = [0, 0, 0, 0];
  const right = [0, 0, 0, 0];
  weights[0] = 1;
  for (let degree = 1; degree <= DEGREE; degree++) {
    left[degree] = t - knots[span + 1 - degree]!;
    right[degree] = knots[span + degree]! - t;
    if (degree === DEGREE) {
      // Derivative of degree 3 from the functions of degree 2: N' = 3 (N₋ / Δ₋ - N₊ / Δ₊).
      for (let k = 0; k <= DEGREE; k++) {
        const before = k > 0 ? weights[k - 1]! / (knots[span + k]! - knots[span + k - DEGREE]!) : 0;
        const after = k < DEGREE ? weights[k]! / (knots[span + k + 1]! - knots[span + k + 1 - DEGREE]!) : 0;
        slopes[k] = DEGREE * (before - after);
      }
    }
    let carried = 0;
    for (let k = 0; k < degree; k++) {
      const part = weights[k]! / (right[k + 1]! + left[degree - k]!);
      weights[k] = carried + right[k + 1]! * part;
      carried = left[degree - k]! * part;
    }
    weights[degree] = carried;
  }
}
