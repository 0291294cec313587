/** How a button looks that saves a file: an icon, its name, and what it is for. */

import { css } from "lit";

export const fileButtonStyle = css`
  .file {
    justify-content: flex-start;
    gap: 12px;
    width: 100%;
    min-height: 48px;
    padding: 4px 12px;
    text-align: start;
  }
  .file > svg {
    color: var(--quiet);
  }
  .file span {
    min-width: 0;
    line-height: 1.3;
  }
  .file b {
    display: block;
    font-weight: 600;
  }
`;
