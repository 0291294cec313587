/** What a wire is called, after the names of what was given for it. */

import { msg, str } from "@lit/localize";
import { listed } from "../../words/numbers";

/** "Cat, Bird, and Fish", without the endings of files. */
export function titleOf(labels: readonly string[]): string {
  const words = labels.map((label) => label.replace(/\.\w{1,5}$/, "").trim()).filter(Boolean);
  return words.length ? listed(words) : msg("A wire");
}

/** For people who do not see it. */
export const altOf = (labels: readonly string[]): string => (labels.length ? msg(str`One continuous wire that shows: ${titleOf(labels)}`) : msg("A sculpture of one continuous wire"));
