import { msg, str } from "@lit/localize";
import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { Insight, LossLevel } from "../../engine/protocol";
import { percent } from "../../words/numbers";
import { viewWords } from "../../view/heading";
import { Part } from "../../view/part";
import { segmented, segmentedStyle } from "../shared/segmented";
import { controls } from "../shared/shared";
import { paintLevel, SHOWINGS, type Showing } from "./level-painting";

/** Every view at every scale of the loss, as a row of small pictures; one of them large. */
@customElement("level-views")
export class LevelViews extends Part {
  @property({ attribute: false }) insight!: Insight;
  @state() private showing: Showing = "difference";
  /** Which one is large, by view and level. */
  @state() private chosen: readonly [view: number, level: number] = [0, 0];

  static override styles = [
    controls,
    segmentedStyle,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
      .row {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(40px, 1fr));
        gap: 4px;
      }
      h4 {
        margin: 0;
        font-size: 13px;
        font-weight: 400;
        text-transform: capitalize;
        color: var(--quiet);
      }
      button.level {
        min-height: 0;
        aspect-ratio: 1;
        overflow: hidden;
        padding: 0;
        border-width: 2px;
      }
      button.level[aria-pressed="true"] {
        border-color: var(--copper);
      }
      canvas {
        display: block;
        width: 100%;
        height: 100%;
        image-rendering: pixelated;
      }
      figure {
        margin: 0;
      }
      figure canvas {
        height: auto;
        border: 1px solid var(--line);
        border-radius: 6px;
      }
      figcaption::first-letter {
        text-transform: capitalize;
      }
      figcaption,
      p {
        margin: 4px 0 0;
        font-size: 13px;
        line-height: 18px;
        color: var(--quiet);
      }
    `,
  ];

  override render() {
    const { views } = this.insight;
    const level = this.large;
    return html`
      ${segmented({
        legend: msg("What the small pictures show"),
        name: "showing",
        options: SHOWINGS.map((value) => ({ value, words: this.wordsOf(value) })),
        value: this.showing,
        choose: (value) => (this.showing = value as Showing),
      })}
      ${views.map(
        (levels, view) => html`<h4 id="view-${view}">${this.nameOf(view)}</h4>
          <div class="row" role="group" aria-labelledby="view-${view}">
            ${levels.map(
              (_, level) => html`<button
                class="level"
                aria-pressed=${String(this.isChosen(view, level))}
                aria-label=${this.sayOf(view, level)}
                title=${this.sayOf(view, level)}
                @click=${() => (this.chosen = [view, level])}
              >
                <canvas data-view=${view} data-level=${level} aria-hidden="true"></canvas>
              </button>`,
            )}
          </div>`,
      )}
      ${level
        ? html`<figure>
            <canvas data-view=${this.chosen[0]} data-level=${this.chosen[1]} role="img" aria-label=${this.sayOf(...this.chosen)}></canvas>
            <figcaption>${this.sayOf(...this.chosen)}${this.showing === "difference" ? html` ${msg("Dark: too much wire. Light: wire is lacking. Grey: right.")}` : nothing}</figcaption>
          </figure>`
        : nothing}
    `;
  }

  protected override updated(): void {
    for (const canvas of this.renderRoot.querySelectorAll("canvas")) {
      const level = this.insight.views[Number(canvas.dataset["view"])]?.[Number(canvas.dataset["level"])];
      if (level) paintLevel(canvas, level, this.showing);
    }
  }

  private get large(): LossLevel | undefined {
    return this.insight.views[this.chosen[0]]?.[this.chosen[1]];
  }

  private isChosen(view: number, level: number): boolean {
    return view === this.chosen[0] && level === this.chosen[1];
  }

  private nameOf(view: number): string {
    return viewWords(this.insight.pulls[view]?.name ?? "");
  }

  private wordsOf(showing: Showing): string {
    return { difference: msg("Difference"), seen: msg("The wire"), wanted: msg("The picture") }[showing];
  }

  private sayOf(view: number, level: number): string {
    const levels = this.insight.views[view] ?? [];
    const { loss = 0, seen } = levels[level] ?? {};
    const whole = levels.reduce((sum, { loss }) => sum + loss, 0);
    const of = percent(whole > 0 ? loss / whole : 0);
    return msg(str`${this.nameOf(view)}, ${seen?.width ?? 0} × ${seen?.height ?? 0} pixels: ${of} of what this view is off by.`);
  }
}
