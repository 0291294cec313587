/**
 * onnxruntime-web: two builds of it lie beside the page as they came, a script and a wasm module each, and one is fetched when
 * the first network is opened.
 */

import type { InferenceSession, Tensor, TensorConstructor, Env, InferenceSessionFactory } from "onnxruntime-web";
import plainScript from "../../node_modules/onnxruntime-web/dist/ort.wasm.bundle.min.mjs?url";
import gpuScript from "../../node_modules/onnxruntime-web/dist/ort.webgpu.bundle.min.mjs?url";
import gpuModule from "../../node_modules/onnxruntime-web/dist/ort-wasm-simd-threaded.asyncify.wasm?url";
import plainModule from "../../node_modules/onnxruntime-web/dist/ort-wasm-simd-threaded.wasm?url";
import { BATCH, type Contract, type Port } from "./contract";
import { briefly, GuidanceError } from "./fault";
import { fetched } from "./fetching";
import type { Numbers } from "./selftest";

/** What computes: a graphics card, or the processor. */
export type Provider = "webgpu" | "wasm";

interface Ort {
  readonly env: Env;
  readonly InferenceSession: InferenceSessionFactory;
  readonly Tensor: TensorConstructor;
}

/** The build for WebGPU computes on the processor too, and is nearly twice as large. `bytes` are for progress alone. */
const BUILDS: Readonly<Record<Provider, { readonly script: string; readonly module: string; readonly bytes: number }>> = {
  wasm: { script: plainScript, module: plainModule, bytes: 14_239_897 },
  webgpu: { script: gpuScript, module: gpuModule, bytes: 26_781_914 },
};
const MOST_BYTES = 64e6;
const MOST_THREADS = 4;

const loading = new Map<Provider, Promise<Runtime>>();

/** The build for a provider, once; a failure is forgotten, so that the next call tries again. */
export function runtimeFor(provider: Provider, progress: (share: number) => void, signal?: AbortSignal): Promise<Runtime> {
  const known = loading.get(provider);
  if (known) return known;
  const runtime = load(provider, progress, signal);
  loading.set(provider, runtime);
  runtime.catch(() => loading.delete(provider));
  return runtime;
}

async function load(provider: Provider, progress: (share: number) => void, signal?: AbortSignal): Promise<Runtime> {
  const { script, module, bytes } = BUILDS[provider];
  const name = "the guidance runtime";
  // Fetched here and not there, for its progress and its end; and there a failure would be for good.
  const wasm = await fetched(module, { name, most: MOST_BYTES, about: bytes, signal, progress });
  try {
    const ort = (await import(/* @vite-ignore */ script)) as Ort;
    ort.env.logLevel = "error";
    ort.env.wasm.wasmBinary = wasm.buffer;
    ort.env.wasm.numThreads = self.crossOriginIsolated ? Math.max(1, Math.min(MOST_THREADS, navigator.hardwareConcurrency >> 1)) : 1;
    return new Runtime(ort);
  } catch (error) {
    console.error(error);
    throw new GuidanceError(name, "The guidance runtime could not be loaded. Check the connection and try again.");
  }
}

/** A graphics card to compute on. */
export interface Card {
  readonly device: GPUDevice;
  /** Whether others compute on it too: then it is not ours to destroy. */
  readonly lent: boolean;
}

/** Of what a card can do, what makes the runtime faster. */
const FEATURES: readonly GPUFeatureName[] = ["shader-f16", "subgroups", "timestamp-query"];

/**
 * The card that `lent` says is in use already, else one with all that it can hold; null where there is none. Asked for here, for
 * onnxruntime waits for ever for one that is refused.
 */
export async function graphicsCard(lent: GPUDevice | null): Promise<Card | null> {
  if (lent) return { device: lent, lent: true };
  const { gpu } = navigator as { readonly gpu?: GPU };
  try {
    const adapter = await gpu?.requestAdapter({ powerPreference: "high-performance" });
    if (!adapter) return null;
    const requiredLimits: Record<string, number> = {};
    // They are their prototype's.
    for (const name in adapter.limits) requiredLimits[name] = adapter.limits[name as Exclude<keyof GPUSupportedLimits, "__brand">];
    return { device: await adapter.requestDevice({ requiredFeatures: FEATURES.filter((feature) => adapter.features.has(feature)), requiredLimits }), lent: false };
  } catch (error) {
    console.warn(error);
    return null;
  }
}

export class Runtime {
  private last: Promise<unknown> = Promise.resolve();

  constructor(private readonly ort: Ort) {}

  /** On a card, which it takes over unless it is lent, or the processor. Throws what onnxruntime throws. Cannot be stopped on its way. */
  async open(bytes: Uint8Array, card: Card | null): Promise<Session> {
    const options: InferenceSession.SessionOptions = { executionProviders: [card ? { name: "webgpu", device: card.device } : "wasm"], logSeverityLevel: 3 };
    try {
      return new Session(await this.inTurn(() => this.ort.InferenceSession.create(bytes, options)), this, card);
    } catch (error) {
      giveBack(card);
      throw error;
    }
  }

  tensor(numbers: Numbers, shape: readonly number[]): Tensor {
    return numbers instanceof Int32Array ? new this.ort.Tensor("int32", numbers, shape) : new this.ort.Tensor("float32", numbers, shape);
  }

  /** One after the other: the module can wait for a graphics card at one place only. */
  inTurn<T>(work: () => Promise<T>): Promise<T> {
    const mine = this.last.then(work, work);
    this.last = mine.catch(() => undefined);
    return mine;
  }
}

/** An opened file. */
export class Session {
  constructor(
    private readonly session: InferenceSession,
    private readonly runtime: Runtime,
    private readonly card: Card | null,
  ) {}

  /** Names, types and shapes as the file has them; any symbol is a batch. */
  get contract(): Contract {
    const { inputMetadata, outputMetadata } = this.session;
    return { inputs: inputMetadata.map(portOf), outputs: outputMetadata.map(portOf) };
  }

  /** All outputs, each in a buffer of its own. Nothing of a run stays behind in the runtime. */
  run(feeds: Readonly<Record<string, Numbers>>, shapes: Readonly<Record<string, readonly number[]>>): Promise<Record<string, Numbers>> {
    return this.runtime.inTurn(async () => {
      const given = Object.fromEntries(Object.entries(feeds).map(([name, numbers]) => [name, this.runtime.tensor(numbers, shapes[name]!)]));
      const found: InferenceSession.ReturnType = await this.session.run(given);
      const answers = Object.fromEntries(Object.entries(found).map(([name, tensor]) => [name, (tensor.data as Float32Array).slice() as Numbers]));
      for (const tensor of [...Object.values(given), ...Object.values(found)]) tensor.dispose();
      return answers;
    });
  }

  async release(): Promise<void> {
    await this.runtime.inTurn(() => this.session.release()).catch((error: unknown) => console.error(briefly(error)));
    giveBack(this.card);
  }
}

function giveBack(card: Card | null): void {
  if (card && !card.lent) card.device.destroy();
}

function portOf(metadata: InferenceSession.ValueMetadata): Port {
  const { name } = metadata;
  if (!metadata.isTensor) return { name, dtype: "no tensor", shape: [] };
  return { name, dtype: metadata.type, shape: metadata.shape.map((d) => (typeof d === "number" ? d : BATCH)) };
}
