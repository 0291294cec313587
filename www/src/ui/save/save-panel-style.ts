/** How the ways to take a wire along look. */

import { css } from "lit";

export const savePanelStyle = css`
  :host {
    display: grid;
    gap: 8px;
  }
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
  .svg {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 8px;
  }
  select {
    text-transform: capitalize;
  }
  .link {
    min-height: 44px;
    font-weight: 600;
  }
  input {
    width: 100%;
  }
  p {
    margin: 0;
  }
  .group {
    gap: 8px;
    padding-block-end: 8px;
  }
  details {
    border-block-end: 1px solid var(--line);
  }
`;
