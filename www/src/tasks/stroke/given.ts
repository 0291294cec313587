/** The one picture that a stroke is made from, and what a person said of the object in it. Immutable, without elements. */

import type { Ink } from "../../engine/protocol";
import { stroke, thinned } from "../../state/picture/ink";
import type { KeptPicture } from "../../state/picture/picture";
import type { FoundObject, PixelHints } from "./protocol";

/** What a person gives for one picture: the picture, and what they said of its mask. */
export interface Subject {
  readonly picture: KeptPicture;
  /** Which of several found objects, the largest first, from 1. */
  readonly object: number;
  /** The person's strokes over what the app found, in order; they are kept when the app finds another object. */
  readonly strokes: readonly MaskStroke[];
  /** A box round the object, where the person dragged one. */
  readonly box?: Box | null;
  /** Strokes by which the app finds it: on the object (they add), and on what is not. */
  readonly marks?: readonly MaskStroke[];
  /** What the app found, for showing: null while it is sought or when nothing was found. */
  readonly found: FoundObject | null;
  /** How near each pixel is, light is near: a picture of the same size. */
  readonly depth: KeptPicture | null;
}

/** In shares of the picture's width and height, y down. */
export type Box = readonly [left: number, top: number, right: number, bottom: number];

/** How a stroke corrects a mask. */
export interface Brush {
  /** Adds to the object, or takes away from it. */
  readonly adds: boolean;
  /** Share of the picture's longer side. */
  readonly width: number;
}

export interface MaskStroke extends Brush {
  /** x, y, x, y, … in shares of the picture's width and height, y down; may lie outside. A single point is a dot. */
  readonly points: readonly number[];
}

interface Size {
  readonly width: number;
  readonly height: number;
}

/** Whether a person said where the object is, so that it is not guessed. */
export function isPointedAt({ box, marks }: Pick<Subject, "box" | "marks">): boolean {
  return !!box || !!marks?.length;
}

/** The box and the marks in the picture's pixels. */
export function hintsOf({ picture: { width, height }, box, marks = [] }: Subject): PixelHints {
  return {
    box: box ? [box[0] * width, box[1] * height, box[2] * width, box[3] * height] : null,
    marks: marks.map(({ adds, points, width: share }) => ({
      onObject: adds,
      points: Float32Array.from(points, (value, i) => value * (i % 2 ? height : width)),
      radius: 0.5 * share * Math.max(width, height),
    })),
  };
}

/** Longest side of a mask, px. */
export const MASK_PX = 512;
/** A hand's line keeps only the points without which it would be this far off, px of the mask. */
const SMOOTH_PX = 0.4;
/** Points are kept to this many parts of a side, a twentieth of a pixel of the mask. */
const PARTS = 1e4;

/** The size of a subject's mask: that of what was found, else the picture's, shrunk to `MASK_PX`. */
export function maskSize({ found, picture }: Subject): Size {
  if (found) return { width: found.width, height: found.height };
  const shrink = Math.min(1, MASK_PX / Math.max(picture.width, picture.height));
  const side = (length: number): number => Math.max(1, Math.round(length * shrink));
  return { width: side(picture.width), height: side(picture.height) };
}

/** A hand's line, in px of a mask, as a stroke that fits the picture at any size. */
export function maskStroke(points: readonly number[], { width, height }: Size, brush: Brush): MaskStroke {
  const kept = thinned(Float32Array.from(points), SMOOTH_PX);
  return { ...brush, points: Array.from(kept, (value, i) => Math.round((PARTS * value) / (i % 2 ? height : width)) / PARTS) };
}

/** The last mask: asked for again and again, and the next one is mostly one stroke more. */
let last: { readonly found: FoundObject | null; readonly strokes: readonly MaskStroke[]; readonly mask: Ink } | null = null;

/**
 * The found mask with the strokes painted over it, 0 to 255, of `maskSize`; null if there is neither a found mask nor a
 * stroke. Not to be written to: what is alike is given out again, and built upon.
 */
export function maskOf(subject: Subject): Ink | null {
  const { found, strokes } = subject;
  if (!found && strokes.length === 0) return null;
  const size = maskSize(subject);
  const isBelow =
    last?.found === found &&
    last.mask.width === size.width &&
    last.mask.height === size.height &&
    last.strokes.length <= strokes.length &&
    last.strokes.every((known, i) => known === strokes[i]);
  const [below, painted] = isBelow ? [last!.mask.ink, last!.strokes.length] : [found?.mask, 0];
  if (isBelow && painted === strokes.length) return last!.mask;
  const ink = below?.slice() ?? new Uint8Array(size.width * size.height);
  const mask = { ...size, ink };
  for (const added of strokes.slice(painted)) paint(mask, added);
  last = { found, strokes, mask };
  return mask;
}

/** Paints a stroke onto a mask, in place. */
export function paint({ width, height, ink }: Ink, { adds, width: share, points }: MaskStroke): void {
  const px = Float32Array.from(points, (value, i) => value * (i % 2 ? height : width));
  stroke(ink, width, { points: px, widthPx: share * Math.max(width, height), erase: !adds });
}

/**
 * The found object at a place (shares of width and height), or the nearest within `reach` (a share of the longer side):
 * fingers are thick, and things may be thin. 0 if there is none.
 */
export function objectAt({ width, height, labels }: FoundObject, x: number, y: number, reach = 0): number {
  const [px, py, reachPx] = [x * width, y * height, reach * Math.max(width, height)];
  const [column, row] = [Math.floor(px), Math.floor(py)];
  if (column >= 0 && row >= 0 && column < width && row < height && labels[row * width + column]) return labels[row * width + column]!;
  let [nearest, least2] = [0, reachPx * reachPx];
  for (let v = Math.max(0, Math.floor(py - reachPx)); v < Math.min(height, py + reachPx); v++) {
    for (let u = Math.max(0, Math.floor(px - reachPx)); u < Math.min(width, px + reachPx); u++) {
      const distance2 = (u + 0.5 - px) ** 2 + (v + 0.5 - py) ** 2;
      if (labels[v * width + u] && distance2 <= least2) [nearest, least2] = [labels[v * width + u]!, distance2];
    }
  }
  return nearest;
}

/**
 * A place on each found object, x and y in shares of width and height: its pixel nearest to its middle, since the middle
 * of a ring is not on it.
 */
export function placesOf({ width, height, labels, count }: FoundObject): readonly (readonly [number, number])[] {
  const sums = Array.from({ length: count + 1 }, () => ({ x: 0, y: 0, pixels: 0, nearest: 0, least2: Infinity }));
  const each = (visit: (sum: (typeof sums)[number], x: number, y: number, i: number) => void): void => {
    for (let i = 0; i < labels.length; i++) {
      const sum = labels[i] ? sums[labels[i]!] : undefined;
      if (sum) visit(sum, (i % width) + 0.5, Math.floor(i / width) + 0.5, i);
    }
  };
  each((sum, x, y) => {
    sum.x += x;
    sum.y += y;
    sum.pixels += 1;
  });
  each((sum, x, y, i) => {
    const distance2 = (x - sum.x / sum.pixels) ** 2 + (y - sum.y / sum.pixels) ** 2;
    if (distance2 < sum.least2) [sum.nearest, sum.least2] = [i, distance2];
  });
  return sums.slice(1).map(({ nearest }) => [((nearest % width) + 0.5) / width, (Math.floor(nearest / width) + 0.5) / height] as const);
}
