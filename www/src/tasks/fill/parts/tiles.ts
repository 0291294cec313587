/** A shelf of small pictures to choose one of: radio buttons underneath, so that keys and screen readers know what they are. */

import { css, html, type TemplateResult } from "lit";

export interface Tile {
  readonly value: string;
  readonly words: string;
  readonly picture: unknown;
}

export function tiles(name: string, options: readonly Tile[], chosen: string | null, locked: boolean, choose: (value: string) => void): TemplateResult[] {
  return options.map(
    ({ value, words, picture }) => html`<label class="tile">
      <input type="radio" name=${name} value=${value} ?disabled=${locked} .checked=${value === chosen} @change=${() => choose(value)} />
      <span class="picture">${picture}</span><span class="words">${words}</span>
    </label>`,
  );
}

export const tilesStyle = css`
  :host {
    display: block;
    container-type: inline-size;
    min-width: 0;
  }
  h2 {
    min-height: 28px;
    color: var(--ink);
  }
  .tiles {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 1fr));
    gap: 8px;
    min-width: 0;
    margin: 0;
    padding: 0;
    border: 0;
  }
  .tile,
  .tiles > button {
    position: relative;
    display: block;
    min-width: 0;
    min-height: 0;
    padding: 0;
    border: 0;
    background: none;
    font-size: 13px;
    line-height: 18px;
    text-align: center;
    color: var(--quiet);
    cursor: pointer;
  }
  .tile input {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    margin: 0;
    opacity: 0;
    cursor: inherit;
  }
  .tile input:disabled {
    cursor: default;
  }
  .picture {
    display: grid;
    place-items: center;
    height: 56px;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
    transition: border-color 150ms ease;
  }
  .words {
    display: block;
    margin-block-start: 2px;
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .tile:hover .picture,
  .tiles > button:hover:not(:disabled) .picture {
    border-color: var(--line-strong);
  }
  input:checked ~ .picture,
  button.chosen .picture {
    border-color: var(--copper);
    box-shadow: 0 0 0 1px var(--copper);
  }
  input:checked ~ .words,
  button.chosen .words {
    color: var(--ink);
    font-weight: 600;
  }
  input:focus-visible ~ .picture {
    outline: 2px solid var(--copper);
    outline-offset: 2px;
  }
  /* A narrow column on a small desk; and a wide sheet. */
  @container (max-width: 199px) {
    .tiles {
      grid-template-columns: repeat(2, minmax(0, 1fr));
    }
  }
  @container (min-width: 480px) {
    .tiles {
      grid-template-columns: repeat(6, minmax(0, 1fr));
    }
  }
  @media (forced-colors: active) {
    input:checked ~ .picture,
    button.chosen .picture {
      outline: 3px solid Highlight;
      outline-offset: -3px;
    }
  }
`;
