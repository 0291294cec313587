/** How the dialog of pictures and films looks. */

import { css } from "lit";

export const filmDialogStyle = css`
  dialog {
    width: min(760px, calc(100vw - 32px));
  }
  .body {
    display: grid;
    grid-template-columns: 320px minmax(0, 1fr);
    align-items: start;
    gap: 24px;
    padding: 8px 24px 16px;
  }
  .choices {
    display: grid;
    gap: 12px;
    min-width: 0;
  }
  .sides {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto minmax(0, 1fr);
    align-items: center;
    gap: 8px;
  }
  .pair {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr));
    gap: 12px;
  }
  label.field {
    display: grid;
    gap: 4px;
    min-width: 0;
    font-size: 13px;
    color: var(--quiet);
  }
  label.field select {
    font-size: 15px;
    color: var(--ink);
    text-transform: capitalize;
  }
  p {
    margin: 0;
  }
  footer {
    position: sticky;
    bottom: 0;
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    align-items: center;
    gap: 8px 16px;
    min-height: 84px;
    padding: 12px 24px;
    border-block-start: 1px solid var(--line);
    background: var(--raised);
  }
  #course {
    min-height: 20px;
  }
  footer .bar {
    margin-block-start: 4px;
  }
  .problem {
    color: var(--error);
  }
  @media (max-width: 719px) {
    .body {
      grid-template-columns: minmax(0, 1fr);
      gap: 16px;
      padding-inline: 16px;
    }
    header,
    footer {
      padding-inline: 16px;
    }
    footer {
      grid-template-columns: minmax(0, 1fr);
    }
  }
`;
