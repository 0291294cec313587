/**
 * Reads numbers that come one after another: several guesses of the next one, each a bell of some width, are mixed by how
 * well they did so far. Twin of the reading half of `src/export/share/guess.rs`: only `+ - * /`, square roots and `floor`,
 * in the same order, so that every bit is the same.
 */

import { Models, numberModels, type RangeDecoder } from "./range";

/** Numbers that a guess is made from. */
const INPUTS = 4;
const BINS = 64;
const TYPICAL_BINS = 6;
/** Numbers stay within this, whatever a damaged code says. */
export const MAX_NUMBER = 2 ** 27;

export const clamp = (x: number): number => Math.max(-MAX_NUMBER, Math.min(MAX_NUMBER, x));

const FORGETTING = 0.998;
const FREEDOM = 0.01;

/** A weighted sum of the inputs, fitted to all numbers so far (recursive least squares with slow forgetting). */
class Fit {
  private readonly weights: Float64Array;
  private readonly inverse = new Float64Array(INPUTS * INPUTS);
  private readonly gain = new Float64Array(INPUTS);

  constructor(weights: readonly number[]) {
    this.weights = Float64Array.from(weights);
    this.begin();
  }

  guess(inputs: Float64Array): number {
    let sum = 0;
    for (let k = 0; k < INPUTS; k++) sum += this.weights[k]! * inputs[k]!;
    return sum;
  }

  learn(inputs: Float64Array, number: number): void {
    const { weights, inverse, gain } = this;
    let scale = FORGETTING;
    for (let i = 0; i < INPUTS; i++) {
      let sum = 0;
      for (let j = 0; j < INPUTS; j++) sum += inverse[INPUTS * i + j]! * inputs[j]!;
      gain[i] = sum;
    }
    for (let i = 0; i < INPUTS; i++) scale += inputs[i]! * gain[i]!;
    const miss = number - this.guess(inputs);
    for (let i = 0; i < INPUTS; i++) weights[i]! += (gain[i]! / scale) * miss;
    for (let i = 0; i < INPUTS; i++) {
      for (let j = 0; j < INPUTS; j++) {
        const at = INPUTS * i + j;
        inverse[at] = (inverse[at]! - (gain[i]! * gain[j]!) / scale) / FORGETTING;
      }
    }
    let trace = 0;
    for (let k = 0; k < INPUTS; k++) trace += inverse[(INPUTS + 1) * k]!;
    const sound = weights.every((weight) => Math.abs(weight) < 16) && trace > 0 && trace < 1e6;
    if (!sound) {
      weights.set([1, 0, 0, 0]);
      this.begin();
    }
  }

  private begin(): void {
    this.inverse.fill(0);
    for (let k = 0; k < INPUTS; k++) this.inverse[(INPUTS + 1) * k] = FREEDOM;
  }
}

/** Means of what a guess misses by, over the last fifty and the last seven numbers. */
class Misses {
  slow = 4;
  fast = 4;

  learn(miss: number): void {
    this.slow += (miss - this.slow) * 0.02;
    this.fast += (miss - this.fast) * 0.15;
  }
}

const bellWidth = (miss: number): number => Math.max(miss, 0.2) * 1.5;

/** A bell `(1 + x²/3)^-3`. */
function bell(x: number, centre: number, width: number): number {
  const t = (x - centre) / width;
  const a = 1 + (t * t) / 3;
  return 1 / (a * a * a);
}

const BELLS = 6;
/** A coordinate's last experts know how far it is from one point to the next as well. */
const EXPERTS = BELLS + 3;
const FORGIVEN = 0.02;

/** What the experts say of one number. */
class Opinion {
  readonly centres = new Float64Array(BELLS);
  readonly widths = new Float64Array(BELLS);
  /** Of the three that know the distance: their bell, the distance, how uneven it is. */
  readonly ringBells = [1, 2, 4] as const;
  readonly distances = new Float64Array(3);
  readonly ringWidths = new Float64Array(3);
  squares = 0;

  at(expert: number, x: number): number {
    if (expert < BELLS) return bell(x, this.centres[expert]!, this.widths[expert]!);
    const ring = expert - BELLS;
    const own = this.ringBells[ring]!;
    return bell(x, this.centres[own]!, this.widths[own]!) * bell(Math.sqrt(this.squares + x * x), this.distances[ring]!, this.ringWidths[ring]!);
  }
}

const densities = new Float64Array(EXPERTS * BINS);
const sums = new Float64Array(2 * BINS);

/** How well each expert did so far. */
class Mixture {
  private readonly shares: Float64Array;
  private readonly outside = new Models(1);
  private readonly escaped = numberModels();

  constructor(private readonly count: number) {
    this.shares = new Float64Array(count).fill(1 / count);
  }

