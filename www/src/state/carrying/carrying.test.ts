import { inflateSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import type { Ink } from "../../engine/protocol";
import { greyPng } from "./grey-png";
import { onSheet, resized } from "./resized";
import { isPacked, packedInto } from "./wire-file";

const disc = (side: number, radius: number): Ink => {
  const ink = Uint8Array.from({ length: side * side }, (_, i) => (Math.hypot((i % side) + 0.5 - side / 2, Math.floor(i / side) + 0.5 - side / 2) < radius ? 255 : 0));
  return { width: side, height: side, ink };
};
const sum = ({ ink }: { readonly ink: Uint8Array }): number => ink.reduce((a, b) => a + b, 0);

/** The rows of a PNG whose every row is told from the one above. */
function greys(png: Uint8Array): number[][] {
  const view = new DataView(png.buffer);
  const [width, height, length] = [view.getUint32(16), view.getUint32(20), view.getUint32(33)];
  const rows = inflateSync(png.subarray(41, 41 + length));
  let above = new Array<number>(width).fill(0);
  return Array.from({ length: height }, (_, y) => (above = above.map((value, x) => (value + rows[y * (1 + width) + 1 + x]!) & 255)));
}

describe("a drawing in a file", () => {
  it("is a grey PNG, black on white, that says its ink again", async () => {
    const png = await greyPng({ width: 3, height: 2, ink: Uint8Array.of(0, 255, 100, 7, 8, 9) }, 1000);
    expect([...png.subarray(24, 26)]).toEqual([8, 0]);
    expect(greys(png)).toEqual([[255, 0, 155], [248, 247, 246]]);
  });

  it("shrinks to 256 px, and further until it fits", async () => {
    let seed = 1;
    const noise: Ink = { width: 512, height: 256, ink: Uint8Array.from({ length: 512 * 256 }, () => (seed = Math.imul(seed, 1664525) + 1013904223) >>> 24) };
    const size = async (most: number): Promise<number[]> => {
      const png = await greyPng(noise, most);
      expect(png.length).toBeLessThanOrEqual(most);
      const rows = greys(png);
      return [rows[0]!.length, rows.length];
    };
    expect(await size(1e6)).toEqual([256, 128]);
    expect((await size(6000))[0]).toBeLessThan(200);
  });

  it("keeps its ink in every size, in the middle of its sheet", () => {
    const ink = disc(200, 60);
    for (const [width, height] of [[100, 100], [400, 400], [77, 77]] as const) {
      expect(sum(resized(ink, width, height)) / (width * height) / (sum(ink) / 200 ** 2)).toBeCloseTo(1, 2);
    }
    expect(resized(ink, 200, 200).ink).toEqual(ink.ink);
    const sheet = onSheet({ width: 20, height: 10, ink: new Uint8Array(200).fill(255) }, 40);
    expect([sheet[0], sheet[20 * 40 + 20], sheet[39 * 40]]).toEqual([0, 255, 0]);
    expect(sum({ ink: sheet }) / 255).toBe(40 * 20);
  });
});

describe("a wire.json", () => {
  const bytes = (text: string): Uint8Array<ArrayBuffer> => new TextEncoder().encode(text) as Uint8Array<ArrayBuffer>;
  const file = bytes('{"format":"wire4d","made_with":{"task":"knit","seed":7,"settings":{}},"knots":[-0.0,1e-7]}\n');

  it("takes along what it was made of, and every number as it was", async () => {
    const whole = await packedInto(file, { drawings: [{ view: "front", label: `<b>"${"x".repeat(99)}`, ...disc(512, 99) }], pairs: { shape: "vase" } });
    const text = new TextDecoder().decode(whole);
    expect(text.startsWith('{"format":"wire4d","made_with":{"task":"knit","seed":7,"settings":{}},"knots":[-0.0,1e-7],')).toBe(true);
    const { drawings, given } = JSON.parse(text) as { drawings: { view: string; label: string }[]; given: object };
    expect([drawings[0]!.view, drawings[0]!.label.length, given]).toEqual(["front", 60, { shape: "vase" }]);
    expect([isPacked(file), isPacked(whole)]).toEqual([false, true]);
  });

  it("stays as it is where nothing is known", async () => {
    expect(await packedInto(file, { drawings: [], pairs: {} })).toEqual(file);
  });
});
