/** The worker's networks: at most one of each kind is open. The page asks by calls, a fit by `opened`. */

import type { Answers, Asked, Kind } from "./contract";
import { briefly, GuidanceError } from "./fault";
import { fetched } from "./fetching";
import { MOST_TEXT } from "./fields";
import { refuseTooLarge } from "./memory";
import { factsOf, openModel, type About, type Facts, type Model } from "./model";
import type { Provider } from "./runtime";
import { Shelf, type Kept, type Texts } from "./shelf";
import { models, opened } from "./opened";
import { readSidecar, type Sidecar } from "./sidecar";
import { diffuserOf, seesPixels, type Diffuser } from "./diffusers";
import { networkOf, type Readers } from "./readers";
import { Tokenizer } from "./tokenizer";

/** Where a network is from: files as a person chose them, in any order; an .onnx of this site, with its .json beside it; the shelf. */
export type Source = { readonly files: readonly File[] } | { readonly url: string } | { readonly kept: string };

/** What `ask` is given: inputs by name, or texts for a text encoder with a tokenizer. */
export type Question = { readonly [K in Kind]: { readonly kind: K; readonly inputs: Asked[K] } }[Kind] | { readonly texts: readonly string[] };

export interface Opened extends About {
  /** Why it could not be kept, as a sentence; null if it is kept, or was not to be. */
  readonly unkept: string | null;
}

type Tell = (words: string, share: number) => void;

/** A network that is found, but not opened: its bytes come when they are wanted. */
interface Found {
  readonly file: string;
  readonly sidecar: Sidecar;
  readonly texts: Texts;
  readonly bytes: (tell: Tell, signal: AbortSignal) => Promise<Uint8Array<ArrayBuffer>>;
  readonly isKept: boolean;
}

const shelf = new Shelf();
const openings = new Set<AbortController>();
let last: Promise<unknown> = Promise.resolve();

let lent = (): GPUDevice | null => null;

/** Networks compute on the card that `card` says is in use, where there is one: two devices would take turns, and memory twice. */
export function lend(card: () => GPUDevice | null): void {
  lent = card;
}

/** What a network is, before anything of it is used. */
export async function look(source: Source): Promise<Facts> {
  return factsOf((await find(source)).sidecar);
}

/**
 * Opens a network in place of the one of its kind that is open; one after the other. The very one that is open stays so: to ask
 * before each use costs nothing, and a worker that was ended meanwhile opens it again.
 */
export function open(source: Source, prefer: Provider, keep: boolean, tell: Tell): Promise<Opened> {
  const opening = new AbortController();
  openings.add(opening);
  const mine = last.then(() => openNow(source, prefer, keep, tell, opening.signal)).finally(() => openings.delete(opening));
  last = mine.catch(() => undefined);
  return mine.catch((error: unknown) => {
    if (opening.signal.aborted) throw new GuidanceError("", "The model was not opened, as you asked.");
    if (error instanceof GuidanceError) throw error;
    console.error(error);
    // Most likely there is no memory left; the core is as well as before.
    throw new GuidanceError("", `The model could not be opened (${briefly(error)}). Close other tabs and try again, or take a smaller one.`);
  });
}

async function openNow(source: Source, prefer: Provider, keep: boolean, progress: Tell, signal: AbortSignal): Promise<Opened> {
  signal.throwIfAborted();
  const { file, sidecar, texts, bytes: read, isKept } = await find(source);
  const tokenizer = texts.tokenizer === null ? null : new Tokenizer(texts.tokenizer, sidecar.tokenizer ?? file);
  const contexts = texts.contexts ?? null;
  const context = sidecar.contract.inputs[0]!.shape[1];
  if (tokenizer && tokenizer.context !== context) {
    throw new GuidanceError(file, `The tokenizer of “${file}” makes ${tokenizer.context} tokens of a text, and it takes ${context}: it is another model's. Choose the one that was exported with it.`);
  }
  const now = models.get(sidecar.kind);
  if (now?.model.isFine && now.model.about.sha256 === sidecar.sha256 && now.prefer === prefer && (isKept || !keep)) {
    models.set(sidecar.kind, { ...now, tokenizer, contexts });
    return { ...now.model.about, unkept: null };
  }
  refuseTooLarge(file, sidecar);
  // Its memory is wanted.
  await close(sidecar.kind);
  const bytes = await read(progress, signal);
  signal.throwIfAborted();
  const model = await openModel({ file, bytes, sidecar }, { prefer, card: lent(), progress, signal });
  models.set(sidecar.kind, { model, tokenizer, contexts, prefer });
  const unkept = keep && !isKept ? await shelf.keep(file, new Blob([bytes]), texts, sidecar.sha256) : null;
  return { ...model.about, unkept };
}

/** One question to an open network; a GuidanceError if none is open that could answer. */
export async function ask(question: Question): Promise<Answers[Kind]> {
  const kind = "texts" in question ? "text-v1" : question.kind;
  const { model, tokenizer } = models.get(kind) ?? {};
  if (!model) throw new GuidanceError("", `No ${kind} model is open. Open one first.`);
  if (!("texts" in question)) return model.run(question.inputs);
  const { name } = model.about;
  if (!tokenizer) throw new GuidanceError(name, `“${name}” has no tokenizer, so it cannot read words. Choose its .tokenizer.json together with it.`);
  return model.run({ ids: tokenizer.rows(question.texts) });
}

/** Closes the open network of a kind. */
export async function close(kind: Kind): Promise<void> {
  const closing = models.get(kind)?.model;
  models.delete(kind);
  await closing?.release();
}

/** Closes all, and gives up what is being opened. */
export async function closeAll(): Promise<void> {
  for (const opening of openings) opening.abort();
  for (const kind of [...models.keys()]) await close(kind);
}

