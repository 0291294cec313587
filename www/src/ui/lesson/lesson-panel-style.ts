/** How a lesson looks. */

import { css } from "lit";

export const lessonPanelStyle = css`
  :host {
    display: grid;
    gap: 8px;
    align-content: start;
    background: var(--paper);
  }
  :host([hidden]) {
    display: none;
  }
  header {
    display: flex;
    align-items: center;
    justify-content: space-between;
    gap: 8px;
    min-height: 40px;
  }
  p {
    margin: 0;
    overflow-wrap: anywhere;
  }
  p + p {
    margin-block-start: 4px;
  }
  .small.quiet {
    display: flex;
    justify-content: space-between;
    gap: 8px;
  }
  .kind {
    color: var(--copper-text);
    font-weight: 600;
  }
  h3 {
    margin: 8px 0 0;
    font-size: 20px;
    font-weight: 600;
    line-height: 1.25;
  }
  h3:focus {
    outline: none;
  }
  .watch {
    display: flex;
    gap: 8px;
    padding: 8px 12px;
    border-radius: 6px;
    background: var(--copper-wash);
  }
  fieldset {
    display: grid;
    gap: 8px;
    min-width: 0;
    margin: 8px 0 0;
    padding: 0;
    border: 0;
  }
  legend {
    margin-block-end: 8px;
    padding: 0;
    font-weight: 600;
  }
  label {
    display: flex;
    align-items: center;
    gap: 12px;
    min-height: 44px;
    padding: 8px 12px;
    border: 1px solid var(--line-strong);
    border-radius: 6px;
    background: var(--raised);
    cursor: pointer;
  }
  label.chosen {
    border-color: var(--copper);
    background: var(--copper-wash);
  }
  label input {
    flex: none;
    width: 20px;
    height: 20px;
    margin: 0;
  }
  .says p {
    padding: 8px 12px;
    border-inline-start: 3px solid var(--line-strong);
  }
  .says .right {
    border-color: var(--copper);
  }
  table {
    width: 100%;
    border-collapse: collapse;
    font-size: 13px;
  }
  caption {
    padding-block: 8px;
    color: var(--quiet);
    text-align: start;
  }
  th,
  td {
    padding: 6px 4px;
    border-block-end: 1px solid var(--line);
    font-weight: 400;
    text-align: end;
  }
  th[scope="row"] {
    text-align: start;
  }
  th[scope="col"] {
    font-weight: 600;
  }
  .wide {
    width: 100%;
  }
  .going {
    display: flex;
    flex-wrap: wrap;
    gap: 8px;
  }
  .going button {
    flex: 1 1 auto;
  }
  .running p {
    min-height: 18px;
    margin-block-start: 4px;
  }
  button.plain.small {
    justify-self: start;
    padding-inline: 4px;
    color: var(--copper-text);
  }
  nav,
  .stand {
    display: flex;
    flex-wrap: wrap;
    gap: 8px;
    margin-block-start: 8px;
  }
  nav button {
    flex: 1 1 0;
    min-height: 44px;
  }
  nav .primary {
    flex-grow: 2;
  }
  .idle {
    position: fixed;
    z-index: 20;
    inset: 0;
    display: grid;
    place-content: center;
    justify-items: center;
    gap: 16px;
    padding: 24px;
    background: color-mix(in srgb, var(--paper) 88%, transparent);
    font-size: 20px;
    text-align: center;
  }
  .idle b {
    font-size: 96px;
    line-height: 1;
    color: var(--copper-text);
  }
  :host([kiosk]) {
    font-size: 20px;
  }
  :host([kiosk]) :is(label, nav button, .wide, .stand button) {
    min-height: 64px;
    font-size: 20px;
  }
`;
