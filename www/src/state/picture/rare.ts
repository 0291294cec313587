/** Pictures that a browser does not decode by itself: SVG, JPEG without an end marker; and what to say about others. */

import { msg, str } from "@lit/localize";
import { Problem } from "../../engine/client";

/** Files that people take for pictures, by what their first bytes say, and what to do with them. */
const FOREIGN: readonly (readonly [signature: RegExp, words: string])[] = [
  [/^....ftyp(hei|hev|mif1|msf1)/s, msg("is a HEIC photo, which this browser cannot read. Share or export it as a JPEG")],
  [/^....ftypavi/s, msg("is an AVIF picture, which this browser cannot read. Save it as a PNG")],
  [/^(II\*\0|MM\0\*)/, msg("is a TIFF picture, which this browser cannot read. Save it as a PNG")],
  [/^%PDF/, msg("is a PDF, not a picture. Export its page as an SVG or PNG")],
  [/^8BPS/, msg("is a Photoshop file. Save it as a PNG")],
  [/^PK/, msg("is an archive, not a picture. Unpack it, or export the drawing as a PNG")],
];
/** Longer side of an SVG that is drawn, px. */
const DRAWN_PX = 1024;

/** A picture that `createImageBitmap` refused, or a sentence that names what it is. */
export async function rarePicture(file: Blob, name: string): Promise<ImageBitmap> {
  const head = String.fromCharCode(...new Uint8Array(await file.slice(0, 4096).arrayBuffer()));
  const known = FOREIGN.find(([signature]) => signature.test(head));
  if (known) throw new Problem(`${name} ${known[1]}.`);
  if (/^\s*<|^\u00ef\u00bb\u00bf/.test(head) && head.includes("<svg")) {
    const drawn = await drawnSvg(new Blob([file], { type: "image/svg+xml" }));
    if (drawn) return drawn;
    throw new Problem(msg(str`${name} is an SVG that this browser cannot draw. Save it as a PNG.`));
  }
  const photo = head.startsWith("\u00ff\u00d8") && (await unendedJpeg(file));
  if (photo) return photo;
  throw new Problem(msg(str`${name} is not a picture this browser can read. Choose a PNG, JPEG, WebP, GIF, BMP, AVIF or SVG file.`));
}

async function drawnSvg(file: Blob): Promise<ImageBitmap | null> {
  const image = new Image();
  image.src = URL.createObjectURL(file);
  try {
    await image.decode();
    // Without a size of its own it is as large as the browser likes.
    const [across, down] = [image.naturalWidth || DRAWN_PX, image.naturalHeight || DRAWN_PX];
    const scale = DRAWN_PX / Math.max(across, down);
    const [width, height] = [across, down].map((side) => Math.max(1, Math.round(side * scale))) as [number, number];
    const canvas = new OffscreenCanvas(width, height);
    canvas.getContext("2d")!.drawImage(image, 0, 0, width, height);
    return canvas.transferToImageBitmap();
  } catch {
    return null;
  } finally {
    URL.revokeObjectURL(image.src);
  }
}

/** A JPEG that lacks nothing but its end marker: what stands in place of the rest then does not matter. */
async function unendedJpeg(file: Blob): Promise<ImageBitmap | null> {
  const END = new Uint8Array([0xff, 0xd9]);
  try {
    const both = [0x55, 0xaa].map((filler) => createImageBitmap(new Blob([file, new Uint8Array(256).fill(filler), END])));
    const [one, other] = (await Promise.all(both)) as [ImageBitmap, ImageBitmap];
    const [a, b] = [pixels(one), pixels(other)];
    return a.every((value, i) => value === b[i]) ? one : null;
  } catch {
    return null;
  }
}

function pixels(bitmap: ImageBitmap): Uint32Array {
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d", { willReadFrequently: true })!;
  context.drawImage(bitmap, 0, 0);
  return new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
}
