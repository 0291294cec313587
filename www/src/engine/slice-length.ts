/**
 * How many iterations fill a slice, learned as a run goes. Some of a slice may be waiting for a graphics card, however few
 * iterations it has; where that is most of it, fewer iterations would only mean waiting more often.
 */

/** How long the run works before it listens again, if it need not wait. */
const SLICE_MS = 30;
/** Most iterations of a slice: a fast card does one in a twentieth of a millisecond. */
const MOST_STEPS = 512;
/** What a slice still counts when the next one is measured. */
const FADE = 0.85;
/** Each so many slices one is longer by half: slices of one length do not tell how much of them is waiting. */
const LONGER_EACH = 8;
/** So many times as long as expected, and as many milliseconds, is more than a moment's trouble: it goes at another pace now. */
const MUCH_LONGER = 4;
const MUCH_MS = 100;

const NONE = { one: 0, n: 0, ms: 0, nn: 0, nMs: 0 };

export class SliceLength {
  private steps = 1;
  private slices = 0;
  private waitMs = 0;
  private stepMs = Infinity;
  /** Faded sums over the slices: of 1, iterations, milliseconds, iterations², iterations × milliseconds. */
  private sums = { ...NONE };

  /** Iterations of the next slice. */
  get next(): number {
    return this.slices % LONGER_EACH === LONGER_EACH - 1 ? Math.min(MOST_STEPS, Math.ceil(1.5 * this.steps)) : this.steps;
  }

  /** A slice of `n` iterations took `ms`. */
  learn(n: number, ms: number): void {
    // The first one pays for all that is done for the first time, and one length alone says nothing: one, one, two.
    if (++this.slices === 1 || n < 1) return;
    if (ms > MUCH_MS && ms > MUCH_LONGER * (this.waitMs + n * this.stepMs)) {
      this.forget();
      return;
    }
    const { sums } = this;
    for (const [name, value] of Object.entries({ one: 1, n, ms, nn: n * n, nMs: n * ms })) {
      const sum = name as keyof typeof sums;
      sums[sum] = FADE * sums[sum] + value;
    }
    this.steps = this.slices === 2 ? 2 * n : this.fitting(n, ms);
  }

  private forget(): void {
    this.steps = this.slices = 1;
    this.waitMs = 0;
    this.stepMs = Infinity;
    this.sums = { ...NONE };
  }

  /** By a straight line through the slices: what they wait, and what each iteration adds. */
  private fitting(n: number, ms: number): number {
    const { one, n: sumN, ms: sumMs, nn, nMs } = this.sums;
    const [meanN, meanMs] = [sumN / one, sumMs / one];
    const spread = nn / one - meanN * meanN;
    // Where lengths hardly differ, what was known of the waiting still holds.
    if (spread > (0.1 * meanN) ** 2) this.waitMs = meanMs - (meanN * (nMs / one - meanN * meanMs)) / spread;
    this.waitMs = Math.max(0, Math.min(this.waitMs, 0.99 * meanMs, 0.99 * ms));
    const workMs = Math.max(SLICE_MS - this.waitMs, this.waitMs);
    this.stepMs = (meanMs - this.waitMs) / meanN;
    // At most twice as many as now, so that one wrong guess costs little.
    return Math.round(Math.max(1, Math.min(MOST_STEPS, 2 * n, workMs / this.stepMs)));
  }
}
