/** The translations hold what the page says, and nothing else. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { catalogOf } from "../../plugins/words/catalog";
import { pseudo } from "../../plugins/words/pseudo";
import { LANGUAGES } from "./languages";

const PAGE = join(import.meta.dirname, "../..");
const catalog = catalogOf(PAGE);
const keys = [...catalog.keys()].sort();
const read = (language: string): Record<string, string> => JSON.parse(readFileSync(join(PAGE, `words/${language}.json`), "utf8")) as Record<string, string>;
const values = (text: string): readonly string[] => (text.match(/\{\d+\}/g) ?? []).sort();
const tags = (text: string): readonly string[] => (text.match(/<\/?\w+/g) ?? []).sort();

it("finds texts in scripts, in pages and beside them", () => {
  expect(catalog.get("One more drawing, and a wire can be made.")?.files).toEqual(["src/tasks/multiview/parts/remedy-list.ts"]);
  expect(catalog.get("Step {0} of {1}")?.strings).toEqual(["Step ", " of ", ""]);
  expect(catalog.get("For teachers")?.files).toContain("teachers.html");
});

it("disguises English without touching what is put in", () => {
  expect(pseudo("Step {0} of {1}")).toBe("[Stép {0} óf {1}···]");
});

describe.each(Object.keys(LANGUAGES).filter((language) => language !== "en"))("%s", (language) => {
  const translations = read(language);

  it("has every text, and none that the page does not say", () => {
    expect(Object.keys(translations).sort()).toEqual(keys);
  });

  it("puts in what the text puts in, with the same markup", () => {
    for (const [key, words] of Object.entries(translations)) {
      expect([key, ...values(words)]).toEqual([key, ...values(key)]);
      expect([key, ...tags(words)]).toEqual([key, ...tags(key)]);
      expect(words.trim(), key).not.toBe("");
    }
  });
});
