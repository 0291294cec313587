import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { GuidanceError } from "./fault";
import { mix } from "./noise";
import { readSidecar, USUAL_SCHEDULE } from "./sidecar";

type Json = { [key: string]: unknown };

const FOLDER = join(import.meta.dirname, "../../../tests/data/guidance");
const VIT = JSON.parse(readFileSync(join(FOLDER, "vit-tiny.json"), "utf8")) as Json;
const TEXT = JSON.parse(readFileSync(join(FOLDER, "text-tiny.json"), "utf8")) as Json;

const fault = (sidecar: unknown): string => {
  try {
    readSidecar(typeof sidecar === "string" ? sidecar : JSON.stringify(sidecar), "x.json");
    return "";
  } catch (error) {
    expect(error).toBeInstanceOf(GuidanceError);
    return (error as Error).message;
  }
};

/** A copy with the value at a path replaced; undefined takes it away. */
function changed(json: Json, path: string, value: unknown): Json {
  const copy = structuredClone(json);
  const keys = path.split(".");
  const inner = keys.slice(0, -1).reduce((at, key) => at[key] as Json, copy);
  inner[keys.at(-1)!] = value;
  return copy;
}

it("reads what the exporter writes", () => {
  const vit = readSidecar(JSON.stringify(VIT), "x.json");
  expect([vit.kind, vit.name, vit.weights, vit.bytes, vit.tokenizer, vit.selftest.batch, vit.selftest.cases.length]).toEqual(["guidance-v1", "vit-tiny", "fp32", 114340, null, 2, 2]);
  expect(vit.contract.inputs[0]!.shape).toEqual(["batch", 3, 32, 32]);
  expect(readSidecar(JSON.stringify(TEXT), "x.json").tokenizer).toBe("text-tiny.tokenizer.json");
  const prompts = [{ prompt: "a cat", vector: Array.from({ length: 16 }, (_, i) => i) }];
  const [prompt] = readSidecar(JSON.stringify({ ...VIT, embeddings: prompts }), "x.json").embeddings;
  expect(Math.hypot(...prompt!.vector)).toBeCloseTo(1, 6);
});

it("reads masks and depths", () => {
  const port = (channels: number) => ({ dtype: "float32", shape: [1, channels, 24, 32] });
  for (const [kind, output] of [["mask-v1", "mask"], ["depth-v1", "depth"]] as const) {
    const io = { inputs: { image: port(3) }, outputs: { [output]: port(1) } };
    const test = { batch: 1, tolerance: { relative: 0.01, absolute: 0.001, cosine: 0.999 }, cases: [{ name: "look", inputs: { image: { fill: "uniform", seed: 1 } }, outputs: { [output]: { l2: 1, sketch: Array(64).fill(0) } } }] };
    const { name, origin, licence, weights, bytes, sha256 } = VIT;
    const sidecar = { kind, name, origin, licence, weights, bytes, sha256, image: [24, 32], io, selftest: test };
    expect(fault(sidecar)).toBe("");
    expect(fault(changed(sidecar, "image", [24, 1024]))).toMatch(/'image'/);
  }
});

it("reads what a diffusion model says of its noise and of no words", () => {
  const port = (...shape: readonly unknown[]) => ({ dtype: "float32", shape: ["batch", ...shape] });
  const io = { inputs: { x_t: port(1, 4, 4), t: port(), context: port(1, 3) }, outputs: { eps: port(1, 4, 4) } };
  const { name, origin, licence, weights, bytes, sha256, selftest } = VIT as { [key: string]: unknown; selftest: Json };
  const seeds = { x_t: { fill: "signed", seed: 1 }, t: { fill: "constant", value: 500 }, context: { fill: "signed", seed: 2 } };
  const test = { ...selftest, batch: 1, cases: [{ name: "noise", inputs: seeds, outputs: { eps: { values: Array(16).fill(0) } } }] };
  const sidecar: Json = { kind: "eps-v1", name, origin, licence, weights, bytes, sha256, latent: [1, 4, 4], context: [1, 3], io, selftest: test };
  const read = (more: Json) => readSidecar(JSON.stringify({ ...sidecar, ...more }), "x.json");
  expect(read({})).toMatchObject({ schedule: USUAL_SCHEDULE, nothing: null });
  expect(read({ schedule: { kind: "cosine", steps: 50 } }).schedule).toMatchObject({ kind: "cosine", steps: 50 });
  expect(read({ schedule: { kind: "linear", steps: 1000, from: 1e-4, to: 0.02 }, nothing: [0, 0, 1] })).toMatchObject({ schedule: { kind: "linear", steps: 1000, from: 1e-4, to: 0.02 }, nothing: Float32Array.of(0, 0, 1) });
  const WRONG: readonly [Json, RegExp][] = [
    [{ schedule: 7 }, /'schedule' must be a JSON object/],
    [{ schedule: { kind: "square", steps: 1000 } }, /'kind' must be one of linear/],
    [{ schedule: { kind: "cosine", steps: 1e6 } }, /'steps' must be a number from 2 to 10000/],
    [{ schedule: { kind: "linear", steps: 1000, from: 0, to: 0.02 } }, /'from' must be a number/],
    [{ schedule: { kind: "linear", steps: 1000, from: 0.5, to: 0.02 } }, /'to' must be a number from 0.5/],
    [{ schedule: { kind: "scaled-linear", steps: 1000, from: 1e-4, to: 1 } }, /'to'/],
    [{ nothing: [1, 2] }, /'nothing' must be 3 finite numbers/],
    [{ nothing: [1, 2, "x"] }, /'nothing'/],
  ];
  for (const [more, said] of WRONG) expect(fault({ ...sidecar, ...more }), JSON.stringify(more)).toMatch(said);
});

