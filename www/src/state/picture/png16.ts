/** PNG pictures of 16 bits, of which a browser would keep 8: depths in millimetres would come down to a few steps. */

import type { Pixels } from "../../engine/protocol";

/** Bytes of a sample, the sides of what is read, and shades that use less than a quarter are spread: all as on the command line. */
const SAMPLE = 2;
const MOST_PX = 25_000_000;
const NARROW = 1 << 14;
const OUTLIERS = 5e-4;
/** Samples of a pixel by the header's kind of colour; palettes have 8 bits at most. */
const CHANNELS: Readonly<Record<number, number>> = { 0: 1, 2: 3, 4: 2, 6: 4 };

/**
 * Its pixels, spread over the 8 bits there are: shades where they use little of the range, `depths` always, 0 (nothing
 * measured) aside. Null for what is better left to the browser: interlaced, with one transparent colour, huge or damaged.
 */
export async function sixteenBit(file: Blob, depths: boolean): Promise<Pixels | null> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const view = new DataView(bytes.buffer);
  const [width, height, channels] = [view.getUint32(16), view.getUint32(20), CHANNELS[bytes[25]!]];
  if (!channels || bytes[28] !== 0 || width * height > MOST_PX || width * height === 0) return null;
  const packed: Uint8Array<ArrayBuffer>[] = [];
  for (let at = 8; at + 8 <= bytes.length; ) {
    const [length, kind] = [view.getUint32(at), String.fromCharCode(...bytes.subarray(at + 4, at + 8))];
    if (kind === "tRNS") return null;
    if (kind === "IDAT") packed.push(bytes.subarray(at + 8, at + 8 + length));
    at += 12 + length;
  }
  const rows = await unpacked(packed, height * (1 + SAMPLE * channels * width));
  if (!rows || !unfilter(rows, SAMPLE * channels * width, SAMPLE * channels)) return null;
  return { width, height, rgba: spread(rows, width, height, channels, depths) };
}

/** Exactly `size` bytes, or null: never more than the header says. */
async function unpacked(packed: Uint8Array<ArrayBuffer>[], size: number): Promise<Uint8Array | null> {
  const all = new Uint8Array(size);
  const reader = new Blob(packed).stream().pipeThrough(new DecompressionStream("deflate")).getReader();
  let at = 0;
  try {
    while (at < size) {
      const { done, value } = await reader.read();
      if (done) return null;
      all.set(value.subarray(0, size - at), at);
      at += value.length;
    }
  } catch {
    return null;
  }
  void reader.cancel().catch(() => undefined);
  return all;
}

/** Undoes the filters of PNG (ISO/IEC 15948, 9.2) in place: a row is its filter's number and `stride` bytes. */
function unfilter(rows: Uint8Array, stride: number, before: number): boolean {
  for (let start = 0; start < rows.length; start += 1 + stride) {
    const filter = rows[start]!;
    if (filter > 4) return false;
    for (let i = 1; i <= stride; i++) {
      const at = start + i;
      const left = i > before ? rows[at - before]! : 0;
      const up = start > 0 ? rows[at - stride - 1]! : 0;
      const corner = start > 0 && i > before ? rows[at - stride - 1 - before]! : 0;
      rows[at]! += [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter]!;
    }
  }
  return true;
}

function paeth(left: number, up: number, corner: number): number {
  const [a, b, c] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)];
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

function spread(rows: Uint8Array, width: number, height: number, channels: number, depths: boolean): Pixels["rgba"] {
  const colours = channels < 3 ? 1 : 3;
  const sample = (x: number, y: number, channel: number): number => {
    const at = y * (1 + SAMPLE * channels * width) + 1 + SAMPLE * (x * channels + channel);
    return (rows[at]! << 8) | rows[at + 1]!;
  };
  const counts = new Uint32Array(65_536);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) for (let c = 0; c < colours; c++) counts[sample(x, y, c)]!++;
  }
  if (depths) counts[0] = 0;
  const beyond = depths ? Math.floor(OUTLIERS * counts.reduce((sum, count) => sum + count, 0)) : 0;
  let [low, high] = [0, 65_535];
  for (let sum = 0; low < 65_535 && (sum += counts[low]!) <= beyond; low++);
  for (let sum = 0; high > 0 && (sum += counts[high]!) <= beyond; high--);
  if (!depths && high - low >= NARROW) [low, high] = [0, 65_535];
  const first = depths ? 1 : 0;
  const scale = (255 - first) / Math.max(1, high - low);
  const level = (value: number): number => (depths && value === 0 ? 0 : Math.max(first, first + scale * (value - low)));
  const rgba = new Uint8ClampedArray(4 * width * height);
  for (let y = 0, at = 0; y < height; y++) {
    for (let x = 0; x < width; x++, at += 4) {
      for (let c = 0; c < 3; c++) rgba[at + c] = level(sample(x, y, colours === 1 ? 0 : c));
      rgba[at + 3] = channels % 2 === 0 ? sample(x, y, channels - 1) / 257 : 255;
    }
  }
  return rgba;
}
