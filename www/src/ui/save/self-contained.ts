/** A wire as one HTML file, which shows it on any device, from a disk as well, and asks nobody for anything. */

import { escaped, inScript, written, type Attributes } from "./markup";

export interface SelfContained {
  /** The text of the element's module, wire-sculpture.js. */
  readonly module: string;
  /** The element's attributes. */
  readonly attributes: Attributes;
  readonly title: string;
  /** What there is to see, for those who do not see it, and for search. */
  readonly description: string;
  /** A picture for where there is no script, as the text of an SVG. */
  readonly svg: string;
  /** Marks the file's own script and style; whoever writes title or description must not know it beforehand. */
  readonly nonce: string;
}

const STYLE = `html,body{height:100%;margin:0;color-scheme:light dark;background:light-dark(#f6f3ee,#302d29);color:light-dark(#1d1b19,#ece7df);font:15px/1.45 system-ui,sans-serif}
body{display:grid;grid-template-rows:minmax(0,1fr) auto}
wire-sculpture{display:block;width:100%;height:100%;min-height:0}
noscript img{display:block;width:100%;height:100%;object-fit:contain}
h1{margin:0;padding:12px 16px;font-size:15px;font-weight:400;text-align:center}`;

/** @throws Error for a nonce that is none. */
export function selfContainedHtml({ module, attributes, title, description, svg, nonce }: SelfContained): string {
  if (!/^[\w+/-]{16,}={0,2}$/.test(nonce)) throw new Error("A nonce is at least 16 characters of base64.");
  const policy = [
    "default-src 'none'",
    `script-src 'nonce-${nonce}'`,
    // The element looks after its styles by itself; those of attributes are no danger here.
    `style-src 'nonce-${nonce}'`,
    "img-src data: blob:",
    "connect-src data:",
    "worker-src blob:",
    "base-uri 'none'",
    "form-action 'none'",
  ].join("; ");
  const poster = svg ? `<noscript><img src="${escaped(svgUrl(svg))}" alt="${escaped(description)}"></noscript>` : "";
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="description" content="${escaped(description)}">
<meta name="generator" content="Wire4D">
<title>${escaped(title)}</title>
<style nonce="${nonce}">${STYLE}</style>
</head>
<body>
<main><wire-sculpture${written(attributes)}></wire-sculpture>${poster}</main>
<h1>${escaped(title)}</h1>
<script type="module" nonce="${nonce}">
${inScript(module)}
</script>
</body>
</html>
`;
}

/** As an address that may stand in a file. */
export const svgUrl = (svg: string): string => `data:image/svg+xml,${encodeURIComponent(svg)}`;
