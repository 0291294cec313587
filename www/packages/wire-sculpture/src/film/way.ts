/** The wires that a run went through, as one that moves. */

import { sampleWire, samplesPerSpan, type Samples, type WireShape } from "../scene/shape";

/**
 * The wire at a place between those that were kept, 0 to 1. Between two that are one line each, it moves evenly, however
 * their control points were laid anew; others follow each other as they are.
 */
export class Way {
  /** Only neighbours are needed at a time. */
  private readonly known = new Map<number, Samples>();

  /** `samples`: about how many points a wire has; at least one wire. */
  constructor(
    private readonly wires: readonly WireShape[],
    private readonly samples: number,
  ) {}

  at(place: number): Samples {
    const last = this.wires.length - 1;
    const at = Math.max(0, Math.min(1, place)) * last;
    const [before, share] = [Math.floor(at), at - Math.floor(at)];
    for (const known of this.known.keys()) if (known < before || known > before + 1) this.known.delete(known);
    if (share === 0) return this.sampled(before);
    const [a, b] = [this.sampled(before), this.sampled(before + 1)];
    return blended(a, b, share, this.samples) ?? (share < 0.5 ? a : b);
  }

  private sampled(index: number): Samples {
    let samples = this.known.get(index);
    if (!samples) this.known.set(index, (samples = sampleWire(this.wires[index]!, samplesPerSpan(this.wires[index]!, this.samples))));
    return samples;
  }
}

/** Both at the same parameters, mixed; null where they are not one line each of the same kind. */
function blended(a: Samples, b: Samples, share: number, count: number): Samples | null {
  const [only, other] = [a.strips[0], b.strips[0]];
  if (!only || !other || a.strips.length > 1 || b.strips.length > 1 || only.closed !== other.closed) return null;
  const parameters = Float32Array.from({ length: count }, (_, i) => i / (only.closed ? count : count - 1));
  const [first, second] = [a, b].map((samples) => evenly(samples, parameters)) as [Even, Even];
  const mix = (from: Float32Array, to: Float32Array): Float32Array => from.map((x, i) => x + (to[i]! - x) * share);
  return { count, parameters, points: mix(first.points, second.points), tangents: mix(first.tangents, second.tangents), strips: [{ first: 0, last: count - 1, closed: only.closed }] };
}

type Even = Pick<Samples, "points" | "tangents">;

/** By straight lines between samples, which are closer than anybody sees. */
function evenly(samples: Samples, parameters: Float32Array): Even {
  const { count, strips } = samples;
  const points = new Float32Array(4 * parameters.length);
  const tangents = new Float32Array(3 * parameters.length);
  const closed = strips[0]!.closed;
  let at = 0;
  parameters.forEach((parameter, i) => {
    while (at + 1 < count && samples.parameters[at + 1]! <= parameter) at++;
    const next = at + 1 < count ? at + 1 : closed ? 0 : at;
    const [low, high] = [samples.parameters[at]!, next > at ? samples.parameters[next]! : 1];
    const share = high > low ? (parameter - low) / (high - low) : 0;
    for (let c = 0; c < 4; c++) points[4 * i + c] = mixed(samples.points[4 * at + c]!, samples.points[4 * next + c]!, share);
    // Directions are as long as their control points are apart, which is not the same on both sides.
    const [from, to] = [unit(samples.tangents, at), unit(samples.tangents, next)];
    for (let c = 0; c < 3; c++) tangents[3 * i + c] = mixed(from[c]!, to[c]!, share);
  });
  return { points, tangents };
}

const mixed = (a: number, b: number, share: number): number => a + (b - a) * share;

function unit(tangents: Float32Array, k: number): readonly number[] {
  const tangent = [0, 1, 2].map((c) => tangents[3 * k + c]!);
  const norm = Math.hypot(...tangent) || 1;
  return tangent.map((x) => x / norm);
}
