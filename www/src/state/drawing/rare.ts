/** Pictures that a browser does not decode by itself: drawings of SVG, and what to say about others. */

import { Problem } from "../../engine/client";

/** Files that people take for pictures, by what their first bytes say, and what to do with them. */
const FOREIGN: readonly (readonly [signature: RegExp, words: string])[] = [
  [/^....ftyp(hei|hev|mif1|msf1)/s, "is a HEIC photo, which this browser cannot read. Share or export it as a JPEG"],
  [/^....ftypavi/s, "is an AVIF picture, which this browser cannot read. Save it as a PNG"],
  [/^(II\*\0|MM\0\*)/, "is a TIFF picture, which this browser cannot read. Save it as a PNG"],
  [/^%PDF/, "is a PDF, not a picture. Export its page as an SVG or PNG"],
  [/^8BPS/, "is a Photoshop file. Save it as a PNG"],
  [/^PK/, "is an archive, not a picture. Unpack it, or export the drawing as a PNG"],
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
    throw new Problem(`${name} is an SVG that this browser cannot draw. Save it as a PNG.`);
  }
  throw new Problem(`${name} is not a picture this browser can read. Choose a PNG, JPEG, WebP, GIF, BMP, AVIF or SVG file.`);
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
