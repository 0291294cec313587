/** What can be made here, as tabs. */

import { css, html, type TemplateResult } from "lit";
import { JOBS, type Job } from "../../state/studio";
import { walkTabs } from "../shared/tablist";

export const JOB_WORDS: Readonly<Record<Job, string>> = { multiview: "Three views", stroke: "One picture", fill: "A shape" };
const TITLES: Readonly<Record<Job, string>> = {
  multiview: "Three drawings, one wire",
  stroke: "One picture, one wire that turns",
  fill: "One shape, one wire all over it",
};

/** `running` is the job that a run is under way for. */
export function jobTabs(chosen: Job, running: Job | null, choose: (job: Job) => void): TemplateResult {
  return html`<div class="jobs" role="tablist" aria-label="What to make" data-keys @keydown=${(event: KeyboardEvent) => walkTabs(event, JOBS, choose)}>
    ${JOBS.map(
      (job) => html`<button
        id="tab-${job}"
        class="plain"
        role="tab"
        title=${TITLES[job]}
        aria-selected=${job === chosen}
        tabindex=${job === chosen ? 0 : -1}
        @click=${() => choose(job)}
      >
        <span>${JOB_WORDS[job]}</span>${job === running && job !== chosen ? html`<i></i><span class="unseen">, being made</span>` : ""}
      </button>`,
    )}
  </div>`;
}

export const jobTabsStyle = css`
  .jobs {
    display: flex;
    align-self: stretch;
    flex: 1;
    min-width: 0;
    gap: 8px;
  }
  .jobs button {
    position: relative;
    height: 100%;
    padding: 0 12px;
    border: 0;
    border-radius: 0;
    line-height: 1.15;
    color: var(--quiet);
  }
  .jobs button[aria-selected="true"] {
    box-shadow: inset 0 -2px 0 var(--copper);
    color: var(--copper-text);
    font-weight: 600;
  }
  .jobs button:focus-visible {
    outline-offset: -4px;
  }
  /* A run goes on there. */
  .jobs i {
    width: 8px;
    height: 8px;
    border-radius: 4px;
    background: var(--copper);
  }
  @media (max-width: 559px) {
    .jobs {
      gap: 0;
    }
    .jobs button {
      gap: 4px;
      padding: 0 6px;
      font-size: 13px;
    }
  }
  @media (forced-colors: active) {
    .jobs button[aria-selected="true"] {
      border-block-end: 3px solid Highlight;
    }
    .jobs i {
      forced-color-adjust: none;
      background: Highlight;
    }
  }
`;
