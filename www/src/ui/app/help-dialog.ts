import { css, html, LitElement } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { icons } from "../shared/icons";
import { remember, remembered } from "../../state/common/remember";
import { dialogStyle } from "../shared/dialog-style";
import { controls } from "../shared/shared";
import { SHORTCUTS } from "./shortcuts";

export const lettersOn = (): boolean => remembered("keys") !== "off";

/** What this is, which keys it knows, and what becomes of one's drawings. */
@customElement("help-dialog")
export class HelpDialog extends LitElement {
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
        <p>
          <b>Three views.</b> Put a picture on each pad: draw it, type a word, choose an icon, or drop a file. Press Run, and one continuous wire
          bends itself until its shadows from the front, the side and above are your three drawings. What no wire can show in all
          views at once is marked in amber before you run, with a click to make it better. Turn the room to see the pictures click
          into place.
        </p>
        <p>
          <b>One picture.</b> Give one picture with something in it: a cat, a face, a word. The app finds what stands out, guesses
          how it is rounded, and bends one wire that draws it from the front and still makes sense from the side. Fewer control
          points make it more abstract.
        </p>
        <p>
          <b>A shape.</b> Choose a shape or drop a mesh, and one closed wire covers it all over. A style bends and thickens it: petals,
          waves, or a picture of your own. What is behind the shape is hidden, so that the lines stay clear.
        </p>
        <p>When you like a wire, copy its link or save it for a 3D printer.</p>
        <p><b>Nothing leaves this device:</b> no upload, no account, no tracking. Your work is kept in this browser only.</p>
        <h2>Keys</h2>
        <dl>
          ${SHORTCUTS.map(
            ({ keys, words }) => html`<dt>${keys.map((key, i) => html`${i ? " or " : ""}${key.split(" ").map((part) => html`<kbd>${part}</kbd> `)}`)}</dt>
              <dd>${words}</dd>`,
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
