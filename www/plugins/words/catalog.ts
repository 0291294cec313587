/**
 * Every text that the page says in the language of whoever reads it: each `msg("…")` and `msg(str`…`)` of its scripts, what
 * its pages mark with `data-words`, the gallery's works, the element's words, and `words/told.json`, what engine and
 * workers say.
 */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { parseAst } from "vite";

/** What the element says, which the page has in its own language. */
const ELEMENT_WORDS = "packages/wire-sculpture/src/element/words.ts";

export interface Text {
  /** Its parts between what is put into it; one alone is a plain text. */
  readonly strings: readonly string[];
  /** The files that say it. */
  readonly files: readonly string[];
}

/** A node of the syntax tree, as far as it matters here. */
interface Node {
  readonly type: string;
  readonly [field: string]: unknown;
}

/** As files of translations have it: `{0}` stands for the first value, `{1}` for the second. */
export const keyOf = (strings: readonly string[]): string => strings.reduce((key, string, i) => `${key}{${i - 1}}${string}`);

/** By key, of the page in this folder. Throws where a text of a script is not written out, so that nobody could translate it. */
export function catalogOf(page: string): ReadonlyMap<string, Text> {
  const texts = new Map<string, Text>();
  const add = (strings: readonly string[], file: string): void => {
    const key = keyOf(strings);
    texts.set(key, { strings, files: [...(texts.get(key)?.files ?? []), file] });
  };
  for (const file of scriptsIn(page)) {
    for (const strings of inScript(readFileSync(join(page, file), "utf8"), file)) add(strings, file);
  }
  for (const file of [...readdirSync(page).filter((name) => name.endsWith(".html")), "src/gallery/below.ts"]) {
    for (const text of inMarkup(readFileSync(join(page, file), "utf8"))) add([text], file);
  }
  for (const kind of Object.values(JSON.parse(readFileSync(join(page, "gallery/kinds.json"), "utf8")) as Record<string, string>)) add([kind], "gallery/kinds.json");
  for (const { title, sentence } of JSON.parse(readFileSync(join(page, "gallery/works.json"), "utf8")) as { readonly title: string; readonly sentence: string }[]) {
    for (const text of [title, sentence]) add([text], "gallery/works.json");
  }
  for (const [, text] of readFileSync(join(page, ELEMENT_WORDS), "utf8").matchAll(/^ {2}\w+: "(.+)",$/gm)) add([text!], ELEMENT_WORDS);
  for (const strings of toldIn(page)) add(strings, "words/told.json");
  return texts;
}

export function toldIn(page: string): readonly (readonly string[])[] {
  return (JSON.parse(readFileSync(join(page, "words/told.json"), "utf8")) as string[]).map((key) => key.split(/\{\d+\}/));
}

const scriptsIn = (page: string): readonly string[] =>
  readdirSync(join(page, "src"), { recursive: true, encoding: "utf8" })
    .filter((name) => /\.ts$/.test(name) && !/\.test\.ts$|\.d\.ts$/.test(name))
    .sort()
    .map((name) => `src/${name}`);

function inScript(code: string, file: string): readonly (readonly string[])[] {
  if (!code.includes("@lit/localize")) return [];
  const found: (readonly string[])[] = [];
  walk(parseAst(code, { lang: "ts" }) as unknown as Node, (call) => {
    const strings = stringsOf((call["arguments"] as Node[])[0]);
    // What is looked up by the library's own type stands in a file beside the scripts.
    if (strings) found.push(strings);
    else if (!file.startsWith("src/words/")) throw new Error(`${file}: a text in msg(…) must be written out: ${code.slice(call["start"] as number, call["end"] as number)}`);
  });
  return found;
}

function walk(node: unknown, found: (call: Node) => void): void {
  if (Array.isArray(node)) return node.forEach((child) => walk(child, found));
  if (typeof node !== "object" || node === null) return;
  const { type, callee } = node as Node & { readonly callee?: { readonly name?: string } };
  if (type === "CallExpression" && callee?.name === "msg") found(node as Node);
  for (const child of Object.values(node)) walk(child, found);
}

function stringsOf(argument: Node | undefined): readonly string[] | null {
  if (argument?.type === "Literal") return [argument["value"] as string];
  const { tag, quasi } = (argument ?? {}) as { readonly tag?: { readonly name?: string }; readonly quasi?: { readonly quasis: { readonly value: { readonly cooked: string } }[] } };
  return argument?.type === "TaggedTemplateExpression" && tag?.name === "str" ? quasi!.quasis.map(({ value }) => value.cooked) : null;
}

/** The inside of each element that says `data-words`, on one line; none holds another of its own kind. */
function inMarkup(html: string): readonly string[] {
  const inside = [...html.matchAll(/<([a-z]\w*)[^>]*\sdata-words(?:\s[^>]*)?>([\s\S]*?)<\/\1>/g)].map((match) => match[2]!);
  const labels = [...html.matchAll(/<[^>]*\sdata-words-label[^>]*>/g)].map((match) => /aria-label="([^"]*)"/.exec(match[0])![1]!);
  return [...inside, ...labels].map((text) => text.trim().replace(/\s+/g, " "));
}
