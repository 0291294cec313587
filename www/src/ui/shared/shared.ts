/** Styles that several elements share: three sizes of text (13, 15, 20 px), two weights, 8 px grid, corners of 6 px. */

import { css } from "lit";

export const controls = css`
  *,
  *::before,
  *::after {
    box-sizing: border-box;
  }
  [hidden] {
    display: none !important;
  }
  button,
  select,
  input {
    font: inherit;
    color: inherit;
  }
  button {
    display: inline-flex;
    align-items: center;
    justify-content: center;
    gap: 8px;
    min-width: 0;
    min-height: 40px;
    padding: 0 12px;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
    cursor: pointer;
    transition: background-color 150ms ease, border-color 150ms ease;
  }
  button:hover:not(:disabled) {
    border-color: var(--line-strong);
  }
  button:disabled {
    color: var(--quiet);
    cursor: default;
    opacity: 0.6;
  }
  button.primary {
    border-color: transparent;
    background: var(--copper-fill);
    color: var(--on-copper);
    font-weight: 600;
    box-shadow: var(--shadow);
  }
  button.primary:hover:not(:disabled) {
    background: color-mix(in srgb, var(--copper-fill), var(--ink) 12%);
  }
  button.plain {
    border-color: transparent;
    background: none;
  }
  button.plain:hover:not(:disabled) {
    background: color-mix(in srgb, var(--ink) 7%, transparent);
  }
  button.square {
    flex: none;
    width: 40px;
    padding: 0;
  }
  select,
  input:is([type="number"], [type="text"]) {
    min-width: 0;
    min-height: 36px;
    padding: 0 8px;
    border: 1px solid var(--line-strong);
    border-radius: 6px;
    background: var(--raised);
  }
  input:is([type="range"], [type="checkbox"], [type="radio"]) {
    accent-color: var(--copper);
  }
  input[type="range"] {
    min-width: 0;
    margin: 0;
    height: 24px;
  }
  :focus-visible {
    outline: 2px solid var(--copper);
    outline-offset: 2px;
  }
  svg.icon {
    flex: none;
    width: 20px;
    height: 20px;
    fill: none;
    stroke: currentColor;
    stroke-width: 1.8;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  h2 {
    margin: 0;
    font-size: 13px;
    font-weight: 600;
    color: var(--quiet);
  }
  .small {
    font-size: 13px;
    line-height: 1.4;
  }
  .quiet {
    color: var(--quiet);
  }
  .unseen {
    position: absolute;
    width: 1px;
    height: 1px;
    overflow: hidden;
    clip-path: inset(50%);
    white-space: nowrap;
  }
  @media (pointer: coarse) {
    button,
    select,
    input:is([type="number"], [type="text"]) {
      min-height: 44px;
    }
    button.square {
      width: 44px;
    }
    input[type="range"] {
      height: 44px;
    }
  }
  @media (forced-colors: active) {
    button.primary {
      forced-color-adjust: none;
      border-color: ButtonText;
    }
  }
  @media (prefers-reduced-motion: reduce) {
    *,
    *::before,
    *::after {
      transition: none !important;
      animation: none !important;
    }
  }
`;

/** A thin bar that fills from its start, `<div class="bar"><i></i></div>`, up to the share in `--share`. */
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
