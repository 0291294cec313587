import { describe, expect, it } from "vitest";
import { graphemes, layOut, type Extent } from "./word-layout";

/** Every letter is one wide and one high, on the baseline. */
const measure = (line: string): Extent => {
  const half = graphemes(line).length / 2;
  return { left: half, right: half, ascent: 1, descent: 0 };
};
const lines = (text: string): readonly string[] => layOut(text, measure).lines.map(({ text }) => text);

describe("a text in a square", () => {
  it("stays on one line while that is not smaller", () => {
    expect(lines("love")).toEqual(["love"]);
    expect(lines("A")).toEqual(["A"]);
    expect(lines("a Donaudampfschifffahrt")).toHaveLength(1);
  });

  it("breaks at spaces where that gives larger letters", () => {
    expect(lines("the quick brown fox")).toEqual(["the", "quick", "brown", "fox"]);
    expect(lines("one two six")).toEqual(["one", "two", "six"]);
  });

  it("never breaks a word, however long", () => {
    expect(lines("Donaudampfschifffahrt")).toEqual(["Donaudampfschifffahrt"]);
    expect(lines("via Donaudampfschifffahrt")).toEqual(["via", "Donaudampfschifffahrt"]);
  });

  it("breaks between letters of scripts without spaces, and between emoji", () => {
    expect(lines("山川草木")).toEqual(["山川", "草木"]);
    expect(lines("🐱🐶🐭🐹")).toEqual(["🐱🐶", "🐭🐹"]);
    expect(lines("👨‍👩‍👧‍👦")).toEqual(["👨‍👩‍👧‍👦"]);
  });

  it("says how much room the ink takes", () => {
    const block = layOut("one two six", measure);
    expect(block).toMatchObject({ left: -1.5, top: -1, width: 3 });
    expect(block.height).toBeCloseTo(3.44, 5);
    expect(block.lines[2]!.baseline).toBeCloseTo(2.44, 5);
  });
});
