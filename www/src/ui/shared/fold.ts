/** How groups that fold look. */

import { css } from "lit";

export const foldStyle = css`
  details {
    border-block-start: 1px solid var(--line);
  }
  summary {
    display: flex;
    align-items: center;
    gap: 8px;
    min-height: 44px;
    list-style: none;
    cursor: pointer;
  }
  summary::-webkit-details-marker {
    display: none;
  }
  summary svg.icon {
    margin-inline-start: auto;
    color: var(--quiet);
    transition: transform 150ms ease;
  }
  details[open] > summary svg.icon {
    transform: rotate(180deg);
  }
  .group {
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    gap: 16px;
    padding-block: 4px 16px;
  }
`;
