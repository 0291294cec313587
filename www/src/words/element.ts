/** The element's words in the page's language. */

import { WORDS, type Words } from "#sculpture/element/words";
import { worded } from "./told";

export const elementWords = (): Words => Object.fromEntries(Object.entries(WORDS).map(([name, text]) => [name, worded(text)])) as Words;
