import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Studio, StudioState } from "../state/studio";
import { percent } from "../state/words";
import { segmented, segmentedStyle } from "./segmented";
import { WORDS } from "./setting-words";
import { controls } from "./shared";

/** The two choices that matter most: how much to spend, and how far the drawings may bend. */
@customElement("run-choices")
export class RunChoices extends LitElement {
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
      ${this.choice("preset", "best")}
      <div>
        ${this.choice("bend", "little")}
        <p class="small quiet">${this.outlook()}</p>
      </div>
    `;
  }

  private choice(name: "preset" | "bend", usual: string) {
    const { label, choices = {} } = WORDS[name]!;
    return segmented({
      legend: label,
      name,
      options: Object.entries(choices).map(([value, words]) => ({ value, words })),
      value: this.studio.value(name) || usual,
      locked: this.state.phase !== "idle",
      choose: (value) => this.studio.set(name, value),
    });
  }

  /** What the chosen bend would come to, as far as that is known before the fit. */
  private outlook(): string {
    const bend = this.state.preview?.bends.find(({ bend }) => bend === this.studio.value("bend"));
    if (!bend || bend.coverable === null) return "";
    const moved = bend.movedPx !== null && bend.movedPx >= 0.1 ? `; lines move by ${bend.movedPx.toFixed(1)} px of 256` : "";
    return `${percent(bend.coverable)} of the ink can be shown${moved}.`;
  }
}
