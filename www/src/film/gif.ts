/** Frames into a GIF, all with the same colours: with others in each, walls would flicker. */

import { applyPalette, GIFEncoder, quantize, type Palette } from "gifenc";
import type { Size } from "#sculpture/film/darkroom";
import { GIF_FPS } from "./formats";
import type { Sink } from "./sink";

const COLOURS = 256;
/** Of the frames that are looked at for their colours, one pixel in so many. */
const LOOKED_AT = 5;
/** Levels between two shades that the encoder tells apart; walls are so soft that steps of them would show. */
const STEP = 8;
/** Bayer's order of four by four, -1/2 to 1/2: shades between two steps become a fine weave of both. */
const WEAVE = [0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5].map((place) => ((place + 0.5) / 16 - 0.5) * STEP);

export function openGif({ width, height }: Size): Sink {
  const gif = GIFEncoder();
  const flat = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;
  const seen: number[] = [];
  let palette: Palette | null = null;

  const pixels = (frame: OffscreenCanvas): Uint8ClampedArray => {
    flat.drawImage(frame, 0, 0);
    return flat.getImageData(0, 0, width, height).data;
  };
  const woven = (data: Uint8ClampedArray): Uint8ClampedArray => {
    for (let at = 0, pixel = 0; at < data.length; at += 4, pixel++) {
      const shift = WEAVE[4 * (Math.floor(pixel / width) & 3) + (pixel % width & 3)]!;
      for (let c = 0; c < 3; c++) data[at + c]! += shift;
    }
    return data;
  };
  const learn = (data: Uint8ClampedArray): void => {
    for (let at = 0; at + 3 < data.length; at += 4 * LOOKED_AT) seen.push(data[at]!, data[at + 1]!, data[at + 2]!, 255);
  };

  return {
    learn: (frame) => learn(woven(pixels(frame))),
    async add(frame) {
      const data = woven(pixels(frame));
      if (seen.length === 0) learn(data);
      const first = palette === null;
      palette ??= quantize(new Uint8Array(seen), COLOURS);
      const how = { delay: 1000 / GIF_FPS, repeat: 0 };
      gif.writeFrame(applyPalette(data, palette), width, height, first ? { ...how, palette } : how);
    },
    async finish() {
      gif.finish();
      return new Blob([gif.bytes()], { type: "image/gif" });
    },
    close: () => undefined,
  };
}
