/**
 * Words with their vectors: `words.json` {kind: "word-table-v1", embed: E, sha256, words: [n texts]} and `words.bin`, n rows of E
 * int8 numbers whose checksum that is. Rows are directions alone, so a scale a row (n float32 behind them) may follow
 * and is not needed.
 */

import { sha256Of } from "./checksum";
import { GuidanceError } from "./fault";
import { Fields } from "./fields";
import { singularsOf } from "./singulars";

const [MOST_WORDS, MOST_EMBED, MOST_TYPED] = [200_000, 4096, 100];

export class Words {
  /** Lower case, and where each stands. */
  private readonly places: ReadonlyMap<string, number>;

  private constructor(
    readonly words: readonly string[],
    readonly embed: number,
    private readonly rows: Int8Array,
  ) {
    this.places = new Map(words.map((word, place) => [word.toLowerCase(), place] as const).reverse());
  }

  /** Both files come from anywhere: a GuidanceError says that `file`, the JSON, or its rows are no such thing. */
  static async open(text: string, bytes: Uint8Array<ArrayBuffer>, file: string): Promise<Words> {
    const { words, embed, sha256 } = read(text, file);
    const fail = (what: string): never => {
      throw new GuidanceError(file, `The rows of “${file}” ${what}. Fetch both files again.`);
    };
    const [plain, scaled] = [words.length * embed, words.length * (embed + 4)];
    if (bytes.length !== plain && bytes.length !== scaled) fail(`have ${bytes.length} bytes and should have ${plain}`);
    if ((await sha256Of(bytes, file)) !== sha256) fail("belong to another file, or are damaged");
    return new Words(words, embed, new Int8Array(bytes.buffer, bytes.byteOffset, plain));
  }

  /** Unit; null for a word that is not in the table, and for a row of zeros. */
  vector(word: string): Float32Array<ArrayBuffer> | null {
    const place = this.places.get(normal(word));
    if (place === undefined) return null;
    const row = this.row(place);
    const length = Math.sqrt(dot(row, row));
    return length > 0 ? Float32Array.from(row, (v) => v / length) : null;
  }

  /** Of the word that is most likely meant. */
  meaning(typed: string): Float32Array<ArrayBuffer> | null {
    return this.vector(typed) ?? this.vector(this.meant(typed, 1)[0] ?? "");
  }

  /** Words that a person may have meant, likeliest first: the word itself, one or many of it, what begins so, what is misspelt so. */
  meant(typed: string, most = 8): string[] {
    const word = normal(typed);
    if (!word) return [];
    const found = new Set<number>();
    for (const form of [word, ...numbersOf(word)]) {
      const place = this.places.get(form);
      if (place !== undefined) found.add(place);
    }
    const all = [...this.places];
    const beginning = all.filter(([other]) => other.startsWith(word));
    for (const [, place] of beginning.sort(([a], [b]) => a.length - b.length)) found.add(place);
    // Of a few letters, each change makes another word.
    const allowed = word.length < 3 ? 0 : word.length < 6 ? 1 : 2;
    const misspelt = found.size >= most ? [] : all.map(([other, place]) => [changes(word, other, allowed), place] as const).filter(([n]) => n <= allowed);
    for (const [, place] of misspelt.sort(([a], [b]) => a - b)) found.add(place);
    return [...found].slice(0, most).map((place) => this.words[place]!);
  }

  private row(place: number): Int8Array {
    return this.rows.subarray(place * this.embed, (place + 1) * this.embed);
  }
}

function read(text: string, file: string): { readonly words: readonly string[]; readonly embed: number; readonly sha256: string } {
  const all = Fields.of(text, (what) => {
    throw new GuidanceError(file, `“${file}” is no table of words: ${what} Fetch it again.`);
  });
  all.word("kind", ["word-table-v1"]);
  const words = all.texts("words", MOST_WORDS);
  return { words, embed: all.whole("embed", 1, MOST_EMBED), sha256: all.text("sha256") };
}

const normal = (word: string): string => word.trim().replace(/\s+/g, " ").toLowerCase().slice(0, MOST_TYPED);

function dot(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let sum = 0;
  for (let i = 0; i < a.length; i++) sum += a[i]! * b[i]!;
  return sum;
}

/** A word's plural and singular, as far as English has rules; some are no words, and are not found. */
function numbersOf(word: string): string[] {
  const forms = [`${word}s`, `${word}es`];
  if (word.endsWith("y")) forms.push(`${word.slice(0, -1)}ies`);
  if (/fe?$/.test(word)) forms.push(word.replace(/fe?$/, "ves"));
  return [...forms, ...singularsOf(word)];
}

/** Letters to put in, take out, exchange or swap until one word is the other; more than `most` where it is more. */
function changes(a: string, b: string, most: number): number {
  if (Math.abs(a.length - b.length) > most) return most + 1;
  let [before, row]: [number[], number[]] = [[], Array.from({ length: b.length + 1 }, (_, j) => j)];
  for (let i = 1; i <= a.length; i++) {
    const next = [i];
    for (let j = 1; j <= b.length; j++) {
      const cost = a[i - 1] === b[j - 1] ? 0 : 1;
      next[j] = Math.min(row[j]! + 1, next[j - 1]! + 1, row[j - 1]! + cost);
      if (i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1]) next[j] = Math.min(next[j]!, before[j - 2]! + 1);
    }
    if (Math.min(...next) > most) return most + 1;
    [before, row] = [row, next];
  }
  return row[b.length]!;
}
