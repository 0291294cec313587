/** The small networks that come with the page. Fetched when somebody wants them; then they stay. */

import aModel from "../../../tools/iconnet/weights/iconnet-a.onnx?url";
import aSidecar from "../../../tools/iconnet/weights/iconnet-a.json?url";
import bModel from "../../../tools/iconnet/weights/iconnet-b.onnx?url";
import bSidecar from "../../../tools/iconnet/weights/iconnet-b.json?url";
import { PLAINER, wordTable } from "./icon-words";
import type { Model } from "./model";
import { networkOf, type Readers } from "./readers";
import { once, opened } from "./shipped";

export const icons = once(async (progress): Promise<Readers> => {
  const words = await wordTable();
  const models: Model<"guidance-v1">[] = [];
  for (const [name, model, sidecar] of [["iconnet-a", aModel, aSidecar], ["iconnet-b", bModel, bSidecar]] as const) {
    // They are too small for a card: it would wait for its orders most of the time.
    models.push(await opened({ kind: "guidance-v1", name, model, sidecar, prefer: "wasm" }, (part) => progress((models.length + part) / 2)));
  }
  return {
    networks: models.map(networkOf),
    vector: async (text) => words.meaning(text),
    instead: () => PLAINER,
  };
});