/** What is kept, after one of it was dropped. */
export async function kept(drop: string | null): Promise<Kept[]> {
  if (drop !== null) await shelf.drop(drop);
  return shelf.list();
}

/** What guides a run, opened if it is not. */
export async function guiding(sha256: string, progress: (share: number) => void): Promise<Readers | Diffuser> {
  const isOpen = ({ model }: { readonly model: Model }): boolean => model.isFine && model.about.sha256 === sha256;
  if (![...models.values()].some(isOpen)) await open({ kept: sha256 }, "webgpu", false, (_, share) => progress(share));
  const { model, contexts } = [...models.values()].find(isOpen)!;
  switch (model.about.kind) {
    case "guidance-v1":
      return readers(model as Model<"guidance-v1">);
    case "eps-v1":
      return diffuserOf(model as Model<"eps-v1">, seesPixels(model as Model<"eps-v1">) ? null : await encoder(progress), contexts);
    default:
      throw new GuidanceError("", "That network cannot guide. Choose another, or take the small ones that come with the page.");
  }
}

/** The encoder that is open, or the newest that is kept. */
async function encoder(progress: (share: number) => void): Promise<Model<"vjp-v1">> {
  const kept = opened("vjp-v1")?.isFine ? null : (await shelf.list()).find(({ kind }) => kind === "vjp-v1");
  if (kept) await open({ kept: kept.sha256 }, "webgpu", false, (_, share) => progress(share));
  const model = opened("vjp-v1");
  if (!model) throw new GuidanceError("", "The diffusion model sees pictures through an encoder, and none is open. Open its encoder, too.");
  return model;
}

/** By prompts of its own file, or by an open text encoder. */
function readers(model: Model<"guidance-v1">): Readers {
  const { embeddings } = model.sidecar;
  const texts = models.get("text-v1");
  return {
    networks: [networkOf(model)],
    async vector(words) {
      const known = embeddings.find(({ prompt }) => prompt.toLowerCase() === words.toLowerCase());
      if (known) return Float32Array.from(known.vector);
      return texts ? (await texts.model.run({ ids: texts.tokenizer!.rows([words]) }) as Answers["text-v1"]).embedding : null;
    },
    instead: () => (embeddings.length ? `Its file knows: ${embeddings.map(({ prompt }) => prompt).slice(0, 8).join(", ")}.` : "Open the text network that belongs to it, too."),
  };
}

function find(source: Source): Promise<Found> {
  if ("kept" in source) return onShelf(source.kept);
  return "files" in source ? inFiles(source.files) : onSite(source.url);
}

async function onShelf(sha256: string): Promise<Found> {
  const found = await shelf.find(sha256);
  if (!found) throw new GuidanceError("", "The model is not kept any more. Choose its files again.");
  const { file, parsed, bytes, sidecar, tokenizer, contexts = null } = found;
  return { file, sidecar: parsed, texts: { sidecar, tokenizer, contexts }, bytes, isKept: true };
}

/** Which file is which is told by what is in it. */
async function inFiles(files: readonly File[]): Promise<Found> {
  const isText = ({ name }: File): boolean => /\.json$/i.test(name);
  const model = files.find((file) => !isText(file));
  if (!model) throw new GuidanceError("", "There is no model among these files. Choose the .onnx and the .json that lies beside it.");
  const texts: { readonly name: string; readonly text: string }[] = [];
  for (const file of files.filter(isText)) if (file.size <= MOST_TEXT) texts.push({ name: file.name, text: await file.text() });
  const known = (kind: string): (typeof texts)[number] | undefined => texts.find(({ text }) => new RegExp(`"kind":\\s*"${kind}"`).test(text.slice(0, 1000)));
  const [tokenizer, contexts] = [known("clip-bpe"), known("contexts-v1")];
  const sidecar = texts.find((text) => text !== tokenizer && text !== contexts);
  if (!sidecar) throw new GuidanceError(model.name, `“${model.name}” lacks its description. Choose the .json that lies beside it, too.`);
  const read = async (tell: Tell): Promise<Uint8Array<ArrayBuffer>> => {
    tell("Reading the file…", 0);
    return new Uint8Array(
      await model.arrayBuffer().catch(() => {
        throw new GuidanceError(model.name, `“${model.name}” could not be read. It may have been moved, or be too large for this browser; choose it again.`);
      }),
    );
  };
  return {
    file: model.name,
    sidecar: readSidecar(sidecar.text, sidecar.name),
    texts: { sidecar: sidecar.text, tokenizer: tokenizer?.text ?? null, contexts: contexts?.text ?? null },
    bytes: read,
    isKept: false,
  };
}

async function onSite(url: string): Promise<Found> {
  const nameOf = (address: string): string => decodeURIComponent(new URL(address, self.location.href).pathname.split("/").at(-1)!).slice(0, 200);
  const textAt = async (address: string): Promise<string> => new TextDecoder().decode(await fetched(address, { name: nameOf(address), most: MOST_TEXT }));
  const beside = url.replace(/\.onnx$/, ".json");
  const text = await textAt(beside);
  const sidecar = readSidecar(text, nameOf(beside));
  // Not fetched again if it is here.
  if (await shelf.find(sidecar.sha256)) return onShelf(sidecar.sha256);
  const tokenizer = sidecar.tokenizer === null ? null : await textAt(new URL(sidecar.tokenizer, new URL(url, self.location.href)).href);
  const file = nameOf(url);
  return {
    file,
    sidecar,
    texts: { sidecar: text, tokenizer },
    bytes: (tell, signal) => fetched(url, { name: file, most: sidecar.bytes, exactly: sidecar.bytes, signal, progress: (share) => tell("Fetching the model…", share) }),
    isKept: false,
  };
}
