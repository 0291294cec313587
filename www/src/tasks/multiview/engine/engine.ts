/** Several drawings, in the worker. */

import { bytesOf, ink, loaded, pulled, taken } from "../../../engine/core";
import type { Picture, Placed, Preview, SettingValues } from "../../../engine/protocol";
import type { TaskEngine } from "../../../engine/task-engine";
import * as wasm from "../../../engine/wasm/wire4d";
import { centred } from "./centred";
import type { Drawing, FoundInk, Reading, Work } from "../protocol";

export const engine: TaskEngine<Work> = {
  task: "multiview",
  handlers: {
    read: async ({ picture, reading, sidePx }) => {
      await loaded();
      const found = read(picture, reading);
      return { ...found, width: sidePx, height: sidePx, ink: centred(found, sidePx) };
    },
    preview: async ({ drawings, settings }) => {
      await loaded();
      return preview(drawings, settings);
    },
  },
  async start({ drawings: given, guided }, settings, from, { tell, note }) {
    await loaded();
    const drawings = set(given);
    const values = JSON.stringify(settings);
    try {
      for (const view of guided) drawings.guide(view);
      const run = await (from ? wasm.Run.resume(drawings, values, from, tell, note) : wasm.Run.start(drawings, values, tell, note));
      return pulled(run, given.map(({ name }) => name));
    } finally {
      drawings.free();
    }
  },
};

function read(picture: Picture, reading: Reading): FoundInk {
  const found = wasm.read_ink(picture.name, picture.width, picture.height, bytesOf(picture), reading.ink, reading.threshold);
  return taken(found, () => ({ ...ink(found.ink()), polarity: found.is_light ? "light" : "dark", note: found.note() }));
}

function preview(drawings: readonly Drawing[], settings: SettingValues): Preview {
  const found = taken(set(drawings), (drawings) => wasm.Preview.of(drawings, JSON.stringify(settings)));
  return taken(found, () => {
    type Words = Omit<Preview, "drawings"> & { readonly drawings: readonly Placed[] };
    const words = JSON.parse(found.words()) as Words;
    const pictures = (index: number) => ({ seen: ink(found.seen(index)), missing: ink(found.missing(index)) });
    return { ...words, drawings: words.drawings.map((placed, index) => ({ ...placed, ...pictures(index) })) };
  });
}

function set(drawings: readonly Drawing[]): wasm.DrawingSet {
  const set = new wasm.DrawingSet();
  try {
    for (const { name, width, height, ink } of drawings) set.add(name, width, height, ink);
  } catch (error) {
    set.free();
    throw error;
  }
  return set;
}
