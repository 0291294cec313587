/** What can go wrong for a person who brings a network. */

/** `message` is a sentence or two for people: which file is at fault, and what to do. Anything else is a fault of the page. */
export class GuidanceError extends Error {
  constructor(
    readonly file: string,
    readonly sentence: string,
  ) {
    super(sentence);
  }
}

/** A program's own words, in one line and not too long, to stand in a sentence. */
export function briefly(error: unknown): string {
  const said = (error instanceof Error ? error.message : String(error)).replace(/\s+/g, " ").trim();
  return said.length > 200 ? `${said.slice(0, 200)}…` : said;
}

/** "351 MB": decimal, as file managers count. */
export function size(bytes: number): string {
  const [unit, name] = bytes < 1e6 ? [1e3, "kB"] : bytes < 1e9 ? [1e6, "MB"] : [1e9, "GB"];
  const count = bytes / unit;
  return `${count < 10 ? count.toFixed(1) : Math.round(count)} ${name}`;
}
