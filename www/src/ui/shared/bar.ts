/** A thin bar that fills from its start: `<div class="bar"><i></i></div>`, up to the share in `--share`. */

import { css } from "lit";

export const barStyle = css`
  .bar {
    height: 4px;
    overflow: hidden;
    border-radius: 2px;
    background: var(--line);
  }
  .bar i {
    display: block;
    height: 100%;
    background: var(--copper);
    transform: scaleX(var(--share, 0));
    transform-origin: left;
    transition: transform 150ms linear;
  }
  :host(:dir(rtl)) .bar i {
    transform-origin: right;
  }
  @media (forced-colors: active) {
    .bar {
      border: 1px solid CanvasText;
    }
    .bar i {
      forced-color-adjust: none;
      background: Highlight;
    }
  }
`;
