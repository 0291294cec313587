/** The language of this page, once it is known. */

import type { Language } from "./languages";

type Patterns = readonly (readonly string[])[];

let current: Language = "en";
let sentences: Patterns = [];

/** English until another has been opened. */
export const language = (): Language => current;

/** For `lang` and `Intl`. */
export const localeTag = (): string => (current === "pseudo" ? "en" : current);

/** The texts of engine and workers that are translated: what they say between their values. */
export const patterns = (): Patterns => sentences;

export function settle(language: Language, patterns: Patterns): void {
  current = language;
  sentences = patterns;
}
