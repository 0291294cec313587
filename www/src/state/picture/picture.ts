/** A file turned into pixels, within bounds: what is too large is refused before it is decoded, or scaled down. */

import { msg, str } from "@lit/localize";
import { Problem } from "../../engine/client";
import type { Picture, Pixels } from "../../engine/protocol";
import { pictureSize } from "./picture-size";

/** The longer side after reading; the fit itself works at 256. */
export const MAX_SIDE_PX = 1024;
/** Larger ones are scaled down by the browser while it decodes them. */
const MAX_WHOLE_PX = 50_000_000;
const MAX_DECODED_PX = 220_000_000;
const MAX_FILE_BYTES = 60_000_000;

/** A picture to look at once more. */
export interface KeptPicture {
  readonly name: string;
  readonly width: number;
  readonly height: number;
  /** RGBA, as a blob: keeping it costs next to nothing. */
  readonly rgba: Blob;
  readonly measured?: boolean;
}

export interface ReadPicture extends Pixels {
  /** What was done to it, in words, or empty. */
  readonly note: string;
  /** It comes from values of 16 bits: as a depth picture it may tell distances. */
  readonly measured?: boolean;
}

/**
 * `depths`: values are no shades, and 0 is nothing measured.
 * @throws Problem with a sentence that names the file.
 */
export async function readPicture(file: Blob, name: string, depths = false): Promise<ReadPicture> {
  if (file.size === 0) throw new Problem(msg(str`${name} is empty. Choose another picture.`));
  if (file.size > MAX_FILE_BYTES) {
    throw new Problem(msg(str`${name} is ${Math.round(file.size / 1e6)} MB large. Choose a picture of at most 60 MB.`));
  }
  const head = new Uint8Array(await file.slice(0, 65_536).arrayBuffer());
  const size = pictureSize(head);
  const pixels = size ? size.width * size.height : 0;
  if (size && pixels > MAX_DECODED_PX) {
    const [width, height] = [size.width, size.height].map((side) => side.toLocaleString("en"));
    throw new Problem(msg(str`${name} is ${width} × ${height} pixels, too many to open here. Make it 4,000 × 4,000 at most.`));
  }
  const { bitmap, measured } = await decoded(file, name, { depths, isFine: !!size && head[1] === 0x50 && head[24] === 16, isHuge: pixels > MAX_WHOLE_PX });
  try {
    const shrink = Math.min(1, MAX_SIDE_PX / Math.max(bitmap.width, bitmap.height));
    const width = Math.max(1, Math.round(bitmap.width * shrink));
    const height = Math.max(1, Math.round(bitmap.height * shrink));
    const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;
    context.imageSmoothingQuality = "high";
    context.drawImage(bitmap, 0, 0, width, height);
    const from = size && pixels > MAX_WHOLE_PX ? size : bitmap;
    const note = shrink < 1 ? msg(str`Scaled down from ${from.width} × ${from.height} pixels.`) : "";
    const { data } = context.getImageData(0, 0, width, height);
    return { width, height, rgba: data as Pixels["rgba"], note, ...(measured && { measured }) };
  } finally {
    bitmap.close();
  }
}

interface Kind {
  readonly depths: boolean;
  /** A PNG of 16 bits: it says so behind its size. */
  readonly isFine: boolean;
  readonly isHuge: boolean;
}

async function decoded(file: Blob, name: string, { depths, isFine, isHuge }: Kind): Promise<{ bitmap: ImageBitmap; measured: boolean }> {
  if (isFine) {
    const fine = await (await import("./png16")).sixteenBit(file, depths);
    if (fine) return { bitmap: await createImageBitmap(new ImageData(fine.rgba, fine.width), { premultiplyAlpha: "none" }), measured: true };
  }
  try {
    const smaller: ImageBitmapOptions = isHuge ? { resizeWidth: 2 * MAX_SIDE_PX, resizeQuality: "high" } : {};
    return { bitmap: await createImageBitmap(file, { premultiplyAlpha: "none", ...smaller }), measured: false };
  } catch {
    return { bitmap: await (await import("./rare")).rarePicture(file, name), measured: false };
  }
}

/** As it is kept: see [`pixelsOf`]. */
export function kept({ rgba, ...rest }: Pixels, name: string): KeptPicture {
  return { name, ...rest, rgba: new Blob([rgba]) };
}

export async function pixelsOf({ rgba, ...rest }: KeptPicture): Promise<Picture> {
  return { ...rest, rgba: new Uint8ClampedArray(await rgba.arrayBuffer()) };
}
