/** What each page may run and load. Only in the build: the development server injects styles. */

import { basename } from "node:path";
import type { Plugin } from "vite";

/** Nothing leaves the device, and nothing from elsewhere runs. */
const APP = "default-src 'self'; connect-src 'self'; img-src 'self' blob:; script-src 'self' 'wasm-unsafe-eval'; object-src 'none'; base-uri 'none'; form-action 'none'";
const DOCS = "default-src 'self'; connect-src 'self'; img-src 'self' blob: data:; worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'";

/** By the page's name; `null` for one whose plugin knows better. */
const POLICIES: Readonly<Record<string, string | null>> = { "docs.html": DOCS, "gallery.html": DOCS, "embed.html": null };

export const policies: Plugin = {
  name: "policies",
  apply: "build",
  transformIndexHtml: (_, { filename }) => {
    const policy = POLICIES[basename(filename)] ?? (basename(filename) in POLICIES ? null : APP);
    return policy === null ? [] : [policyTag(policy)];
  },
};

export const policyTag = (content: string) => ({ tag: "meta", attrs: { "http-equiv": "Content-Security-Policy", content }, injectTo: "head-prepend" as const });
