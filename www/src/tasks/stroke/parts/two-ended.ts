import { msg, str } from "@lit/localize";
import { html, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { Part } from "../../../view/part";
import { controls } from "../../../ui/shared/shared";
import { twoEndedStyle } from "./two-ended-style";

export interface Ends {
  readonly low: number;
  readonly high: number;
}

/** A slider with two ends: two plain sliders on one track, so that keys and screen readers know what they are. Fires `choose`. */
@customElement("two-ended")
export class TwoEnded extends Part {
  @property({ attribute: false }) min = 0;
  @property({ attribute: false }) max = 1;
  @property({ attribute: false }) step = 0.1;
  @property({ attribute: false }) low = 0;
  @property({ attribute: false }) high = 1;
  @property({ attribute: false }) names: readonly [low: string, high: string] = [msg("From"), msg("To")];
  @property({ attribute: false }) unit = "";
  /** Both ends are one. */
  @property({ type: Boolean }) together = false;
  @property({ type: Boolean }) disabled = false;
  /** While it is dragged. */
  @state() private draft: Ends | null = null;

  static override styles = [controls, twoEndedStyle];

  override render() {
    const { low, high } = this.ends;
    return html`<div class="track ${this.disabled ? "off" : ""}">
      <i class="between"></i>
      ${this.together ? this.end("low", low, msg(str`${this.names[0]} and ${this.names[1].toLowerCase()}`)) : [this.end("low", low, this.names[0]), this.end("high", high, this.names[1])]}
    </div>`;
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("low") || changed.has("high")) this.draft = null;
  }

  protected override updated(): void {
    const { low, high } = this.ends;
    const share = (value: number): number => Math.max(0, Math.min(1, (value - this.min) / (this.max - this.min)));
    const between = this.renderRoot.querySelector<HTMLElement>(".between")!;
    // Set by script: the page's policy allows no style attributes.
    between.style.insetInlineStart = `${100 * (this.together ? 0 : share(low))}%`;
    between.style.insetInlineEnd = `${100 * (1 - share(high))}%`;
  }

  private get ends(): Ends {
    return this.draft ?? { low: this.low, high: this.high };
  }

  private end(which: keyof Ends, value: number, name: string) {
    return html`<input
      class=${which}
      type="range"
      aria-label=${name}
      aria-valuetext="${value} ${this.unit}"
      min=${this.min}
      max=${this.max}
      step=${this.step}
      .value=${String(value)}
      ?disabled=${this.disabled}
      @input=${(event: Event) => (this.draft = this.moved(which, event))}
      @change=${(event: Event) => this.choose(this.moved(which, event))}
    />`;
  }

  /** An end that is pushed past the other takes it along. */
  private moved(which: keyof Ends, event: Event): Ends {
    const value = Number((event.target as HTMLInputElement).value);
    if (this.together) return { low: value, high: value };
    const { low, high } = this.ends;
    return which === "low" ? { low: value, high: Math.max(high, value) } : { low: Math.min(low, value), high: value };
  }

  private choose(ends: Ends): void {
    this.draft = ends;
    this.dispatchEvent(new CustomEvent<Ends>("choose", { detail: ends }));
  }
}
