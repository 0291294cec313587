/** How a choice along a slider looks: its name above it, and below it in words where it leads. */

import { css } from "lit";

export const choiceStyle = css`
  .choice {
    display: grid;
    min-width: 0;
  }
  .head,
  .ends {
    display: flex;
    justify-content: space-between;
    gap: 8px;
    font-size: 13px;
    line-height: 18px;
    color: var(--quiet);
  }
  .head {
    align-items: center;
  }
  b {
    font-weight: 600;
    color: var(--ink);
  }
  input[type="range"] {
    width: 100%;
  }
`;
