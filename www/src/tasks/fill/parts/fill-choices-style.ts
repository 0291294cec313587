/** How the choices that matter most look: sliders below each other, or side by side on a phone. */

import { css } from "lit";

export const fillChoicesStyle = css`
  :host {
    display: block;
    container-type: inline-size;
    min-width: 0;
  }
  .all {
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    gap: 12px;
  }
  .off b {
    color: var(--quiet);
  }
  .run {
    display: flex;
    align-items: center;
    justify-content: space-between;
    gap: 8px;
    font-size: 13px;
    color: var(--quiet);
  }
  select {
    flex: 0 1 auto;
    color: var(--ink);
  }
  @container (max-width: 199px) {
    .run {
      display: grid;
    }
  }
  /* Always there: nothing jumps when lines are laid. */
  .laying {
    display: grid;
    gap: 4px;
    min-height: 24px;
  }
  .laying:not(.busy) .bar {
    visibility: hidden;
  }
  /* A phone: side by side. */
  @container (min-width: 300px) {
    .all {
      grid-template-columns: repeat(2, minmax(0, 1fr));
      gap: 12px 24px;
    }
    .laying {
      grid-column: 1 / -1;
    }
    .run {
      display: grid;
      grid-template-columns: minmax(0, 1fr);
      align-content: start;
      gap: 4px;
    }
    select {
      width: 100%;
    }
  }
`;
