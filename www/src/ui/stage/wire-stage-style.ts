/** How the stage and its controls look. */

import { css } from "lit";

export const wireStageStyle = css`
  :host {
    position: relative;
    display: flex;
    flex-direction: column;
    overflow: hidden;
    container-type: inline-size;
    background: var(--stage);
  }
  canvas {
    display: block;
    flex: 1;
    min-height: 0;
    width: 100%;
    mask-image: linear-gradient(to right, transparent, #000 6%, #000 94%, transparent), linear-gradient(transparent, #000 6%, #000 94%, transparent);
    mask-composite: intersect;
    touch-action: none;
    cursor: grab;
  }
  canvas:active {
    cursor: grabbing;
  }
  /* The mask would take the ring as well. */
  canvas:focus-visible {
    outline: none;
  }
  canvas:focus-visible ~ .ring {
    position: absolute;
    inset: 4px;
    border: 2px solid var(--copper);
    border-radius: 6px;
    pointer-events: none;
  }
  .bar {
    position: relative;
    display: flex;
    flex: none;
    flex-wrap: wrap;
    align-items: center;
    justify-content: center;
    gap: 8px;
    padding: 4px 8px 16px;
  }
  .group {
    display: flex;
    flex: none;
    padding: 3px;
    border: 1px solid var(--line);
    border-radius: 9px;
    background: var(--raised);
    box-shadow: var(--shadow);
  }
  .group button {
    min-height: 32px;
    padding: 0 12px;
    border-color: transparent;
    background: none;
    font-size: 13px;
  }
  .group button.square {
    width: 32px;
    padding: 0;
  }
  .group button:hover {
    background: color-mix(in srgb, var(--ink) 7%, transparent);
  }
  .views button {
    min-width: 56px;
    text-transform: capitalize;
  }
  .group button[aria-pressed="true"] {
    background: var(--copper-wash, color-mix(in srgb, var(--copper) 18%, transparent));
    color: var(--copper-text);
    font-weight: 600;
  }
  .more {
    display: flex;
    gap: 8px;
  }
  .group select {
    min-height: 32px;
    padding: 0 4px 0 8px;
    border: 0;
    background: none;
    font-size: 13px;
    cursor: pointer;
  }
  .toggle {
    display: none;
  }
  @media (pointer: coarse) {
    .bar {
      padding-bottom: 8px;
    }
    .group :is(button, select) {
      min-height: 44px;
    }
    .group button.square {
      width: 44px;
    }
  }
  @container (max-width: 660px) {
    .views.many button {
      min-width: 0;
      padding: 0 6px;
    }
    .bar {
      flex-wrap: nowrap;
    }
    .toggle {
      display: flex;
    }
    .more {
      position: absolute;
      bottom: 100%;
      left: 0;
      right: 0;
      justify-content: center;
      padding: 0 8px;
    }
    .more .group:last-child {
      flex: 0 1 auto;
      min-width: 0;
    }
    .more select {
      min-width: 0;
      text-overflow: ellipsis;
    }
    .more:not(.open) {
      display: none;
    }
  }
  @container (max-width: 400px) {
    .more .group button.square {
      width: 38px;
    }
  }
  @media (forced-colors: active) {
    .group button[aria-pressed="true"] {
      forced-color-adjust: none;
      background: Highlight;
      color: HighlightText;
    }
  }
  .problem,
  .lost {
    max-width: 40ch;
    margin: auto;
    padding: 24px;
    text-align: center;
    text-wrap: balance;
  }
  .problem p,
  .lost {
    color: var(--quiet);
  }
  .problem h2 {
    font-size: 15px;
    color: var(--ink);
  }
  .problem svg {
    width: 96px;
    height: 96px;
    stroke-width: 0.6;
    color: var(--copper);
  }
  .lost {
    position: absolute;
    inset: 0 0 56px;
    display: grid;
    place-content: center;
  }
`;
