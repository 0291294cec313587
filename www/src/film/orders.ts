/** What is asked of whoever makes pictures and films, and what it answers. */

import type { Ground, Size, Subject } from "#sculpture/film/darkroom";
import { FOUND, TURNTABLE } from "#sculpture/film/film";
import type { Pose, Vantage } from "#sculpture/scene/orbit";
import type { Choice } from "./formats";

export const FILMS = { turntable: TURNTABLE, found: FOUND } as const;
export type FilmName = keyof typeof FILMS;

/** How long a film takes to watch. */
export const secondsOf = (film: FilmName): number => FILMS[film].seconds;

export interface StillOrder {
  readonly make: "still";
  readonly from: Vantage | Pose;
  readonly size: Size;
  readonly ground: Ground;
}

export interface FilmOrder {
  readonly make: "film";
  readonly film: FilmName;
  /** As `sizeFor` says for the format. */
  readonly size: Size;
  readonly choice: Choice;
  /** As many frames as its seconds have, unless told. */
  readonly frames?: number;
}

/** A small picture to look at, of a still or of a place in a film, 0 to 1. */
export interface Preview {
  readonly make: "preview";
  readonly of: Omit<StillOrder, "make"> | { readonly film: FilmName; readonly share: number; readonly size: Size };
}

export type Order = ({ readonly id: number } & (StillOrder | FilmOrder | Preview)) | { readonly subject: Subject };

/** How a film comes along. */
export interface Progress {
  readonly done: number;
  readonly frames: number;
  /** Milliseconds; of all so far, those for drawing, and those for encoding beyond that. */
  readonly msLeft: number;
  readonly drawMs: number;
  readonly encodeMs: number;
}

export type Told =
  | { readonly id: number; readonly progress: Progress }
  | { readonly id: number; readonly blob: Blob }
  | { readonly id: number; readonly bitmap: ImageBitmap }
  /** Why it cannot be made. */
  | { readonly id: number; readonly problem: string };
