/** The page's icons, 20 px, drawn as strokes. */

import { svg, html, type TemplateResult } from "lit";

const icon = (shapes: TemplateResult): TemplateResult => html`<svg class="icon" viewBox="0 0 20 20" aria-hidden="true">${shapes}</svg>`;

export const icons = {
  run: icon(svg`<path d="M6 4.2v11.6l9.5-5.8z" fill="currentColor" />`),
  pause: icon(svg`<path d="M7 4.5v11M13 4.5v11" />`),
  stop: icon(svg`<rect x="5" y="5" width="10" height="10" rx="1.5" />`),
  download: icon(svg`<path d="M10 3v9.5M6 9l4 4 4-4M3.5 16.5h13" />`),
  link: icon(svg`<path d="M8.5 11.5a3 3 0 0 0 4.3 0l2.7-2.7a3 3 0 0 0-4.3-4.3l-1 1M11.5 8.5a3 3 0 0 0-4.3 0l-2.7 2.7a3 3 0 0 0 4.3 4.3l1-1" />`),
  close: icon(svg`<path d="m5.5 5.5 9 9m0-9-9 9" />`),
  picture: icon(svg`<rect x="3" y="4" width="14" height="12" rx="1.5" /><path d="m3.5 14 4-4 3 3 2.5-2.5 3.5 3.5" /><circle cx="12.8" cy="7.6" r="1.1" />`),
  file: icon(svg`<path d="M5 3h6.5L15 6.5V17H5zM11.5 3v3.5H15" />`),
  warning: icon(svg`<path d="M10 3.2 17.6 16.5H2.4zM10 8.2v3.6M10 14.2v.1" />`),
};
