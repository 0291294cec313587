/** One picture, in the worker. */

import { bytesOf, ink, loaded, own, pulled, taken } from "../../../engine/core";
import type { Picture } from "../../../engine/protocol";
import type { TaskEngine } from "../../../engine/task-engine";
import * as wasm from "../../../engine/wasm/wire4d";
import { bytes, depthPicture, seen } from "../../../guidance/sight";
import type { FoundObject, PixelHints, StrokeWork } from "../protocol";

interface Known {
  readonly key: number;
  readonly picture: Picture;
  readonly subject: wasm.Subject;
}

/** What was looked at last: whoever draws on a picture asks again at every stroke, and then makes a wire of it. */
let last: Known | null = null;

export const engine: TaskEngine<StrokeWork> = {
  task: "stroke",
  handlers: {
    find: async ({ key, picture, object, hints }) => {
      await loaded();
      const known = knownAs(key, picture);
      if (!known) return null;
      point(known.subject, hints);
      return hints.box || hints.marks.length ? find(known.subject, object) : findUnpointed(known, object);
    },
    guessDepth: async ({ picture: { name, width, height, rgba } }) => {
      const near = await seen("depth-v1", { width, height, rgba });
      return near && { name: `${name}, as ${near.by} sees it`, width, height, rgba: depthPicture(near, width, height) };
    },
  },
  async start(work, settings, from, { tell, note }) {
    await loaded();
    const known = knownAs(work.key, work.picture)!;
    const { subject } = known;
    const given = JSON.stringify(settings);
    // Whoever asks meanwhile must not get hold of it.
    last = null;
    try {
      say(subject, work);
      return pulled(await (from ? wasm.Run.resume_stroke(subject, given, from, tell, note) : wasm.Run.start_stroke(subject, given, tell, note)));
    } finally {
      if (last) subject.free();
      else last = known;
    }
  },
};

/** The picture of this key with what was learnt of it, and nothing said of it; null where it is neither known nor given. */
function knownAs(key: number, picture: Picture | null): Known | null {
  if (last?.key !== key) {
    if (!picture) return null;
    last?.subject.free();
    last = null;
    last = { key, picture, subject: new wasm.Subject(picture.name, picture.width, picture.height, bytesOf(picture)) };
  }
  last.subject.clear_hints();
  return last;
}

/** As an open network sees it; where there is none, or it sees nothing, as it is found here. */
async function findUnpointed({ picture, subject }: Known, object: number): Promise<FoundObject> {
  let failed: string[] = [];
  try {
    const mask = await seen("mask-v1", picture);
    if (mask) {
      subject.set_mask(mask.width, mask.height, bytes(mask.values));
      const { notes, ...found } = find(subject, object);
      return { ...found, notes: [`The object is as the network ${mask.by} sees it.`, ...notes] };
    }
  } catch (error) {
    failed = [`${error instanceof Error ? error.message : error}. The object is found without the network.`];
    subject.clear_hints();
  }
  const { notes, ...found } = find(subject, object);
  return { ...found, notes: [...failed, ...notes] };
}

function find(subject: wasm.Subject, object: number): FoundObject {
  const found = wasm.find_object(subject, object);
  return taken(found, () => {
    const { ink: mask, ...size } = ink(found.mask());
    return { ...size, mask, labels: own(found.labels()), count: found.count, isSure: found.is_sure, notes: JSON.parse(found.notes()) as string[] };
  });
}

function point(subject: wasm.Subject, { box, marks }: PixelHints): void {
  if (box) subject.set_bounds(...(box as [number, number, number, number]));
  for (const { onObject, points, radius } of marks) subject.add_stroke(onObject, points, radius);
}

/** What a person says of a picture of which nothing was said. */
function say(subject: wasm.Subject, { mask, hints, depth }: StrokeWork): void {
  if (mask) subject.set_mask(mask.width, mask.height, mask.ink);
  point(subject, hints);
  if (depth) subject.set_depth(depth.name, depth.width, depth.height, bytesOf(depth), depth.measured ?? false);
}
