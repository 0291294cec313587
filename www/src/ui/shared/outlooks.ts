/** Small pictures of the wire, each a button to look at it from there. */

import { msg } from "@lit/localize";
import { css, html, type TemplateResult } from "lit";
import type { Heading } from "../../view/heading";
import { SMALL_PX } from "../../view/small-pictures";

export interface Outlook extends Heading {
  readonly words: string;
}

/** Its canvases are for the element to paint, in their order. Fires `look-from` with the heading that a person wants. */
export function outlooks(all: readonly Outlook[]): TemplateResult {
  return html`<ul>
    ${all.map(
      ({ words, azimuth, elevation }) => html`<li>
        <button title=${msg("Look from there")} @click=${({ currentTarget }: Event) => look(currentTarget!, { azimuth, elevation })}>
          <canvas width=${SMALL_PX} height=${SMALL_PX} aria-hidden="true"></canvas>
          <span class="words"><span class="unseen">${msg("Look at it:")} </span>${words}</span>
        </button>
      </li>`,
    )}
  </ul>`;
}

function look(button: EventTarget, detail: Heading): void {
  button.dispatchEvent(new CustomEvent<Heading>("look-from", { detail, bubbles: true, composed: true }));
}

export const outlookStyle = css`
  ul {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 1fr));
    gap: 8px;
    margin: 0;
    padding: 0;
    list-style: none;
  }
  button {
    display: block;
    width: 100%;
    min-height: 0;
    padding: 0 0 4px;
    overflow: hidden;
    font-size: 13px;
    line-height: 18px;
    color: var(--quiet);
  }
  button:hover {
    color: var(--ink);
  }
  canvas {
    display: block;
    width: 100%;
    aspect-ratio: 1;
  }
  .words {
    display: block;
  }
  .words::first-letter {
    text-transform: capitalize;
  }
`;
