/** How painting on a picture looks, besides what editors share. */

import { css } from "lit";

export const maskEditorStyle = css`
  .room {
    container-type: normal;
    position: relative;
    place-items: stretch;
  }
  subject-canvas {
    position: absolute;
    inset: 0;
    /* It stays where it is when the tools below it change. */
    place-items: start center;
    transition: opacity 150ms ease;
  }
  subject-canvas::part(frame) {
    border: 1px solid var(--line);
    border-radius: 6px;
    box-shadow: var(--shadow);
  }
  .busy subject-canvas {
    opacity: 0.4;
  }
  .side {
    grid-template-rows: minmax(0, 1fr);
  }
  .of-tool {
    display: grid;
    gap: 12px;
  }
  .sides {
    display: grid;
    grid-template-columns: repeat(4, minmax(0, 1fr));
    gap: 8px;
  }
  .sides label {
    display: grid;
    gap: 2px;
  }
  .sides input {
    width: 100%;
    padding-inline: 6px;
    color: var(--ink);
  }
  .field label {
    font-size: 13px;
    color: var(--quiet);
  }
  @container (max-width: 639px) {
    .body {
      grid-template: minmax(0, 1fr) auto / minmax(0, 1fr);
      gap: 16px;
    }
    .panel {
      gap: 12px;
      padding-block-end: 16px;
    }
    .panel .fine {
      display: none;
    }
    .panel .status {
      min-height: 20px;
    }
  }
  /* The picture before words. */
  @container (max-width: 639px) and (max-height: 560px) {
    .panel,
    .of-tool {
      gap: 8px;
    }
    .how {
      display: none;
    }
    .panel legend,
    .field label {
      position: absolute;
      width: 1px;
      height: 1px;
      overflow: hidden;
      clip-path: inset(50%);
    }
  }
`;
