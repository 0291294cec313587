import { css, html, LitElement, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { SettingRow, SettingValues } from "../engine/protocol";
import { controls } from "./shared";

/** Friendlier words for the settings that matter most, in the order they are shown; ranges come from the core's table. */
const SHOWN: Readonly<Record<string, { label: string; words: Readonly<Record<string, string>> }>> = {
  preset: { label: "Quality", words: { fast: "Quick sketch", best: "Best wire", paper: "As in the paper" } },
  bend: { label: "Bend the drawings to agree", words: { none: "Not at all", little: "A little", free: "Freely" } },
};

/** The main settings. Fires `choose` with a name and a value. */
@customElement("settings-panel")
export class SettingsPanel extends LitElement {
  /** The core's table; until it is there, the choices are those that have words. */
  @property({ attribute: false }) rows: readonly SettingRow[] = [];
  @property({ attribute: false }) values: SettingValues = {};
  @property({ type: Boolean }) locked = false;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: 12px;
      }
      label {
        display: grid;
        gap: 4px;
        font-size: 13px;
        color: var(--quiet);
      }
      select {
        width: 100%;
        min-height: 40px;
        padding: 0 8px;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--raised);
        color: var(--ink);
        font-size: 15px;
      }
      @media (pointer: coarse) {
        select {
          min-height: 44px;
        }
      }
    `,
  ];

  override render() {
    return Object.entries(SHOWN).map(([name, { label, words }]) => {
      const row = this.rows.find((row) => row.name === name);
      return html`<label title=${row?.help ?? nothing}>
        ${label}
        <select name=${name} ?disabled=${this.locked} @change=${(event: Event) => this.change(name, (event.target as HTMLSelectElement).value)}>
          ${(row?.choices ?? Object.keys(words)).map(
            (value) => html`<option value=${value} ?selected=${this.values[name] === value}>${words[value] ?? value}</option>`,
          )}
        </select>
      </label>`;
    });
  }

  private change(name: string, value: string): void {
    this.dispatchEvent(new CustomEvent<[string, string]>("choose", { detail: [name, value] }));
  }
}
