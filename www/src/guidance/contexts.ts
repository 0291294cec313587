/**
 * Words as a diffusion model was told them, from a file beside it: {kind: "contexts-v1", shape: [N, D], contexts: [{prompt, values}]},
 * the values N * D float32, the lowest byte first, in base64. It comes from anywhere.
 */

import { SIZES } from "./contract";
import { GuidanceError } from "./fault";
import { Fields } from "./fields";

const MOST_CONTEXTS = 1024;

export interface Context {
  readonly prompt: string;
  readonly values: Float32Array<ArrayBuffer>;
}

/** Of a model that takes `shape`; a GuidanceError says what else `file` is. */
export function readContexts(text: string, file: string, shape: readonly number[]): readonly Context[] {
  const all = Fields.of(text, (what) => {
    throw new GuidanceError(file, `“${file}” is no file of contexts for this model: ${what} Make it again with the model's own text encoder.`);
  });
  all.word("kind", ["contexts-v1"]);
  const [rows, numbers] = all.sizes("shape", SIZES["eps-v1"]["context"]!);
  if (rows !== shape[0] || numbers !== shape[1]) all.fail(`'shape' is ${rows}, ${numbers}, and the model takes ${shape.join(", ")}.`);
  return all.list("contexts", 1, MOST_CONTEXTS).map((one) => ({ prompt: one.text("prompt"), values: one.floats("values", rows! * numbers!) }));
}
