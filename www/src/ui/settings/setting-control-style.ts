/** How a setting looks. */

import { css } from "lit";

export const settingControlStyle = css`
  :host {
    display: block;
  }
  .head {
    display: flex;
    align-items: center;
    justify-content: space-between;
    gap: 4px;
    min-height: 28px;
  }
  .head label {
    min-width: 0;
    overflow-wrap: anywhere;
  }
  /* Beside the label, never on a line of its own. */
  .changed label {
    position: relative;
    padding-inline-end: 10px;
  }
  .changed label::after {
    content: "";
    position: absolute;
    inset-block-start: calc(50% - 3px);
    inset-inline-end: 0;
    width: 6px;
    height: 6px;
    border-radius: 3px;
    background: var(--copper);
  }
  .back {
    flex: none;
    gap: 4px;
    min-height: 28px;
    padding: 0 4px;
    padding-inline: 4px 0;
    font-size: 13px;
    color: var(--copper-text);
  }
  .back svg.icon {
    width: 16px;
    height: 16px;
  }
  .value {
    display: flex;
    align-items: center;
    gap: 8px;
  }
  .value > select,
  input[type="range"] {
    flex: 1;
  }
  input[type="number"] {
    flex: 0 1 88px;
    width: 88px;
  }
  .seed input {
    flex: 1;
  }
  input[aria-invalid="true"] {
    border-color: var(--error);
    outline-color: var(--error);
  }
  input[type="checkbox"] {
    flex: none;
    width: 20px;
    height: 20px;
    margin: 0;
  }
  .unit {
    flex: none;
    min-width: 0;
    font-size: 13px;
    color: var(--quiet);
  }
  p {
    margin: 2px 0 0;
  }
  .problem {
    color: var(--error);
  }
  @media (pointer: coarse) {
    .back,
    .head {
      min-height: 44px;
    }
    input[type="checkbox"] {
      width: 24px;
      height: 24px;
    }
  }
  @media (forced-colors: active) {
    .changed label::after {
      forced-color-adjust: none;
      background: Highlight;
    }
  }
`;
