/** One choice of a few, side by side: radio buttons underneath, so that keys and screen readers know what they are. */

import { css, html, type TemplateResult } from "lit";

export interface Segmented {
  readonly legend: string;
  readonly name: string;
  readonly options: readonly { readonly value: string; readonly words: string; readonly title?: string }[];
  readonly value: string;
  readonly locked?: boolean;
  choose(value: string): void;
}

export function segmented({ legend, name, options, value, locked = false, choose }: Segmented): TemplateResult {
  return html`<fieldset class="segmented" ?disabled=${locked}>
    <legend>${legend}</legend>
    <div class="options">
      ${options.map(
        (option) => html`<label title=${option.title ?? ""}>
          <input
            type="radio"
            name=${name}
            value=${option.value}
            .checked=${option.value === value}
            @change=${() => choose(option.value)}
          /><span>${option.words}</span>
        </label>`,
      )}
    </div>
  </fieldset>`;
}

export const segmentedStyle = css`
  .segmented {
    min-width: 0;
    margin: 0;
    padding: 0;
    border: 0;
  }
  .segmented legend {
    margin-block-end: 4px;
    padding: 0;
    font-size: 13px;
    color: var(--quiet);
  }
  .segmented .options {
    display: flex;
    padding: 2px;
    border-radius: 6px;
    background: color-mix(in srgb, var(--ink) 8%, transparent);
  }
  .segmented label {
    position: relative;
    flex: 1 1 auto;
    min-width: 0;
    cursor: pointer;
  }
  .segmented input {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    margin: 0;
    opacity: 0;
    cursor: inherit;
  }
  .segmented span {
    display: grid;
    place-items: center;
    min-height: 32px;
    padding: 0 6px;
    border: 1px solid transparent;
    border-radius: 5px;
    font-size: 13px;
    line-height: 1.2;
    text-align: center;
    color: var(--quiet);
    overflow-wrap: anywhere;
    transition: background-color 150ms ease;
  }
  .segmented label:hover span {
    color: var(--ink);
  }
  .segmented input:checked + span {
    border-color: var(--copper);
    background: var(--raised);
    color: var(--ink);
  }
  .segmented input:focus-visible + span {
    outline: 2px solid var(--copper);
    outline-offset: 1px;
  }
  .segmented:disabled label {
    cursor: default;
  }
  .segmented:disabled span {
    color: var(--quiet);
  }
  @media (pointer: coarse) {
    .segmented span {
      min-height: 40px;
    }
  }
  @media (forced-colors: active) {
    .segmented input:checked + span {
      forced-color-adjust: none;
      background: Highlight;
      color: HighlightText;
    }
  }
`;
