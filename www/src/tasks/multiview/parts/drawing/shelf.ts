/** Finds icons by plain words. */

import { singularsOf } from "../../../../guidance/singulars";

export interface Icon {
  readonly name: string;
  readonly tags: readonly string[];
}

/** How well a word fits an icon: 0 is best. */
const NO_MATCH = Infinity;

/**
 * The icons that fit every word of the query, best first: by name, then by the start of the name, then a part of the name,
 * a tag, the start of a tag, and whatever else contains the word. Of equals, the shorter name.
 */
export function find<T extends Icon>(icons: readonly T[], query: string): readonly T[] {
  const words = query.toLowerCase().split(/[\s-]+/u).filter(Boolean);
  const whole = words.join("-");
  const asked = words.map((word) => [word, ...singularsOf(word)]);
  return icons
    .map((icon) => ({ icon, rank: icon.name === whole ? -1 : asked.reduce((sum, forms) => sum + rankOf(icon, forms), 0) }))
    .filter(({ rank }) => rank < NO_MATCH)
    .sort((a, b) => a.rank - b.rank || a.icon.name.length - b.icon.name.length || (a.icon.name < b.icon.name ? -1 : 1))
    .map(({ icon }) => icon);
}

function rankOf(icon: Icon, forms: readonly string[]): number {
  let best = NO_MATCH;
  for (let i = 0; i < forms.length; i++) best = Math.min(best, rankOfForm(icon, forms[i]!) + (i ? 0.5 : 0));
  return best;
}

function rankOfForm({ name, tags }: Icon, word: string): number {
  if (name === word) return 0;
  if (name.startsWith(word)) return 1;
  if (`${name}-`.includes(`-${word}-`)) return 2;
  if (tags.includes(word)) return 3;
  if (tags.some((tag) => tag.startsWith(word))) return 4;
  return name.includes(word) || tags.some((tag) => tag.includes(word)) ? 5 : NO_MATCH;
}
