/** The JSON beside an ONNX file: what is known of it before it is opened. It comes from anywhere, so nothing in it is believed. */

import { BATCH, contractOf, count, isDynamic, KINDS, portFaults, SIZES, type Contract, type Kind, type Port, type Shape } from "./contract";
import { GuidanceError } from "./fault";
import { Fields } from "./fields";
import { BUCKETS, madeUnit } from "./noise";

const MOST_PROMPTS = 1024;
const MOST_CASES = 8;
const MOST_BATCH = 8;
/** A self-test that lets more through tells nothing. */
const LAXEST = { relative: 0.1, absolute: 0.1, cosine: 0.9 };
/** Of a diffusion model's times, and of how much noise a time adds. */
const [MOST_STEPS, LEAST_BETA] = [10_000, 1e-9];
/** What a protobuf, and so a file without external weights, can be. */
const MOST_BYTES = 2 ** 31;

export type Weights = "fp32" | "fp16" | "int8";

export interface Prompt {
  readonly prompt: string;
  /** Unit. */
  readonly vector: Float32Array<ArrayBuffer>;
}

/** How a diffusion model's noise grows, of `steps` times; `from` and `to` are betas and mean nothing to a cosine. */
export interface Schedule {
  readonly kind: "linear" | "scaled-linear" | "cosine";
  readonly steps: number;
  readonly from: number;
  readonly to: number;
}

/** Stable Diffusion's: of a model that does not say. */
export const USUAL_SCHEDULE: Schedule = { kind: "scaled-linear", steps: 1000, from: 0.00085, to: 0.012 };

/** How an input is filled. */
export type Fill =
  | { readonly fill: "uniform" | "signed" | "unit"; readonly seed: number }
  | { readonly fill: "constant"; readonly value: number }
  | { readonly fill: "count"; readonly first: number };

/** What an output should be: all of up to 64 numbers, else its length and a sketch. */
export type Expected = { readonly values: readonly number[] } | { readonly l2: number; readonly sketch: readonly number[] };

export interface Case {
  readonly name: string;
  readonly inputs: Readonly<Record<string, Fill>>;
  readonly outputs: Readonly<Record<string, Expected>>;
}

export interface Selftest {
  readonly batch: number;
  readonly tolerance: { readonly relative: number; readonly absolute: number; readonly cosine: number };
  readonly cases: readonly Case[];
}

export interface Sidecar<K extends Kind = Kind> {
  readonly kind: K;
  readonly name: string;
  /** Where the weights are from. */
  readonly origin: string;
  readonly licence: string;
  /** How they are stored; they are unpacked to fp32 when the file is opened. */
  readonly weights: Weights;
  /** Of the ONNX file. */
  readonly bytes: number;
  /** Of the ONNX file, in lower-case hexadecimal. */
  readonly sha256: string;
  readonly contract: Contract;
  /** The name of the tokenizer's file, of a text encoder that brings one. */
  readonly tokenizer: string | null;
  /** Prompts that need no text encoder. */
  readonly embeddings: readonly Prompt[];
  /** Of a diffusion model. */
  readonly schedule: Schedule;
  /** A diffusion model's context of no words, where it brings that. */
  readonly nothing: Float32Array<ArrayBuffer> | null;
  readonly selftest: Selftest;
}

/** What must be as it is, where a sidecar says it: a file that wants something else computes something else. */
const FIXED = { range: [0, 1], layout: "NCHW", colour: "sRGB", mean_std_inside: true, direction_eps: 1e-6 };

/** Throws a GuidanceError that names `file` and the field that is wrong. */
export function readSidecar(text: string, file: string): Sidecar {
  const fail = (what: string): never => {
    throw new GuidanceError(file, `“${file}” cannot be used: ${what} Export the model again with tools/guidance, and keep both files as they are.`);
  };
  return sidecarOf(Fields.of(text, fail));
}

