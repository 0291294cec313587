/** What all pads look like on which one picture is given: a head, a sheet with the picture on it, an invitation while it is empty. */

import { css } from "lit";

/** On the sheet lies an element of the class `shown`. */
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
  .aside {
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
  .shown {
    position: absolute;
    inset: 0;
    transition: opacity 150ms ease;
  }
  .busy .shown {
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
`;
