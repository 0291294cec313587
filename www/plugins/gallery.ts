/** Writes the works into the gallery's page, and lays their files and what they were made of beside it. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";
import { cards } from "../src/gallery/cards";
import { fileOf, KINDS, meshOf, picturesOf, type Work } from "../src/gallery/works";

const ROOT = join(import.meta.dirname, "..");
const works = (): readonly Work[] => JSON.parse(readFileSync(join(ROOT, "gallery/works.json"), "utf8")) as readonly Work[];

export const gallery: Plugin = {
  name: "gallery",
  transformIndexHtml: {
    order: "pre",
    handler: (html) =>
      html
        .replace("<!--works-->", () => cards(works(), "#"))
        .replace("<!--kinds-->", () => Object.entries(KINDS).map(([task, kind]) => `<button type="button" data-task="${task}" aria-pressed="false" data-words>${kind}</button>`).join("")),
  },
  generateBundle() {
    const inputs = works().flatMap((work) => [...picturesOf(work), ...(meshOf(work) ? [meshOf(work)!] : [])]);
    const files = [...works().map(fileOf), ...new Set(inputs.map((input) => `gallery/inputs/${input}`))];
    for (const fileName of files) this.emitFile({ type: "asset", fileName, source: readFileSync(join(ROOT, fileName)) });
  },
};
