import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { SettingRow, SettingsTable, SettingValues } from "../../engine/protocol";
import type { Studio } from "../../state/studio";
import { Part } from "../../view/part";
import { foldStyle } from "../shared/fold";
import { icons } from "../shared/icons";
import "./setting-control";
import { GROUPS, WORDS } from "./setting-words";
import { controls } from "../shared/shared";

/** The first two stand beside Run, ink is found pad by pad, and there is one engine to compute on. */
const ELSEWHERE: readonly string[] = ["preset", "bend", "ink", "backend"];

/** Every setting of the core's table, folded in groups. What is slotted in stands before Expert. */
@customElement("settings-panel")
export class SettingsPanel extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) table: SettingsTable | null = null;
  /** What differs from the preset. */
  @property({ attribute: false }) settings: SettingValues = {};
  @property({ type: Boolean }) locked = false;
  /** Groups that were opened: the controls of the others are not made yet. */
  @state() private opened: ReadonlySet<string> = new Set();

  static override styles = [
    controls,
    foldStyle,
    css`
      :host {
        display: block;
      }
      .top {
        display: flex;
        align-items: center;
        justify-content: space-between;
        min-height: 32px;
      }
      .top button {
        gap: 4px;
        min-height: 32px;
        padding: 0 8px;
        font-size: 13px;
        color: var(--copper-text);
      }
      .count {
        font-size: 13px;
        color: var(--copper-text);
      }
    `,
  ];

  override render() {
    const changed = Object.keys(this.settings).filter((name) => !ELSEWHERE.includes(name));
    return html`
      <div class="top">
        <h2>Settings</h2>
        ${changed.length
          ? html`<button class="plain" ?disabled=${this.locked} @click=${() => this.studio.resetSettings()}>${icons.reset} Reset all</button>`
          : nothing}
      </div>
      ${this.table
        ? Object.keys(GROUPS).map((group) => html`${group === "expert" ? html`<slot></slot>` : nothing}${this.group(group, changed)}`)
        : html`<p class="small quiet">They come with the engine, which is still being loaded.</p><slot></slot>`}
    `;
  }

  private group(group: string, changed: readonly string[]) {
    const rows = this.table!.rows.filter((row) => row.group === group && !ELSEWHERE.includes(row.name)).toSorted(byWords);
    if (rows.length === 0) return nothing;
    const count = rows.filter((row) => changed.includes(row.name)).length;
    return html`<details @toggle=${() => (this.opened = new Set([...this.opened, group]))}>
      <summary>${GROUPS[group]} ${count ? html`<span class="count">${count} changed</span>` : nothing} ${icons.more}</summary>
      <div class="group">
        ${(this.opened.has(group) ? rows : []).map(
          (row) => html`<setting-control
            data-setting=${row.name}
            .row=${row}
            .value=${this.studio.value(row.name)}
            .usual=${this.usual(row.name)}
            ?locked=${this.locked}
            @choose=${(event: CustomEvent<string>) => this.studio.set(row.name, event.detail)}
          ></setting-control>`,
        )}
      </div>
    </details>`;
  }

  private usual(name: string): string {
    return this.table?.presets[this.studio.value("preset")]?.[name] ?? "";
  }
}

/** In the order of the words table; settings it does not know come last. */
function byWords(a: SettingRow, b: SettingRow): number {
  const names = Object.keys(WORDS);
  const place = (row: SettingRow): number => names.indexOf(row.name) + 1 || names.length + 1;
  return place(a) - place(b);
}
