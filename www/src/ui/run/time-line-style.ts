/** How the run as time looks. */

import { css } from "lit";

export const timeLineStyle = css`
  :host {
    display: block;
    container-type: inline-size;
    padding: 8px 16px;
  }
  .all {
    display: grid;
    grid-template: auto 24px / auto minmax(0, 1fr) auto;
    gap: 0 12px;
    align-items: center;
    min-height: 56px;
  }
  .play {
    grid-row: 1 / 3;
  }
  .label {
    overflow: hidden;
    font-size: 13px;
    line-height: 20px;
    color: var(--quiet);
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .label b {
    font-weight: 600;
    color: var(--ink);
  }
  .way {
    position: relative;
    grid-column: 2;
    height: 24px;
  }
  .way input {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 24px;
  }
  /* The middle of the range's handle goes from 8 px to 8 px before the end. */
  .marks {
    position: absolute;
    inset: 0 8px auto;
    height: 0;
    margin: 0;
    padding: 0;
    list-style: none;
  }
  .marks li {
    position: absolute;
    top: -3px;
    width: 2px;
    height: 7px;
    border-radius: 1px;
    background: var(--line-strong);
  }
  /* Where control points came, went or were laid anew. */
  .marks :is(.reinit, .refine, .respace, .thin) {
    top: -6px;
    height: 10px;
    background: var(--copper);
  }
  .marks .done {
    background: var(--copper);
  }
  .acts {
    grid-row: 1 / 3;
    grid-column: 3;
    display: flex;
    gap: 8px;
  }
  .acts button {
    min-height: 36px;
    font-size: 13px;
    white-space: nowrap;
  }
  .hint {
    grid-column: 1 / -1;
    grid-row: 1 / 3;
    margin: 0;
    text-align: center;
  }
  /* No room beside it: two halves below it. */
  @container (max-width: 499px) {
    .all {
      grid-template: 20px 24px 52px / auto minmax(0, 1fr);
    }
    .acts {
      grid-row: 3;
      grid-column: 1 / -1;
      align-self: end;
    }
    .acts button {
      flex: 1;
    }
    .hint {
      grid-row: 1 / 4;
    }
  }
  @media (pointer: coarse) {
    .acts button {
      min-height: 44px;
    }
  }
  @media (forced-colors: active) {
    .marks li {
      background: CanvasText;
    }
  }
`;
