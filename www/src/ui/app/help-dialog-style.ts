/** How help looks. */

import { css } from "lit";

export const helpDialogStyle = css`
  dialog {
    width: min(560px, calc(100vw - 32px));
  }
  .body {
    display: grid;
    gap: 16px;
    padding: 0 24px 24px;
  }
  .body > * {
    margin: 0;
  }
  h2 {
    margin-block-start: 8px;
    color: var(--ink);
  }
  dl {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    gap: 8px 24px;
    margin: 0;
  }
  dt {
    white-space: nowrap;
  }
  dd {
    margin: 0;
  }
  a {
    color: var(--copper-text);
    text-underline-offset: 3px;
  }
  kbd {
    display: inline-block;
    min-width: 24px;
    padding: 0 6px;
    border: 1px solid var(--line-strong);
    border-radius: 4px;
    font: inherit;
    font-size: 13px;
    text-align: center;
  }
  label {
    display: flex;
    align-items: center;
    gap: 8px;
    min-height: 24px;
  }
  .language select {
    min-height: 40px;
    padding: 0 8px;
    border: 1px solid var(--line-strong);
    border-radius: 6px;
    background: var(--raised);
    color: inherit;
  }
  input {
    flex: none;
    width: 20px;
    height: 20px;
    margin: 0;
  }
`;
