/** How the bar with the name and the tabs looks. */

import { css } from "lit";

export const topBarStyle = css`
  :host {
    display: flex;
    align-items: center;
    gap: 16px;
    min-width: 0;
    padding: 0 16px 0 24px;
    padding-inline: 24px 16px;
  }
  h1 {
    margin: 0;
    font-size: 20px;
    font-weight: 600;
    letter-spacing: -0.01em;
  }
  h1 b {
    font-weight: 600;
    color: var(--copper-text);
  }
  .gallery {
    padding: 10px 0;
    color: var(--quiet);
    text-decoration: none;
  }
  .gallery:hover {
    color: var(--ink);
  }
  .tools {
    display: flex;
    align-items: center;
    gap: 4px;
  }
  .share {
    margin-inline: 8px;
  }
  @media (max-width: 819px), (max-width: 1099px) and (orientation: portrait) {
    :host {
      padding-inline: 16px 4px;
    }
    .tools {
      gap: 0;
    }
    .share {
      display: none;
    }
  }
  @media (max-width: 699px) {
    .lessons {
      display: none;
    }
  }
  /* Where there is room for one of them, it is the tabs. */
  @media (max-width: 559px) {
    :host {
      gap: 0;
      padding-inline-start: 6px;
    }
    h1 {
      position: absolute;
      clip-path: inset(50%);
    }
    .gallery {
      display: none;
    }
  }
`;
