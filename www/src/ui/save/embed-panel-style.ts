/** How embedding looks. */

import { css } from "lit";

export const embedPanelStyle = css`
  :host {
    display: grid;
    gap: 24px;
  }
  .look {
    display: grid;
    grid-template-columns: minmax(0, 3fr) minmax(0, 2fr);
    gap: 24px;
  }
  .preview {
    display: grid;
    place-items: center;
    min-height: 240px;
    margin: 0;
    padding: 12px;
    border-radius: 6px;
    background: color-mix(in srgb, var(--ink) 5%, transparent);
  }
  wire-sculpture {
    display: block;
    width: 100%;
    aspect-ratio: 4 / 3;
    font: inherit;
    border-radius: 4px;
    overflow: hidden;
  }
  wire-sculpture.fluid {
    aspect-ratio: 3 / 2;
  }
  wire-sculpture.square {
    width: min(100%, 360px);
    aspect-ratio: 1;
  }
  .choices {
    display: grid;
    align-content: start;
    gap: 12px;
  }
  label {
    display: flex;
    align-items: center;
    gap: 8px;
    min-height: 24px;
  }
  .segmented label {
    display: block;
  }
  input[type="checkbox"] {
    flex: none;
    width: 20px;
    height: 20px;
    margin: 0;
  }
  input[type="color"] {
    width: 44px;
    height: 32px;
    padding: 2px;
    border: 1px solid var(--line-strong);
    border-radius: 6px;
    background: var(--raised);
  }
  .colour {
    display: flex;
    align-items: center;
    justify-content: space-between;
    min-height: 32px;
  }
  .take {
    display: grid;
    gap: 8px;
    justify-items: start;
  }
  .take > * {
    max-width: 100%;
    margin: 0;
  }
  a {
    color: var(--copper-text);
    text-underline-offset: 3px;
  }
  pre {
    width: 100%;
    max-height: 144px;
    padding: 12px;
    overflow: auto;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--paper);
  }
  pre code {
    font: 13px/1.5 ui-monospace, "SF Mono", "Cascadia Mono", "Roboto Mono", "DejaVu Sans Mono", monospace;
    white-space: pre-wrap;
    overflow-wrap: anywhere;
  }
  .pair {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 8px;
  }
  @media (max-width: 639px) {
    .look {
      grid-template-columns: minmax(0, 1fr);
    }
    .take {
      justify-items: stretch;
    }
  }
  @media (pointer: coarse) {
    label {
      min-height: 44px;
    }
    .segmented label {
      min-height: 0;
    }
  }
`;
