/** Diffusion models that know words, and what makes their latents. */

import { readContexts } from "./contexts";
import { GuidanceError } from "./fault";
import { PLAINER, wordTable } from "./icon-words";
import type { Model } from "./model";
import type { Knowing } from "./readers";
import type { Schedule } from "./sidecar";

type Floats = Float32Array<ArrayBuffer>;

/** As the core calls it: n rows of `shape`, and of `context` numbers each; times are 1 to the schedule's steps. */
export interface Denoiser {
  readonly shape: readonly [channels: number, rows: number, columns: number];
  readonly context: number;
  run(batch: { x_t: Floats; t: number; contexts: Floats }): Promise<{ readonly eps: Floats }>;
}

/** Of pictures of `size` px. */
export interface Encoder {
  readonly size: number;
  run(given: { image: Floats; cotangent: Floats }): Promise<{ readonly latent: Floats; readonly grad: Floats }>;
}

export interface Diffuser extends Knowing {
  readonly denoiser: Denoiser;
  /** Null where the model sees pixels. */
  readonly encoder: Encoder | null;
  readonly schedule: Schedule;
  /** The context of no words. */
  readonly nothing: Floats;
}

/** Of a model, with its file of contexts where it has one. A GuidanceError where it lacks words, or has another's encoder. */
export async function diffuserOf(model: Model<"eps-v1">, encoder: Model<"vjp-v1"> | null, contexts: string | null): Promise<Diffuser> {
  const { sidecar } = model;
  const [seen, , context] = sidecar.contract.inputs;
  const [shape, rows] = [seen!.shape.slice(1) as [number, number, number], context!.shape.slice(1) as [number, number]];
  const each = shape.reduce((a, b) => a * b);
  const denoiser: Denoiser = {
    shape,
    context: rows[0] * rows[1],
    // The file counts times from 0.
    run: ({ x_t, t, contexts: context }) => model.run({ x_t, t: new Float32Array(x_t.length / each).fill(t - 1), context }),
  };
  return { denoiser, encoder: encoder && encoderOf(encoder, shape), schedule: sidecar.schedule, ...(await wordsOf(model, rows, contexts)) };
}

/** Whether a model sees pictures as they are, grey or coloured. */
export const seesPixels = ({ sidecar }: Pick<Model<"eps-v1">, "sidecar">): boolean => {
  const [, channels, rows, columns] = sidecar.contract.inputs[0]!.shape;
  return (channels === 1 || channels === 3) && rows === columns;
};

function encoderOf(model: Model<"vjp-v1">, shape: readonly number[]): Encoder {
  const { name } = model.about;
  const [image, latent] = model.sidecar.contract.inputs;
  const made = latent!.shape.slice(1);
  const fail = (what: string): never => {
    throw new GuidanceError(name, `“${name}” ${what}`);
  };
  if (made.join() !== shape.join()) fail(`makes latents of ${made.join(" x ")}, and the diffusion model takes ${shape.join(" x ")}. Open the encoder that belongs to it.`);
  if (image!.shape[2] !== image!.shape[3]) fail("takes no square pictures. Export it again with square ones.");
  return { size: image!.shape[2] as number, run: (given) => model.run(given) };
}

/** As the model was told words: by its file, or by the rows of the table that comes with the page. */
async function wordsOf({ sidecar, about: { name } }: Model<"eps-v1">, rows: readonly [number, number], contexts: string | null): Promise<Knowing & Pick<Diffuser, "nothing">> {
  if (contexts !== null) {
    const known = readContexts(contexts, name, rows);
    const find = (words: string): Floats | null => known.find(({ prompt }) => prompt.toLowerCase() === words.toLowerCase())?.values ?? null;
    const nothing = sidecar.nothing ?? find("");
    if (!nothing) throw new GuidanceError(name, `“${name}” does not say what no words are: its file of contexts needs an empty prompt.`);
    const prompts = known.map(({ prompt }) => prompt).filter(Boolean);
    return { nothing, vector: async (words) => find(words), instead: () => `Its file knows: ${prompts.slice(0, 8).join(", ")}.` };
  }
  const table = await wordTable();
  if (rows[0] !== 1 || rows[1] !== table.embed) throw new GuidanceError(name, `“${name}” lacks its words. Choose its file of contexts together with it.`);
  const nothing = sidecar.nothing ?? Float32Array.from({ length: table.embed }, (_, i) => (i === table.embed - 1 ? 1 : 0));
  return { nothing, vector: async (words) => table.meaning(words), instead: () => PLAINER };
}