function sidecarOf(all: Fields): Sidecar {
  const kind = all.word("kind", KINDS);
  const sizes = Object.entries(SIZES[kind]).flatMap(([name, most]) => all.sizes(name, most));
  const contract = contractOf(kind, sizes);
  for (const [name, value] of Object.entries(FIXED)) {
    const said = all.maybe(name);
    if (said !== undefined && JSON.stringify(said) !== JSON.stringify(value)) all.fail(`'${name}' must be ${JSON.stringify(value)}.`);
  }
  const io = all.fields("io");
  const faults = portFaults(contract, { inputs: ports(io.fields("inputs")), outputs: ports(io.fields("outputs")) });
  if (faults.length) all.fail(`'io' does not say what its kind and sizes mean. ${faults[0]}`);
  return {
    kind,
    name: all.text("name"),
    origin: all.text("origin"),
    licence: all.text("licence"),
    weights: all.word("weights", ["fp32", "fp16", "int8"]),
    bytes: all.whole("bytes", 1, MOST_BYTES),
    sha256: all.matching("sha256", /^[0-9a-f]{64}$/, "64 lower-case hexadecimal digits"),
    contract,
    // A file's name and no path.
    tokenizer: all.maybe("tokenizer") === undefined ? null : all.matching("tokenizer", /^\w[\w.-]{0,199}$/, "the name of a file"),
    embeddings: all.maybe("embeddings") === undefined ? [] : all.list("embeddings", 0, MOST_PROMPTS).map((entry) => prompt(entry, sizes[1]!)),
    schedule: all.maybe("schedule") === undefined ? USUAL_SCHEDULE : schedule(all.fields("schedule")),
    nothing: kind !== "eps-v1" || all.maybe("nothing") === undefined ? null : Float32Array.from(all.numbers("nothing", sizes[3]! * sizes[4]!)),
    selftest: selftest(all.fields("selftest"), contract),
  };
}

function ports(side: Fields): Port[] {
  return side.names(16).map((name) => {
    const port = side.fields(name);
    const shape = port.values("shape", 8).map((d) => (d === BATCH || (typeof d === "number" && Number.isInteger(d)) ? d : port.fail("'shape' must hold sizes.")));
    return { name, dtype: port.text("dtype"), shape: shape as Shape };
  });
}

function schedule(all: Fields): Schedule {
  const kind = all.word("kind", ["linear", "scaled-linear", "cosine"]);
  const steps = all.whole("steps", 2, MOST_STEPS);
  if (kind === "cosine") return { ...USUAL_SCHEDULE, kind, steps };
  const from = all.number("from", LEAST_BETA, 1 - LEAST_BETA);
  return { kind, steps, from, to: all.number("to", from, 1 - LEAST_BETA) };
}

function prompt(entry: Fields, embed: number): Prompt {
  const vector = Float32Array.from(entry.numbers("vector", embed));
  if (!vector.some((v) => v !== 0)) entry.fail("'vector' is all zeros.");
  return { prompt: entry.text("prompt"), vector: madeUnit(vector, embed) };
}

function selftest(all: Fields, contract: Contract): Selftest {
  const batch = all.whole("batch", 1, isDynamic(contract) ? MOST_BATCH : 1);
  const tolerance = all.fields("tolerance");
  return {
    batch,
    tolerance: {
      relative: tolerance.number("relative", 0, LAXEST.relative),
      absolute: tolerance.number("absolute", 0, LAXEST.absolute),
      cosine: tolerance.number("cosine", LAXEST.cosine, 1),
    },
    cases: all.list("cases", 1, MOST_CASES).map((one) => {
      const [inputs, outputs] = [one.fields("inputs"), one.fields("outputs")];
      return {
        name: one.text("name"),
        inputs: Object.fromEntries(contract.inputs.map(({ name }) => [name, fill(inputs.fields(name))])),
        outputs: Object.fromEntries(contract.outputs.map(({ name, shape }) => [name, expected(outputs.fields(name), count(shape, batch))])),
      };
    }),
  };
}

function fill(how: Fields): Fill {
  const fill = how.word("fill", ["uniform", "signed", "unit", "constant", "count"]);
  if (fill === "constant") return { fill, value: how.number("value") };
  if (fill === "count") return { fill, first: how.whole("first", 0, 2 ** 20) };
  return { fill, seed: how.whole("seed", 0, 2 ** 31) };
}

function expected(output: Fields, numbers: number): Expected {
  if (numbers <= BUCKETS) return { values: output.numbers("values", numbers) };
  return { l2: output.number("l2", 0), sketch: output.numbers("sketch", BUCKETS) };
}
