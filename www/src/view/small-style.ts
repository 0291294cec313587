/** How small pictures and what is written below them look. */

import { css } from "lit";

export const smallStyle = css`
  figure {
    margin: 0;
    min-width: 0;
  }
  canvas {
    display: block;
    box-sizing: border-box;
    width: 100%;
    aspect-ratio: 1;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
  }
  figcaption {
    display: flex;
    flex-wrap: wrap;
    justify-content: space-between;
    gap: 0 4px;
    margin-top: 4px;
    font-size: 13px;
    line-height: 18px;
  }
  .name {
    flex: 1;
    min-width: 0;
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
    text-transform: capitalize;
    color: var(--quiet);
  }
`;
