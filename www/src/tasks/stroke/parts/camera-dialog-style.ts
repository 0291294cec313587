/** How the dialog that takes a photo looks. */

import { css } from "lit";

export const cameraDialogStyle = css`
  dialog {
    width: min(640px, calc(100vw - 32px));
  }
  .all {
    display: grid;
    gap: 16px;
    padding: 16px 24px 24px;
  }
  h2 {
    font-size: 20px;
    color: var(--ink);
  }
  p {
    margin: 0;
  }
  .view {
    position: relative;
    display: grid;
    place-items: center;
    aspect-ratio: 4 / 3;
    max-height: 60dvh;
    min-width: 0;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--paper);
  }
  video {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    object-fit: contain;
  }
  .view p {
    padding: 24px;
    max-width: 44ch;
    text-align: center;
    text-wrap: balance;
  }
  .buttons {
    display: flex;
    flex-wrap: wrap;
    gap: 8px;
  }
  .buttons .primary {
    margin-inline-start: auto;
    min-width: 112px;
  }
  @media (max-width: 479px) {
    .all {
      padding: 16px;
    }
    .view {
      aspect-ratio: 3 / 4;
    }
  }
`;
