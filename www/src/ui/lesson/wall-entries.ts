/** What hangs on the wall, out of what a teacher pastes: lines of mail or chat, each with a link and perhaps a name. */

import { codeIn, openShareCode } from "#sculpture/share/code";

export interface Entry {
  readonly name: string;
  /** The wire, as a share code. */
  readonly code: string;
}

export interface Pasted {
  readonly entries: readonly Entry[];
  /** How many links could not be opened. */
  readonly broken: number;
}

/** A line that has a link brings the name before or after it; where it has none, the line above may be one. */
export function entriesIn(text: string): Pasted {
  const entries: Entry[] = [];
  let broken = 0;
  let above = "";
  for (const line of text.split(/\r?\n/)) {
    const link = /\S*[#&]\S*\bw=\S*/.exec(line)?.[0];
    if (link === undefined) {
      if (line.trim()) above = named(line);
      continue;
    }
    const code = codeOf(link);
    if (code === null) broken++;
    else entries.push({ name: named(line.replace(link, " ")) || above, code });
    above = "";
  }
  return { entries, broken };
}

function codeOf(link: string): string | null {
  const found = codeIn(link);
  if (!found) return null;
  try {
    openShareCode(found.code);
    return found.code;
  } catch {
    return null;
  }
}

/** Without what stands between a name and a link. */
function named(text: string): string {
  return text.replace(/^[\s:;,|<>"'()\[\]–-]+|[\s:;,|<>"'()\[\]–-]+$/g, "").slice(0, 60);
}

/** New ones come behind those that are there; whose wire is there already keeps its place. */
export function withMore(there: readonly Entry[], more: readonly Entry[]): readonly Entry[] {
  const all = new Map(there.map((entry) => [entry.code, entry]));
  for (const entry of more) all.set(entry.code, { code: entry.code, name: entry.name || all.get(entry.code)?.name || "" });
  return [...all.values()];
}

/** By name; those without one come last. */
export function sorted(entries: readonly Entry[], language: string): readonly Entry[] {
  const { compare } = new Intl.Collator(language, { numeric: true });
  return entries.toSorted((a, b) => Number(a.name === "") - Number(b.name === "") || compare(a.name, b.name));
}
