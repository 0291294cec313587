import { html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { msg } from "@lit/localize";
import type { Studio, StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { foldStyle } from "../shared/fold";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";

/** Where a teacher sets the page up for a class; not within a lesson. What is in it comes when it is opened. */
@customElement("class-fold")
export class ClassFold extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @state() private ready = false;

  static override styles = [controls, foldStyle];

  override render() {
    if (this.state.lesson) return nothing;
    return html`<details @toggle=${this.fetch}>
      <summary>${msg("For my class")} ${icons.more}</summary>
      ${this.ready ? html`<class-editor class="group" .studio=${this.studio} .state=${this.state}></class-editor>` : nothing}
    </details>`;
  }

  private readonly fetch = async (): Promise<void> => {
    await import("./class-editor");
    this.ready = true;
  };
}