it("says which field is wrong", () => {
  const CASES: readonly [string, unknown, RegExp][] = [
    ["kind", "guidance-v9", /'kind' must be one of guidance-v1/],
    ["size", 4096, /'size' must be whole numbers from 1 to at most 1024/],
    ["size", 31.5, /'size'/],
    ["size", "32", /'size'/],
    ["embed", 0, /'embed'/],
    ["embed", 1e9, /'embed'/],
    ["bytes", 2 ** 31 + 1, /'bytes' must be a number from 1 to 2147483648/],
    ["bytes", -1, /'bytes'/],
    ["sha256", "ABC", /'sha256' must be 64/],
    ["name", "x".repeat(201), /'name' must be a text of at most 200/],
    ["name", undefined, /'name'/],
    ["licence", 7, /'licence'/],
    ["weights", "int4", /'weights' must be one of/],
    ["layout", "NHWC", /'layout' must be "NCHW"/],
    ["range", [-1, 1], /'range' must be \[0,1\]/],
    ["mean_std_inside", false, /'mean_std_inside'/],
    ["io", [], /'io' must be a JSON object/],
    ["io.inputs.image.shape", ["batch", 3, 64, 64], /The input is image\[batch, 3, 64, 64\] float32 and must be image\[batch, 3, 32, 32\]/],
    ["io.inputs.extra", { dtype: "float32", shape: [] }, /extra.*not in the contract/],
    ["io.outputs.grad", undefined, /The output grad.* is missing/],
    ["io.outputs.grad", 7, /'grad' of 'outputs' of 'io' must be a JSON object/],
    ["tokenizer", "../secret.json", /'tokenizer' must be the name of a file/],
    ["embeddings", [{ prompt: "a", vector: [1, 2] }], /'vector' must be 16 finite numbers/],
    ["embeddings", [{ prompt: "a", vector: Array(16).fill(0) }], /all zeros/],
    ["selftest", undefined, /'selftest'/],
    ["selftest.batch", 1e6, /'batch'/],
    ["selftest.cases", [], /'cases' is empty/],
    ["selftest.tolerance.relative", 5, /'relative' must be a number from 0 to 0.1/],
    ["selftest.tolerance.cosine", -1, /'cosine' must be a number from 0.9 to 1/],
    ["selftest.cases.0.inputs.image", { fill: "random", seed: 1 }, /'fill' must be one of/],
    ["selftest.cases.0.inputs.image.seed", 0.5, /'seed'/],
    ["selftest.cases.0.outputs.loss.values", [], /'values' must be 1 finite numbers/],
    ["selftest.cases.0.outputs.grad.sketch", [1], /'sketch' must be 64 finite numbers/],
  ];
  for (const [path, value, said] of CASES) {
    expect(fault(changed(VIT, path, value)), path).toMatch(said);
    expect(fault(changed(VIT, path, value))).toMatch(/^“x\.json” cannot be used: .* Export the model again/);
  }
  for (const text of ["", "{", "[]", "null", "7", '"x"', "{}", "{}".padEnd(2 ** 24 + 3)]) expect(fault(text)).toMatch(/^“x\.json” cannot be used/);
  expect(fault(`${JSON.stringify(VIT).slice(0, -1)},"__proto__":{"kind":"text-v1"}}`)).toBe("");
});

it("is not brought down by anything", () => {
  const HOSTILE = [null, true, -1, 0, 1e308, "", "x".repeat(300), [], {}, [null], { length: 3 }, [[[[]]]], "<img src=x onerror=alert(1)>"];
  const paths = (value: unknown, at: string[]): string[][] =>
    typeof value === "object" && value !== null ? Object.entries(value).flatMap(([key, inner]) => [[...at, key], ...paths(inner, [...at, key])]) : [];
  const all = paths(VIT, []);
  let refused = 0;
  all.forEach((path, i) => {
    const value = HOSTILE[mix(i) % HOSTILE.length];
    if (fault(changed(VIT, path.join("."), value))) refused++;
  });
  // The rest are texts, numbers that a network may answer, and what nobody reads.
  expect(refused).toBeGreaterThan(0.2 * all.length);
  const text = JSON.stringify(VIT);
  for (let i = 0; i < 300; i++) {
    const at = mix(i) % text.length;
    fault(text.slice(0, at) + String.fromCharCode(32 + (mix(i + 1000) % 90)) + text.slice(at + 1));
  }
});
