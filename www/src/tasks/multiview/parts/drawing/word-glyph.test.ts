import { describe, expect, it } from "vitest";
import { glyphInk } from "./word-glyph";

const SIDE = 128;
const filled = (colourAt: (x: number, y: number) => readonly [number, number, number, number]): Uint8ClampedArray => {
  const pixels = new Uint8ClampedArray(4 * SIDE * SIDE);
  for (let i = 0; i < SIDE * SIDE; i++) pixels.set(colourAt(i % SIDE, Math.floor(i / SIDE)), 4 * i);
  return pixels;
};
const inSquare = (x: number, y: number): boolean => x >= 32 && x < 96 && y >= 32 && y < 96;
const NOTHING = [0, 0, 0, 0] as const;

describe("written glyphs", () => {
  it("are ink where they take the colour they are written in", () => {
    const ink = glyphInk(
      filled((x, y) => (inSquare(x, y) ? [0, 0, 0, 255] : NOTHING)),
      filled((x, y) => (inSquare(x, y) ? [255, 255, 255, 255] : NOTHING)),
      SIDE,
    );
    expect([ink[64 * SIDE + 64], ink[10 * SIDE + 10]]).toEqual([255, 0]);
  });

  it("are drawn in outline where they bring their own colour", () => {
    const yellow = filled((x, y) => (inSquare(x, y) ? [255, 204, 50, 255] : NOTHING));
    const ink = glyphInk(yellow, yellow, SIDE);
    expect([ink[64 * SIDE + 64], ink[64 * SIDE + 32], ink[32 * SIDE + 64], ink[10 * SIDE + 10]]).toEqual([0, 255, 255, 0]);
  });

  it("keep their dark parts as filled ink, and lose specks", () => {
    const eye = filled((x, y) => {
      if (x === 40 && y === 40) return [0, 0, 200, 255];
      if (x >= 56 && x < 80 && y >= 56 && y < 80) return [20, 10, 5, 255];
      return inSquare(x, y) ? [255, 204, 50, 255] : NOTHING;
    });
    const ink = glyphInk(eye, eye, SIDE);
    expect([ink[66 * SIDE + 66], ink[47 * SIDE + 47]]).toEqual([255, 0]);
  });
});
