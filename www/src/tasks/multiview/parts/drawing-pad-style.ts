/** How a pad for a drawing looks: a sheet with tools beside it; on a phone, the sheet alone. */

import { css } from "lit";

export const drawingPadStyle = css`
  .opener {
    margin-inline-start: auto;
    margin-inline-end: -6px;
    width: 32px;
    min-height: 32px;
    color: var(--quiet);
  }
  .row {
    grid-template-columns: minmax(0, 1fr) auto;
  }
  .sheet {
    color: var(--ink);
  }
  section:not(.over) .sheet:hover {
    border-color: var(--line-strong);
  }
  section.locked .sheet:hover {
    border-color: var(--line);
  }
  .invitation {
    gap: 8px;
    color: var(--quiet);
    pointer-events: none;
  }
  .short {
    display: none;
  }
  .over .invitation {
    border-color: var(--copper);
    color: var(--ink);
  }
  .tools {
    display: flex;
    flex-direction: column;
    justify-content: space-between;
    gap: 2px;
  }
  .tools button {
    flex: 1 1 auto;
    max-height: 48px;
    color: var(--quiet);
  }
  .tools button:hover:not(:disabled),
  .opener:hover:not(:disabled) {
    color: var(--ink);
  }
  .line {
    display: flex;
    align-items: center;
    gap: 6px;
    height: 20px;
    margin: 4px 0 0;
    overflow: hidden;
    white-space: nowrap;
  }
  .line span {
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .hatch {
    flex: none;
    width: 16px;
    height: 10px;
    border: 1px solid var(--amber);
    border-radius: 2px;
    background: repeating-linear-gradient(-45deg, var(--amber) 0 2px, transparent 2px 4px);
  }
  .line b {
    font-weight: 600;
    color: var(--amber-text);
  }
  .menu {
    position: fixed;
    inset: auto;
    min-width: 208px;
    margin: 0;
    padding: 4px;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
    color: var(--ink);
    box-shadow: var(--shadow);
  }
  .menu button {
    display: flex;
    justify-content: flex-start;
    width: 100%;
    min-height: 36px;
    border-color: transparent;
    background: none;
  }
  .menu button:is(:hover, :focus-visible):not(:disabled) {
    background: color-mix(in srgb, var(--ink) 7%, transparent);
  }
  .menu hr {
    margin: 4px 8px;
    border: 0;
    border-block-start: 1px solid var(--line);
  }
  .menu .icon {
    color: var(--quiet);
  }
  @container (max-width: 199px) {
    .row {
      grid-template-columns: minmax(0, 1fr);
      gap: 4px;
    }
    .tools {
      flex-direction: row;
    }
  }
  /* A third of a phone's width: the sheet is the button, all else is in the editor and the menu. */
  .line .less {
    display: none;
  }
  @container (max-width: 149px) {
    .line .less {
      display: inline;
    }
    .head {
      min-height: 36px;
      gap: 0;
    }
    .tools,
    .head .aside,
    .line .more,
    .invitation .long {
      display: none;
    }
    .invitation {
      gap: 4px;
      margin: 4px;
    }
    .invitation .short {
      display: inline;
    }
    .problem {
      padding: 6px;
      font-size: 12px;
      line-height: 1.25;
    }
    .problem button {
      position: static;
      float: inline-end;
      margin: -6px;
    }
  }
  @media (pointer: coarse) {
    .opener {
      width: 44px;
      min-height: 44px;
      margin-block: -6px;
      margin-inline-end: -10px;
    }
    .menu button {
      min-height: 44px;
    }
  }
  @media (forced-colors: active) {
    .hatch {
      forced-color-adjust: none;
    }
  }
`;
