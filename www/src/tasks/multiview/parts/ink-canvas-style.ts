/** How a sheet that is drawn on looks. */

import { css } from "lit";

export const inkCanvasStyle = css`
  :host {
    display: block;
    position: relative;
    aspect-ratio: 1;
    overflow: hidden;
  }
  .sheet,
  canvas {
    position: absolute;
    inset: 0;
    display: block;
    width: 100%;
    height: 100%;
  }
  .sheet:focus-visible {
    outline-offset: -3px;
  }
  .drawing {
    cursor: crosshair;
  }
  .fingers {
    touch-action: none;
  }
  .cursor {
    position: absolute;
    left: 50%;
    top: 50%;
    width: 24px;
    height: 24px;
    margin: -12px;
    border: 2px solid var(--copper);
    border-radius: 50%;
    box-shadow: 0 0 0 1.5px var(--raised);
    pointer-events: none;
    opacity: 0;
  }
  .sheet:focus-visible .cursor {
    opacity: 1;
  }
  .cursor.down {
    background: var(--copper);
  }
`;
