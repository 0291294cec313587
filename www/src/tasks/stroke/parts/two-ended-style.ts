/** How a slider with two ends looks. */

import { css } from "lit";

export const twoEndedStyle = css`
  :host {
    display: block;
  }
  .track {
    position: relative;
    height: 24px;
  }
  .track::before,
  .between {
    content: "";
    position: absolute;
    inset-block-start: calc(50% - 3px);
    inset-inline: 0;
    height: 6px;
    border-radius: 3px;
    background: color-mix(in srgb, var(--ink) 18%, transparent);
  }
  .between {
    background: var(--copper);
  }
  input[type="range"] {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    appearance: none;
    background: none;
    /* Only its thumb, or the upper one would cover the other. */
    pointer-events: none;
  }
  input::-webkit-slider-thumb {
    width: 18px;
    height: 18px;
    border: 2px solid var(--raised);
    border-radius: 9px;
    background: var(--copper);
    appearance: none;
    cursor: pointer;
    pointer-events: auto;
  }
  input::-moz-range-thumb {
    width: 14px;
    height: 14px;
    border: 2px solid var(--raised);
    border-radius: 9px;
    background: var(--copper);
    cursor: pointer;
    pointer-events: auto;
  }
  input:focus-visible {
    outline: none;
  }
  input:focus-visible::-webkit-slider-thumb {
    outline: 2px solid var(--copper);
    outline-offset: 2px;
  }
  input:focus-visible::-moz-range-thumb {
    outline: 2px solid var(--copper);
    outline-offset: 2px;
  }
  .off {
    opacity: 0.5;
  }
  @media (pointer: coarse) {
    .track {
      height: 44px;
    }
    input::-webkit-slider-thumb {
      width: 26px;
      height: 26px;
      border-radius: 13px;
    }
    input::-moz-range-thumb {
      width: 22px;
      height: 22px;
      border-radius: 13px;
    }
  }
  @media (forced-colors: active) {
    .between,
    input::-webkit-slider-thumb {
      forced-color-adjust: none;
      background: Highlight;
    }
    .track::before {
      background: CanvasText;
    }
  }
`;
