import { describe, expect, it } from "vitest";
import type { MaskStroke, Subject } from "./given";
import { hintsOf, isPointedAt } from "./given";
import { hintsWithBox, hintsWithMark } from "./hints";

const picture = { name: "cup.jpg", width: 400, height: 200, rgba: new Blob() };
const blank: Subject = { picture, object: 1, strokes: [], found: null, depth: null };
const mark = (adds: boolean, ...points: number[]): MaskStroke => ({ adds, width: 0.02, points });

describe("a mark", () => {
  it("joins those of its kind, wherever they are", () => {
    const first = mark(true, 0.2, 0.5, 0.4, 0.5);
    const { marks } = hintsWithMark({ ...blank, marks: [first] }, mark(true, 0.3, 0.5, 0.5, 0.5));
    expect(marks[0]).toBe(first);
    expect(marks).toHaveLength(2);
  });

  it("rubs out what it contradicts, and no more", () => {
    const line = mark(true, 0.1, 0.5, 0.9, 0.5);
    const { marks } = hintsWithMark({ ...blank, marks: [line] }, mark(false, 0.5, 0.2, 0.5, 0.8));
    expect(marks.map(({ adds }) => adds)).toEqual([true, true, false]);
    const [left, right] = marks;
    // Two half widths of .02 of the longer side, which is the width.
    expect(left!.points.at(-2)).toBeGreaterThan(0.47);
    expect(left!.points.at(-2)).toBeLessThan(0.481);
    expect(right!.points[0]).toBeGreaterThan(0.519);
    expect([left!.points[0], right!.points.at(-2)]).toEqual([0.1, 0.9]);
    const gone = hintsWithMark({ ...blank, marks: [mark(true, 0.5, 0.5)] }, mark(false, 0.505, 0.5));
    expect(gone.marks).toEqual([mark(false, 0.505, 0.5)]);
  });

  it("is left alone beside one of the other kind", () => {
    const known = mark(false, 0.1, 0.1, 0.9, 0.1);
    expect(hintsWithMark({ ...blank, marks: [known] }, mark(true, 0.1, 0.3, 0.9, 0.3)).marks[0]).toBe(known);
  });

  it("on the object makes the box larger, and one beside it does not", () => {
    const boxed: Subject = { ...blank, box: [0.4, 0.4, 0.6, 0.6] };
    expect(hintsWithMark(boxed, mark(true, 0.5, 0.5, 0.8, 0.3)).box).toEqual([0.4, 0.3, 0.8, 0.6]);
    expect(hintsWithMark(boxed, mark(true, 0.5, 0.5, 1.2, 0.5)).box).toEqual([0.4, 0.4, 1, 0.6]);
    expect(hintsWithMark(boxed, mark(false, 0.5, 0.5, 0.8, 0.3)).box).toEqual(boxed.box);
  });
});

describe("a box", () => {
  it("keeps the marks on the object that are in it, and all beside it", () => {
    const beside = mark(false, 0.05, 0.05, 0.1, 0.1);
    const marks = [mark(true, 0.1, 0.5, 0.5, 0.5), mark(true, 0.9, 0.9), beside];
    const hints = hintsWithBox({ ...blank, marks }, [0.3, 0.3, 0.7, 0.7]);
    expect(hints.marks).toHaveLength(2);
    expect(hints.marks[0]!.points[0]).toBeGreaterThanOrEqual(0.3);
    expect(hints.marks[1]).toBe(beside);
  });

  it("goes without the marks", () => {
    const marks = [mark(true, 0.1, 0.5)];
    expect(hintsWithBox({ ...blank, box: [0, 0, 0.5, 1], marks }, null)).toEqual({ box: null, marks });
  });
});

it("pixels are those of the picture, widths of its longer side", () => {
  expect(isPointedAt(blank)).toBe(false);
  const subject: Subject = { ...blank, box: [0.25, 0.25, 0.5, 1], marks: [mark(true, 0.5, 0.5)] };
  expect(isPointedAt(subject)).toBe(true);
  expect(hintsOf(subject)).toEqual({ box: [100, 50, 200, 200], marks: [{ onObject: true, points: Float32Array.of(200, 100), radius: 4 }] });
});
