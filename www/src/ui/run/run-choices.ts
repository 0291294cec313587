import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Studio, StudioState } from "../../state/studio";
import { percent } from "../../state/common/words";
import { Part } from "../../view/part";
import { segmentedStyle } from "../shared/segmented";
import { controls } from "../shared/shared";
import { settingChoice } from "./setting-choice";
import { wireChoice } from "./wire-choice";

const BENDS: Readonly<Record<string, string>> = {
  none: "The drawings stay exactly as they are",
  little: "Lines may move by a pixel or two",
  free: "Lines may move as far as it takes",
};

/** The choices that matter most: how much to spend, how calm the wire is, and how far the drawings may bend. */
@customElement("run-choices")
export class RunChoices extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;

  static override styles = [
    controls,
    segmentedStyle,
    css`
      :host {
        display: grid;
        gap: 16px;
      }
      p {
        min-height: 18px;
        margin: 4px 0 0;
      }
    `,
  ];

  override render() {
    return html`
      ${settingChoice(this.studio, this.state, "preset", "best")}
      ${wireChoice(this.studio, this.state)}
      ${this.state.doc.job === "multiview"
        ? html`<div>
            ${settingChoice(this.studio, this.state, "bend", "little")}
            <p class="small quiet">${this.outlook()}</p>
          </div>`
        : nothing}
    `;
  }

  /** What the chosen bend means, and comes to as far as that is known before the fit. */
  private outlook(): string {
    const chosen = this.studio.options.value("bend") || "little";
    const coverable = this.state.preview?.bends.find(({ bend }) => bend === chosen)?.coverable ?? null;
    return `${BENDS[chosen] ?? ""}${coverable === null ? "" : `; ${percent(coverable)} can be shown`}.`;
  }
}
