/** A word, letters of any script or an emoji as a stamp: written with the fonts of this device, as large as the sheet lets it. */

import { msg } from "@lit/localize";
import { PAPER_PX } from "../../paper";
import { glyphInk } from "./word-glyph";
import { graphemes, layOut } from "./word-layout";

export const FONTS = {
  round: { label: "Figtree", family: '"Figtree", sans-serif' },
  plain: { label: msg("Plain"), family: "system-ui, sans-serif" },
  serif: { label: msg("Serif"), family: "serif" },
  typewriter: { label: msg("Typewriter"), family: "monospace" },
  handwriting: { label: msg("Handwriting"), family: "cursive" },
} as const;
export type Font = keyof typeof FONTS;

export interface Lettering {
  readonly font: Font;
  readonly bold: boolean;
}

export interface Written {
  /** PAPER_PX square. */
  readonly ink: Uint8Array<ArrayBuffer>;
  /** Letters and signs that no font of this device has. */
  readonly unknown: readonly string[];
}

/** Longer texts are no drawing. */
export const MOST_LETTERS = 80;
const MARGIN_PX = 0.04 * PAPER_PX;
const MEASURED_PX = 100;
/** A dash or a dot alone does not fill the sheet. */
const LARGEST_PX = 640;
/** No font has a glyph for these: what is drawn in their stead is what is drawn for any unknown letter. */
const UNASSIGNED = ["\u{10FFFE}", "\u{0378}"];

export async function write(text: string, { font, bold }: Lettering): Promise<Written> {
  const { family } = FONTS[font];
  const fontOf = (px: number): string => `${bold ? 700 : 400} ${px}px ${family}`;
  await document.fonts.load(fontOf(MEASURED_PX), text).catch(() => []);
  const context = blank(PAPER_PX);
  context.textAlign = "center";
  context.direction = isRightToLeft(text) ? "rtl" : "ltr";
  context.font = fontOf(MEASURED_PX);
  const block = layOut(text, (line) => {
    const measured = context.measureText(line);
    return {
      left: measured.actualBoundingBoxLeft,
      right: measured.actualBoundingBoxRight,
      ascent: measured.actualBoundingBoxAscent,
      descent: measured.actualBoundingBoxDescent,
    };
  });
  let place = placed({ left: block.left, top: block.top, right: block.left + block.width, bottom: block.top + block.height });
  const inColour = (colour: string): Uint8ClampedArray => {
    context.clearRect(0, 0, PAPER_PX, PAPER_PX);
    context.font = fontOf(MEASURED_PX * place.scale);
    context.fillStyle = colour;
    for (const line of block.lines) context.fillText(line.text, place.x, place.y + place.scale * line.baseline);
    return context.getImageData(0, 0, PAPER_PX, PAPER_PX).data;
  };
  let black = inColour("black");
  const bounds = inkBounds(black);
  if (!bounds) return { ink: new Uint8Array(PAPER_PX ** 2), unknown: graphemes(text.trim()) };
  const unknown = unknownIn(text, fontOf(32));
  if (!isColoured(black)) return { ink: glyphInk(black, null, PAPER_PX), unknown };
  // Emoji say that they are larger than what is to be seen of them.
  const { scale, x, y } = place;
  place = placed({
    left: (bounds.left - x) / scale,
    right: (bounds.right - x) / scale,
    top: (bounds.top - y) / scale,
    bottom: (bounds.bottom - y) / scale,
  });
  black = inColour("black");
  return { ink: glyphInk(black, inColour("white"), PAPER_PX), unknown };
}

/** Whether what was written in black brings colours of its own. */
function isColoured(rgba: Uint8ClampedArray): boolean {
  for (let i = 0; i < rgba.length; i += 4) {
    if (rgba[i + 3]! > 32 && Math.max(rgba[i]!, rgba[i + 1]!, rgba[i + 2]!) > 32) return true;
  }
  return false;
}

interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Where to write what fills that box at MEASURED_PX, and how many times as large, to fill the sheet. */
function placed({ left, top, right, bottom }: Box): { readonly scale: number; readonly x: number; readonly y: number } {
  const fits = (PAPER_PX - 2 * MARGIN_PX) / Math.max(right - left, bottom - top);
  const scale = fits > 0 ? Math.min(fits, LARGEST_PX / MEASURED_PX) : 1;
  return { scale, x: PAPER_PX / 2 - (scale * (left + right)) / 2, y: PAPER_PX / 2 - (scale * (top + bottom)) / 2 };
}

function inkBounds(rgba: Uint8ClampedArray): Box | null {
  let [left, top, right, bottom] = [PAPER_PX, PAPER_PX, 0, 0];
  for (let y = 0; y < PAPER_PX; y++) {
    for (let x = 0; x < PAPER_PX; x++) {
      if (rgba[4 * (y * PAPER_PX + x) + 3]! < 16) continue;
      [left, right] = [Math.min(left, x), Math.max(right, x + 1)];
      [top, bottom] = [Math.min(top, y), Math.max(bottom, y + 1)];
    }
  }
  return right > left ? { left, top, right, bottom } : null;
}

const RIGHT_TO_LEFT = /[\p{Script=Hebrew}\p{Script=Arabic}\p{Script=Syriac}\p{Script=Thaana}\p{Script=Nko}\p{Script=Adlam}]/u;

/** By its first letter, as browsers take `dir="auto"`. */
const isRightToLeft = (text: string): boolean => RIGHT_TO_LEFT.test(/\p{L}/u.exec(text)?.[0] ?? "");

/** Letters that come out as nothing, or as the box that stands for any unknown letter. */
function unknownIn(text: string, font: string): readonly string[] {
  const context = blank(64);
  context.font = font;
  const picture = (letter: string): number => {
    context.clearRect(0, 0, 64, 64);
    context.fillText(letter, 12, 44);
    return fingerprint(context.getImageData(0, 0, 64, 64).data);
  };
  const boxes = new Set([EMPTY, ...UNASSIGNED.map(picture)]);
  return [...new Set(graphemes(text.replace(/\s/gu, "")))].filter((letter) => boxes.has(picture(letter)));
}

const EMPTY = 0;

/** A number for a picture, by the places and strengths of its ink (FNV-1a's way). */
function fingerprint(rgba: Uint8ClampedArray): number {
  let hash = 0x811c9dc5;
  let any = false;
  for (let i = 3; i < rgba.length; i += 4) {
    any ||= rgba[i]! > 0;
    hash = Math.imul(hash ^ rgba[i]!, 0x01000193);
  }
  return any ? hash : EMPTY;
}

function blank(side: number): OffscreenCanvasRenderingContext2D {
  return new OffscreenCanvas(side, side).getContext("2d", { willReadFrequently: true })!;
}
