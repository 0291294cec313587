/** A pad's drawing: layers of ink on a square sheet, and what may be done to it. Immutable: every change is a new sheet. */

import { msg } from "@lit/localize";
import type { KeptPicture } from "../../state/picture/picture";
import type { Drawing, FoundInk, Reading } from "./protocol";
import { laid, laidPoints, over, quarters, stroke, thinned, type Lay, type PenLine } from "../../state/picture/ink";

/** Side of a sheet, px; y down. */
export const PAPER_PX = 512;

/** A picture and the ink the core found in it, fitted onto a sheet. */
export interface PictureLayer {
  readonly kind: "picture";
  readonly picture: KeptPicture;
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
export interface StrokeLayer extends PenLine {
  readonly kind: "stroke";
}

export type Layer = PictureLayer | StampLayer | StrokeLayer;

export interface Paper {
  /** Bottom first. */
  readonly layers: readonly Layer[];
  /** What a person would call it: a file's name, a word, "Drawing". */
  readonly label: string;
}

/** Points are kept on this binary grid, so that turning a sheet there and back gives the very same numbers. */
const GRID_PX = 1 / 16;
/** A hand's line keeps only the points without which it would be this far off. */
const SMOOTH_PX = 0.4;
/** Fainter than this everywhere is a blank sheet: noise, not a drawing. */
const FAINT = 16;

const BLANK_PAPER: Paper = { layers: [], label: "" };

export function withStroke(paper: Paper | null, stroke: Omit<StrokeLayer, "kind">): Paper {
  const points = thinned(stroke.points, SMOOTH_PX).map((value) => Math.round(value / GRID_PX) * GRID_PX);
  const { layers, label } = paper ?? BLANK_PAPER;
  return { layers: [...layers, { kind: "stroke", ...stroke, points }], label: label || msg("Drawing") };
}

/**
 * A sheet has one thing that fills it, a picture, a word or an icon. Another takes its place, and what was drawn over the
 * one before goes with it; what was drawn first stays.
 */
export function withStamp(paper: Paper | null, stamp: Omit<StampLayer, "kind">): Paper {
  const { layers } = paper ?? BLANK_PAPER;
  const filling = layers.findIndex(({ kind }) => kind !== "stroke");
  const below = filling < 0 ? layers : layers.slice(0, filling);
  return { layers: [...below, { kind: "stamp", ...stamp }], label: stamp.label };
}

export function mirrored(paper: Paper): Paper {
  return moved(paper, { mirrored: true, quarterTurns: 0 });
}

/** Counter-clockwise. */
export function turned(paper: Paper, quarterTurns: number): Paper {
  return moved(paper, { mirrored: false, quarterTurns: quarters(quarterTurns) });
}

function moved(paper: Paper, lay: Lay): Paper {
  return { ...paper, layers: paper.layers.map((layer) => movedLayer(layer, lay)) };
}

function movedLayer(layer: Layer, lay: Lay): Layer {
  switch (layer.kind) {
    case "picture": {
      // A mirror after a turn is the opposite turn after a mirror.
      const before = lay.mirrored ? -layer.lay.quarterTurns : layer.lay.quarterTurns;
      return { ...layer, lay: { mirrored: layer.lay.mirrored !== lay.mirrored, quarterTurns: quarters(before + lay.quarterTurns) } };
    }
    case "stamp":
      return { ...layer, ink: laid(layer.ink, PAPER_PX, lay) };
    case "stroke":
      return { ...layer, points: laidPoints(layer.points, PAPER_PX, lay) };
  }
}

export function isBlank(paper: Paper | null): boolean {
  if (!paper || paper.layers.length === 0) return true;
  const ink = compose(paper);
  let blank = blanks.get(ink);
  if (blank === undefined) blanks.set(ink, (blank = isFaint(ink)));
  return blank;
}

function isFaint(ink: Uint8Array): boolean {
  for (let i = 0; i < ink.length; i++) if (ink[i]! >= FAINT) return false;
  return true;
}

/** The paper as it goes into a run, by the name of its pad. */
export function drawingOf(paper: Paper, name: string): Drawing {
  return { name, width: PAPER_PX, height: PAPER_PX, ink: compose(paper) };
}

/** Of composed sheets, whether they are blank: asked for again and again. */
const blanks = new WeakMap<Uint8Array, boolean>();
/** The last sheets that were composed, newest first. Few: each is 256 kB, and undo keeps papers by the hundred. */
const composed: { readonly layers: readonly Layer[]; readonly ink: Uint8Array<ArrayBuffer> }[] = [];
const MOST_COMPOSED = 12;

/** All layers as one ink, PAPER_PX square. Not to be written to: what is alike is given out again, and built upon. */
export function compose({ layers }: Paper): Uint8Array<ArrayBuffer> {
  let base: (typeof composed)[number] | undefined;
  for (const known of composed) {
    const isBelow = known.layers.length <= layers.length && known.layers.every((layer, i) => layer === layers[i]);
    if (isBelow && known.layers.length >= (base?.layers.length ?? 0)) base = known;
  }
  if (base?.layers.length === layers.length) return base.ink;
  const ink = base ? base.ink.slice() : new Uint8Array(PAPER_PX * PAPER_PX);
  for (const layer of layers.slice(base?.layers.length ?? 0)) lay(ink, layer);
  composed.unshift({ layers, ink });
  composed.length = Math.min(composed.length, MOST_COMPOSED);
  return ink;
}

function lay(ink: Uint8Array<ArrayBuffer>, layer: Layer): void {
  switch (layer.kind) {
    case "picture":
      return over(ink, laid(layer.found.ink, PAPER_PX, layer.lay));
    case "stamp":
      return over(ink, layer.ink);
    case "stroke":
      return stroke(ink, PAPER_PX, layer);
  }
}
