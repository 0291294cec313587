/** Ink as a small PNG file: 8-bit grey, ink black on white. */

import type { Ink } from "../../engine/protocol";
import { within } from "./resized";

/** Longest side, px. */
const MOST_PX = 256;
/** Smaller than this there is nothing left to see. */
const LEAST_PX = 48;
const SHRINK = 0.8;

/** As large as fits into so many bytes. */
export async function greyPng(ink: Ink, mostBytes: number): Promise<Uint8Array> {
  for (let side = MOST_PX; ; side *= SHRINK) {
    const png = await encoded(within(ink, Math.round(side)));
    if (png.length <= mostBytes || side < LEAST_PX) return png;
  }
}

async function encoded({ width, height, ink }: Ink): Promise<Uint8Array> {
  // Each row is told from the one above (filter 2 of ISO/IEC 15948), which is much alike.
  const rows = new Uint8Array(height * (1 + width));
  for (let y = 0; y < height; y++) {
    const start = y * (1 + width);
    rows[start] = 2;
    for (let x = 0; x < width; x++) rows[start + 1 + x] = (y > 0 ? ink[(y - 1) * width + x]! : 255) - ink[y * width + x]!;
  }
  const packed = await new Response(new Blob([rows]).stream().pipeThrough(new CompressionStream("deflate"))).arrayBuffer();
  const heading = new Uint8Array(13);
  new DataView(heading.buffer).setUint32(0, width);
  new DataView(heading.buffer).setUint32(4, height);
  heading[8] = 8;
  const parts = [[0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10], chunk("IHDR", heading), chunk("IDAT", new Uint8Array(packed)), chunk("IEND", new Uint8Array())];
  return Uint8Array.from(parts.flatMap((part) => [...part]));
}

function chunk(kind: string, data: Uint8Array): Uint8Array {
  const bytes = new Uint8Array(12 + data.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set(new TextEncoder().encode(kind), 4);
  bytes.set(data, 8);
  view.setUint32(8 + data.length, crc32(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

function crc32(bytes: Uint8Array): number {
  let crc = -1;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}
