import { msg, str } from "@lit/localize";
import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { presetOf } from "../../../state/settings/values";
import { tableOf, type Studio, type StudioState } from "../../../state/studio";
import { count } from "../../../words/numbers";
import { Part } from "../../../view/part";
import { choiceStyle } from "../../../ui/shared/choice";
import { segmentedStyle } from "../../../ui/shared/segmented";
import { controls } from "../../../ui/shared/shared";
import "./two-ended";
import type { Ends } from "./two-ended";
import { settingChoice } from "../../../ui/run/setting-choice";

/** Ends and step of the sliders; the settings themselves go further. */
const POINTS = [40, 400, 10] as const;
const WIDTHS = [0, 24, 0.5] as const;
/** The least width that the other may end at, px. */
const LEAST_MOST = 0.5;

/** What matters most where one picture becomes a wire: how much to spend, how abstract it gets, and how thin and thick. */
@customElement("stroke-choices")
export class StrokeChoices extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;

  static override styles = [
    controls,
    segmentedStyle,
    choiceStyle,
    css`
      :host {
        display: grid;
        gap: 16px;
      }
      .head {
        min-height: 24px;
      }
      label {
        display: flex;
        align-items: center;
        gap: 8px;
        color: var(--ink);
        cursor: pointer;
      }
      /* Where the app decides, it only says what moving it would begin with. */
      .points.left {
        opacity: 0.5;
      }
      input[type="checkbox"] {
        width: 18px;
        height: 18px;
        margin: 0;
      }
      @media (pointer: coarse) {
        .head {
          min-height: 44px;
        }
      }
    `,
  ];

  override render() {
    return html`
      ${settingChoice(this.studio, this.state, "preset", "best")}
      ${this.abstraction()} ${this.widths()}
    `;
  }

  private get locked(): boolean {
    return this.state.phase !== "idle";
  }

  private abstraction() {
    const points = this.number("control_points");
    const auto = points === 0;
    const set = (points: number): void => this.studio.options.set("control_points", String(points));
    return html`<div class="choice" role="group" aria-labelledby="abstraction">
      <div class="head">
        <span id="abstraction">${msg("Abstraction")}</span>
        <label><input class="auto" type="checkbox" ?disabled=${this.locked} .checked=${auto} @change=${(event: Event) => set((event.target as HTMLInputElement).checked ? 0 : POINTS[1] / 2)} /> ${msg("Auto")}</label>
      </div>
      <input
        class=${auto ? msg("points left") : "points"}
        type="range"
        ?disabled=${this.locked}
        aria-label=${msg("Abstraction, by the number of control points")}
        aria-valuetext=${auto ? msg("chosen by the app") : msg(str`${count(points)} control points`)}
        min=${POINTS[0]}
        max=${POINTS[1]}
        step=${POINTS[2]}
        .value=${String(auto ? POINTS[1] : points)}
        @change=${(event: Event) => set(Number((event.target as HTMLInputElement).value))}
      />
      <div class="ends"><span>${msg("A few bends")}</span><b>${auto ? msg("As many as it takes") : msg(str`${count(points)} points`)}</b><span>${msg("Every line")}</span></div>
    </div>`;
  }

  private widths() {
    const [least, most] = [this.number("min_width"), this.number("max_width")];
    const constant = least === most;
    const unit = "px";
    return html`<div class="choice" role="group" aria-labelledby="widths">
      <div class="head">
        <span id="widths">${msg("Width of the wire")}</span>
        <label><input class="constant" type="checkbox" ?disabled=${this.locked} .checked=${constant} @change=${this.makeConstant} /> ${msg("Constant")}</label>
      </div>
      <two-ended
        .min=${WIDTHS[0]}
        .max=${WIDTHS[1]}
        .step=${WIDTHS[2]}
        .low=${least}
        .high=${most}
        .names=${[msg("Thinnest"), msg("Thickest")]}
        .unit=${msg("pixels of 256")}
        ?together=${constant}
        ?disabled=${this.locked}
        @choose=${(event: CustomEvent<Ends>) => this.setWidths(event.detail)}
      ></two-ended>
      <div class="ends"><b>${constant ? `${shown(least)} ${unit}` : msg(str`${shown(least)} to ${shown(most)} ${unit}`)}</b><span>${msg("in a picture of 256 px")}</span></div>
    </div>`;
  }

  private number(name: string): number {
    return Number(this.studio.options.value(name) || 0);
  }

  private readonly makeConstant = (event: Event): void => {
    if (!(event.target as HTMLInputElement).checked) {
      const table = tableOf(this.state);
      const usual = table ? presetOf(this.studio.options.all, table) : {};
      this.setWidths({ low: Number(usual["min_width"] ?? 1), high: Number(usual["max_width"] ?? WIDTHS[1]) });
      return;
    }
    // Neither end: hair lines would hardly be seen, and the thickest leave no room for each other.
    const middle = Math.sqrt(Math.max(LEAST_MOST, this.number("min_width")) * this.number("max_width"));
    const width = Math.min(WIDTHS[1], Math.max(LEAST_MOST, Math.round(middle / WIDTHS[2]) * WIDTHS[2]));
    this.setWidths({ low: width, high: width });
  };

  private setWidths({ low, high }: Ends): void {
    this.studio.options.setAll({ min_width: String(low), max_width: String(Math.max(LEAST_MOST, high)) }, msg("Set the width"), "set width");
  }
}

const shown = (px: number): string => count(Math.round(100 * px) / 100);
