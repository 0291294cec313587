/** A network from a file, checked before it is used and after each answer. */

import { sha256Of } from "./checksum";
import { count, portFaults, sized, type Answers, type Asked, type Kind } from "./contract";
import { briefly, GuidanceError, size } from "./fault";
import { memoryOf, refuseTooLarge } from "./memory";
import { outlineOf } from "./onnx";
import { graphicsCard, runtimeFor, type Card, type Provider, type Runtime, type Session } from "./runtime";
import { isFinite, selftestFault, type Numbers } from "./selftest";
import type { Sidecar } from "./sidecar";

export interface ModelFiles {
  /** The name of the ONNX file. */
  readonly file: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly sidecar: Sidecar;
}

export interface Opening {
  /** What it should be computed with; where that fails its self-test, it is the processor. */
  readonly prefer: Provider;
  /** A graphics card that is in use already, if there is one. */
  readonly card?: GPUDevice | null;
  /** What is being done, and how far that is, 0 to 1. */
  progress?(words: string, share: number): void;
  /** Gives up between two steps, with an AbortError; nothing stays open. */
  readonly signal?: AbortSignal;
}

/** What a person should know of a network. All of it is plain text from the sidecar, or found out here. */
export interface Facts {
  readonly kind: Kind;
  readonly name: string;
  readonly licence: string;
  readonly origin: string;
  readonly sha256: string;
  /** Of its file. */
  readonly bytes: number;
  /** Bytes that it takes while it is opened, about. */
  readonly memory: number;
  /** Prompts that it knows the vectors of. */
  readonly prompts: readonly string[];
}

export interface About extends Facts {
  readonly provider: Provider;
  /** Why that is not what was preferred, as a sentence. */
  readonly note: string | null;
}

export function factsOf(sidecar: Sidecar): Facts {
  const { kind, name, licence, origin, sha256, bytes, embeddings } = sidecar;
  return { kind, name, licence, origin, sha256, bytes, memory: memoryOf(sidecar), prompts: embeddings.map(({ prompt }) => prompt) };
}

export class Model<K extends Kind = Kind> {
  private gaveUp = false;

  private constructor(
    readonly sidecar: Sidecar<K>,
    readonly about: About,
    private session: Session | null,
  ) {}

  /** For `openModel`, which has checked it. */
  static of(sidecar: Sidecar, about: About, session: Session): Model {
    return new Model(sidecar, about, session);
  }

  /**
   * Any number of rows from 1, where the contract has a batch; all inputs must agree on it. A GuidanceError for what does not
   * fit the contract, for answers that are not finite, and where the model was released or the runtime gives up.
   */
  async run(asked: Asked[K]): Promise<Answers[K]> {
    const { session, sidecar } = this;
    const fail = (what: string): never => {
      throw new GuidanceError(sidecar.name, `“${sidecar.name}” ${what}`);
    };
    if (!session) return fail("is closed. Open it again.");
    const answers = await ask(session, sidecar, asked as Readonly<Record<string, Numbers>>, fail).catch((error: unknown) => {
      if (error instanceof GuidanceError) throw error;
      this.gaveUp = true;
      return fail(`could not be computed (${briefly(error)}). Open it again, or take a smaller model.`);
    });
    const wrong = Object.entries(answers).find(([, numbers]) => !isFinite(numbers));
    if (wrong) return fail(`answered with numbers that are not finite (${wrong[0]}). Nothing was done with them; look at what it was given, or take another model.`);
    return answers as unknown as Answers[K];
  }

  /** False once it was released, or the runtime gave up on it: its graphics card was lost, or memory ran out. */
  get isFine(): boolean {
    return this.session !== null && !this.gaveUp;
  }

  /** Leaves its memory to the next one; a wasm memory never shrinks, so only the worker's end gives it back. */
  async release(): Promise<void> {
    const { session } = this;
    this.session = null;
    await session?.release();
  }
}

