import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Subject } from "../../state/subject/subject";
import { Part } from "../../view/part";
import { controls } from "../shared/shared";

/** Stands in for the pad. */
@customElement("subject-pad")
export class SubjectPad extends Part {
  @property({ attribute: false }) subject: Subject | null = null;
  @property({ type: Boolean }) busy = false;
  @property() problem = "";
  @property() note = "";
  @property({ type: Boolean }) locked = false;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
    `,
  ];

  override render() {
    return html`<h2>Picture</h2>
      <p>${this.subject?.picture.name ?? "None"} ${this.subject?.found?.count ?? ""} ${this.problem} ${this.note}</p>
      <input type="file" accept="image/*" aria-label="Picture" ?disabled=${this.locked} @change=${this.give} />`;
  }

  private readonly give = (event: Event): void => {
    const file = (event.target as HTMLInputElement).files?.[0];
    if (file) this.dispatchEvent(new CustomEvent("give", { detail: { file, name: file.name } }));
  };
}
