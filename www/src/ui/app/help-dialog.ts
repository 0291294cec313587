import { css, html, LitElement, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { icons } from "../shared/icons";
import { remember, remembered } from "../../state/common/remember";
import { dialogStyle } from "../shared/dialog-style";
import { controls } from "../shared/shared";
import { ACTIONS } from "./actions";

export const lettersOn = (): boolean => remembered("keys") !== "off";

/** What this is, which keys it knows, and what becomes of one's drawings. */
@customElement("help-dialog")
export class HelpDialog extends LitElement {
  /** What it says of each task. */
  @property({ attribute: false }) tasks: readonly TemplateResult[] = [];
  @state() private letters = lettersOn();
  @query("dialog") private dialog!: HTMLDialogElement;

  static override styles = [
    controls,
    dialogStyle,
    css`
      dialog {
        width: min(560px, calc(100vw - 32px));
      }
      header {
        position: sticky;
        top: 0;
        display: flex;
        align-items: center;
        justify-content: space-between;
        padding: 16px 16px 8px 24px;
        padding-inline: 24px 16px;
        background: var(--raised);
      }
      h1 {
        margin: 0;
        font-size: 20px;
        font-weight: 600;
      }
      .body {
        display: grid;
        gap: 16px;
        padding: 0 24px 24px;
      }
      .body > * {
        margin: 0;
      }
      h2 {
        margin-block-start: 8px;
        color: var(--ink);
      }
      dl {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr);
        gap: 8px 24px;
        margin: 0;
      }
      dt {
        white-space: nowrap;
      }
      dd {
        margin: 0;
      }
      kbd {
        display: inline-block;
        min-width: 24px;
        padding: 0 6px;
        border: 1px solid var(--line-strong);
        border-radius: 4px;
        font: inherit;
        font-size: 13px;
        text-align: center;
      }
      label {
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: 24px;
      }
      input {
        flex: none;
        width: 20px;
        height: 20px;
        margin: 0;
      }
    `,
  ];

  override render() {
    return html`<dialog aria-labelledby="title" @click=${this.clickedBeside}>
      <header>
        <h1 id="title">Pictures into one wire</h1>
        <button class="plain square" aria-label="Close help" @click=${() => this.dialog.close()}>${icons.close}</button>
      </header>
      <div class="body">
        ${this.tasks.map((help) => html`<p>${help}</p>`)}
        <p>When you like a wire, copy its link or save it for a 3D printer.</p>
        <p><b>Nothing leaves this device:</b> no upload, no account, no tracking. Your work is kept in this browser only.</p>
        <h2>Keys</h2>
        <dl>
          ${ACTIONS.filter(({ help }) => help).map(
            ({ keys = [], help }) => html`<dt>${keys.map((key, i) => html`${i ? " or " : ""}${key.split(" ").map((part) => html`<kbd>${part}</kbd> `)}`)}</dt>
              <dd>${help}</dd>`,
          )}
        </dl>
        <label><input type="checkbox" .checked=${this.letters} @change=${this.switchLetters} /> Use keys of one letter</label>
        <h2>Licences</h2>
        <p class="small quiet">
          Wire4D is free software, MIT or Apache-2.0. With it come the typeface Figtree (OFL 1.1), icons by Lucide (ISC) and Lit
          (BSD-3-Clause).
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
