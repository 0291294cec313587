/** What a wire is called, after the names of what was given for it. */

/** "Cat, Bird, and Fish", without the endings of files. */
export function titleOf(labels: readonly string[]): string {
  const words = labels.map((label) => label.replace(/\.\w{1,5}$/, "").trim()).filter(Boolean);
  return words.length ? new Intl.ListFormat("en", { type: "conjunction" }).format(words) : "A wire";
}

/** For people who do not see it. */
export const altOf = (labels: readonly string[]): string => (labels.length ? `One continuous wire that shows: ${titleOf(labels)}` : "A sculpture of one continuous wire");
