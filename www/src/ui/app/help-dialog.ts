import { msg } from "@lit/localize";
import { html, LitElement, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { icons } from "../shared/icons";
import { remember, remembered } from "../../state/common/remember";
import { language } from "../../words/language";
import { LANGUAGES, type Language } from "../../words/languages";
import { speak } from "../../words/open";
import { dialogHeadStyle, dialogStyle } from "../shared/dialog-style";
import { controls } from "../shared/shared";
import { ACTIONS } from "./actions";
import { helpDialogStyle } from "./help-dialog-style";

export const lettersOn = (): boolean => remembered("keys") !== "off";

/** What this is, which keys it knows, and what becomes of one's drawings. */
@customElement("help-dialog")
export class HelpDialog extends LitElement {
  /** What it says of each task. */
  @property({ attribute: false }) tasks: readonly TemplateResult[] = [];
  @state() private letters = lettersOn();
  @query("dialog") private dialog!: HTMLDialogElement;

  static override styles = [controls, dialogStyle, dialogHeadStyle, helpDialogStyle];

  override render() {
    return html`<dialog aria-labelledby="title" @click=${this.clickedBeside}>
      <header>
        <h1 id="title">${msg("Pictures into one wire")}</h1>
        <button class="plain square" aria-label=${msg("Close help")} @click=${() => this.dialog.close()}>${icons.close}</button>
      </header>
      <div class="body">
        ${this.tasks.map((help) => html`<p>${help}</p>`)}
        <p>${msg("When you like a wire, share its link, save it for a 3D printer, or")} <a href="./docs.html" target="_blank">${msg("show it on your own page")}</a>.</p>
        <p><b>${msg("Nothing leaves this device:")}</b> ${msg("no upload, no account, no tracking. Your work is kept in this browser only.")}</p>
        <label class="language"
          >${icons.language} ${msg("Language")}
          <select @change=${(event: Event) => speak((event.target as HTMLSelectElement).value as Language)}>
            ${Object.entries(LANGUAGES).map(([code, name]) => html`<option value=${code} lang=${code} .selected=${code === language()}>${name}</option>`)}
          </select></label
        >
        <h2>${msg("Keys")}</h2>
        <dl>
          ${ACTIONS.filter(({ help }) => help).map(
            ({ keys = [], help }) => html`<dt>${keys.map((key, i) => html`${i ? msg(" or ") : ""}${key.split(" ").map((part) => html`<kbd>${part}</kbd> `)}`)}</dt>
              <dd>${help}</dd>`,
          )}
        </dl>
        <label><input type="checkbox" .checked=${this.letters} @change=${this.switchLetters} /> ${msg("Use keys of one letter")}</label>
        <h2>${msg("Licences")}</h2>
        <p class="small quiet">
          ${msg("Wire4D is free software, MIT or Apache-2.0. With it come the typeface Figtree (OFL 1.1), icons by Lucide (ISC), Lit (BSD-3-Clause), uqr (MIT), gifenc (MIT), jsQR (Apache-2.0) and Mediabunny (MPL-2.0, as it is at github.com/Vanilagy/mediabunny).")}
        </p>
      </div>
    </dialog>`;
  }

  show(): void {
    if (!this.dialog.open) this.dialog.showModal();
  }

  private readonly switchLetters = (event: Event): void => {
    this.letters = (event.target as HTMLInputElement).checked;
    remember("keys", this.letters ? "on" : "off");
  };

  private readonly clickedBeside = (event: Event): void => {
    if (event.target === this.dialog) this.dialog.close();
  };
}
