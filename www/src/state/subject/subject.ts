/** The one picture of a stroke: what the app found in it, and what a person painted over that. Immutable. */

import type { FoundObject, Ink } from "../../engine/protocol";

/** A picture as it is kept: RGBA as a blob costs next to nothing. */
export interface SubjectPicture {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  readonly rgba: Blob;
}

export interface Subject {
  readonly picture: SubjectPicture;
  /** Which of several found objects, the largest first, from 1. */
  readonly object: number;
  /** The person's brush strokes over what was found. */
  readonly strokes: readonly MaskStroke[];
  /** What the app found, for showing. */
  readonly found: FoundObject | null;
  readonly depth: SubjectPicture | null;
}

export interface MaskStroke {
  readonly adds: boolean;
  readonly width: number;
  readonly points: readonly number[];
}

/** The found mask with the strokes over it; null lets the app find it. */
export function maskOf({ found }: Subject): Ink | null {
  return found && { width: found.width, height: found.height, ink: found.mask };
}
