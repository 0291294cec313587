import { msg, str } from "@lit/localize";
import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { passingOf } from "../../../state/contract/state";
import type { Studio, StudioState } from "../../../state/studio";
import { percent } from "../../../words/numbers";
import { Part } from "../../../view/part";
import { settingChoice } from "../../../ui/run/setting-choice";
import { segmentedStyle } from "../../../ui/shared/segmented";
import { controls } from "../../../ui/shared/shared";
import { multiview } from "../task";

const BENDS: Readonly<Record<string, string>> = {
  none: msg("The drawings stay exactly as they are"),
  little: msg("Lines may move by a pixel or two"),
  free: msg("Lines may move as far as it takes"),
};

/** How far the drawings may bend. */
@customElement("bend-choice")
export class BendChoice extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;

  static override styles = [
    controls,
    segmentedStyle,
    css`
      :host {
        display: block;
      }
      p {
        min-height: 18px;
        margin: 4px 0 0;
      }
    `,
  ];

  override render() {
    return html`${settingChoice(this.studio, this.state, "bend", "little")}
      <p class="small quiet">${this.outlook()}</p>`;
  }

  /** What the chosen bend means, and comes to as far as that is known before the fit. */
  private outlook(): string {
    const chosen = this.studio.options.value("bend") || "little";
    const coverable = passingOf(this.state, multiview).preview?.bends.find(({ bend }) => bend === chosen)?.coverable ?? null;
    return `${BENDS[chosen] ?? ""}${coverable === null ? "" : msg(str`; ${percent(coverable)} can be shown`)}.`;
  }
}
