/** How fine pictures are drawn and how soon the next one follows: as a slow machine can, and within a share of its time. */

/** Pictures that take longer than this to finish are drawn coarser, down to this share of the pixels a side. */
const LATE_MS = 40;
const COARSER = 0.8;
export const COARSEST = 0.4;
/** Longer than this, and they are also drawn less often, to leave the machine to others; longer still, and the page slept. */
const VERY_LATE_MS = 80;
const LONGEST_BREATH_MS = 150;
const ASLEEP_MS = 3000;
/** How long everything stands still before the picture is drawn at its finest again. */
const REFINE_MS = 250;

/** Within a share of the time, pictures are made so coarse that they may follow each other like this, if that is possible. */
const RATIONED_MS = 200;
/** They follow each other at least like this, or people would think that nothing goes on. */
const LONGEST_REST_MS = 2000;
const RATIONED_REFINE_MS = 2000;
/** But not coarser than this many pixels on their longer side, which gains nothing; a little less than their finest all the same. */
const FEWEST_PX = 340;
const LEAST_COARSE = 0.9;
/** How far they may be from what the share allows: what is drawn finer and coarser in turns flickers. */
const LEEWAY = 1.6;
/** Others on the machine only ever make pictures later: the quickest of the last so many says what one costs. */
const TIMED = 6;

export class Pace {
  /** Share of the canvas' pixels a side that are drawn: less than 1 only while a slow machine has to keep up. */
  fineness = 1;
  private share = 1;
  /** Within a share of the time, and the fineness that this allows. */
  private coarsest = COARSEST;
  private allowed = COARSEST;
  /** What the last pictures took, ms, as if they had been drawn at their finest: most of it goes by the pixels. */
  private readonly times: number[] = [];
  private tooMuch = false;

  /** Whether the processor draws, so that pictures take its time from others. */
  constructor(private readonly byProcessor: boolean) {}

  /** The longer side of the canvas, pixels. */
  resize(longerPx: number): void {
    this.coarsest = Math.max(COARSEST, Math.min(LEAST_COARSE, FEWEST_PX / longerPx));
    this.allowed = Math.max(this.coarsest, this.allowed);
  }

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
    return this.tooMuch;
  }

  /** A picture is about to be drawn: at its finest where everything stands `still`. `held`: somebody moves the camera, and is not kept waiting. */
  begin(still: boolean, held: boolean): void {
    if (still) this.fineness = 1;
    else if (this.rationed && !held) this.fineness = this.affordable();
  }

  /** A picture took so long, and another one is to follow or not: after how many ms that may be. */
  end(tookMs: number, followed: boolean, held: boolean): number {
    if (tookMs > ASLEEP_MS) return 0;
    this.times.push(tookMs / this.fineness ** 2);
    if (this.times.length > TIMED) this.times.shift();
    if (this.rationed && !held) return Math.min(LONGEST_REST_MS, this.finestMs * this.fineness ** 2 * (1 / this.share - 1));
    // A picture that nothing follows may take its time.
    if (!followed) return 0;
    const late = tookMs >= LATE_MS;
    this.tooMuch = late && this.fineness === COARSEST;
    if (late) this.fineness = Math.max(COARSEST, this.fineness * COARSER);
    return tookMs > VERY_LATE_MS ? Math.min(LONGEST_BREATH_MS, tookMs) : 0;
  }

  /** What the finest picture costs. */
  private get finestMs(): number {
    return Math.max(1, Math.min(...this.times));
  }

  private affordable(): number {
    if (this.times.length === 0) return this.allowed;
    const times = (this.share * RATIONED_MS) / (this.finestMs * this.allowed ** 2);
    if (times < 1 || times > LEEWAY) this.allowed = Math.max(this.coarsest, Math.min(1, this.allowed * Math.sqrt(times)));
    return this.allowed;
  }
}
