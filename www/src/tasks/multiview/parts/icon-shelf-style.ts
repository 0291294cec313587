/** How the shelf of icons looks. */

import { css } from "lit";

export const iconShelfStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    gap: 12px;
    min-height: 0;
  }
  .search {
    position: relative;
  }
  .search .icon {
    position: absolute;
    inset-block-start: calc(50% - 10px);
    inset-inline-start: 10px;
    color: var(--quiet);
    pointer-events: none;
  }
  .search input {
    width: 100%;
    min-height: 40px;
    padding-block: 0;
    padding-inline: 38px 8px;
    border: 1px solid var(--line-strong);
    border-radius: 6px;
    background: var(--raised);
  }
  .width {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr) 3.2em;
    align-items: center;
    gap: 8px;
  }
  output {
    text-align: end;
  }
  .scroll {
    flex: 1 1 auto;
    min-height: 200px;
    overflow: auto;
    overscroll-behavior: contain;
    /* Room for the focus ring. */
    margin: -4px;
    padding: 4px;
  }
  .grid {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(52px, 1fr));
    gap: 4px;
  }
  .grid button {
    aspect-ratio: 1;
    min-height: 0;
    padding: 0;
  }
  .grid button[aria-pressed="true"] {
    border-color: var(--copper);
    background: var(--copper-wash, var(--raised));
  }
  .grid svg {
    width: 62%;
    height: 62%;
    fill: none;
    stroke: currentColor;
    stroke-width: var(--stroke);
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .rest {
    width: 100%;
    margin-block-start: 8px;
  }
  .nothing {
    display: grid;
    justify-items: center;
    gap: 12px;
    padding: 32px 8px;
    text-align: center;
    color: var(--quiet);
    overflow-wrap: anywhere;
  }
  .nothing p {
    margin: 0;
  }
  .nothing div {
    display: flex;
    flex-wrap: wrap;
    justify-content: center;
    gap: 8px;
  }
  details {
    color: var(--quiet);
  }
  summary {
    min-height: 24px;
    cursor: pointer;
  }
  pre {
    max-height: 160px;
    margin: 8px 0 0;
    padding: 8px;
    overflow: auto;
    border: 1px solid var(--line);
    border-radius: 6px;
    font: 11px/1.4 ui-monospace, monospace;
    white-space: pre-wrap;
  }
  @media (pointer: coarse) {
    .search input {
      min-height: 44px;
    }
    summary {
      min-height: 44px;
      padding-block: 12px;
    }
  }
  @media (forced-colors: active) {
    .grid button[aria-pressed="true"] {
      border: 3px solid Highlight;
    }
  }
`;
