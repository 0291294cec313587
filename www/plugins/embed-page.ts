/**
 * `embed.html` is one file, with the element in it: a frame with `sandbox` has an origin of its own, for which a plain host
 * gives out no modules; and it is there after one request.
 */

import { createHash } from "node:crypto";
import { basename } from "node:path";
import type { Plugin } from "vite";
import { inScript } from "../src/ui/save/markup.ts";
import { bundled } from "./bundled.ts";
import { policyTag } from "./policies.ts";

const PAGE = "embed.html";
const SCRIPT = /<script type="module" src="\.\/([^"]+)"><\/script>\s*/;

export function embedPage(): Plugin[] {
  let entry = "";
  const isPage = (filename: string): boolean => basename(filename) === PAGE;
  return [
    {
      name: "embed-page:without-its-script",
      apply: "build",
      transformIndexHtml: {
        order: "pre",
        handler(html, { filename }) {
          if (!isPage(filename)) return html;
          entry = SCRIPT.exec(html)![1]!;
          return html.replace(SCRIPT, "");
        },
      },
    },
    {
      name: "embed-page:with-its-script",
      apply: "build",
      transformIndexHtml: {
        order: "post",
        async handler(html, { filename }) {
          if (!isPage(filename)) return html;
          const script = `\n${inScript(await bundled(entry))}\n`;
          const styles = [...html.matchAll(/<style>([\s\S]*?)<\/style>/g)].map((match) => match[1]!);
          const policy = [
            "default-src 'none'",
            `script-src ${[script].map(hash).join(" ")}`,
            `style-src ${styles.map(hash).join(" ")}`,
            // Wires and posters from anywhere: whoever frames the page says which.
            "connect-src 'self' https:",
            "img-src 'self' https: blob: data:",
            "worker-src 'self' blob:",
            "base-uri 'none'",
            "form-action 'none'",
          ].join("; ");
          const tag = { tag: "script", attrs: { type: "module" }, children: script, injectTo: "body" as const };
          return { html, tags: [policyTag(policy), tag] };
        },
      },
    },
  ];
}

const hash = (text: string): string => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
