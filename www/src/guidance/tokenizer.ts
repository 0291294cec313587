/**
 * CLIP's tokenizer: byte pairs, lower case, padded to a fixed length; from the JSON that `tools/guidance` writes beside a text
 * encoder: {kind: "clip-bpe", context, pad, merges: ["i n", …]}. The vocabulary follows from that: 256 bytes, the same at a
 * word's end, one token a merge, start, end.
 */

import { GuidanceError } from "./fault";
import { Fields } from "./fields";

const END = "</w>";
const PIECES = /'s|'t|'re|'ve|'m|'ll|'d|\p{L}+|\p{N}|[^\s\p{L}\p{N}]+/giu;
/** Of Python's white space, what JavaScript's `\s` lacks too. */
const SPACES = /[\s\x1c-\x1f\x85]+/u;
/** Of HTML's entities the ones that people's texts have; and numbers. */
const ENTITIES: Readonly<Record<string, string>> = { amp: "&", lt: "<", gt: ">", quot: '"', apos: "'", nbsp: "\u00a0" };

const [MOST_CONTEXT, MOST_MERGES, MOST_PROMPT] = [1024, 2 ** 18, 10_000];

export class Tokenizer {
  readonly context: number;
  private readonly pad: number;
  private readonly start: number;
  private readonly ids = new Map<string, number>();
  /** By a pair, with a space between. */
  private readonly ranks = new Map<string, number>();

  /** `text` comes from anywhere: a GuidanceError says that `file` is no tokenizer. */
  constructor(text: string, private readonly file: string) {
    const { context, pad, merges } = read(text, file);
    this.context = context;
    this.pad = pad;
    const letters = [...LETTERS.values()];
    const words = [...letters, ...letters.map((letter) => letter + END), ...merges.map((merge) => merge.replace(" ", ""))];
    words.forEach((word, id) => this.ids.set(word, id));
    merges.forEach((merge, rank) => this.ranks.set(merge, rank));
    this.start = words.length;
  }

  /** Rows of `context` ids, one a text: start, its tokens, end, padding. What is too long loses its last tokens. */
  rows(texts: readonly string[]): Int32Array<ArrayBuffer> {
    const rows = new Int32Array(texts.length * this.context).fill(this.pad);
    texts.forEach((text, row) => rows.set([this.start, ...this.encode(text).slice(0, this.context - 2), this.start + 1], row * this.context));
    return rows;
  }

  /** Ids without start and end, as many as it takes. A GuidanceError for a text without any. */
  encode(text: string): number[] {
    const plain = unescaped(unescaped(text.slice(0, MOST_PROMPT))).split(SPACES).filter(Boolean).join(" ").toLowerCase();
    const ids = [...plain.matchAll(PIECES)].flatMap(([piece]) => this.merged(piece).map((part) => this.ids.get(part)!));
    if (!ids.length) throw new GuidanceError(this.file, "A prompt is empty. Say what the picture should look like.");
    return ids;
  }

  /** The pair that was merged first in training is merged first, wherever it stands, until none is known. */
  private merged(piece: string): string[] {
    let parts = Array.from(new TextEncoder().encode(piece), (byte) => LETTERS.get(byte)!);
    parts.push(parts.pop()! + END);
    for (;;) {
      const pairs = parts.slice(1).map((part, i) => `${parts[i]!} ${part}`);
      const best = pairs.reduce((best, pair) => ((this.ranks.get(pair) ?? Infinity) < (this.ranks.get(best) ?? Infinity) ? pair : best), "");
      if (!best) return parts;
      const joined: string[] = [];
      for (let i = 0; i < parts.length; i++) {
        const both = pairs[i] === best;
        joined.push(both ? parts[i]! + parts[i + 1]! : parts[i]!);
        if (both) i++;
      }
      parts = joined;
    }
  }
}

function read(text: string, file: string): { context: number; pad: number; merges: readonly string[] } {
  const all = Fields.of(text, (what) => {
    throw new GuidanceError(file, `“${file}” is no tokenizer: ${what} Export the text encoder again with tools/guidance.`);
  });
  all.word("kind", ["clip-bpe"]);
  const merges = all.texts("merges", MOST_MERGES);
  if (!merges.every((merge) => /^[^ ]+ [^ ]+$/.test(merge))) all.fail("'merges' must be pairs.");
  return { context: all.whole("context", 3, MOST_CONTEXT), pad: all.whole("pad", 0, 2 ** 20), merges };
}

function unescaped(text: string): string {
  return text.replace(/&(?:#(\d{1,7})|#[xX]([0-9a-fA-F]{1,6})|(\w{2,4}));/g, (all, decimal?: string, hex?: string, name?: string) => {
    if (name !== undefined) return ENTITIES[name] ?? all;
    const code = decimal !== undefined ? parseInt(decimal, 10) : parseInt(hex!, 16);
    return code > 0 && code < 0x110000 && !(code >= 0xd800 && code < 0xe000) ? String.fromCodePoint(code) : "\ufffd";
  });
}

/** A printable character for each byte, in the order of CLIP's vocabulary: printable Latin-1 first, the rest from U+0100. */
const LETTERS: ReadonlyMap<number, string> = letters();

function letters(): Map<number, string> {
  const shown = Array.from({ length: 256 }, (_, byte) => byte).filter((byte) => (byte >= 33 && byte < 127) || (byte >= 161 && byte < 256 && byte !== 173));
  const table = new Map(shown.map((byte) => [byte, String.fromCharCode(byte)]));
  for (let byte = 0; byte < 256; byte++) if (!table.has(byte)) table.set(byte, String.fromCharCode(256 + table.size - shown.length));
  return table;
}
