/** What the engine and the page's workers say, in the page's language. They speak English: "input: problem; remedy", or a whole sentence. */

import { msg, type StrResult } from "@lit/localize";
import { language, patterns } from "./language";

/** A text that is known as a whole or by its clauses; another as it is. */
export function told(text: string): string {
  if (language() === "en") return text;
  const whole = known(text);
  if (whole !== null) return whole;
  const name = /^([^:;]{1,80}): (.+)$/s.exec(text);
  if (name) return `${known(name[1]!) ?? name[1]!}: ${told(name[2]!)}`;
  const clauses = text.split("; ");
  return clauses.length > 1 ? clauses.map(told).join("; ") : text;
}

function known(text: string): string | null {
  for (const strings of patterns()) {
    const values = strings.length === 1 ? (strings[0] === text ? [] : null) : valuesIn(text, strings);
    if (values) return strings.length === 1 ? say(text) : say({ strTag: true, strings, values } as unknown as StrResult);
  }
  return null;
}

/** What stands between the strings, or null where it is another text. */
function valuesIn(text: string, strings: readonly string[]): readonly string[] | null {
  const escaped = strings.map((string) => string.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"));
  return new RegExp(`^${escaped.join("(.+?)")}$`, "s").exec(text)?.slice(1) ?? null;
}

/** Puts a page's own texts into its language: the inside of every element that says `data-words`. */
export function sayIn(root: ParentNode): void {
  if (language() === "en") return;
  for (const element of root.querySelectorAll<HTMLElement>("[data-words]")) {
    // Markup of ours, in the page and in the translations.
    element.innerHTML = worded(plain(element.innerHTML));
  }
  for (const element of root.querySelectorAll<HTMLElement>("[data-words-label]")) {
    element.setAttribute("aria-label", worded(element.getAttribute("aria-label") ?? ""));
  }
}

const plain = (markup: string): string => markup.trim().replace(/\s+/g, " ");

/** A text that stands in a file beside the scripts. */
export const worded = (text: string): string => (language() === "en" ? text : say(text));
/** What `msg` is changes when a language is opened. */
const say = (text: string | StrResult): string => (msg as (text: string | StrResult) => string)(text);
