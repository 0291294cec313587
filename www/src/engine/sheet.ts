import type { Ink } from "./protocol";

/** Dark lines on white become ink; no finder is needed for drawings that we made ourselves. */
export async function sheetOf(drawing: Blob): Promise<Ink> {
  const bitmap = await createImageBitmap(drawing);
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true })!;
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  const { data } = context.getImageData(0, 0, width, height);
  const ink = new Uint8Array(width * height);
  for (let i = 0; i < ink.length; i++) ink[i] = 255 - data[4 * i]!;
  return { width, height, ink };
}
