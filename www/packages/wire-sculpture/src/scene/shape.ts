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

/** Samples a span so that there are about `total` in all: at least 2, which look smooth where spans are many, and at most 8. */
export function samplesPerSpan(wire: WireShape, total: number, least = 2): number {
  return Math.max(least, Math.min(8, Math.round(total / Math.max(1, wire.controlPoints.length / 4))));
}

/** What of sampling depends on the knots alone, so that moving control points costs little. */
interface Layout {
  readonly closed: boolean;
  readonly controls: number;
  readonly perSpan: number;
  readonly knots: Float64Array;
  readonly count: number;
  readonly strips: Samples["strips"];
  readonly parameters: Float32Array;
  /** The first of the four control points of each sample, their weights, and those of the derivative. */
  readonly firsts: Int32Array;
  readonly weights: Float64Array;
  readonly slopes: Float64Array;
}

/** `perSpan` samples on every span of the knots. */
export function sampleWire(wire: WireShape, perSpan: number): Samples {
  const layout = layOut(wire, perSpan);
  return combine(layout, wire.controlPoints, new Float32Array(4 * layout.count), new Float32Array(3 * layout.count));
}

/** Samples wires that follow each other. What it gives is good until it is asked again. */
export class Sampler {
  private layout: Layout | null = null;
  private points = new Float32Array(0);
  private tangents = new Float32Array(0);

  sample(wire: WireShape, perSpan: number): Samples {
    if (!this.layout || !fits(this.layout, wire, perSpan)) {
      this.layout = layOut(wire, perSpan);
      this.points = new Float32Array(4 * this.layout.count);
      this.tangents = new Float32Array(3 * this.layout.count);
    }
    return combine(this.layout, wire.controlPoints, this.points, this.tangents);
  }
}

function fits(layout: Layout, wire: WireShape, perSpan: number): boolean {
  const { knots } = wire;
  if (layout.closed !== wire.closed || layout.perSpan !== perSpan || layout.knots.length !== knots.length) return false;
  if (layout.controls !== Math.floor(wire.controlPoints.length / 4)) return false;
  for (let k = 0; k < knots.length; k++) if (layout.knots[k] !== knots[k]) return false;
  return true;
}

function layOut(wire: WireShape, perSpan: number): Layout {
  const knots = new Float64Array(wire.knots);
  const controls = Math.floor(wire.controlPoints.length / 4);
  const lastSpan = wire.closed ? controls + DEGREE - 1 : controls - 1;
  const spans: number[] = [];
  for (let span = DEGREE; span <= lastSpan; span++) {
    if (knots[span + 1]! > knots[span]!) spans.push(span);
  }
  // Four equal knots break the curve: the baselines of independent pieces are drawn as such.
  const ends = spans.map((span, index) => index + 1 < spans.length ? spans[index + 1]! - span > DEGREE : !wire.closed);
  const count = spans.length * perSpan + ends.filter(Boolean).length;
  const parameters = new Float32Array(count);
  const firsts = new Int32Array(count);
  const weights = new Float64Array(4 * count);
  const slopes = new Float64Array(4 * count);
  const strips: { first: number; last: number; closed: boolean }[] = [];
  const start = knots[DEGREE]!;
  const length = knots[lastSpan + 1]! - start || 1;
  const [weight, slope] = [new Float64Array(4), new Float64Array(4)];
  let [first, at] = [0, 0];

  spans.forEach((span, index) => {
    const [low, high] = [knots[span]!, knots[span + 1]!];
    for (let k = 0; k < (ends[index] ? perSpan + 1 : perSpan); k++) {
      const t = k === perSpan ? high : low + ((high - low) * k) / perSpan;
      basis(knots, span, t, weight, slope);
      weights.set(weight, 4 * at);
      slopes.set(slope, 4 * at);
      firsts[at] = span - DEGREE;
      parameters[at++] = (t - start) / length;
    }
    if (ends[index]) strips.push({ first, last: at - 1, closed: false });
    else if (index + 1 === spans.length) strips.push({ first, last: at - 1, closed: true });
    if (ends[index]) first = at;
  });
  return { closed: wire.closed, controls, perSpan, knots, count, strips, parameters, firsts, weights, slopes };
}

function combine(layout: Layout, controlPoints: ArrayLike<number>, points: Float32Array, tangents: Float32Array): Samples {
  const { count, strips, parameters, controls, firsts, weights, slopes } = layout;
  // One kind of array, whatever came: the loop below is the hottest of the page.
  const control = new Float64Array(controlPoints);
  for (let i = 0; i < count; i++) {
    let x = 0;
    let y = 0;
    let z = 0;
    let width = 0;
    let dx = 0;
    let dy = 0;
    let dz = 0;
    for (let k = 0; k < 4; k++) {
      const at = ((firsts[i]! + k) % controls) * 4;
      const weight = weights[4 * i + k]!;
      const slope = slopes[4 * i + k]!;
      x += weight * control[at]!;
      y += weight * control[at + 1]!;
      z += weight * control[at + 2]!;
      width += weight * control[at + 3]!;
      dx += slope * control[at]!;
      dy += slope * control[at + 1]!;
      dz += slope * control[at + 2]!;
    }
    points[4 * i] = x;
    points[4 * i + 1] = y;
    points[4 * i + 2] = z;
    points[4 * i + 3] = Math.max(0, width / 2);
    tangents[3 * i] = dx;
    tangents[3 * i + 1] = dy;
    tangents[3 * i + 2] = dz;
  }
  return { count, points, tangents, parameters, strips };
}

const left = new Float64Array(DEGREE + 1);
const right = new Float64Array(DEGREE + 1);

/** The four cubic basis functions that do not vanish on the span, and their derivatives by t (The NURBS Book, A2.2). */
export function basis(
  knots: ArrayLike<number>,
  span: number,
  t: number,
  weights: Float64Array,
  slopes: Float64Array,
): void {
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
