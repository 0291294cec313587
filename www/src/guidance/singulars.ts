/** English plurals, as far as there are rules. */

/** An ending, and what stands for it in the singular. A "bus" and a "glass" are none. */
const RULES: readonly (readonly [RegExp, string])[] = [
  [/^(..+)ies$/u, "$1y"],
  [/^(..+)ves$/u, "$1f"],
  [/^(..+)ves$/u, "$1fe"],
  [/^(..+(?:s|x|z|o|ch|sh))es$/u, "$1"],
  [/^(..+[^s])s$/u, "$1"],
];

/** What a word may be the plural of; some are no words, and are found nowhere. */
export const singularsOf = (word: string): readonly string[] => RULES.flatMap(([plural, singular]) => (plural.test(word) ? word.replace(plural, singular) : []));
