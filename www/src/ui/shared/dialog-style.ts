/** The frame of a dialog. */

import { css } from "lit";

export const dialogStyle = css`
  dialog {
    max-height: calc(100dvh - 32px);
    padding: 0;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
    color: var(--ink);
    box-shadow: var(--shadow);
  }
  dialog::backdrop {
    background: rgb(20 16 12 / 45%);
  }
`;
