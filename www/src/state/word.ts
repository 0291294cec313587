/** A word, letters of any script or an emoji as a stamp: written with the fonts of this device, as large as the sheet lets it. */

import { PAPER_PX } from "./paper";
import { glyphInk } from "./word-glyph";
import { graphemes, layOut } from "./word-layout";

export const FONTS = {
  round: { label: "Figtree", family: '"Figtree", sans-serif' },
  plain: { label: "Plain", family: "system-ui, sans-serif" },
  serif: { label: "Serif", family: "serif" },
  typewriter: { label: "Typewriter", family: "monospace" },
  handwriting: { label: "Handwriting", family: "cursive" },
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
  const room = PAPER_PX - 2 * MARGIN_PX;
  const scale = Math.min(room / block.width, room / block.height, LARGEST_PX / MEASURED_PX);
  if (!Number.isFinite(scale) || scale <= 0) return { ink: new Uint8Array(PAPER_PX ** 2), unknown: graphemes(text.trim()) };
  context.font = fontOf(MEASURED_PX * scale);
  const x = PAPER_PX / 2 - scale * (block.left + block.width / 2);
  const y = PAPER_PX / 2 - scale * (block.top + block.height / 2);
  const inColour = (colour: string): Uint8ClampedArray => {
    context.clearRect(0, 0, PAPER_PX, PAPER_PX);
    context.fillStyle = colour;
    for (const line of block.lines) context.fillText(line.text, x, y + scale * line.baseline);
    return context.getImageData(0, 0, PAPER_PX, PAPER_PX).data;
  };
  return { ink: glyphInk(inColour("black"), inColour("white"), PAPER_PX), unknown: unknownIn(text, fontOf(32)) };
}

const RIGHT_TO_LEFT = /[\p{Script=Hebrew}\p{Script=Arabic}\p{Script=Syriac}\p{Script=Thaana}\p{Script=Nko}\p{Script=Adlam}]/u;

/** By its first letter, as browsers take `dir="auto"`. */
const isRightToLeft = (text: string): boolean => RIGHT_TO_LEFT.test(/\p{L}/u.exec(text)?.[0] ?? "");

/** Letters that come out as nothing, or as the box that stands for any unknown letter. */
function unknownIn(text: string, font: string): readonly string[] {
  const context = blank(64);
  context.font = font;
  const picture = (letter: string): string => {
    context.clearRect(0, 0, 64, 64);
    context.fillText(letter, 12, 44);
    const { data } = context.getImageData(0, 0, 64, 64);
    return data.every((value) => value === 0) ? "" : data.join();
  };
  const boxes = new Set(["", ...UNASSIGNED.map(picture)]);
  return [...new Set(graphemes(text.replace(/\s/gu, "")))].filter((letter) => boxes.has(picture(letter)));
}

function blank(side: number): OffscreenCanvasRenderingContext2D {
  return new OffscreenCanvas(side, side).getContext("2d", { willReadFrequently: true })!;
}
