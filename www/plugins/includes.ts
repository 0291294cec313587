/**
 * Files that a page shows as they are: `<!--example FILE-->` becomes the text of that snippet, `{code JOB}` the share
 * code of that job's example.
 */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";
import { escaped } from "../src/ui/save/markup.ts";

const ROOT = join(import.meta.dirname, "..");
const read = (...path: string[]): string => readFileSync(join(ROOT, ...path), "utf8").trimEnd();

export const includes: Plugin = {
  name: "includes",
  transformIndexHtml: {
    order: "pre",
    handler: (html) =>
      html
        .replace(/<!--example ([\w.-]+)-->/g, (_, file: string) => escaped(read("packages/wire-sculpture/examples", file)))
        .replace(/\{code (\w+)\}/g, (_, job: string) => read("src/tasks", job, "example/wire.code")),
  },
};
