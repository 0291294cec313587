/** Lays words over a run: each view's, as networks know them. */

import { GuidanceError } from "../guidance/fault";
import type { CoreRun } from "./core";
import { ICONS, type Guide } from "./protocol";
import type { Ears } from "./task-engine";
import type { Readers } from "../guidance/readers";

/** A GuidanceError where nothing can guide: no network, or none of its words. */
export async function guideByWords(run: CoreRun, { words, weight, by }: Guide, tell: Ears["tell"], notice: (words: string) => void): Promise<void> {
  const views = run.targets().map(({ view }) => view.name);
  const wanted = views.map((view) => words[view]?.trim() ?? "");
  if (weight <= 0 || !wanted.some(Boolean)) return;
  const progress = (share: number): void => tell("Fetching what knows words…", share);
  const readers: Readers = by === ICONS ? await (await import("../guidance/icons")).icons(progress) : await (await import("../guidance/service")).readers(by, progress);
  const vectors = await Promise.all(wanted.map((word) => (word ? readers.vector(word) : null)));
  wanted.forEach((word, view) => {
    if (word && !vectors[view]) notice(`“${word}” (${views[view]}) is no word that guides here. ${readers.instead(word)}`);
  });
  if (!vectors.some(Boolean)) throw new GuidanceError("", "None of the words could guide the wire.");
  run.guideByWords(weight, readers.networks, readers.networks.map(() => vectors));
}
