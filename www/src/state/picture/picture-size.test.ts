import { describe, expect, it } from "vitest";
import { pictureSize } from "./picture-size";

const bytes = (...parts: (string | number[])[]): Uint8Array =>
  Uint8Array.from(parts.flatMap((part) => (typeof part === "string" ? [...part].map((c) => c.charCodeAt(0)) : part)));

describe("pictureSize", () => {
  const png = bytes([0x89], "PNG", [13, 10, 26, 10, 0, 0, 0, 13], "IHDR", [0, 0, 0x4e, 0x20, 0, 0, 0x27, 0x10]);

  it("reads the size of a PNG without decoding it", () => {
    expect(pictureSize(png)).toEqual({ width: 20_000, height: 10_000 });
  });

  it("finds the frame header of a JPEG behind other segments", () => {
    const jpeg = bytes([0xff, 0xd8, 0xff, 0xe0, 0, 4, 1, 2, 0xff, 0xc2, 0, 17, 8, 0x01, 0x00, 0x02, 0x00, 3, 0, 0]);
    expect(pictureSize(jpeg)).toEqual({ width: 512, height: 256 });
  });

  it("reads GIF, BMP and the three kinds of WebP", () => {
    expect(pictureSize(bytes("GIF89a", [44, 1, 200, 0]))).toEqual({ width: 300, height: 200 });
    expect(pictureSize(bytes("BM", Array<number>(16).fill(0), [5, 0, 0, 0, 250, 255, 255, 255]))).toEqual({ width: 5, height: 6 });
    const riff = (chunk: string, rest: number[]): Uint8Array => bytes("RIFF", [0, 0, 0, 0], "WEBP", chunk, rest);
    expect(pictureSize(riff("VP8X", [10, 0, 0, 0, 0, 0, 0, 0, 0xff, 1, 0, 0x7f, 0, 0]))).toEqual({ width: 512, height: 128 });
    expect(pictureSize(riff("VP8 ", [0, 0, 0, 0, 0, 0, 0, 0x9d, 1, 0x2a, 64, 0, 32, 0]))).toEqual({ width: 64, height: 32 });
    expect(pictureSize(riff("VP8L", [0, 0, 0, 0, 0x2f, 0x3f, 0xc0, 0x07, 0, 0, 0, 0, 0, 0]))).toEqual({ width: 64, height: 32 });
  });

  it("knows nothing of other files and of cut-off ones", () => {
    expect(pictureSize(bytes("hello, I am no picture at all"))).toBeNull();
    expect(pictureSize(png.subarray(0, 20))).toBeNull();
    expect(pictureSize(bytes([0xff, 0xd8, 0xff, 0xe0, 0xff, 0xff, 0, 0]))).toBeNull();
    expect(pictureSize(new Uint8Array())).toBeNull();
  });
});
