/** How two wires side by side look. */

import { css } from "lit";

export const wirePairStyle = css`
  :host {
    display: block;
  }
  table {
    width: 100%;
    border-collapse: collapse;
    table-layout: fixed;
    font-size: 13px;
    line-height: 18px;
  }
  th {
    font-weight: 400;
    text-align: start;
    color: var(--quiet);
  }
  thead th {
    padding: 0 4px 4px;
    font-weight: 600;
    color: var(--ink);
  }
  thead th:first-child,
  tbody th {
    width: 72px;
    padding-inline: 0 4px;
  }
  td {
    padding: 4px;
    font-weight: 600;
  }
  tbody tr:not(.picture) {
    border-block-start: 1px solid var(--line);
  }
  .picture th {
    vertical-align: top;
    padding-block-start: 4px;
  }
`;
