/** Formulas and tokens are Python's, number by number: `tools/guidance/scripts/make_fixture.py` wrote what they should be. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { cosine, mix, signed, sketch, uniform, unitRows } from "./noise";
import { Tokenizer } from "./tokenizer";

interface Formulas {
  readonly mix: readonly { readonly x: number; readonly mix: number }[];
  readonly uniform: readonly { readonly seed: number; readonly values: number[] }[];
  readonly unit: { readonly seed: number; readonly width: number; readonly values: number[] };
  readonly sketches: readonly { readonly seed: number; readonly count: number; readonly values: number[] }[];
  readonly tokenizer: object;
  readonly tokens: readonly { readonly text: string; readonly ids: number[]; readonly all: number[] }[];
}

const FOLDER = join(import.meta.dirname, "../../../tests/data/guidance");
const wanted = JSON.parse(readFileSync(join(FOLDER, "formulas.json"), "utf8")) as Formulas;

it("mixes and fills", () => {
  for (const { x, mix: mixed } of wanted.mix) expect(mix(x)).toBe(mixed);
  for (const { seed, values } of wanted.uniform) expect([...uniform(seed, 5)]).toEqual([...Float32Array.from(values)]);
  const { seed, width, values } = wanted.unit;
  expect([...unitRows(seed, 3 * width, width)]).toEqual([...Float32Array.from(values)]);
});

it("sketches", () => {
  for (const { seed, count, values } of wanted.sketches) {
    const sums = sketch(signed(seed, 1000).subarray(0, count));
    expect(sums.length).toBe(values.length);
    sums.forEach((sum, i) => expect(sum).toBeCloseTo(values[i]!, 12));
  }
  const [a, b] = [signed(1, 1000), signed(2, 1000)];
  expect(cosine(sketch(a), sketch(a))).toBeCloseTo(1, 12);
  expect(Math.abs(cosine(sketch(a), sketch(b)))).toBeLessThan(0.5);
  expect(cosine([0, 0], [0, 0])).toBe(1);
  expect(cosine([0, 0], [0, 1])).toBe(0);
});

it("tokenizes", () => {
  const tokenizer = new Tokenizer(JSON.stringify(wanted.tokenizer), "x.tokenizer.json");
  expect(wanted.tokens.length).toBeGreaterThan(5);
  for (const { text, ids, all } of wanted.tokens) {
    expect(tokenizer.encode(text), text).toEqual(all);
    expect([...tokenizer.rows([text])]).toEqual(ids);
  }
  expect([...tokenizer.rows(["a cat", "wire"])]).toEqual([...tokenizer.rows(["a cat"]), ...tokenizer.rows(["wire"])]);
});

it("refuses what is no tokenizer, and what has no words", () => {
  const good = { kind: "clip-bpe", context: 8, pad: 0, merges: ["a b"] };
  const said = (file: object | string): string => {
    try {
      new Tokenizer(typeof file === "string" ? file : JSON.stringify(file), "x.tokenizer.json");
      return "";
    } catch (error) {
      return (error as Error).message;
    }
  };
  expect(said(good)).toBe("");
  for (const bad of ["{", "[]", "null", {}, { ...good, kind: "x" }, { ...good, context: 2 }, { ...good, context: 1e9 }, { ...good, pad: -1 }, { ...good, pad: "0" }, { ...good, merges: {} }, { ...good, merges: ["ab"] }, { ...good, merges: ["a b c"] }, { ...good, merges: [1] }]) {
    expect(said(bad), JSON.stringify(bad)).toMatch(/^“x\.tokenizer\.json” is no tokenizer: .*\. Export the text encoder again/);
  }
  for (const empty of ["", "   ", "&nbsp;"]) expect(() => new Tokenizer(JSON.stringify(good), "x").encode(empty)).toThrow("A prompt is empty");
});
