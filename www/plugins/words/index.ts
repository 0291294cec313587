/** `words/LANGUAGE.json?words`: the translations as the page asks for them, by the names that texts have in scripts. */

import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { generateMsgId } from "@lit/localize/internal/id-generation.js";
import type { Plugin } from "vite";
import { catalogOf, toldIn } from "./catalog.ts";
import { pseudo } from "./pseudo.ts";

const PAGE = join(import.meta.dirname, "../..");
const QUERY = "?words";

export const words: Plugin = {
  name: "words",
  enforce: "pre",
  load(id) {
    if (!id.endsWith(`.json${QUERY}`)) return null;
    const path = id.slice(0, -QUERY.length);
    const catalog = catalogOf(PAGE);
    const isPseudo = basename(path) === "pseudo.json";
    const translations = isPseudo ? {} : (JSON.parse(readFileSync(path, "utf8")) as Record<string, string>);
    const templates = [...catalog].flatMap(([key, { strings }]) => {
      const words = isPseudo ? pseudo(key) : translations[key];
      return words === undefined ? [] : [`${generateMsgId(strings.length === 1 ? strings[0]! : [...strings], false)}:${written(words)}`];
    });
    const code = [
      "const t=(strings,...values)=>({strTag:true,strings,values});",
      `export const templates={${templates.join(",")}};`,
      `export const told=${JSON.stringify(toldIn(PAGE))};`,
    ];
    return { code: code.join("\n"), moduleType: "js" };
  },
};

/** A string, or what the library takes for one with values: their places in the order of the translation. */
function written(words: string): string {
  const parts = words.split(/\{(\d+)\}/);
  if (parts.length === 1) return JSON.stringify(words);
  const strings = parts.filter((_, i) => i % 2 === 0);
  return `t(${[JSON.stringify(strings), ...parts.filter((_, i) => i % 2 === 1)].join(",")})`;
}
