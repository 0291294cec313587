/** A pad's drawing: layers of ink on a square sheet, and what may be done to it. Immutable: every change is a new sheet. */

import type { FoundInk, Picture, Reading } from "../engine/protocol";

/** Side of a sheet, px; y down. */
export const PAPER_PX = 512;

/** Mirrored left to right first, then turned counter-clockwise by quarters. */
export interface Lay {
  readonly mirrored: boolean;
  readonly quarterTurns: number;
}

/** A picture and the ink the core found in it; fitted onto the sheet without stretching. */
export interface PictureLayer {
  readonly kind: "picture";
  readonly picture: Picture;
  readonly reading: Reading;
  readonly found: FoundInk;
  readonly lay: Lay;
}

/** A word, an emoji or an icon, as ink of the sheet's size. */
export interface StampLayer {
  readonly kind: "stamp";
  readonly label: string;
  readonly ink: Uint8Array<ArrayBuffer>;
}

/** A stroke of the pen, or of the eraser over everything below it. */
export interface StrokeLayer {
  readonly kind: "stroke";
  readonly erase: boolean;
  readonly widthPx: number;
  /** x, y, x, y, … in px of the sheet. */
  readonly points: Float32Array<ArrayBuffer>;
}

export type Layer = PictureLayer | StampLayer | StrokeLayer;

export interface Paper {
  /** Bottom first. */
  readonly layers: readonly Layer[];
  /** What a person would call it: a file's name, a word, "Drawing". */
  readonly label: string;
}
