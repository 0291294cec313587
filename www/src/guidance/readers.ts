/** Networks that see pictures where words lie too. */

import type { Model } from "./model";

type Floats = Float32Array<ArrayBuffer>;

/** As the core calls it: n rows of pictures of `size` px, `[n, 3, size, size]`, and of vectors of `embed` numbers. */
export interface Network {
  readonly size: number;
  readonly embed: number;
  run(batch: { images: Floats; source: Floats; target: Floats; weight: Floats }): Promise<{
    readonly loss: number;
    readonly grad: Floats;
    readonly cos: Floats;
    readonly embedding: Floats;
  }>;
}

/** Whoever knows words. */
export interface Knowing {
  /** Unit, but for a diffusion model; null for words that are not known. */
  vector(words: string): Promise<Floats | null>;
  /** What might be said instead, a sentence or nothing. */
  instead(words: string): string;
}

export interface Readers extends Knowing {
  /** All of one space of vectors. */
  readonly networks: readonly Network[];
}

/** A model as the core calls it. */
export function networkOf(model: Model<"guidance-v1">): Network {
  const [image, vector] = model.sidecar.contract.inputs;
  const [size, embed] = [image!.shape[2] as number, vector!.shape[1] as number];
  return {
    size,
    embed,
    async run({ images: image, source, target, weight }) {
      const { loss, ...rest } = await model.run({ image, source, target, weight });
      return { ...rest, loss: loss[0]! };
    },
  };
}
