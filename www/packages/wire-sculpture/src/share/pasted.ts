/**
 * Codes in text as people paste it: a link with other parameters round its code, in brackets, quotes or a sentence, wrapped
 * or quoted by mail, as HTML, percent-encoded by a program that checks links. Twin of `src/export/share/pasted.rs`.
 */

/** Places at which a code may begin, and ends that are tried for each: texts made to have more are no links. */
const MOST_STARTS = 16;
const MOST_ENDS = 256;
/** Zero-width spaces and joiners, marks of direction, soft hyphens, the byte order mark. */
const INVISIBLE = /[\u00ad\u200b-\u200f\u202a-\u202e\u2060-\u2064\ufeff]/g;

export interface Found {
  readonly code: string;
  /** Whether it stands at a `w=`. */
  readonly named: boolean;
  /** What stands before its `w=` and after it. */
  readonly before: string;
  readonly after: string;
}

/** What may be a share code in `text`, likelier ones first; the checksum tells which one is. */
export function codesIn(text: string): Found[] {
  let plain = text.replace(INVISIBLE, "");
  let starts = parameters(plain);
  // Twice, for links in links.
  for (let round = 0; round < 2 && starts.length === 0; round++) {
    plain = plain.replace(/%([0-9a-f]{2})/gi, (_, hex: string) => String.fromCharCode(parseInt(hex, 16)));
    starts = parameters(plain);
  }
  const named = starts.length > 0;
  if (!named) starts = words(plain);
  return starts.slice(0, MOST_STARTS).flatMap((start) => readings(plain, start, named));
}

function parameters(text: string): number[] {
  return [...text.matchAll(/(?<![\w-])w=(?:3D)?/g)].map((match) => match.index + match[0].length);
}

/** Where what looks like a code begins, the longest first. */
function words(text: string): number[] {
  return [...text.matchAll(/[\w-]{7,}/g)].sort((a, b) => b[0].length - a[0].length).map(({ index }) => index);
}

/** The code at `start`, read on over line breaks: up to the first one, up to the second one, … */
function readings(text: string, start: number, named: boolean): Found[] {
  const before = text.slice(0, start).replace(/w=(3D)?$/, "");
  const found: Found[] = [];
  // A piece of code, and the break before the next one.
  const piece = /([\w-]+)((?:=\r?\n|\s)[\s>|]*)?/y;
  piece.lastIndex = start;
  let code = "";
  for (let match; found.length < MOST_ENDS && (match = piece.exec(text)); ) {
    code += match[1]!;
    found.push({ code, named, before, after: text.slice(match.index + match[1]!.length) });
    if (match[2] === undefined) break;
  }
  // A link in _italics_.
  const bare = found.map((each) => ({ ...each, code: each.code.replace(/[-_]+$/, "") }));
  return [...found, ...bare].filter(({ code }) => code);
}