  number(coder: RangeDecoder, centre: number, doublings: number, opinion: Opinion): number {
    if (coder.bit(this.outside, 0)) return clamp(centre + coder.number(this.escaped));
    const { count, shares } = this;
    const bin = 2 ** doublings;
    const start = centre - (BINS / 2) * bin;
    const half = (bin - 1) / 2;
    sums.fill(0);
    for (let expert = 0; expert < count; expert++) {
      const from = expert * BINS;
      let sum = 0;
      for (let k = 0; k < BINS; k++) sum += densities[from + k] = opinion.at(expert, start + k * bin + half);
      for (let k = 0; k < BINS; k++) sums[BINS + k]! += shares[expert]! * (densities[from + k]! /= sum);
    }
    const read = choose(coder);
    let sum = 0;
    for (let expert = 0; expert < count; expert++) sum += shares[expert]! *= densities[expert * BINS + read]! + 1e-9;
    for (let expert = 0; expert < count; expert++) shares[expert] = ((1 - FORGIVEN) * shares[expert]!) / sum + FORGIVEN / count;
    return clamp(start + read * bin + coder.bits(doublings));
  }
}

/** One of the bins, by halving. */
function choose(coder: RangeDecoder): number {
  for (let node = BINS - 1; node > 0; node--) sums[node] = sums[2 * node]! + sums[2 * node + 1]!;
  let node = 1;
  while (node < BINS) {
    const one = Math.max(1, Math.min(65_535, Math.floor((sums[2 * node + 1]! / sums[node]!) * 65_536)));
    node = 2 * node + (coder.split(one, 16) ? 1 : 0);
  }
  return node - BINS;
}

/** Reads a series of some numbers at a time: coordinates (3) or widths (1). */
export class Series {
  private readonly fit: Fit;
  private readonly ofPlain = new Misses();
  private readonly ofFitted = new Misses();
  private readonly mixtures: readonly Mixture[];
  private readonly distance = [12, 12];
  private unevenness = 1;
  private readonly opinion = new Opinion();

  /** With the weights of the inputs at first. */
  constructor(private readonly count: 1 | 3, weights: readonly number[]) {
    this.fit = new Fit(weights);
    this.mixtures = Array.from({ length: count }, (_, slot) => new Mixture(slot === 2 ? EXPERTS : BELLS));
  }

  /** The next numbers. `plain` is a first guess of them, `inputs` what a better one is made from. */
  next(coder: RangeDecoder, plain: readonly number[], inputs: readonly Float64Array[]): number[] {
    const { ofPlain, ofFitted, opinion, distance } = this;
    const fitted = inputs.map((of) => clamp(this.fit.guess(of)));
    const order = fitted.map((_, c) => c).sort((a, b) => Math.abs(fitted[a]!) - Math.abs(fitted[b]!));
    let doublings = 0;
    while (Math.max(ofFitted.slow, ofFitted.fast) > TYPICAL_BINS * 2 ** doublings) doublings++;
    const read = new Array<number>(this.count).fill(0);
    opinion.squares = 0;
    const { slow, fast } = ofFitted;
    [ofPlain.slow, slow * 0.7, fast * 0.6, fast * 1.2, slow * 1.5, ofPlain.fast].forEach((miss, k) => (opinion.widths[k] = bellWidth(miss)));
    opinion.distances.set([distance[0]!, distance[1]!, distance[0]!]);
    [this.unevenness, this.unevenness, this.unevenness * 0.5].forEach((miss, k) => (opinion.ringWidths[k] = bellWidth(miss)));
    order.forEach((c, slot) => {
      opinion.centres.fill(fitted[c]!, 1, 5);
      opinion.centres[0] = opinion.centres[5] = plain[c]!;
      const number = this.mixtures[slot]!.number(coder, Math.floor(fitted[c]! + 0.5), doublings, opinion);
      read[c] = number;
      opinion.squares += number * number;
    });
    this.learn(read, plain, fitted, inputs, Math.sqrt(opinion.squares));
    return read;
  }

  private learn(read: readonly number[], plain: readonly number[], fitted: readonly number[], inputs: readonly Float64Array[], far: number): void {
    const { distance } = this;
    this.unevenness += (Math.abs(far - distance[0]!) - this.unevenness) * 0.03;
    distance[0]! += (far - distance[0]!) * 0.03;
    distance[1]! += (far - distance[1]!) * 0.2;
    const miss = (guess: readonly number[]): number => read.reduce((sum, number, c) => sum + Math.abs(number - guess[c]!), 0) / read.length;
    this.ofPlain.learn(miss(plain));
    this.ofFitted.learn(miss(fitted));
    read.forEach((number, c) => this.fit.learn(inputs[c]!, number));
  }
}
