import { readFileSync } from "node:fs";
import { join } from "node:path";
import { deflateSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import type { Pixels } from "../../engine/protocol";
import { sixteenBit } from "./png16";

const FIELD = join(import.meta.dirname, "../../../../tests/field/depth-16bit-mm");
const field = (name: string) => new Blob([readFileSync(join(FIELD, name))]);

/** A PNG of one row of grey, each sample its two bytes, filtered by nothing. */
function grey(values: readonly number[], { kind = 0, interlaced = 0 } = {}): Blob {
  const chunk = (name: string, data: Uint8Array): Buffer => {
    const length = Buffer.alloc(4);
    length.writeUInt32BE(data.length);
    return Buffer.concat([length, Buffer.from(name), data, Buffer.alloc(4)]);
  };
  const header = Buffer.alloc(13);
  header.writeUInt32BE(values.length, 0);
  header.writeUInt32BE(1, 4);
  header.set([16, kind, 0, 0, interlaced], 8);
  const row = Buffer.from([0, ...values.flatMap((value) => [value >> 8, value & 255])]);
  return new Blob([Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", header), chunk("IDAT", deflateSync(row)), chunk("IEND", Buffer.alloc(0))])]);
}

const reds = ({ rgba }: Pixels): number[] => Array.from({ length: rgba.length / 4 }, (_, i) => rgba[4 * i]!);

describe("PNG pictures of 16 bits", () => {
  it("are spread over the range where they use little of it", async () => {
    expect(reds((await sixteenBit(grey([300, 550, 800]), false))!)).toEqual([0, 128, 255]);
    expect(reds((await sixteenBit(grey([0, 32_896, 65_535]), false))!)).toEqual([0, 128, 255]);
    expect(reds((await sixteenBit(grey([0, 500, 750, 1000]), true))!)).toEqual([0, 1, 128, 255]);
  });

  it("are read whatever their filters, as the browser reads the same in 8 bits", async () => {
    const fine = await sixteenBit(field("near-is-bright-300-to-800.png"), true);
    const full = await sixteenBit(field("near-is-bright-full-range.png"), true);
    expect([fine!.width, fine!.height]).toEqual([192, 192]);
    const [a, b] = [reds(fine!), reds(full!)];
    expect(Math.max(...a.map((value, i) => (value && b[i] ? Math.abs(value - b[i]) : 0)))).toBeLessThan(6);
    expect(new Set(a).size).toBeGreaterThan(150);
  });

  it("are left to the browser where they are of another kind or damaged", async () => {
    expect(await sixteenBit(grey([1, 2, 3], { interlaced: 1 }), false)).toBeNull();
    expect(await sixteenBit(grey([1, 2, 3], { kind: 3 }), false)).toBeNull();
    expect(await sixteenBit(grey([1, 2, 3], { kind: 2 }), false)).toBeNull();
    const whole = new Uint8Array(await grey([300, 550, 800]).arrayBuffer());
    for (const length of [30, 44, 48]) expect(await sixteenBit(new Blob([whole.slice(0, length)]), false)).toBeNull();
  });
});
