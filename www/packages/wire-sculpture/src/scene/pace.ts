/** How fine pictures are drawn and how soon the next one follows: as a slow machine can, and within a share of its time. */

/** Pictures that take longer than this to finish are drawn coarser, down to this share of the pixels a side. */
const LATE_MS = 40;
const COARSEST = 0.4;
const COARSER = 0.8;
/** Longer than this, and they are also drawn less often, to leave the machine to others; longer still, and the page slept. */
const VERY_LATE_MS = 80;
const LONGEST_BREATH_MS = 150;
const ASLEEP_MS = 3000;
/** Within a share of the time, pictures are made so coarse that they may follow each other like this, if that is possible. */
const RATIONED_MS = 200;
/** How far they may be from that: what is drawn finer and coarser in turns flickers. */
const LEEWAY = 1.6;
/** How long everything stands still before the picture is drawn at its finest again. */
const REFINE_MS = 250;
const RATIONED_REFINE_MS = 2000;

export class Pace {
  /** Share of the canvas' pixels a side that are drawn: less than 1 only while a slow machine has to keep up. */
  fineness = 1;
  private share = 1;
  /** Of the last picture that another followed: whether it was late, and as coarse as they come. */
  private late = false;
  private coarsest = false;

  /** Whether the processor draws, so that pictures take its time from others. */
  constructor(private readonly byProcessor: boolean) {}

  /** Where the processor draws, this share of the time may go into pictures, above 0 to 1. A graphics card is nobody else's. */
  ration(share: number): void {
    this.share = share;
  }

  /** Whether others need the time that pictures take. */
  get rationed(): boolean {
    return this.byProcessor && this.share < 1;
  }

  /** How long everything has to stand still before the picture is drawn at its finest again. */
  get refineMs(): number {
    return this.rationed ? RATIONED_REFINE_MS : REFINE_MS;
  }

  /** Whether even the coarsest pictures are late: then nothing should move by itself. */
  get overtaxed(): boolean {
    return this.late && this.coarsest;
  }

  /** A picture took so long: after how many ms another may follow. `held`: somebody moves the camera, and is not kept waiting. */
  rest(tookMs: number, held: boolean): number {
    if (tookMs > ASLEEP_MS) return 0;
    if (this.rationed && !held) return tookMs * (1 / this.share - 1);
    return tookMs > VERY_LATE_MS ? Math.min(LONGEST_BREATH_MS, tookMs) : 0;
  }

  /** A picture took so long, and another is to follow: how fine that is. */
  adapt(tookMs: number, held: boolean): void {
    this.late = tookMs >= LATE_MS && tookMs <= ASLEEP_MS;
    this.coarsest = this.fineness === COARSEST;
    let times = this.late ? COARSER : 1;
    if (this.rationed && !held) {
      const off = (this.share * RATIONED_MS) / Math.max(1, tookMs);
      // Most of what a picture costs goes by its pixels.
      times = off < 1 || off > LEEWAY ? Math.sqrt(off) : 1;
    }
    this.fineness = Math.max(COARSEST, Math.min(1, this.fineness * times));
  }
}
