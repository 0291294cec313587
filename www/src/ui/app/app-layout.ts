/** Where everything is: three columns on a desk, a stage above a sheet on a phone or an upright tablet. */

import { css } from "lit";

export const layout = css`
  :host {
    display: grid;
    grid-template: 56px minmax(0, 1fr) auto auto / 280px minmax(0, 1fr) 312px;
    grid-template-areas: "head head head" "left stage right" "left time right" "left under right";
    height: 100%;
    min-height: 0;
    overflow: hidden;
  }
  top-bar {
    grid-area: head;
    border-block-end: 1px solid var(--line);
  }
  wire-stage {
    grid-area: stage;
    min-height: 0;
  }
  time-line {
    grid-area: time;
    border-block-start: 1px solid var(--line);
    background: var(--paper);
  }
  .tool-buttons {
    grid-area: stage;
    z-index: 2;
    display: flex;
    gap: 8px;
    align-self: start;
    justify-self: start;
    margin: 12px;
  }
  .tool-buttons button {
    min-height: 36px;
    font-size: 13px;
    box-shadow: var(--shadow);
  }
  @media (max-width: 499px) {
    .tool-buttons button {
      width: 44px;
      min-height: 44px;
      padding: 0;
    }
    .tool-buttons span {
      position: absolute;
      width: 1px;
      height: 1px;
      overflow: hidden;
      clip-path: inset(50%);
      white-space: nowrap;
    }
  }
  .tool-buttons [aria-pressed="true"] {
    border-color: var(--copper);
    background: var(--copper-wash);
    color: var(--copper-text);
    font-weight: 600;
  }
  .tool {
    grid-area: left;
    z-index: 2;
    border-inline-end: 1px solid var(--line);
    background: var(--paper);
  }
  .under {
    grid-area: under;
    background: var(--paper);
  }
  /* What lies open needs more room than what it lies over. */
  :host([tooled]) {
    grid-template-columns: 336px minmax(0, 1fr) 312px;
  }
  :host([tooled]) .left {
    display: none;
  }
  pad-editor,
  mask-editor {
    grid-row: 2 / -1;
    grid-column: 2;
    z-index: 3;
    min-height: 0;
    background: var(--paper);
  }
  notice-list {
    grid-area: stage;
    z-index: 4;
    align-self: start;
    justify-self: center;
    width: min(560px, 100% - 32px);
    margin-block-start: 16px;
  }
  main {
    display: contents;
  }
  /* What is placed within them scrolls with them: nothing hangs out below the page. */
  .left,
  .right,
  .tool,
  section {
    position: relative;
  }
  .coming {
    visibility: hidden;
  }
  live-region {
    position: fixed;
  }
  .left,
  .right,
  .tool {
    min-height: 0;
    overflow: auto;
    overscroll-behavior: contain;
    scrollbar-width: thin;
    scrollbar-color: var(--line-strong) transparent;
  }
  .left {
    grid-area: left;
    border-inline-end: 1px solid var(--line);
  }
  .right {
    grid-area: right;
    border-inline-start: 1px solid var(--line);
  }
  #part-lesson {
    padding: 16px 24px;
    border-block-end: 1px solid var(--line);
  }
  :host([lesson]) {
    grid-template-columns: 344px minmax(0, 1fr) auto;
  }
  :host([lesson]) .right {
    width: 312px;
  }
  /* What is to be read stays: a tool lies over the other column. */
  @media (min-width: 1100px), (min-width: 820px) and (orientation: landscape) {
    :host([lesson][tooled]) .left {
      display: block;
    }
    :host([lesson][tooled]) .right {
      display: none;
    }
    :host([lesson][tooled]) .tool {
      grid-area: right;
      width: 336px;
      border-inline: 1px solid var(--line) 0;
    }
  }
  /* Locked, and to be seen as such. */
  [inert] {
    opacity: 0.6;
  }
  #part-pictures {
    display: grid;
    gap: 16px;
    align-content: start;
    padding: 16px 24px;
  }
  /* Stays while the rest of its column scrolls. */
  run-panel {
    position: sticky;
    z-index: 1;
    inset-block-start: 0;
    padding: 16px 24px 8px;
    background: var(--paper);
  }
  .right section {
    padding: 8px 24px 24px;
  }
  #part-run {
    display: grid;
    gap: 24px;
  }
  @media (max-width: 1279px) {
    :host {
      grid-template-columns: 208px minmax(0, 1fr) 272px;
    }
    :host([tooled]) {
      grid-template-columns: 288px minmax(0, 1fr) 272px;
    }
    :host([lesson]) {
      grid-template-columns: 304px minmax(0, 1fr) auto;
    }
    :host([lesson]) .right {
      width: 272px;
    }
    :is(#part-pictures, #part-lesson) {
      padding: 16px;
    }
    run-panel {
      padding-inline: 16px;
    }
    .right section {
      padding-inline: 16px;
    }
  }
  @media (max-width: 819px), (max-width: 1099px) and (orientation: portrait) {
    :host {
      grid-template: 48px minmax(0, 46fr) auto minmax(0, 40fr) auto / minmax(0, 1fr);
      grid-template-areas: "head" "stage" "run" "sheet" "tabs";
    }
    :host([lesson]) {
      grid-template-rows: 48px minmax(0, 36fr) auto minmax(0, 50fr) auto;
      grid-template-columns: minmax(0, 1fr);
    }
    :host([tooled]) {
      grid-template-columns: minmax(0, 1fr);
    }
    .tool {
      grid-area: sheet;
      border: 0;
    }
    .left,
    .right {
      display: contents;
    }
    top-bar {
      border: 0;
    }
    run-panel {
      grid-area: run;
      position: static;
      padding: 0 16px;
      border-block-end: 1px solid var(--line);
    }
    time-line {
      grid-area: auto;
      margin-inline: -16px;
      padding-block: 0;
      border: 0;
    }
    :host .right section,
    #part-lesson,
    #part-pictures {
      grid-area: sheet;
      min-height: 0;
      overflow: auto;
      overscroll-behavior: contain;
      align-content: start;
      padding: 16px;
    }
    #part-pictures {
      grid-template-columns: repeat(3, minmax(0, 1fr));
      gap: 8px 16px;
      padding-block: 8px;
    }
    #part-pictures.one {
      grid-template-columns: minmax(0, 1fr);
    }
    #part-pictures :is(remedy-list, .gallery) {
      grid-column: 1 / -1;
    }
    .gallery {
      padding-block: 12px;
      color: var(--copper-text);
    }
    pad-editor,
    mask-editor {
      position: fixed;
      z-index: 5;
      inset: 0;
    }
  }
  /* Too low to divide: two halves side by side where there is width, else one page that scrolls. */
  @media (max-width: 959px) and (max-height: 559px) {
    :host {
      display: flex;
      flex-direction: column;
      height: auto;
      min-height: 100%;
      overflow: visible;
    }
    wire-stage {
      order: 1;
      flex: none;
      height: 70svh;
      min-height: 160px;
    }
    notice-list {
      order: 1;
      align-self: center;
    }
    run-panel {
      order: 2;
      padding-block-end: 8px;
    }
    :host .right section,
    #part-lesson,
    #part-pictures {
      order: 3;
      flex: 1 0 auto;
      overflow: visible;
    }
    .tool {
      order: 3;
      flex: 1 0 auto;
      overflow: visible;
    }
    .tool-buttons {
      order: 0;
      margin-block-end: 4px;
    }
    .tabs {
      order: 4;
      position: sticky;
      z-index: 2;
      inset-block-end: 0;
    }
  }
  @media (min-width: 560px) and (max-width: 959px) and (max-height: 559px) {
    :host {
      display: grid;
      grid-template: 44px auto minmax(0, 1fr) auto / minmax(0, 1fr) minmax(0, 1fr);
      grid-template-areas: "head head" "stage run" "stage sheet" "stage tabs";
      height: 100%;
      overflow: hidden;
    }
    :host([lesson]) {
      grid-template-rows: 44px auto minmax(0, 1fr) auto;
      grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
    }
    :host([tooled]) {
      grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
    }
    .tool {
      overflow: auto;
    }
    wire-stage {
      height: auto;
    }
    :host .right section,
    #part-lesson,
    #part-pictures {
      overflow: auto;
    }
    .tabs {
      position: static;
    }
  }
  @media (min-width: 600px) and (max-width: 1099px) and (orientation: portrait) {
    #part-pictures.one,
    #part-lesson,
    #part-settings,
    #part-share {
      width: 100%;
      max-width: 600px;
      margin-inline: auto;
    }
  }
`;
