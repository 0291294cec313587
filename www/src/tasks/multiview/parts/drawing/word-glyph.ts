/** Ink out of written glyphs: letters as they are; what brings its own colours, such as emoji, as a line drawing. */

import { stroke, type PenLine } from "../../../../state/picture/ink";

type Rgba = Uint8ClampedArray;

/** Takes JPEG-like noise and soft gradients out, and joins the two sides of a thin outline into one line. */
const MEAN_REACH = 2;
const BLUR_PX = Math.sqrt((2 * MEAN_REACH + 1) ** 2 / 4 - 1 / 4);
/** Colour steps of at least the first start a line, of at least the second carry it on; 0 to 255. */
const STEP = 52;
const FAINT_STEP = 22;
/** Lines with fewer pixels are specks. */
const SPECK_PX = 24;
const LINE_PX = 13;
/** Darker than this is filled: eyes, hearts, wheels. */
const DARK = 70;

/**
 * The same text written in black and in white, on nothing. Where both show the same colour, the colour is the glyph's own.
 * Without a white one, all is ink that is there.
 */
export function glyphInk(black: Rgba, white: Rgba | null, side: number): Uint8Array<ArrayBuffer> {
  const ink = new Uint8Array(side * side);
  const coloured = new Uint8Array(side * side);
  let any = false;
  for (let i = 0; i < ink.length; i++) {
    const own = white !== null && black[4 * i + 3]! > 32 && Math.abs(black[4 * i]! - white[4 * i]!) < 64;
    if (own) coloured[i] = 1;
    else ink[i] = black[4 * i + 3]!;
    any ||= own;
  }
  if (any) drawOutlines(ink, black, coloured, side);
  return ink;
}

function drawOutlines(ink: Uint8Array<ArrayBuffer>, rgba: Rgba, coloured: Uint8Array, side: number): void {
  const channels = [0, 1, 2, 3].map((channel) => {
    const plane = new Float32Array(side * side);
    for (let i = 0; i < plane.length; i++) {
      if (coloured[i]) plane[i] = channel === 3 ? rgba[4 * i + 3]! : onWhite(rgba[4 * i + channel]!, rgba[4 * i + 3]!);
      else plane[i] = channel === 3 ? 0 : 255;
    }
    return plane;
  });
  for (let i = 0; i < ink.length; i++) {
    if (!coloured[i]) continue;
    const light = 0.299 * channels[0]![i]! + 0.587 * channels[1]![i]! + 0.114 * channels[2]![i]!;
    ink[i] = Math.max(ink[i]!, Math.min(255, Math.max(0, (DARK - light) * 8)));
  }
  const dot: PenLine = { points: new Float32Array(2), widthPx: LINE_PX, erase: false };
  for (const i of outlines(channels.map((plane) => blurred(plane, side)), side)) {
    dot.points[0] = (i % side) + 0.5;
    dot.points[1] = Math.floor(i / side) + 0.5;
    stroke(ink, side, dot);
  }
}

const onWhite = (value: number, alpha: number): number => 255 - ((255 - value) * alpha) / 255;

/** Pixels on the crest of a colour step (Canny's edges, over all channels at once as Di Zenzo has it). */
function outlines(channels: readonly Float32Array[], side: number): readonly number[] {
  const steps = new Float32Array(side * side);
  const along = new Uint8Array(side * side);
  // The steepest slope of a step of one after the blur.
  const perStep = BLUR_PX * Math.sqrt(2 * Math.PI);
  for (let y = 1; y < side - 1; y++) {
    for (let x = 1; x < side - 1; x++) {
      const i = y * side + x;
      let [xx, xy, yy] = [0, 0, 0];
      for (const plane of channels) {
        const dx = (plane[i + 1]! - plane[i - 1]!) / 2;
        const dy = (plane[i + side]! - plane[i - side]!) / 2;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
      }
      const largest = (xx + yy) / 2 + Math.sqrt(((xx - yy) / 2) ** 2 + xy * xy);
      steps[i] = perStep * Math.sqrt(largest);
      const angle = 0.5 * Math.atan2(2 * xy, xx - yy);
      along[i] = (Math.round(angle / (Math.PI / 4)) + 4) % 4;
    }
  }
  const toNext = [1, side + 1, side, 1 - side];
  const crest = (i: number): boolean => {
    const next = toNext[along[i]!]!;
    return steps[i]! >= FAINT_STEP && steps[i]! > steps[i - next]! && steps[i]! >= steps[i + next]!;
  };
  return connected(steps, crest, side);
}

/** Crests that hang together with a strong one and are more than specks. */
function connected(steps: Float32Array, crest: (i: number) => boolean, side: number): readonly number[] {
  const seen = new Uint8Array(steps.length);
  const kept: number[] = [];
  const around = [-side - 1, -side, -side + 1, -1, 1, side - 1, side, side + 1];
  for (let start = side + 1; start < steps.length - side - 1; start++) {
    if (seen[start] || steps[start]! < STEP || !crest(start)) continue;
    const line = [start];
    seen[start] = 1;
    for (const i of line) {
      for (const step of around) {
        const next = i + step;
        if (seen[next] || next <= side || next >= steps.length - side - 1 || !crest(next)) continue;
        seen[next] = 1;
        line.push(next);
      }
    }
    if (line.length >= SPECK_PX) for (const i of line) kept.push(i);
  }
  return kept;
}

/** Three running means along each axis: close to a bell curve, at a cost that does not grow with its width. */
function blurred(plane: Float32Array, side: number): Float32Array {
  let from: Float32Array = plane;
  let to: Float32Array = new Float32Array(plane.length);
  for (const [step, line] of [[1, side], [1, side], [1, side], [side, 1], [side, 1], [side, 1]] as const) {
    for (let l = 0; l < side; l++) mean(from, to, l * line, step, side);
    [from, to] = [to, from === plane ? new Float32Array(plane.length) : from];
  }
  return from;
}

/** The mean over MEAN_REACH neighbours on either side, along one line; the line's ends go on for ever. */
function mean(from: Float32Array, to: Float32Array, start: number, step: number, count: number): void {
  const at = (p: number): number => from[start + Math.min(count - 1, Math.max(0, p)) * step]!;
  let sum = 0;
  for (let p = -MEAN_REACH; p <= MEAN_REACH; p++) sum += at(p);
  for (let p = 0; p < count; p++) {
    to[start + p * step] = sum / (2 * MEAN_REACH + 1);
    sum += at(p + MEAN_REACH + 1) - at(p - MEAN_REACH);
  }
}
