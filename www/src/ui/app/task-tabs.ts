/** What can be made here, as tabs. */

import { msg } from "@lit/localize";
import { css, html, type TemplateResult } from "lit";
import type { PageTask } from "../shared/page-task";
import { walkTabs } from "../shared/tablist";

/** `running` is the task that a run is under way for. */
export function taskTabs(tasks: readonly PageTask[], chosen: string, running: string | null, choose: (task: string) => void): TemplateResult {
  const names = tasks.map(({ name }) => name);
  return html`<div class="tasks" role="tablist" aria-label=${msg("What to make")} data-keys @keydown=${(event: KeyboardEvent) => walkTabs(event, names, choose)}>
    ${tasks.map(
      ({ name, page }) => html`<button
        id="tab-${name}"
        class="plain"
        role="tab"
        title=${page.title}
        aria-selected=${name === chosen}
        tabindex=${name === chosen ? 0 : -1}
        @click=${() => choose(name)}
      >
        <span>${page.tab}</span>${name === running && name !== chosen ? html`<i></i><span class="unseen">${msg(", being made")}</span>` : ""}
      </button>`,
    )}
  </div>`;
}

export const taskTabsStyle = css`
  .tasks {
    display: flex;
    align-self: stretch;
    flex: 1;
    min-width: 0;
    gap: 8px;
  }
  .tasks button {
    position: relative;
    height: 100%;
    padding: 0 12px;
    border: 0;
    border-radius: 0;
    line-height: 1.15;
    color: var(--quiet);
  }
  .tasks button[aria-selected="true"] {
    box-shadow: inset 0 -2px 0 var(--copper);
    color: var(--copper-text);
    font-weight: 600;
  }
  .tasks button:focus-visible {
    outline-offset: -4px;
  }
  /* A run goes on there. */
  .tasks i {
    width: 8px;
    height: 8px;
    border-radius: 4px;
    background: var(--copper);
  }
  @media (max-width: 559px) {
    .tasks {
      gap: 0;
    }
    .tasks button {
      gap: 4px;
      padding: 0 6px;
      font-size: 13px;
    }
  }
  @media (forced-colors: active) {
    .tasks button[aria-selected="true"] {
      border-block-end: 3px solid Highlight;
    }
    .tasks i {
      forced-color-adjust: none;
      background: Highlight;
    }
  }
`;
