/** What people can choose of a picture or a film, and what its file is called. */

import { msg, str } from "@lit/localize";
import type { Size } from "#sculpture/film/darkroom";
import { decimal } from "../../words/numbers";
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
  picture: { words: msg("Picture"), ending: "", button: msg("Save the picture") },
  turntable: { words: msg("Once round"), ending: "-turning", button: msg("Make the film") },
  found: { words: msg("How it was found"), ending: "-found", button: msg("Make the film") },
};

export type Shape = "square" | "story" | "wide" | "custom";

/** Sizes that posts have, pixels. */
export const SHAPES: Readonly<Record<Exclude<Shape, "custom">, Size & { readonly words: string }>> = {
  square: { words: msg("Square"), width: 1080, height: 1080 },
  story: { words: msg("Story"), width: 1080, height: 1920 },
  wide: { words: msg("Wide"), width: 1920, height: 1080 },
};

export const LEAST_PX = 64;
export const MOST_PX = 4096;

/** A side as somebody typed it: whole, and one that can be drawn; what is no number is the old one. */
export function side(typed: number, before: number): number {
  return Number.isFinite(typed) ? Math.max(LEAST_PX, Math.min(MOST_PX, Math.round(typed))) : before;
}

/** "2.1 MB" */
export function sizeWords(bytes: number): string {
  return bytes < 1e6 ? msg(str`${Math.max(1, Math.round(bytes / 1e3))} kB`) : msg(str`${decimal(bytes / 1e6, 1)} MB`);
}
