/**
 * The kinds of networks, and what each promises by name, type and shape; `tools/guidance` writes the first four.
 *
 * | kind | inputs | outputs |
 * |---|---|---|
 * | guidance-v1 | image[batch,3,S,S], source[batch,E], target[batch,E], weight[batch] | loss[], grad like image, cos[batch], embedding[batch,E] |
 * | text-v1 | ids[batch,context] int32 | embedding[batch,E] |
 * | vjp-v1 | image[1,3,H,W], cotangent like latent | latent[1,C,h,w], grad like image |
 * | eps-v1 | x_t[batch,C,h,w], t[batch], context[batch,N,D] | eps like x_t |
 * | mask-v1 | image[1,3,H,W] | mask[1,1,H,W], 0 (ground) to 1 (object) |
 * | depth-v1 | image[1,3,H,W] | depth[1,1,H,W], larger is nearer |
 *
 * Everything but `ids` is float32. Images are sRGB in 0..1, channels first, red first, rows from the top.
 */

export const KINDS = ["guidance-v1", "text-v1", "vjp-v1", "eps-v1", "mask-v1", "depth-v1"] as const;
export type Kind = (typeof KINDS)[number];

type Floats = Float32Array<ArrayBuffer>;

/** What a network of each kind is asked: its inputs, row by row. All batches of one question are equal. */
export interface Asked {
  "guidance-v1": { readonly image: Floats; readonly source: Floats; readonly target: Floats; readonly weight: Floats };
  "text-v1": { readonly ids: Int32Array<ArrayBuffer> };
  "vjp-v1": { readonly image: Floats; readonly cotangent: Floats };
  "eps-v1": { readonly x_t: Floats; readonly t: Floats; readonly context: Floats };
  "mask-v1": { readonly image: Floats };
  "depth-v1": { readonly image: Floats };
}

/** What it answers: its outputs, each a buffer of its own. */
export interface Answers {
  "guidance-v1": { readonly loss: Floats; readonly grad: Floats; readonly cos: Floats; readonly embedding: Floats };
  "text-v1": { readonly embedding: Floats };
  "vjp-v1": { readonly latent: Floats; readonly grad: Floats };
  "eps-v1": { readonly eps: Floats };
  "mask-v1": { readonly mask: Floats };
  "depth-v1": { readonly depth: Floats };
}

/** A dimension that may be any number from 1. */
export const BATCH = "batch";
export type Shape = readonly (number | typeof BATCH)[];

/** One input or output. */
export interface Port {
  readonly name: string;
  readonly dtype: string;
  readonly shape: Shape;
}

export interface Contract {
  readonly inputs: readonly Port[];
  readonly outputs: readonly Port[];
}

/** How many numbers each size of a kind is, in the order that `contractOf` takes them, and the most that each may be. */
export const SIZES: Readonly<Record<Kind, Readonly<Record<string, readonly number[]>>>> = {
  "guidance-v1": { size: [1024], embed: [4096] },
  "text-v1": { context: [1024], embed: [4096] },
  "vjp-v1": { image: [1024, 1024], latent: [64, 512, 512] },
  "eps-v1": { latent: [64, 512, 512], context: [1024, 4096] },
  "mask-v1": { image: [512, 512] },
  "depth-v1": { image: [512, 512] },
};

const port = (name: string, shape: Shape, dtype = "float32"): Port => ({ name, dtype, shape });

/** A kind's contract, with its sizes (all of them, one after the other) filled in. */
export function contractOf(kind: Kind, sizes: readonly number[]): Contract {
  const [a = 1, b = 1, c = 1, d = 1, e = 1] = sizes;
  switch (kind) {
    case "guidance-v1": {
      const [image, rows, each]: Shape[] = [[BATCH, 3, a, a], [BATCH, b], [BATCH]];
      return {
        inputs: [port("image", image!), port("source", rows!), port("target", rows!), port("weight", each!)],
        outputs: [port("loss", []), port("grad", image!), port("cos", each!), port("embedding", rows!)],
      };
    }
    case "text-v1":
      return { inputs: [port("ids", [BATCH, a], "int32")], outputs: [port("embedding", [BATCH, b])] };
    case "vjp-v1":
      return {
        inputs: [port("image", [1, 3, a, b]), port("cotangent", [1, c, d, e])],
        outputs: [port("latent", [1, c, d, e]), port("grad", [1, 3, a, b])],
      };
    case "eps-v1":
      return {
        inputs: [port("x_t", [BATCH, a, b, c]), port("t", [BATCH]), port("context", [BATCH, d, e])],
        outputs: [port("eps", [BATCH, a, b, c])],
      };
    case "mask-v1":
    case "depth-v1":
      return { inputs: [port("image", [1, 3, a, b])], outputs: [port(kind === "mask-v1" ? "mask" : "depth", [1, 1, a, b])] };
  }
}

/** A shape for one batch size. */
export const sized = (shape: Shape, batch: number): number[] => shape.map((d) => (d === BATCH ? batch : d));

/** How many numbers that is. */
export const count = (shape: Shape, batch: number): number => sized(shape, batch).reduce((product, d) => product * d, 1);

export const isDynamic = ({ inputs }: Contract): boolean => inputs.some(({ shape }) => shape.includes(BATCH));

/** A sentence for each port that a file lacks, has too many of, or has otherwise. */
export function portFaults(contract: Contract, found: Contract): string[] {
  return (["inputs", "outputs"] as const).flatMap((side) => {
    const word = side.slice(0, -1);
    const others = new Map(found[side].map((port) => [port.name, port]));
    const faults = contract[side].flatMap((port) => {
      const other = others.get(port.name);
      others.delete(port.name);
      if (!other) return [`The ${word} ${told(port)} is missing.`];
      return other.dtype === port.dtype && alike(port.shape, other.shape) ? [] : [`The ${word} is ${told(other)} and must be ${told(port)}.`];
    });
    return [...faults, ...[...others.values()].map((port) => `The ${word} ${told(port)} is not in the contract.`)];
  });
}

const alike = (wanted: Shape, found: Shape): boolean => wanted.length === found.length && wanted.every((d, i) => d === found[i]);

const told = ({ name, dtype, shape }: Port): string => `${name.slice(0, 40)}[${shape.join(", ")}] ${dtype}`;
