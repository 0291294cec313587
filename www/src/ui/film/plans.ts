/** What people can choose of a picture or a film, and what its file is called. */

import type { Size } from "#sculpture/film/darkroom";
import type { FilmName } from "../../film/orders";

export type Kind = "picture" | FilmName;

export interface Kinds {
  readonly words: string;
  /** At the end of its file's name. */
  readonly ending: string;
  /** What the button says that makes it. */
  readonly button: string;
}

export const KINDS: Readonly<Record<Kind, Kinds>> = {
  picture: { words: "Picture", ending: "", button: "Save the picture" },
  turntable: { words: "Once round", ending: "-turning", button: "Make the film" },
  found: { words: "How it was found", ending: "-found", button: "Make the film" },
};

export type Shape = "square" | "story" | "wide" | "custom";

/** Sizes that posts have, pixels. */
export const SHAPES: Readonly<Record<Exclude<Shape, "custom">, Size & { readonly words: string }>> = {
  square: { words: "Square", width: 1080, height: 1080 },
  story: { words: "Story", width: 1080, height: 1920 },
  wide: { words: "Wide", width: 1920, height: 1080 },
};

export const LEAST_PX = 64;
export const MOST_PX = 4096;

/** A side as somebody typed it: whole, and one that can be drawn; what is no number is the old one. */
export function side(typed: number, before: number): number {
  return Number.isFinite(typed) ? Math.max(LEAST_PX, Math.min(MOST_PX, Math.round(typed))) : before;
}

/** "2.1 MB" */
export function sizeWords(bytes: number): string {
  return bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}
