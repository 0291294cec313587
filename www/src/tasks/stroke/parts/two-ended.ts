import { css, html, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { Part } from "../../../view/part";
import { controls } from "../../../ui/shared/shared";

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
  @property({ attribute: false }) names: readonly [low: string, high: string] = ["From", "To"];
  @property({ attribute: false }) unit = "";
  /** Both ends are one. */
  @property({ type: Boolean }) together = false;
  @property({ type: Boolean }) disabled = false;
  /** While it is dragged. */
  @state() private draft: Ends | null = null;

  static override styles = [
    controls,
    css`
      :host {
        display: block;
      }
      .track {
        position: relative;
        height: 24px;
      }
      .track::before,
      .between {
        content: "";
        position: absolute;
        inset-block-start: calc(50% - 3px);
        inset-inline: 0;
        height: 6px;
        border-radius: 3px;
        background: color-mix(in srgb, var(--ink) 18%, transparent);
      }
      .between {
        background: var(--copper);
      }
      input[type="range"] {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
        appearance: none;
        background: none;
        /* Only its thumb, or the upper one would cover the other. */
        pointer-events: none;
      }
      input::-webkit-slider-thumb {
        width: 18px;
        height: 18px;
        border: 2px solid var(--raised);
        border-radius: 9px;
        background: var(--copper);
        appearance: none;
        cursor: pointer;
        pointer-events: auto;
      }
      input::-moz-range-thumb {
        width: 14px;
        height: 14px;
        border: 2px solid var(--raised);
        border-radius: 9px;
        background: var(--copper);
        cursor: pointer;
        pointer-events: auto;
      }
      input:focus-visible {
        outline: none;
      }
      input:focus-visible::-webkit-slider-thumb {
        outline: 2px solid var(--copper);
        outline-offset: 2px;
      }
      input:focus-visible::-moz-range-thumb {
        outline: 2px solid var(--copper);
        outline-offset: 2px;
      }
      .off {
        opacity: 0.5;
      }
      @media (pointer: coarse) {
        .track {
          height: 44px;
        }
        input::-webkit-slider-thumb {
          width: 26px;
          height: 26px;
          border-radius: 13px;
        }
        input::-moz-range-thumb {
          width: 22px;
          height: 22px;
          border-radius: 13px;
        }
      }
      @media (forced-colors: active) {
        .between,
        input::-webkit-slider-thumb {
          forced-color-adjust: none;
          background: Highlight;
        }
        .track::before {
          background: CanvasText;
        }
      }
    `,
  ];

  override render() {
    const { low, high } = this.ends;
    return html`<div class="track ${this.disabled ? "off" : ""}">
      <i class="between"></i>
      ${this.together ? this.end("low", low, `${this.names[0]} and ${this.names[1].toLowerCase()}`) : [this.end("low", low, this.names[0]), this.end("high", high, this.names[1])]}
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
