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
  /** Of the picture, as for `find`. */
  readonly key: number;
  readonly picture: Picture;
  /** What of it is the object, of any size; null lets the app find it. */
  readonly mask: Ink | null;
  /** What a person points at; counts where there is no mask. */
  readonly hints: PixelHints;
  /** How near each pixel is, light is near. */
  readonly depth: Picture | null;
}

/** What a person points at, px of the picture. */
export interface PixelHints {
  /** A box round the object. */
  readonly box: PixelBox | null;
  readonly marks: readonly PixelMark[];
}

export type PixelBox = readonly [left: number, top: number, right: number, bottom: number];

/** A stroke on the object or on its ground. */
export interface PixelMark {
  readonly onObject: boolean;
  /** x, y, x, y, … */
  readonly points: Float32Array<ArrayBuffer>;
  /** Half its width. */
  readonly radius: number;
}

declare module "../../engine/protocol" {
  interface Calls {
    /**
     * The object in a picture: what the hints point at, else the `object`-th of several, the largest is 1. Refused with a
     * sentence if there is none. Where nobody points, an open network of the kind mask-v1 says what it is. The worker keeps the last picture, with what it learnt of it: without a picture the answer
     * is null where the one of this `key` is not there.
     */
    find: { arguments: { key: number; picture: Picture | null; object: number; hints: PixelHints }; answer: FoundObject | null };
    /** How near its places are, as the open network of the kind depth-v1 says, and its name; null where none is open. */
    guessDepth: { arguments: { picture: Picture }; answer: Picture | null };
  }
}
