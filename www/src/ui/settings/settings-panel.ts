import { msg, str } from "@lit/localize";
import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { SettingRow, SettingsTable, SettingValues } from "../../engine/protocol";
import { setWhenHidden } from "../../state/actions/actions";
import { ANYWHERE, INSTEAD, WHEN_HIDDEN, type Studio, type Whereabouts, type WhenHidden } from "../../state/studio";
import { isHidden, isSettingLocked, NO_LOCKS, type Locks } from "../../state/common/locks";
import { Part } from "../../view/part";
import { foldStyle } from "../shared/fold";
import { icons } from "../shared/icons";
import "./setting-control";
import { GROUPS, WORDS } from "./setting-words";
import { controls } from "../shared/shared";
import { deviceOf, reasonOf } from "./device-words";
import { presetOf } from "../../state/settings/values";
import { rendererWord } from "../../state/address/renderer";

/** Stands near Run, for every task. */
const PRESET = "preset";

/** The page's own, not the core's. */
const HIDDEN_ROW: SettingRow = {
  name: "when_hidden",
  group: "run",
  unit: "",
  help: msg("A paused run goes on by itself when the tab is back."),
  kind: "choice",
  affects: [],
  choices: WHEN_HIDDEN,
};

/** Every setting of the core's table, folded in groups. What is slotted in stands before Expert. */
@customElement("settings-panel")
export class SettingsPanel extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) table: SettingsTable | null = null;
  /** What differs from the preset. */
  @property({ attribute: false }) settings: SettingValues = {};
  /** Settings that have a control elsewhere. */
  @property({ attribute: false }) elsewhere: readonly string[] = [];
  @property({ attribute: false }) where: Whereabouts = ANYWHERE;
  @property() whenHidden: WhenHidden = "go";
  @property({ type: Boolean }) locked = false;
  @property({ attribute: false }) locks: Locks = NO_LOCKS;
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
      .where {
        margin-block-start: 8px;
      }
      .where p {
        margin: 0;
        overflow-wrap: anywhere;
      }
      .word {
        white-space: nowrap;
      }
      .refusal {
        color: var(--error);
      }
    `,
  ];

  override render() {
    const changed = Object.keys(this.settings).filter((name) => this.isHere(name));
    return html`
      <div class="top">
        <h2>${msg("Settings")}</h2>
        ${changed.length
          ? html`<button class="plain" ?disabled=${this.locked} @click=${() => this.studio.options.reset()}>${icons.reset} ${msg("Reset all")}</button>`
          : nothing}
      </div>
      ${this.table
        ? Object.keys(GROUPS).map((group) => html`${group === "expert" ? html`<slot></slot>` : nothing}${this.group(group, changed)}`)
        : html`<p class="small quiet">${msg("They come with the engine, which is still being loaded.")}</p><slot></slot>`}
    `;
  }

  private isHere(name: string): boolean {
    return name !== PRESET && !isHidden(this, name) && !this.elsewhere.includes(name);
  }

  private group(group: string, changed: readonly string[]) {
    const rows = this.table!.rows.filter((row) => row.group === group && this.isHere(row.name)).toSorted(byWords);
    if (rows.length === 0) return nothing;
    const count = rows.filter((row) => changed.includes(row.name)).length;
    return html`<details @toggle=${() => (this.opened = new Set([...this.opened, group]))}>
      <summary>${GROUPS[group]} ${count ? html`<span class="count">${msg(str`${count} changed`)}</span>` : nothing} ${icons.more}</summary>
      <div class="group">
        ${(this.opened.has(group) ? rows : []).map((row) => this.control(row))}
        ${this.opened.has(group) && group === HIDDEN_ROW.group ? this.hiddenTab() : nothing}
      </div>
    </details>`;
  }

  private control(row: SettingRow) {
    const { where } = this;
    const place = row.name === "backend";
    const byAddress = place && where.byAddress;
    return html`<setting-control
      data-setting=${row.name}
      .row=${row}
      .value=${byAddress ? where.asked : this.studio.options.value(row.name)}
      .usual=${byAddress ? "" : this.usual(row.name)}
      ?locked=${this.locked || byAddress || isSettingLocked(this, row.name)}
      @choose=${(event: CustomEvent<string>) => this.studio.options.set(row.name, event.detail)}
      >${place ? this.whereabouts() : nothing}</setting-control
    >`;
  }

  /** Which device that comes to, and why. */
  private whereabouts() {
    const { asked, byAddress, place, refusal } = this.where;
    return html`<div class="where small" role="status">
      ${byAddress ? html`<p class="quiet">${msg("For this visit the address decides")} <span class="word">(${rendererWord(asked)})</span>.</p>` : nothing}
      ${refusal
        ? html`<p class="refusal">${refusal} ${INSTEAD}</p>`
        : place
          ? html`<p><b>${deviceOf(place)}</b></p><p class="quiet">${reasonOf(place)}</p>`
          : html`<p class="quiet">${msg("Looking for what there is…")}</p>`}
    </div>`;
  }

  private hiddenTab() {
    return html`<setting-control
      data-setting=${HIDDEN_ROW.name}
      .row=${HIDDEN_ROW}
      .value=${this.whenHidden}
      @choose=${(event: CustomEvent<WhenHidden>) => this.studio.act(setWhenHidden, event.detail)}
    ></setting-control>`;
  }

  private usual(name: string): string {
    return this.table ? (presetOf(this.studio.options.all, this.table)[name] ?? "") : "";
  }
}

/** In the order of the words table; settings it does not know come last. */
function byWords(a: SettingRow, b: SettingRow): number {
  const names = Object.keys(WORDS);
  const place = (row: SettingRow): number => names.indexOf(row.name) + 1 || names.length + 1;
  return place(a) - place(b);
}
