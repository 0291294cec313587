/** What the page's end of this task and its engine tell each other. */

import type { Ink, Picture } from "../../engine/protocol";

/** What of one picture is the object. */
export interface FoundObject {
  readonly width: number;
  readonly height: number;
  /** How much of each pixel is the object, 0 to 255; of the picture's own aspect, at most 512 px a side. */
  readonly mask: Uint8Array<ArrayBuffer>;
  /** Which object each pixel is, the largest first, from 1; 0 where there is nothing. */
  readonly labels: Uint8Array<ArrayBuffer>;
  readonly count: number;
  /** Whether it is likely what a person would point at; not with what was kept before that was known. */
  readonly isSure?: boolean;
  /** What makes the finding doubtful, in sentences. */
  readonly notes: readonly string[];
}

/** The picture as it goes into a run. */
export interface StrokeWork {
  readonly picture: Picture;
  /** What of it is the object, of any size; null lets the app find it. */
  readonly mask: Ink | null;
  /** A box round the object, px; counts where there is no mask. */
  readonly box: PixelBox | null;
  /** How near each pixel is, light is near. */
  readonly depth: Picture | null;
}

export type PixelBox = readonly [left: number, top: number, right: number, bottom: number];

declare module "../../engine/protocol" {
  interface Calls {
    /** The object in a picture: what the box is round, else the `object`-th of several, the largest is 1. Refused with a sentence if there is none. */
    find: { arguments: { picture: Picture; object: number; box: PixelBox | null }; answer: FoundObject };
  }
}
