/** The page's colours for the sculpture. */

import { css } from "lit";

export const wireStageStyle = css`
  :host {
    --wire-background: var(--stage);
    --wire-ink: var(--ink);
    --wire-quiet: var(--quiet);
    --wire-line: var(--line);
    --wire-raised: var(--raised);
    --wire-accent: var(--copper);
    --wire-accent-text: var(--copper-text);
    --wire-accent-wash: var(--copper-wash);
    --wire-elevation: var(--shadow);
    aspect-ratio: auto;
    font: inherit;
  }
  .over {
    pointer-events: none;
  }
`;
