/** A file turned into pixels, within bounds: what is too large is refused before it is decoded, or scaled down. */

import { Problem } from "../../engine/client";
import type { Picture, Pixels } from "../../engine/protocol";
import type { KeptPicture } from "./paper";
import { pictureSize } from "./picture-size";

/** The longer side after reading; the fit itself works at 256. */
export const MAX_SIDE_PX = 1024;
const MAX_DECODED_PX = 50_000_000;
const MAX_FILE_BYTES = 60_000_000;

export interface ReadPicture extends Pixels {
  /** What was done to it, in words, or empty. */
  readonly note: string;
}

/** @throws Problem with a sentence that names the file. */
export async function readPicture(file: Blob, name: string): Promise<ReadPicture> {
  if (file.size === 0) throw new Problem(`${name} is empty. Choose another picture.`);
  if (file.size > MAX_FILE_BYTES) {
    throw new Problem(`${name} is ${Math.round(file.size / 1e6)} MB large. Choose a picture of at most 60 MB.`);
  }
  const size = pictureSize(new Uint8Array(await file.slice(0, 65_536).arrayBuffer()));
  if (size && size.width * size.height > MAX_DECODED_PX) {
    const [width, height] = [size.width, size.height].map((side) => side.toLocaleString("en"));
    throw new Problem(`${name} is ${width} × ${height} pixels, too many to open here. Make it 4,000 × 4,000 at most.`);
  }
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(file, { premultiplyAlpha: "none" });
  } catch {
    throw new Problem(`${name} is not a picture this browser can read. Choose a PNG, JPEG or WebP file.`);
  }
  try {
    const shrink = Math.min(1, MAX_SIDE_PX / Math.max(bitmap.width, bitmap.height));
    const width = Math.max(1, Math.round(bitmap.width * shrink));
    const height = Math.max(1, Math.round(bitmap.height * shrink));
    const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;
    context.imageSmoothingQuality = "high";
    context.drawImage(bitmap, 0, 0, width, height);
    const note = shrink < 1 ? `Scaled down from ${bitmap.width} × ${bitmap.height} pixels.` : "";
    return { width, height, rgba: context.getImageData(0, 0, width, height).data as Pixels["rgba"], note };
  } finally {
    bitmap.close();
  }
}

/** As it is kept: see [`pixelsOf`]. */
export function kept({ width, height, rgba }: Pixels, name: string): KeptPicture {
  return { name, width, height, rgba: new Blob([rgba]) };
}

export async function pixelsOf({ rgba, ...rest }: KeptPicture): Promise<Picture> {
  return { ...rest, rgba: new Uint8ClampedArray(await rgba.arrayBuffer()) };
}
