import jsQR from "jsqr";
import { describe, expect, it } from "vitest";
import { MOST_IN_QR, qrOf, qrSvg, type QrCode } from "./qr";

/** Pixels a module. */
const SCALE = 4;

/** What an independent reader sees in a code, with a black blot of so many modules a side on it. */
function read({ side, path }: QrCode, blot = 0): string | null {
  const dark = new Set<number>();
  for (const [, x, y, run] of path.matchAll(/M(\d+) (\d+)h(\d+)v1/g)) for (let k = 0; k < Number(run); k++) dark.add(Number(y) * side + Number(x) + k);
  for (let y = 0; y < blot; y++) for (let x = 0; x < blot; x++) dark.add(((side >> 1) + y) * side + (side >> 1) + x);
  const px = side * SCALE;
  const pixels = new Uint8ClampedArray(4 * px * px);
  for (let at = 0; at < px * px; at++) {
    const module = Math.floor(at / px / SCALE) * side + Math.floor((at % px) / SCALE);
    pixels.set(dark.has(module) ? [0, 0, 0, 255] : [255, 255, 255, 255], 4 * at);
  }
  return jsQR(pixels, px, px)?.data ?? null;
}

const link = (length: number): string => "https://example.org/wire/#v=1&w=".padEnd(length, "aB3-_x9Z");

describe("qrOf", () => {
  it.each([
    [60, "H"],
    [1273, "H"],
    [1274, "Q"],
    [1663, "Q"],
    [1664, "M"],
    [2331, "M"],
    [2332, "L"],
    [2953, "L"],
  ])("holds a link of %i characters at level %s, which another's reader reads", (length, level) => {
    const code = qrOf(link(length))!;
    expect(code.level).toBe(level);
    expect(read(code)).toBe(link(length));
  });

  it("is read with a blot on it", () => {
    const code = qrOf(link(200))!;
    expect(read(code, 7)).toBe(link(200));
    // The blot can be too large.
    expect(read(code, 40)).toBeNull();
  });

  it("is null for what no code holds, in bytes", () => {
    expect(qrOf(link(MOST_IN_QR + 1))).toBeNull();
    expect(qrOf("ü".repeat(MOST_IN_QR / 2 + 1))).toBeNull();
  });
});

it("makes a picture that is dark on light", () => {
  const svg = qrSvg(qrOf(link(60))!);
  expect(svg).toMatch(/^<svg xmlns="http:\/\/www.w3.org\/2000\/svg" viewBox="0 0 (\d+) \1"/);
  expect(svg).toContain(`<path fill="#fff"`);
});
