/** How what a wire amounts to looks: pictures beside a sentence, and figures below them. */

import { css } from "lit";

export const resultStyle = css`
  :host {
    display: grid;
    gap: 8px;
  }
  /* Four lines are kept free: nothing below moves when there is something to say. */
  p {
    min-height: 73px;
    margin: 0;
    overflow-wrap: anywhere;
  }
  .beside {
    display: grid;
    grid-template-columns: minmax(0, 1fr) minmax(0, 2fr);
    gap: 8px;
    margin-block-end: 8px;
  }
  .beside match-panels {
    grid-template-columns: minmax(0, 1fr);
  }
  dl {
    display: grid;
    grid-template-columns: 1.6fr 1fr;
    gap: 0 16px;
    margin: 0 0 8px;
    font-size: 13px;
  }
  dl div {
    display: flex;
    justify-content: space-between;
    gap: 8px;
    padding-block: 4px;
    border-block-end: 1px solid var(--line);
  }
  dl .wide {
    grid-column: 1 / -1;
  }
  dt {
    color: var(--quiet);
  }
  dd {
    margin: 0;
    font-weight: 600;
    white-space: nowrap;
  }
  .fault {
    text-align: end;
    text-wrap: balance;
    white-space: normal;
  }
  /* Two lines in most columns, and nothing below moves when they come. */
  .tight {
    min-height: 2lh;
  }
  .fault button {
    min-height: 24px;
    padding: 0;
    border: 0;
    background: none;
    font-weight: inherit;
    text-align: inherit;
    text-decoration: underline;
    text-decoration-color: #d81b60;
  }
  .fault button[aria-pressed="true"] {
    text-decoration-thickness: 3px;
  }
`;
