import { msg, str } from "@lit/localize";
import { html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { givenFor, passingOf } from "../../../state/contract/state";
import { fill } from "../task";
import { deskOf, type Studio, type StudioState } from "../../../state/studio";
import { decimal, percent } from "../../../words/numbers";
import { Part } from "../../../view/part";
import { WORDS } from "../../../ui/settings/setting-words";
import { choiceStyle } from "../../../ui/shared/choice";
import { barStyle, controls } from "../../../ui/shared/shared";
import { fillChoicesStyle } from "./fill-choices-style";

interface Slider {
  readonly name: string;
  readonly label: string;
  /** Of the slider; the setting itself goes further. */
  readonly range: readonly [min: number, max: number, step: number];
  readonly ends: readonly [string, string];
  /** Of the value, for people. */
  words(value: number): string;
}

const SPACING: Slider = {
  name: "curve_spacing",
  label: msg("Spacing"),
  range: [0.03, 0.16, 0.005],
  ends: [msg("Close"), msg("Wide")],
  // The shape is two units across.
  words: (value) => msg(str`${decimal(50 * value, 1)}% of its size`),
};
const DENSITY: Slider = { name: "density", label: msg("Density"), range: [0.1, 1, 0.05], ends: [msg("Light"), msg("Dark")], words: (value) => msg(str`${percent(value)} wire`) };
const STYLE: Slider = { name: "style_strength", label: msg("Style"), range: [0, 1, 0.05], ends: [msg("Not at all"), msg("All of it")], words: percent };

/** What matters most where a wire covers a shape: how close its lines lie, how dark they are, and how far the style bends them. */
@customElement("fill-choices")
export class FillChoices extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;

  static override styles = [controls, choiceStyle, barStyle, fillChoicesStyle];

  override render() {
    const { covering } = passingOf(this.state, fill);
    const styled = givenFor(this.state, fill)?.style != null;
    const busy = covering !== null;
    return html`<div class="all">
      ${this.slider(SPACING)} ${this.slider(DENSITY)} ${this.slider(STYLE, styled ? "" : msg("needs a style"))}
      <label class="run">${msg(str`Lines run ${this.flow(styled)}`)}</label>
      <div class=${busy ? "laying busy" : "laying"}>
        <div class="bar"><i></i></div>
        <span class="small quiet" role="status">${busy ? msg("Laying the lines…") : this.words()}</span>
      </div>
    </div>`;
  }

  protected override updated(): void {
    this.style.setProperty("--share", String(passingOf(this.state, fill).covering ?? 0));
  }

  private words(): string {
    const { planned, restyled, doc, phase } = this.state;
    if (phase !== "idle") return "";
    if (planned) return !passingOf(this.state, fill).curve ? "" : deskOf(doc).made ? msg("Shown as they would run now.") : msg("Shown as they will run.");
    return restyled ? msg("Cover it again to see that.") : "";
  }

  /** `why` it cannot be set, or empty. */
  private slider({ name, label, range, ends, words }: Slider, why = "") {
    const [min, max, step] = range;
    const value = Number(this.studio.options.value(name) || min);
    const locked = this.state.phase !== "idle" || why !== "";
    return html`<div class="choice ${why ? "off" : ""}">
      <label class="head" for=${name}><span>${label}</span><b>${why || words(value)}</b></label>
      <input
        id=${name}
        type="range"
        min=${min}
        max=${max}
        step=${step}
        aria-valuetext=${words(value)}
        .value=${String(value)}
        ?disabled=${locked}
        @input=${(event: Event) => this.studio.options.set(name, (event.target as HTMLInputElement).value)}
      />
      <div class="ends" aria-hidden="true"><span>${ends[0]}</span><span>${ends[1]}</span></div>
    </div>`;
  }

  private flow(styled: boolean) {
    const flow = this.studio.options.value("flow") || "smooth";
    return html`<select ?disabled=${this.state.phase !== "idle"} @change=${(event: Event) => this.studio.options.set("flow", (event.target as HTMLSelectElement).value)}>
      ${Object.entries(WORDS["flow"]!.choices!).map(
        ([value, words]) => html`<option value=${value} .selected=${value === flow} ?disabled=${value === "style" && !styled}>${words}</option>`,
      )}
    </select>`;
  }
}
