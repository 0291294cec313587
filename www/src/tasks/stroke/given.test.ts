import { describe, expect, it } from "vitest";
import type { FoundObject } from "./protocol";
import { maskOf, maskSize, maskStroke, objectAt, placesOf, type MaskStroke, type Subject } from "./given";

const picture = (width: number, height: number) => ({ name: "cup.png", width, height, rgba: new Blob() });

/** What was found, from rows of labels: blank is ground, and the first object is the mask. */
function found(...rows: string[]): FoundObject {
  const labels = Uint8Array.from(rows.join(""), (letter) => (letter === " " ? 0 : Number(letter)));
  const mask = labels.map((label) => (label === 1 ? 255 : 0));
  return { width: rows[0]!.length, height: rows.length, mask, labels, count: Math.max(...labels), notes: [] };
}

const blank = (width: number, height: number): FoundObject => found(...Array.from({ length: height }, () => " ".repeat(width)));

function subject(found: FoundObject | null, ...strokes: MaskStroke[]): Subject {
  return { picture: picture(found?.width ?? 100, found?.height ?? 50), object: 1, strokes, found, depth: null };
}

const adds = (width: number, ...points: number[]): MaskStroke => ({ adds: true, width, points });
const takes = (width: number, ...points: number[]): MaskStroke => ({ adds: false, width, points });
/** The mask's value at a place in shares. */
function at(subject: Subject, x: number, y: number): number {
  const { width, height, ink } = maskOf(subject)!;
  return ink[Math.floor(y * height) * width + Math.floor(x * width)]!;
}
const sum = (subject: Subject): number => maskOf(subject)!.ink.reduce((sum, value) => sum + value, 0) / 255;

describe("a mask", () => {
  it("is null where nothing was found or painted, and the found one where nothing was painted", () => {
    expect(maskOf(subject(null))).toBeNull();
    const things = found("11 2", "11 2");
    expect(maskOf(subject(things))).toEqual({ width: 4, height: 2, ink: things.mask });
  });

  it("is what strokes add and take away, in their order", () => {
    const line = [0.1, 0.5, 0.9, 0.5];
    const across = [0.5, 0.1, 0.5, 0.9];
    const before = subject(blank(100, 100), adds(0.2, ...line));
    expect([at(before, 0.5, 0.5), at(before, 0.2, 0.5), at(before, 0.5, 0.8)]).toEqual([255, 255, 0]);
    const cut = subject(blank(100, 100), adds(0.2, ...line), takes(0.1, ...across));
    expect([at(cut, 0.5, 0.5), at(cut, 0.2, 0.5), at(cut, 0.5, 0.8)]).toEqual([0, 255, 0]);
    const mended = subject(blank(100, 100), takes(0.1, ...across), adds(0.2, ...line));
    expect(at(mended, 0.5, 0.5)).toBe(255);
  });

  it("is as wide as its stroke is, of the longer side, with soft rims", () => {
    const mask = maskOf(subject(blank(100, 50), adds(0.1, 0.5, 0.1, 0.5, 0.9)))!;
    const row = mask.ink.subarray(25 * 100, 26 * 100);
    expect(row.reduce((sum, value) => sum + value, 0) / 255).toBeCloseTo(10, 1);
    expect(maskOf(subject(blank(100, 50), adds(0.105, 0.5, 0.5)))!.ink.some((value) => value > 0 && value < 255)).toBe(true);
  });

  it("shows a stroke of one point as a dot, round in any picture", () => {
    for (const [width, height] of [[200, 200], [200, 80], [60, 200]] as const) {
      const dot = subject(blank(width, height), adds(0.1, 0.5, 0.5));
      expect(sum(dot)).toBeGreaterThan(0.97 * Math.PI * 100);
      expect(sum(dot)).toBeLessThan(1.03 * Math.PI * 100);
      const { ink } = maskOf(dot)!;
      const wide = ink.subarray((height / 2) * width, (height / 2 + 1) * width).reduce((sum, value) => sum + value, 0);
      let high = 0;
      for (let y = 0; y < height; y++) high += ink[y * width + width / 2]!;
      expect(Math.abs(wide - high)).toBeLessThan(255);
    }
  });

  it("holds a stroke that leaves the picture, up to its edge", () => {
    const thick = subject(blank(40, 20), adds(0.2, -0.5, 0.5, 1.5, 0.5));
    expect([at(thick, 0, 0.5), at(thick, 0.99, 0.5), at(thick, 0.5, 0)]).toEqual([255, 255, 0]);
    expect(sum(subject(blank(40, 20), adds(0.2, 2, 2, 3, 3)))).toBe(0);
  });

  it("shows a stroke at the same place whatever size the mask has", () => {
    const path = [0.2, 0.3, 0.7, 0.6, 0.4, 0.9];
    const [small, large] = [subject(blank(90, 60), adds(0.1, ...path)), subject(blank(360, 240), adds(0.1, ...path))];
    expect(sum(large) / sum(small)).toBeCloseTo(16, 0);
    for (const [x, y] of [[0.2, 0.3], [0.7, 0.6], [0.4, 0.9]] as const) expect([at(small, x, y), at(large, x, y)]).toEqual([255, 255]);
  });

  it("can be painted where nothing was found, as large as the picture but no larger than needed", () => {
    const small = subject(null, adds(0.2, 0.5, 0.5));
    expect(maskSize(small)).toEqual({ width: 100, height: 50 });
    expect([at(small, 0.5, 0.5), at(small, 0.1, 0.1)]).toEqual([255, 0]);
    expect(maskSize({ ...small, picture: picture(1024, 300) })).toEqual({ width: 512, height: 150 });
    expect(maskSize({ ...small, picture: picture(1, 3000) })).toEqual({ width: 1, height: 512 });
  });

  it("keeps the strokes when another object is found", () => {
    const first = found("11  ", "11  ");
    const second = { ...first, mask: first.mask.map((value) => 255 - value) };
    const corner = takes(0.01, 0.01, 0.01, 0.12, 0.12);
    expect(at(subject(first, corner), 0.3, 0.9)).toBe(255);
    expect(at(subject(second, corner), 0.3, 0.9)).toBe(0);
    expect(at(subject(second, corner), 0.9, 0.9)).toBe(255);
  });

  it("never writes to what was found or to what it gave out before", () => {
    const things = blank(50, 50);
    const dot = adds(0.3, 0.5, 0.5);
    const before = maskOf(subject(things, dot))!;
    const kept = before.ink.slice();
    expect(maskOf(subject(things, dot))).toBe(before);
    expect(sum(subject(things, dot, takes(0.2, 0.5, 0.5)))).toBeLessThan(sum(subject(things, dot)));
    expect(before.ink).toEqual(kept);
    expect(things.mask.every((value) => value === 0)).toBe(true);
    // One stroke fewer, after an undo.
    expect(maskOf(subject(things, dot))!.ink).toEqual(kept);
  });
});

