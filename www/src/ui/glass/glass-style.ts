/** How the glass box looks. */

import { css } from "lit";

export const glassStyle = css`
  :host {
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    gap: 16px;
    align-content: start;
    padding: 8px 16px 24px;
  }
  header {
    display: flex;
    align-items: center;
    justify-content: space-between;
    gap: 8px;
    margin-inline-end: -8px;
  }
  h3 {
    margin: 0 0 4px;
    font-size: 15px;
    font-weight: 600;
  }
  p {
    margin: 0;
  }
  section {
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    gap: 4px;
    padding-block-start: 12px;
    border-block-start: 1px solid var(--line);
  }
  wire-strip {
    margin-inline: -16px;
  }
  .legend,
  .events {
    margin: 0;
    padding: 0;
    list-style: none;
  }
  .heads {
    display: flex;
    gap: 8px;
    justify-content: end;
    font-size: 13px;
    line-height: 18px;
  }
  .heads .loss {
    width: 6ch;
  }
  .legend label {
    display: grid;
    grid-template-columns: 20px 28px minmax(0, 1fr) 5ch 6ch;
    gap: 8px;
    align-items: center;
    min-height: 28px;
    font-size: 13px;
    line-height: 16px;
    cursor: pointer;
  }
  .swatch {
    width: 28px;
    height: 10px;
    overflow: visible;
  }
  .share,
  .loss {
    text-align: end;
    color: var(--quiet);
  }
  .check {
    display: flex;
    gap: 8px;
    align-items: center;
    min-height: 28px;
    font-size: 13px;
    cursor: pointer;
  }
  input[type="checkbox"] {
    width: 20px;
    height: 20px;
    margin: 0;
  }
  .events {
    max-height: 200px;
    overflow: auto;
  }
  .events button {
    justify-content: start;
    width: 100%;
    min-height: 28px;
    padding: 4px;
    font-size: 13px;
    line-height: 16px;
    text-align: start;
  }
  @media (pointer: coarse) {
    .legend label,
    .check,
    .events button {
      min-height: 44px;
    }
  }
`;
