/** How the list of what would help looks. */

import { css } from "lit";

export const remedyListStyle = css`
  :host {
    display: block;
    container-type: inline-size;
  }
  section {
    display: grid;
    align-content: start;
    gap: 8px;
    min-height: 24px;
  }
  p {
    margin: 0;
    text-wrap: pretty;
  }
  .sum {
    display: flex;
    align-items: center;
    gap: 8px;
    min-height: 24px;
  }
  .sum .icon {
    color: var(--copper-text);
  }
  .sum strong {
    font-weight: 600;
  }
  .some strong {
    color: var(--amber-text);
  }
  .busy {
    opacity: 0.6;
  }
  ul {
    display: grid;
    gap: 4px;
    margin: 0;
    padding: 0;
    list-style: none;
  }
  button {
    width: 100%;
    justify-content: flex-start;
    gap: 8px;
    padding: 4px 8px;
    text-align: start;
    line-height: 1.25;
  }
  .arranged button {
    display: inline;
    width: auto;
    min-height: 24px;
    padding: 2px 0;
    color: var(--copper-text);
    text-decoration: underline;
  }
  button .words {
    flex: 1;
    min-width: 0;
  }
  button .words small {
    display: block;
    font-size: 13px;
    color: var(--quiet);
  }
  button > .icon {
    color: var(--quiet);
  }
  .gain {
    flex: none;
    color: var(--quiet);
  }
  .gain b {
    font-weight: 600;
    color: var(--ink);
  }
  [aria-pressed="true"] {
    border-color: var(--copper);
    background: var(--copper-wash, var(--raised));
  }
  .tick {
    visibility: hidden;
  }
  [aria-pressed="true"] .tick {
    visibility: visible;
    color: var(--copper-text);
  }
  @media (forced-colors: active) {
    [aria-pressed="true"] {
      border: 2px solid Highlight;
    }
  }
`;
