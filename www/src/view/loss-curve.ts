import { msg } from "@lit/localize";
import { css, html, nothing, svg } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { RunEvent } from "../engine/protocol";
import { curve } from "./curve";
import { Part } from "./part";

const WIDTH = 240;
const HEIGHT = 56;

/** How far the views are from their drawings, falling as the run goes on, with a mark for everything that happened. */
@customElement("loss-curve")
export class LossCurve extends Part {
  /** [iteration, loss] */
  @property({ attribute: false }) losses: readonly (readonly [number, number])[] = [];
  @property({ attribute: false }) events: readonly RunEvent[] = [];
  @property({ type: Number }) iterations = 0;
  /** The iteration that is looked at, if it is not the newest. */
  @property({ attribute: false }) at: number | null = null;

  static override styles = css`
    :host {
      display: block;
    }
    .row {
      display: flex;
      justify-content: space-between;
      gap: 8px;
      font-size: 13px;
      color: var(--quiet);
    }
    .value {
      color: var(--ink);
    }
    svg {
      display: block;
      width: 100%;
      height: ${HEIGHT}px;
      margin-top: 4px;
      overflow: visible;
    }
    :host(:dir(rtl)) svg {
      transform: scaleX(-1);
    }
    line {
      stroke: var(--line);
      vector-effect: non-scaling-stroke;
    }
    .mark {
      stroke: var(--line-strong);
      stroke-dasharray: 2 3;
    }
    .at {
      stroke: var(--ink);
    }
    .curve {
      fill: none;
      stroke: var(--copper);
      stroke-width: 2;
      stroke-linejoin: round;
      vector-effect: non-scaling-stroke;
    }
  `;

  override render() {
    const last = this.losses.findLast(([iteration]) => this.at === null || iteration <= this.at);
    const x = (iteration: number): number => (iteration / Math.max(1, this.iterations)) * WIDTH;
    const upright = (name: string, iteration: number) =>
      svg`<line class=${name} x1=${x(iteration)} x2=${x(iteration)} y1="0" y2=${HEIGHT} />`;
    return html`
      <div class="row">
        <span>${msg("Still off by")}</span>
        <span class="value" data-loss=${last ? last[1] : ""}>${last ? last[1].toPrecision(2) : "–"}</span>
      </div>
      <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="none" aria-hidden="true">
        <line x1="0" x2=${WIDTH} y1=${HEIGHT - 0.5} y2=${HEIGHT - 0.5} />
        ${this.events.filter(({ kind }) => kind !== "done").map(({ iteration }) => upright("mark", iteration))}
        ${this.at === null ? nothing : upright("at", this.at)}
        ${this.losses.length > 1 ? svg`<path class="curve" d=${curve(this.losses, this.iterations, WIDTH, HEIGHT)} />` : nothing}
      </svg>
    `;
  }
}
