import { expect, it } from "vitest";
import { readContexts } from "./contexts";
import { GuidanceError } from "./fault";

const packed = (numbers: readonly number[]): string => Buffer.from(Float32Array.from(numbers).buffer).toString("base64");
const FILE = { kind: "contexts-v1", shape: [2, 2], contexts: [{ prompt: "a cat", values: packed([1, -2, 0.5, 4]) }, { prompt: "", values: packed([0, 0, 0, 1]) }] };
const read = (change: object, shape = [2, 2]) => readContexts(JSON.stringify({ ...FILE, ...change }), "x.contexts.json", shape);

it("reads contexts", () => {
  expect(read({})).toEqual([
    { prompt: "a cat", values: Float32Array.of(1, -2, 0.5, 4) },
    { prompt: "", values: Float32Array.of(0, 0, 0, 1) },
  ]);
});

it("says what is wrong with a file", () => {
  const one = (values: unknown) => ({ contexts: [{ prompt: "a", values }] });
  const CASES: readonly [object, RegExp][] = [
    [{ kind: "contexts-v2" }, /'kind'/],
    [{ shape: [77, 1e9] }, /'shape' must be whole numbers/],
    [{ shape: [4, 1] }, /'shape' is 4, 1, and the model takes 2, 2/],
    [{ contexts: [] }, /'contexts' is empty/],
    [{ contexts: [{ prompt: 7, values: "" }] }, /'prompt'/],
    [one([1, 2, 3, 4]), /'values' must be 4 finite numbers of 32 bits in base64/],
    [one(packed([1, 2, 3])), /'values'/],
    [one("!".repeat(24)), /'values'/],
    [one(packed([1, 2, NaN, 4])), /'values'/],
    [one(packed([1, 2, Infinity, 4])), /'values'/],
  ];
  for (const [change, said] of CASES) {
    expect(() => read(change), JSON.stringify(change)).toThrow(GuidanceError);
    expect(() => read(change)).toThrow(said);
  }
  expect(() => read({}, [1, 4])).toThrow(/the model takes 1, 4/);
});
