/** JSON from anywhere, read field by field: each has its type and its bounds, or it is said which has not. */

/** Of a whole text, in characters: a thousand prompts with their vectors, or all words of a language. */
export const MOST_TEXT = 16 * 2 ** 20;
/** Of a text in it. */
const MOST_NAME = 200;

const isText = (value: unknown): value is string => typeof value === "string" && value.length <= MOST_NAME;

/** An object's fields, each asked for by its name and type. */
export class Fields {
  private readonly all: Readonly<Record<string, unknown>>;

  private constructor(
    value: unknown,
    private readonly where: string,
    private readonly raise: (what: string) => never,
  ) {
    if (typeof value !== "object" || value === null || Array.isArray(value)) raise(`${where || "it"} must be a JSON object.`);
    this.all = value as Record<string, unknown>;
  }

  /** Of a JSON text; `raise` throws, and is told what is wrong in a sentence's second half, with its full stop. */
  static of(text: string, raise: (what: string) => never): Fields {
    if (text.length > MOST_TEXT) raise("it is far too long.");
    let json: unknown = null;
    try {
      json = JSON.parse(text);
    } catch {
      raise("it is not JSON.");
    }
    return new Fields(json, "", raise);
  }

  fail(what: string): never {
    return this.raise(this.where ? `in ${this.where}, ${what}` : what);
  }

  /** Undefined where there is none. */
  maybe(name: string): unknown {
    return Object.hasOwn(this.all, name) ? this.all[name] : undefined;
  }

  /** All names, if they are not too many and not too long. */
  names(most: number): string[] {
    const names = Object.keys(this.all);
    return names.length <= most && names.every((name) => name.length <= MOST_NAME) ? names : this.fail("there are too many fields, or too long ones.");
  }

  private within(name: string): string {
    return `'${name.slice(0, 40)}'${this.where && ` of ${this.where}`}`;
  }

  fields(name: string): Fields {
    return new Fields(this.maybe(name), this.within(name), this.raise);
  }

  list(name: string, least: number, most: number): Fields[] {
    const values = this.values(name, most);
    if (values.length < least) this.fail(`'${name}' is empty.`);
    return values.map((value) => new Fields(value, this.within(name), this.raise));
  }

  values(name: string, most: number): readonly unknown[] {
    const value = this.maybe(name);
    return Array.isArray(value) && value.length <= most ? (value as unknown[]) : this.fail(`'${name}' must be a list of at most ${most}.`);
  }

  text(name: string): string {
    const value = this.maybe(name);
    return isText(value) ? value : this.fail(`'${name}' must be a text of at most ${MOST_NAME} characters.`);
  }

  matching(name: string, pattern: RegExp, meaning: string): string {
    const value = this.text(name);
    return pattern.test(value) ? value : this.fail(`'${name}' must be ${meaning}.`);
  }

  word<W extends string>(name: string, words: readonly W[]): W {
    const value = this.maybe(name);
    return words.find((word) => word === value) ?? this.fail(`'${name}' must be one of ${words.join(", ")}.`);
  }

  number(name: string, least = -Infinity, most = Infinity): number {
    const value = this.maybe(name);
    return typeof value === "number" && Number.isFinite(value) && value >= least && value <= most
      ? value
      : this.fail(`'${name}' must be a number${least > -Infinity ? ` from ${least}` : ""}${most < Infinity ? ` to ${most}` : ""}.`);
  }

  whole(name: string, least: number, most: number): number {
    const value = this.number(name, least, most);
    return Number.isInteger(value) ? value : this.fail(`'${name}' must be a whole number.`);
  }

  numbers(name: string, count: number): number[] {
    const values = this.values(name, count);
    return values.length === count && values.every((value) => typeof value === "number" && Number.isFinite(value))
      ? (values as number[])
      : this.fail(`'${name}' must be ${count} finite numbers.`);
  }

  /** So many finite float32, the lowest byte first, in base64. */
  floats(name: string, count: number): Float32Array<ArrayBuffer> {
    const value = this.maybe(name);
    const fail = (): never => this.fail(`'${name}' must be ${count} finite numbers of 32 bits in base64.`);
    if (typeof value !== "string" || value.length !== 4 * Math.ceil((4 * count) / 3)) return fail();
    try {
      const bytes = Uint8Array.from(atob(value), (letter) => letter.charCodeAt(0));
      if (bytes.length !== 4 * count) fail();
      const view = new DataView(bytes.buffer);
      const floats = Float32Array.from({ length: count }, (_, i) => view.getFloat32(4 * i, true));
      return floats.every(Number.isFinite) ? floats : fail();
    } catch {
      return fail();
    }
  }

  texts(name: string, most: number): readonly string[] {
    const values = this.values(name, most);
    return values.every(isText) ? values : this.fail(`'${name}' must be texts of at most ${MOST_NAME} characters.`);
  }

  /** One whole number, or a list of several, each from 1 to its most. */
  sizes(name: string, most: readonly number[]): number[] {
    const value = this.maybe(name);
    const values: readonly unknown[] = Array.isArray(value) ? value : [value];
    const fit = values.length === most.length && values.every((v, i) => Number.isInteger(v) && (v as number) >= 1 && (v as number) <= most[i]!);
    return fit ? (values as number[]) : this.fail(`'${name}' must be whole numbers from 1 to at most ${most.join(", ")}.`);
  }
}
