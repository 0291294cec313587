/** The parts of the sheet on a phone, and the tabs that choose one. */

import { msg } from "@lit/localize";
import { css, html, type TemplateResult } from "lit";
import { icons } from "../shared/icons";
import { walkTabs } from "../shared/tablist";

export const TABS = ["lesson", "pictures", "run", "settings", "share"] as const;
export type Tab = (typeof TABS)[number];
/** There while a lesson is on. */
export const LESSON_TAB: Tab = "lesson";

const SHOWN: Readonly<Record<Tab, { words: string; icon: TemplateResult }>> = {
  lesson: { words: msg("Lesson"), icon: icons.lesson },
  pictures: { words: msg("Pictures"), icon: icons.pictures },
  run: { words: msg("Run"), icon: icons.run },
  settings: { words: msg("Settings"), icon: icons.settings },
  share: { words: msg("Share"), icon: icons.share },
};

/** `pads` is what the part where things are given is called; `chosen` is null where something else lies in the sheet. */
export function tabs(chosen: Tab | null, pads: string, choose: (tab: Tab) => void, shown: readonly Tab[]): TemplateResult {
  const press = (event: KeyboardEvent): void => walkTabs(event, shown, choose);
  return html`<div class="tabs" role="tablist" aria-label=${msg("Parts of the page")} data-keys @keydown=${press}>
    ${shown.map(
      (tab) => html`<button
        id="tab-${tab}"
        class="plain"
        role="tab"
        aria-selected=${tab === chosen}
        aria-controls="part-${tab}"
        tabindex=${tab === (chosen ?? shown[0]) ? 0 : -1}
        @click=${() => choose(tab)}
      >
        ${SHOWN[tab].icon} ${tab === "pictures" ? pads : SHOWN[tab].words}
      </button>`,
    )}
  </div>`;
}

export const tabsStyle = css`
  .tabs {
    grid-area: tabs;
    display: grid;
    grid-auto-flow: column;
    grid-auto-columns: minmax(0, 1fr);
    padding-block-end: env(safe-area-inset-bottom);
    border-block-start: 1px solid var(--line);
    background: var(--raised);
  }
  .tabs button {
    flex-direction: column;
    gap: 2px;
    min-height: 52px;
    border: 0;
    padding: 4px 2px;
    border-radius: 0;
    font-size: 13px;
    line-height: 1.2;
    color: var(--quiet);
  }
  .tabs button[aria-selected="true"] {
    box-shadow: inset 0 2px 0 var(--copper);
    color: var(--copper-text);
    font-weight: 600;
  }
  .tabs button:focus-visible {
    outline-offset: -3px;
  }
  @media (forced-colors: active) {
    .tabs button[aria-selected="true"] {
      border-block-start: 3px solid Highlight;
    }
  }
`;
