/** How the shelf of shapes looks. */

import { css } from "lit";

export const shapePadStyle = css`
  svg {
    width: 50px;
    height: 50px;
  }
  .picture svg.icon {
    width: 22px;
    height: 22px;
    color: var(--quiet);
  }
  .clay {
    fill: var(--clay);
  }
  .rim {
    fill: var(--line-strong);
  }
  :is(.wire, .edge, .tube, .limb) {
    fill: none;
    stroke-linecap: round;
    stroke-linejoin: round;
  }
  .wire {
    stroke: var(--copper);
    stroke-width: 1.3;
  }
  .limb,
  .tube {
    stroke: var(--clay);
  }
  .tube {
    stroke-width: 7;
  }
  .edge {
    stroke: var(--raised);
    stroke-width: 9;
    stroke-linecap: butt;
  }
  :host {
    --clay: color-mix(in srgb, var(--line) 75%, var(--line-strong));
  }
  @media (forced-colors: active) {
    :host {
      --clay: color-mix(in srgb, CanvasText 25%, Canvas);
    }
  }
  .up {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    justify-content: space-between;
    gap: 4px 8px;
    margin-block-start: 8px;
    color: var(--quiet);
  }
  .up select {
    min-width: 0;
    color: var(--ink);
  }
  .line {
    min-height: 37px;
    margin: 6px 0 0;
    overflow-wrap: anywhere;
  }
  .problem {
    display: flex;
    align-items: start;
    gap: 4px;
    margin: 6px 0 0;
    padding: 8px;
    padding-inline-end: 0;
    border: 1px mesh var(--error);
    border-radius: 6px;
    background: var(--raised);
    color: var(--error);
    overflow-wrap: anywhere;
  }
  .problem span {
    flex: 1;
    min-width: 0;
  }
  .problem button {
    min-height: 32px;
    width: 32px;
  }
  @media (pointer: coarse) {
    .problem button {
      min-height: 44px;
      width: 44px;
    }
  }
`;
