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

/** A title and the button that closes it, which stay while the rest scrolls. */
export const dialogHeadStyle = css`
  header {
    position: sticky;
    top: 0;
    z-index: 1;
    display: flex;
    align-items: center;
    justify-content: space-between;
    padding-block: 16px 8px;
    padding-inline: 24px 16px;
    background: var(--raised);
  }
  h1 {
    margin: 0;
    font-size: 20px;
    font-weight: 600;
  }
`;
