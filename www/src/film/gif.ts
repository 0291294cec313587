/** Frames into a GIF, all with the same colours: with others in each, walls would flicker. */

import { applyPalette, GIFEncoder, quantize, type Palette } from "gifenc";
import type { Size } from "#sculpture/darkroom";
import { GIF_FPS } from "./formats";
import type { Sink } from "./sink";

const COLOURS = 256;
/** Of the frames that are looked at for their colours, one pixel in so many. */
const LOOKED_AT = 5;

export function openGif({ width, height }: Size): Sink {
  const gif = GIFEncoder();
  const flat = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;
  const seen: number[] = [];
  let palette: Palette | null = null;

  const pixels = (frame: OffscreenCanvas): Uint8ClampedArray => {
    flat.drawImage(frame, 0, 0);
    return flat.getImageData(0, 0, width, height).data;
  };
  const learn = (data: Uint8ClampedArray): void => {
    for (let at = 0; at + 3 < data.length; at += 4 * LOOKED_AT) seen.push(data[at]!, data[at + 1]!, data[at + 2]!, 255);
  };

  return {
    learn: (frame) => learn(pixels(frame)),
    async add(frame) {
      const data = pixels(frame);
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
