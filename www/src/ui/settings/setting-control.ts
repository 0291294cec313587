import { msg, str } from "@lit/localize";
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { SettingRow } from "../../engine/protocol";
import { icons } from "../shared/icons";
import { isOn, isSwitch, refusal, switched } from "./setting-value";
import { wordsFor } from "./setting-words";
import { controls } from "../shared/shared";
import { settingControlStyle } from "./setting-control-style";

const MOST_SEEDS = 1_000_000;

/** One setting with its words, range and help; what is slotted in stands below. Fires `choose` with a possible value. */
@customElement("setting-control")
export class SettingControl extends LitElement {
  @property({ attribute: false }) row!: SettingRow;
  @property() value = "";
  /** The preset's value, to go back to. */
  @property() usual = "";
  @property({ type: Boolean }) locked = false;
  /** What is typed or dragged but not taken yet. */
  @state() private draft: string | null = null;
  @state() private problem = "";

  static override styles = [controls, settingControlStyle];

  override render() {
    const { row, value, usual } = this;
    const { label } = wordsFor(row.name);
    const changed = usual !== "" && value !== usual;
    return html`
      <div class="head ${changed ? "changed" : ""}">
        <label for="control">${label}</label>
        ${isSwitch(row) && !changed ? this.toggle() : nothing}
        ${changed
          ? html`<button class="plain back" ?disabled=${this.locked} aria-label=${msg(str`Set ${label} back to ${this.wordsOf(usual)}`)} @click=${() => this.choose(usual)}>
              ${icons.reset} ${this.wordsOf(usual)}
            </button>`
          : nothing}
        ${isSwitch(row) && changed ? this.toggle() : nothing}
      </div>
      ${isSwitch(row) ? nothing : this.control()}
      ${this.problem ? html`<p class="small problem" id="problem" role="alert">${this.problem}</p>` : nothing}
      <p class="small quiet" id="help">${row.help}</p>
      <slot></slot>
    `;
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("value") || changed.has("row")) {
      this.draft = null;
      this.problem = "";
    }
  }

  private control(): TemplateResult {
    const { row, value, locked } = this;
    if (row.kind === "choice") {
      return html`<div class="value">
        <select id="control" aria-describedby="help" ?disabled=${locked} .value=${value} @change=${(event: Event) => this.choose((event.target as HTMLSelectElement).value)}>
          ${(row.choices ?? []).map((choice) => html`<option value=${choice} .selected=${choice === value}>${this.wordsOf(choice)}</option>`)}
        </select>
      </div>`;
    }
    const slider = wordsFor(row.name).slider;
    const shown = this.draft ?? value;
    const seed = row.name === "seed";
    return html`<div class="value ${seed ? "seed" : ""}">
      ${slider
        ? html`<input
            type="range"
            aria-label=${msg(str`${wordsFor(row.name).label}, slider`)}
            min=${slider[0]}
            max=${slider[1]}
            step=${slider[2]}
            .value=${shown}
            ?disabled=${locked}
            @input=${this.drag}
            @change=${this.take}
          />`
        : nothing}
      <input
        id="control"
        type="number"
        inputmode="decimal"
        step="any"
        min=${row.min ?? nothing}
        max=${row.max ?? nothing}
        .value=${shown}
        ?disabled=${locked}
        aria-describedby=${this.problem ? "problem help" : "help"}
        aria-invalid=${this.problem ? "true" : "false"}
        @change=${this.take}
      />
      ${row.unit ? html`<span class="unit">${row.unit}</span>` : nothing}
      ${seed
        ? html`<button class="square" aria-label=${msg("Roll another seed")} title=${msg("Roll another seed")} ?disabled=${locked} @click=${this.roll}>${icons.dice}</button>`
        : nothing}
    </div>`;
  }

  private toggle(): TemplateResult {
    const { row, value, locked } = this;
    return html`<input
      id="control"
      type="checkbox"
      aria-describedby="help"
      .checked=${isOn(value)}
      ?disabled=${locked}
      @change=${(event: Event) => this.choose(switched(row, (event.target as HTMLInputElement).checked))}
    />`;
  }

  private wordsOf(value: string): string {
    if (isSwitch(this.row)) return isOn(value) ? "on" : "off";
    return wordsFor(this.row.name).choices?.[value] ?? value;
  }

  private readonly drag = (event: Event): void => {
    this.draft = (event.target as HTMLInputElement).value;
    this.problem = "";
  };

  private readonly take = (event: Event): void => {
    const text = (event.target as HTMLInputElement).value;
    this.draft = text;
    this.problem = refusal(this.row, text);
    if (!this.problem) this.choose(String(Number(text)));
  };

  private readonly roll = (): void => this.choose(String(Math.floor(Math.random() * MOST_SEEDS)));

  private choose(value: string): void {
    this.dispatchEvent(new CustomEvent<string>("choose", { detail: value }));
  }
}
