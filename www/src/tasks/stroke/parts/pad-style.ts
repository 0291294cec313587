/** How the pad looks: a sheet with three tools below it, or beside it on a phone. */

import { css } from "lit";

export const padStyle = css`
  :host {
    display: block;
    container-type: inline-size;
    min-width: 0;
  }
  .head {
    display: flex;
    align-items: center;
    gap: 8px;
    min-height: 32px;
  }
  h2 {
    color: var(--ink);
  }
  .name {
    flex: 1;
    min-width: 0;
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .row {
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    gap: 8px;
  }
  .sheet {
    position: relative;
    aspect-ratio: 1;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
    box-shadow: var(--shadow);
    transition: border-color 150ms ease;
  }
  .over .sheet {
    border-color: var(--copper);
    outline: 2px solid var(--copper);
  }
  subject-canvas {
    position: absolute;
    inset: 0;
    transition: opacity 150ms ease;
  }
  .busy subject-canvas {
    opacity: 0.4;
  }
  .invitation {
    position: absolute;
    inset: 0;
    display: grid;
    place-content: center;
    justify-items: center;
    gap: 12px;
    margin: 8px;
    border: 1.5px dashed var(--line-strong);
    border-radius: 4px;
    padding: 8px;
    text-align: center;
    text-wrap: balance;
  }
  .invitation p {
    margin: 0;
  }
  .ways {
    display: flex;
    flex-wrap: wrap;
    gap: 8px;
  }
  .ways button {
    flex: 1 1 auto;
  }
  .landing {
    position: absolute;
    inset: 0;
    display: grid;
    place-content: center;
    background: color-mix(in srgb, var(--raised) 88%, transparent);
    font-weight: 600;
    pointer-events: none;
  }
  .tools {
    display: grid;
    grid-template-columns: repeat(3, minmax(0, 1fr));
    gap: 4px;
  }
  .tools button {
    flex-direction: column;
    gap: 2px;
    min-height: 52px;
    padding: 4px;
    font-size: 13px;
    line-height: 1.2;
    color: var(--quiet);
  }
  .tools button:hover:not(:disabled) {
    color: var(--ink);
  }
  .shelf {
    display: grid;
    grid-template-columns: repeat(5, minmax(0, 1fr));
    gap: 4px 8px;
  }
  .shelf p {
    grid-column: 1 / -1;
    margin: 0;
  }
  .shelf button {
    aspect-ratio: 1;
    width: 100%;
    max-width: 56px;
    min-height: 0;
    padding: 2px;
    background: #fff;
    overflow: hidden;
  }
  .shelf canvas {
    display: block;
    width: 100%;
    border-radius: 4px;
  }
  .line {
    min-height: 40px;
    margin: 4px 0 0;
    text-wrap: pretty;
    overflow-wrap: anywhere;
  }
  .segmented {
    margin-block-end: 12px;
  }
  summary {
    min-height: 36px;
  }
  summary .name {
    text-align: end;
  }
  summary svg.icon {
    margin: 0;
  }
  .group {
    gap: 8px;
  }
  .group p {
    margin: 0;
  }
  /* A narrow column on a small desk. */
  @container (max-width: 199px) {
    .invitation,
    .ways button {
      padding-inline: 4px;
      font-size: 13px;
    }
    .invitation {
      gap: 8px;
    }
    .tools {
      gap: 0;
    }
    .shelf {
      column-gap: 4px;
    }
  }
  /* A phone: wide, and low. */
  @container (min-width: 260px) {
    .row {
      grid-template-columns: minmax(0, 1fr) 76px;
    }
    .sheet {
      aspect-ratio: auto;
      height: clamp(196px, 28vh, 320px);
    }
    .tools,
    .shelf {
      grid-template-columns: minmax(0, 1fr);
      align-content: space-between;
    }
    .tools button {
      min-height: 60px;
    }
    .empty .row {
      grid-template-columns: minmax(0, 1fr);
    }
    .empty .shelf {
      grid-template-columns: repeat(5, minmax(44px, 56px));
      justify-content: space-between;
    }
    .line {
      min-height: 20px;
    }
  }
  @media (pointer: coarse) {
    summary {
      min-height: 44px;
    }
  }
`;
