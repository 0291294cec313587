/**
 * How the page shows where somebody posts its address. Those who read it want whole addresses, and a page that may lie
 * anywhere knows none: the variable WIRE4D_URL, given to the build, says where it will lie, such as
 * `https://example.org/wire/`. Without, the picture's address is relative, which some readers understand.
 */

import { basename } from "node:path";
import type { HtmlTagDescriptor, Plugin } from "vite";

/** 1200 x 630 pixels: the example in its room, made with the page's own "Pictures and films". */
const PICTURE = "og.jpg";
const ALT = "A copper wire hangs in the corner of a room. Its three shadows are a cat, a bird and a fish.";

export function openGraph(home = process.env["WIRE4D_URL"] ?? ""): Plugin {
  return {
    name: "open-graph",
    transformIndexHtml: {
      order: "post",
      handler: (html, { filename }) => (basename(filename) === "index.html" ? tagsFor(html, home) : []),
    },
  };
}

/** @throws where `home` is not the address of a folder on the web. */
export function tagsFor(html: string, home: string): HtmlTagDescriptor[] {
  const title = /<title>([^<]*)</.exec(html)?.[1] ?? "Wire4D";
  const description = /<meta name="description" content="([^"]*)"/.exec(html)?.[1] ?? "";
  const base = home && folder(home);
  const open: Readonly<Record<string, string>> = {
    type: "website",
    site_name: "Wire4D",
    title,
    description,
    ...(base && { url: base }),
    image: (base || "./") + PICTURE,
    "image:width": "1200",
    "image:height": "630",
    "image:alt": ALT,
  };
  const meta = (attrs: Record<string, string>): HtmlTagDescriptor => ({ tag: "meta", attrs, injectTo: "head" });
  return [...Object.entries(open).map(([name, content]) => meta({ property: `og:${name}`, content })), meta({ name: "twitter:card", content: "summary_large_image" })];
}

function folder(home: string): string {
  const url = URL.canParse(home) ? new URL(home) : null;
  if (!url || !/^https?:$/.test(url.protocol)) throw new Error(`WIRE4D_URL: "${home}" is no address on the web; give where the page will lie, such as https://example.org/wire/`);
  return (url.origin + url.pathname).replace(/\/?$/, "/");
}
