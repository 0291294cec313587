/** What guides a run, in an address: `guide-front=umbrella`, a word a view, and what differs from the usual. */

import { DENOISER, ICONS, USUAL_WEIGHT, type Guide } from "../../engine/protocol";

type Pairs = Readonly<Record<string, string>>;

const KEY = "guide-";
const [MOST_LETTERS, MOST_WEIGHT] = [60, 1000];

/** Files of one's own stay here. */
export function writeGuide(guide: Guide | null): Pairs {
  const { words = {}, weight = USUAL_WEIGHT, by = ICONS } = guide ?? {};
  const said = Object.entries(words).filter(([, word]) => word);
  if (!said.length) return {};
  const pairs = [...said, ...(weight === USUAL_WEIGHT ? [] : [["weight", String(weight)] as const]), ...(by === DENOISER ? [["by", by] as const] : [])];
  return Object.fromEntries(pairs.map(([name, value]) => [KEY + name, value]));
}

/** Null where nothing is said of `views`. */
export function readGuide(pairs: Pairs, views: readonly string[]): Guide | null {
  const said = (name: string): string => (pairs[KEY + name] ?? "").trim().slice(0, MOST_LETTERS);
  const words = Object.fromEntries(views.map((view) => [view, said(view)] as const).filter(([, word]) => word));
  const weight = Number(said("weight") || USUAL_WEIGHT);
  if (!Object.keys(words).length) return null;
  return { words, weight: weight >= 0 && weight <= MOST_WEIGHT ? weight : USUAL_WEIGHT, by: said("by") === DENOISER ? DENOISER : ICONS };
}
