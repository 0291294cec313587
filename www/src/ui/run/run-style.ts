/** How Run and what goes with it looks: a block on a desk, a strip between stage and sheet on a phone. */

import { css } from "lit";

export const runStyle = css`
  :host {
    display: block;
  }
  .buttons {
    display: grid;
    grid-template-columns: repeat(4, minmax(0, 1fr));
    gap: 8px;
  }
  button {
    grid-column: span 2;
    min-height: 40px;
    padding: 0 8px;
    white-space: nowrap;
  }
  .primary,
  .wide {
    grid-column: 1 / -1;
  }
  .primary svg.icon {
    fill: currentColor;
  }
  .primary,
  .pause {
    min-height: 48px;
  }
  .pause {
    grid-column: span 2;
    font-weight: 600;
  }
  .bar {
    margin-block-start: 16px;
  }
  /* Three lines are kept free, so that nothing below moves when a run starts. */
  p {
    display: flex;
    flex-wrap: wrap;
    align-content: start;
    gap: 0 8px;
    min-height: 54px;
    margin: 8px 0 0;
    font-size: 13px;
    line-height: 18px;
    white-space: nowrap;
    color: var(--quiet);
  }
  .words {
    flex: 1;
    min-width: 60%;
    overflow-wrap: anywhere;
    white-space: normal;
  }
  .device {
    flex: 1 0 100%;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .steps {
    flex: 1;
  }
  /* A strip between stage and sheet: one row of buttons, two lines of words. */
  @media (max-width: 819px), (max-width: 1099px) and (orientation: portrait) {
    :host {
      display: flex;
      flex-direction: column;
    }
    .bar {
      order: -1;
      margin: 0 -16px 8px;
      border-radius: 0;
    }
    .buttons {
      display: flex;
    }
    button {
      flex: 1 1 auto;
      min-height: 44px;
    }
    .primary {
      flex-grow: 3;
    }
    p {
      min-height: 36px;
      margin: 4px 0;
    }
    .words {
      overflow: hidden;
      text-overflow: ellipsis;
      white-space: nowrap;
    }
    /* Too wide to stand beside the words. */
    .device {
      flex: 1 1 60%;
      min-width: 0;
    }
    .steps {
      position: absolute;
      clip-path: inset(50%);
    }
  }
  @media (max-width: 479px) {
    .going button:not(.pause) span {
      display: none;
    }
  }
`;
