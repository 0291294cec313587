/** How a picture that is tapped or painted on looks. */

import { css } from "lit";

export const subjectCanvasStyle = css`
  :host {
    display: grid;
    place-items: center;
    container-type: size;
  }
  .frame {
    position: relative;
    width: min(100cqw, 100cqh * var(--aspect, 1));
    aspect-ratio: var(--aspect, 1);
    overflow: hidden;
  }
  .frame:focus-visible {
    outline-offset: -3px;
  }
  canvas {
    position: absolute;
    inset: 0;
    display: block;
    width: 100%;
    height: 100%;
  }
  /* Pictures with holes are on white paper for the wire, too. */
  #picture {
    background: #fff;
    forced-color-adjust: none;
  }
  .tappable {
    cursor: pointer;
  }
  .asks {
    cursor: crosshair;
    touch-action: none;
  }
  .box {
    position: absolute;
    border: 1.5px dashed var(--ink);
    outline: 1.5px solid var(--raised);
    pointer-events: none;
  }
  .box.under-way {
    border: 2px dashed var(--copper);
  }
  .workable {
    cursor: none;
    touch-action: none;
  }
  .ring {
    position: absolute;
    min-width: 16px;
    aspect-ratio: 1;
    translate: -50% -50%;
    border: 2px solid var(--copper);
    border-radius: 50%;
    outline: 1.5px solid var(--raised);
    box-shadow: inset 0 0 0 1.5px var(--raised);
    pointer-events: none;
    opacity: 0;
  }
  .ring.takes {
    border-style: dashed;
    border-color: var(--ink);
  }
  .ring.corner {
    border: 0;
    outline: 0;
    box-shadow: none;
    width: 0;
    min-width: 0;
  }
  .ring::before,
  .ring:is(.adds, .corner)::after {
    content: "";
    position: absolute;
    inset: 0;
    margin: auto;
    width: 9px;
    height: 2px;
    background: var(--ink);
    box-shadow: 0 0 0 1px var(--raised);
  }
  .ring.corner::before,
  .ring.corner::after {
    inset: -1px -11px;
    width: 22px;
  }
  .ring:is(.adds, .corner)::after {
    rotate: 90deg;
  }
  .workable:is(:hover, :focus-visible) .ring {
    opacity: 1;
  }
  @media (forced-colors: active) {
    .ring {
      forced-color-adjust: none;
      border-color: Highlight;
    }
  }
`;