describe("a hand's line", () => {
  it("becomes shares of the picture, without the points that say nothing", () => {
    const { points, adds, width } = maskStroke([20, 10, 40, 10, 60, 10, 100, 50], { width: 200, height: 100 }, { adds: false, width: 0.05 });
    expect([adds, width]).toEqual([false, 0.05]);
    expect(points).toEqual([0.1, 0.1, 0.3, 0.1, 0.5, 0.5]);
  });

  it("may be one point", () => {
    expect(maskStroke([50, 50], { width: 100, height: 100 }, { adds: true, width: 0.1 }).points).toEqual([0.5, 0.5]);
  });
});

describe("a tap", () => {
  const things = found("11    ", "11  2 ", "      ", "3     ");

  it("finds the object under it", () => {
    expect([objectAt(things, 0.1, 0.1), objectAt(things, 0.75, 0.4), objectAt(things, 0.05, 0.9), objectAt(things, 0.5, 0.9)]).toEqual([1, 2, 3, 0]);
  });

  it("finds the nearest one within reach", () => {
    expect(objectAt(things, 0.9, 0.4)).toBe(0);
    expect(objectAt(things, 0.9, 0.4, 0.2)).toBe(2);
    expect(objectAt(things, 0.15, 0.65, 0.3)).toBe(3);
  });

  it("may land outside of the picture", () => {
    expect([objectAt(things, -1, 0.5), objectAt(things, 1, 1), objectAt(things, 0.5, 7, 0.1)]).toEqual([0, 0, 0]);
  });
});

it("has a place on each object, also on a ring", () => {
  const things = found("111   ", "1 1  2", "111   ");
  const places = placesOf(things);
  expect(places).toHaveLength(2);
  expect(places.map(([x, y]) => objectAt(things, x, y))).toEqual([1, 2]);
});
