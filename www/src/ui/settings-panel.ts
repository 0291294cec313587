import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { SettingValues } from "../engine/protocol";
import { controls } from "./shared";

interface Choice {
  readonly name: string;
  readonly label: string;
  readonly options: readonly (readonly [value: string, label: string])[];
}

/** Words for the two settings that matter most; names and values are those of the core's table. */
const CHOICES: readonly Choice[] = [
  { name: "preset", label: "Quality", options: [["fast", "Quick sketch"], ["best", "Best wire"], ["paper", "As in the paper"]] },
  { name: "bend", label: "Bend the drawings to agree", options: [["none", "Not at all"], ["little", "A little"], ["free", "Freely"]] },
];

/** The main settings. Fires `choose` with a name and a value. */
@customElement("settings-panel")
export class SettingsPanel extends LitElement {
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
    return CHOICES.map(
      ({ name, label, options }) => html`<label>
        ${label}
        <select name=${name} ?disabled=${this.locked} @change=${(event: Event) => this.change(name, (event.target as HTMLSelectElement).value)}>
          ${options.map(([value, text]) => html`<option value=${value} ?selected=${this.values[name] === value}>${text}</option>`)}
        </select>
      </label>`,
    );
  }

  private change(name: string, value: string): void {
    this.dispatchEvent(new CustomEvent<[string, string]>("choose", { detail: [name, value] }));
  }
}