/** Runs a session on inputs that fit its contract. */
async function ask(session: Session, { contract }: Sidecar, asked: Readonly<Record<string, Numbers>>, fail: (what: string) => never): Promise<Record<string, Numbers>> {
  const batches = contract.inputs.map(({ name, shape, dtype }) => {
    const numbers = asked[name];
    if (!(numbers instanceof (dtype === "int32" ? Int32Array : Float32Array))) return fail(`was not given ${name}.`);
    const batch = numbers.length / count(shape, 1);
    return Number.isInteger(batch) && batch >= 1 && (batch === 1 || count(shape, 2) > count(shape, 1)) ? batch : fail(`was given ${numbers.length} numbers as ${name}, which are no whole rows.`);
  });
  const [batch] = batches;
  if (batches.some((other) => other !== batch)) fail(`was given inputs of different batches (${batches.join(", ")}).`);
  const shapes = Object.fromEntries(contract.inputs.map(({ name, shape }) => [name, sized(shape, batch!)]));
  const answers = await session.run(Object.fromEntries(contract.inputs.map(({ name }) => [name, asked[name]!])), shapes);
  for (const { name, shape } of contract.outputs) {
    const [given, wanted] = [answers[name]?.length, count(shape, batch!)];
    if (given !== wanted) fail(`answered ${given} numbers as ${name}, where there should be ${wanted}. Export it again with tools/guidance.`);
  }
  return answers;
}

/**
 * Opens a network: is it whole and the one that its sidecar describes, does it fit into memory, does it keep its contract, and
 * is it computed rightly here? A GuidanceError says what is not so.
 */
export async function openModel(files: ModelFiles, { prefer, card: lent = null, progress = () => undefined, signal }: Opening): Promise<Model> {
  const { sidecar } = files;
  refuseTooLarge(files.file, sidecar);
  progress("Checking the file…", 0);
  await checkFile(files);
  signal?.throwIfAborted();
  const card = prefer === "webgpu" ? await graphicsCard(lent) : null;
  let provider: Provider = card ? "webgpu" : "wasm";
  let note = provider === prefer ? null : "This browser gives no graphics card, so the processor is used.";
  const runtime = await runtimeFor(provider, (share) => progress("Fetching the guidance runtime…", share), signal);
  signal?.throwIfAborted();
  let session: Session;
  try {
    session = await opened(runtime, card, files, progress);
  } catch (error) {
    if (!card) throw error;
    signal?.throwIfAborted();
    // A card that computes a file wrongly does it without an error: the self-test tells.
    note = `The graphics card cannot be used for it, so the processor is: ${briefly(error)}`;
    provider = "wasm";
    session = await opened(runtime, null, files, progress);
  }
  if (signal?.aborted) {
    await session.release();
    signal.throwIfAborted();
  }
  return Model.of(sidecar, { ...factsOf(sidecar), provider, note }, session);
}

/** A session that keeps the contract and passes the self-test. */
async function opened(runtime: Runtime, card: Card | null, { file, bytes, sidecar }: ModelFiles, progress: (words: string, share: number) => void): Promise<Session> {
  const fail = (what: string): never => {
    throw new GuidanceError(file, `“${file}” ${what}`);
  };
  progress("Opening the model…", 0);
  const session = await runtime.open(bytes, card).catch((error: unknown) => fail(`cannot be opened (${briefly(error)}). Export it again with tools/guidance.`));
  try {
    const faults = portFaults(sidecar.contract, session.contract);
    if (faults.length) fail(`is not what its description says. ${faults[0]} Export it again with tools/guidance.`);
    progress("Trying the model…", 0);
    const fault = await selftestFault(sidecar.selftest, sidecar.contract, (feeds) => ask(session, sidecar, feeds, fail)).catch((error: unknown) => {
      if (error instanceof GuidanceError) throw error;
      return `it could not be computed (${briefly(error)})`;
    });
    if (fault) fail(`fails its self-test: ${fault}. It is not used; export it again with tools/guidance, or take another model.`);
    return session;
  } catch (error) {
    await session.release();
    throw error;
  }
}

/** That the bytes are a whole ONNX file, and the very one that the sidecar is of. */
async function checkFile({ file, bytes, sidecar }: ModelFiles): Promise<void> {
  const fail = (what: string): never => {
    throw new GuidanceError(file, `“${file}” ${what}`);
  };
  const outline = outlineOf(bytes);
  if (!outline) return fail("is not a whole ONNX file. Choose the .onnx that tools/guidance wrote, with the .json beside it.");
  if (outline.external) fail("lacks its weights: they lie in another file. Export it again with its weights inside, as tools/guidance does.");
  if (bytes.length !== sidecar.bytes) fail(`has ${size(bytes.length)} and its description says ${size(sidecar.bytes)}: it is damaged, or belongs to another .json. Fetch both again.`);
  if ((await sha256Of(bytes, file)) !== sidecar.sha256) fail("is not the file that its description is of (their checksums differ): it is damaged, or belongs to another .json. Fetch both again.");
}
