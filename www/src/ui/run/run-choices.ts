import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Studio, StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { segmentedStyle } from "../shared/segmented";
import { controls } from "../shared/shared";
import { settingChoice } from "./setting-choice";
import { wireChoice } from "./wire-choice";

/** The choices that matter most: how much to spend, and how calm the wire is. What is slotted in stands below. */
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
    `,
  ];

  override render() {
    return html`${settingChoice(this.studio, this.state, "preset", "best")} ${wireChoice(this.studio, this.state)} <slot></slot>`;
  }
}
