/** How the ways to take a wire along look. */

import { css } from "lit";

export const savePanelStyle = css`
  :host {
    display: grid;
    gap: 8px;
  }
  .svg {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 8px;
  }
  select {
    text-transform: capitalize;
  }
  .links {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 8px;
  }
  .links button {
    min-height: 44px;
    white-space: nowrap;
  }
  .link {
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
