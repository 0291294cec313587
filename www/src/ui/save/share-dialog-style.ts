/** How sharing looks. */

import { css } from "lit";
import { fileButtonStyle } from "./file-button-style";

export const shareDialogStyle = [
  fileButtonStyle,
  css`
    dialog {
      width: min(840px, calc(100vw - 32px));
      overflow: hidden auto;
    }
    header {
      display: flex;
      align-items: center;
      justify-content: space-between;
      padding-block-start: 16px;
      padding-inline: 24px 16px;
    }
    h1 {
      margin: 0;
      overflow: hidden;
      font-size: 20px;
      font-weight: 600;
      text-overflow: ellipsis;
      white-space: nowrap;
    }
    .tabs {
      display: flex;
      gap: 24px;
      padding-inline: 24px;
      border-block-end: 1px solid var(--line);
    }
    .tabs button {
      min-height: 44px;
      padding: 0;
      border: 0;
      border-block-end: 2px solid transparent;
      border-radius: 0;
      background: none;
      color: var(--quiet);
    }
    .tabs button[aria-selected="true"] {
      border-block-end-color: var(--copper);
      color: var(--ink);
      font-weight: 600;
    }
    .body {
      display: grid;
      gap: 16px;
      padding: 24px;
    }
    .body p {
      margin: 0;
    }
    .line {
      display: grid;
      grid-template-columns: minmax(0, 1fr) auto;
      gap: 8px;
    }
    .line input,
    .line button {
      min-height: 44px;
    }
    .line button {
      min-width: 136px;
    }
    .line input {
      color: var(--quiet);
      text-overflow: ellipsis;
    }
    .send {
      justify-self: start;
    }
    hr {
      width: 100%;
      margin: 8px 0;
      border: 0;
      border-block-start: 1px solid var(--line);
    }
    .ways {
      display: grid;
      grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
      gap: 24px 32px;
    }
    .with-code {
      grid-template: auto 1fr / auto minmax(0, 1fr);
    }
    .with-code .code {
      grid-row: 1 / 3;
    }
    section {
      display: grid;
      align-content: start;
      gap: 8px;
      min-width: 0;
    }
    h2 {
      color: var(--ink);
    }
    .code {
      max-width: 100%;
      height: auto;
      border: 1px solid var(--line);
      border-radius: 6px;
      forced-color-adjust: none;
    }
    .pair {
      display: flex;
      flex-wrap: wrap;
      gap: 8px;
    }
    .note {
      display: flex;
      gap: 8px;
    }
    .note svg {
      color: var(--amber-text);
    }
    .simpler {
      display: grid;
      gap: 8px;
    }
    @media (max-width: 639px) {
      dialog {
        width: 100vw;
        max-width: 100vw;
        height: 100dvh;
        max-height: 100dvh;
        margin: 0;
        border: 0;
        border-radius: 0;
      }
      header,
      .tabs {
        padding-inline-start: 16px;
      }
      .body {
        padding: 16px;
      }
      .line,
      .ways,
      .with-code {
        grid-template: none / minmax(0, 1fr);
      }
      .with-code .code {
        grid-row: auto;
      }
      .send {
        justify-self: stretch;
      }
      .code {
        justify-self: center;
      }
    }
  `,
];
