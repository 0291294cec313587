/** The small networks that come with the page. Fetched when somebody wants them; then they stay. */

import aModel from "../../../tools/iconnet/weights/iconnet-a.onnx?url";
import aSidecar from "../../../tools/iconnet/weights/iconnet-a.json?url";
import bModel from "../../../tools/iconnet/weights/iconnet-b.onnx?url";
import bSidecar from "../../../tools/iconnet/weights/iconnet-b.json?url";
import { fetched } from "./fetching";
import { textAt, wordTable } from "./icon-words";
import { openModel, type Model } from "./model";
import { networkOf, type Readers } from "./readers";
import { readSidecar } from "./sidecar";

const MOST_BYTES = 8e6;

let known: Promise<Readers> | null = null;

/** A failure is forgotten, so that the next run tries again. */
export function icons(progress: (share: number) => void): Promise<Readers> {
  known ??= open(progress).catch((error: unknown) => {
    known = null;
    throw error;
  });
  return known;
}

async function open(progress: (share: number) => void): Promise<Readers> {
  const words = await wordTable();
  const models: Model<"guidance-v1">[] = [];
  for (const [name, model, sidecar] of [["iconnet-a", aModel, aSidecar], ["iconnet-b", bModel, bSidecar]] as const) {
    const share = (part: number): void => progress((models.length + part) / 2);
    const described = readSidecar(await textAt(sidecar, `${name}.json`), `${name}.json`);
    const bytes = await fetched(model, { name, most: MOST_BYTES, exactly: described.bytes, progress: (part) => share(0.5 * part) });
    // They are too small for a card: it would wait for its orders most of the time.
    models.push((await openModel({ file: name, bytes, sidecar: described }, { prefer: "wasm", progress: (_, part) => share(0.5 + 0.5 * part) })) as Model<"guidance-v1">);
  }
  return {
    networks: models.map(networkOf),
    vector: async (text) => words.vector(text) ?? words.vector(words.meant(text, 1)[0] ?? ""),
    instead: () => "Try a plainer word for it.",
  };
}
