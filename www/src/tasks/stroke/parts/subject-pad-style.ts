/** How the pad for one picture looks, besides what pads share: three tools below the sheet, or beside it on a phone. */

import { css } from "lit";

export const subjectPadStyle = css`
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
  .pointed {
    display: flex;
    flex-wrap: wrap;
    gap: 8px;
    margin-block-end: 12px;
  }
  .pointed button {
    flex: 1 1 auto;
    padding-inline: 8px;
    font-size: 13px;
  }
  .segmented {
    margin-block-end: 12px;
  }
  summary {
    min-height: 36px;
  }
  summary .aside {
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
