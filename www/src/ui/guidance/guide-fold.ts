import { msg } from "@lit/localize";
import { html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { Studio, StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { foldStyle } from "../shared/fold";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";

/** Where words may guide. What is in it comes when it is opened. */
@customElement("guide-fold")
export class GuideFold extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @property({ type: Boolean }) locked = false;
  @state() private ready = false;

  static override styles = [controls, foldStyle];

  override render() {
    return html`<details @toggle=${this.fetch}>
      <summary>${msg("Guide by words")} <span class="small quiet">${msg("experimental")}</span> ${icons.more}</summary>
      ${this.ready ? html`<guide-panel class="group" .studio=${this.studio} .state=${this.state} ?locked=${this.locked}></guide-panel>` : nothing}
    </details>`;
  }

  private readonly fetch = async (): Promise<void> => {
    await import("./guide-panel");
    this.ready = true;
  };
}
