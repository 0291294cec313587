/** How the editor looks: a sheet with its tools beside it, or below it on a phone. */

import { css } from "lit";

export const sheetAndTools = css`
  :host {
    display: block;
    position: relative;
    min-height: 0;
  }
  dialog {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    max-width: none;
    max-height: none;
    margin: 0;
    padding: 0;
    border: 0;
    overflow: hidden;
    background: var(--paper);
    color: var(--ink);
    container-type: size;
  }
  dialog:modal {
    position: fixed;
    height: 100dvh;
  }
  dialog::backdrop {
    background: var(--paper);
  }
  .all {
    display: grid;
    grid-template: auto minmax(0, 1fr) / minmax(0, 1fr);
    height: 100%;
  }
  header {
    display: flex;
    align-items: center;
    gap: 4px;
    padding: 8px 24px;
  }
  header h2 {
    flex: none;
    font-size: 20px;
    line-height: 1.2;
    color: var(--ink);
  }
  .moved {
    flex: 1;
    min-width: 0;
    margin-inline-start: 8px;
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  header .primary {
    margin-inline-start: 8px;
    min-width: 88px;
  }
  .body {
    display: grid;
    grid-template: minmax(0, 1fr) / minmax(0, 1fr) 272px;
    gap: 24px;
    min-height: 0;
    padding: 8px 24px 24px;
  }
  .room {
    container-type: size;
    display: grid;
    place-items: start center;
    min-height: 0;
  }
  .sheet {
    position: relative;
    width: min(100cqw, 100cqh);
    aspect-ratio: 1;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
    box-shadow: var(--shadow);
  }
  .over .sheet {
    border-color: var(--copper);
    outline: 2px solid var(--copper);
  }
  ink-canvas {
    position: absolute;
    inset: 0;
  }
  .hint {
    position: absolute;
    inset: 0;
    display: grid;
    place-content: center;
    padding: 24px;
    text-align: center;
    text-wrap: balance;
    color: var(--quiet);
    pointer-events: none;
  }
  .side {
    display: grid;
    grid-template-rows: auto minmax(0, 1fr);
    gap: 16px;
    min-height: 0;
  }
  .tabs {
    display: grid;
    grid-template-columns: repeat(4, minmax(0, 1fr));
    border-block-end: 1px solid var(--line);
  }
  .tabs button {
    flex-direction: column;
    gap: 2px;
    min-height: 56px;
    padding: 4px;
    border: 0;
    border-radius: 6px 6px 0 0;
    background: none;
    color: var(--quiet);
    font-size: 13px;
  }
  .tabs button:hover {
    color: var(--ink);
  }
  .tabs [aria-selected="true"] {
    color: var(--ink);
    font-weight: 600;
    box-shadow: inset 0 -3px var(--copper);
  }
  .panel {
    display: flex;
    flex-direction: column;
    gap: 16px;
    min-height: 0;
    overflow: auto;
    overscroll-behavior: contain;
    /* Room for focus rings. */
    margin: -4px;
    padding: 4px;
  }
  .panel > * {
    flex: none;
  }
  .panel > icon-shelf {
    flex: 1 1 auto;
  }
  .panel p {
    margin: 0;
  }
  .field {
    display: grid;
    gap: 4px;
  }
  .field > span {
    font-size: 13px;
    color: var(--quiet);
  }
  .field input[type="text"] {
    min-height: 48px;
    padding: 0 12px;
    font-size: 20px;
  }
  .amount {
    display: grid;
    grid-template-columns: minmax(0, 1fr) 72px;
    align-items: center;
    gap: 12px;
  }
  .penwidth {
    display: grid;
    place-items: center;
    height: 72px;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
  }
  .penwidth i {
    width: var(--width);
    height: var(--width);
    border-radius: 50%;
    background: var(--ink);
  }
  .penwidth.erase i {
    border: 1.5px dashed var(--line-strong);
    background: none;
  }
  .check {
    display: flex;
    align-items: center;
    gap: 8px;
    min-height: 24px;
  }
  .check input {
    width: 18px;
    height: 18px;
    margin: 0;
  }
  .status {
    min-height: 40px;
    overflow-wrap: anywhere;
  }
  .problem {
    color: var(--error);
  }
  kbd {
    padding: 0 4px;
    border: 1px solid var(--line-strong);
    border-radius: 3px;
    font: inherit;
  }
  .fine {
    display: block;
  }
  @container (max-width: 639px) {
    header {
      padding: 4px 16px;
    }
    .body {
      grid-template: auto minmax(0, 1fr) / minmax(0, 1fr);
      gap: 8px;
      padding: 4px 16px 0;
    }
    .room {
      container-type: inline-size;
    }
    .sheet {
      width: min(100cqw, 48dvh);
    }
    /* Room for the keyboard, and for the shelf. */
    :is(.type, .icons) .sheet {
      width: min(100cqw, 30dvh);
    }
    .side {
      gap: 12px;
    }
    .panel {
      padding-block-end: 24px;
    }
    .tabs button {
      min-height: 48px;
    }
    .penwidth {
      display: none;
    }
  }
  @media (pointer: coarse) {
    .fine {
      display: none;
    }
    .check {
      min-height: 44px;
    }
  }
  @media (pointer: fine) {
    .coarse {
      display: none;
    }
  }
  @media (forced-colors: active) {
    .tabs [aria-selected="true"] {
      border-block-end: 3px solid Highlight;
    }
    .penwidth i {
      forced-color-adjust: none;
      background: CanvasText;
    }
  }
`;
