import { msg } from "@lit/localize";
import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { LOOK_NAMES, type LookName } from "#sculpture/scene/looks";
import { Part } from "../../view/part";
import { foldStyle } from "../shared/fold";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";

const WORDS: Readonly<Record<LookName, string>> = {
  copper: msg("Copper"),
  steel: msg("Black steel"),
  parameter: msg("Colours along the wire"),
  width: msg("Colours by width"),
};

/** How the stage looks. Fires `look-change` with `{ look, room }`, as the stage does. */
@customElement("look-panel")
export class LookPanel extends Part {
  @property() look: LookName = "copper";
  @property({ type: Boolean }) room = true;

  static override styles = [
    controls,
    foldStyle,
    css`
      label {
        display: grid;
        gap: 4px;
      }
      .switch {
        display: flex;
        align-items: center;
        justify-content: space-between;
        min-height: 28px;
      }
      input {
        width: 20px;
        height: 20px;
        margin: 0;
      }
    `,
  ];

  override render() {
    return html`<details>
      <summary>${msg("Look")} ${icons.more}</summary>
      <div class="group">
        <label>
          ${msg("Wire")}
          <select @change=${(event: Event) => this.choose((event.target as HTMLSelectElement).value as LookName, this.room)}>
            ${LOOK_NAMES.map((name) => html`<option value=${name} .selected=${name === this.look}>${WORDS[name]}</option>`)}
          </select>
        </label>
        <label class="switch">
          ${msg("Room with shadows")}
          <input type="checkbox" .checked=${this.room} @change=${(event: Event) => this.choose(this.look, (event.target as HTMLInputElement).checked)} />
        </label>
      </div>
    </details>`;
  }

  private choose(look: LookName, room: boolean): void {
    this.dispatchEvent(new CustomEvent("look-change", { detail: { look, room } }));
  }
}
