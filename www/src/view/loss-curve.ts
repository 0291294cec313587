import { css, html, LitElement, svg } from "lit";
import { customElement, property } from "lit/decorators.js";
import { curve } from "./curve";

const WIDTH = 240;
const HEIGHT = 56;

/** How far the views are from their drawings, falling as the run goes on. Logarithmic upwards. */
@customElement("loss-curve")
export class LossCurve extends LitElement {
  /** [iteration, loss] */
  @property({ attribute: false }) losses: readonly (readonly [number, number])[] = [];

  static override styles = css`
    :host {
      display: block;
    }
    .row {
      display: flex;
      justify-content: space-between;
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
    .ground {
      stroke: var(--line);
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
    const last = this.losses.at(-1);
    return html`
      <div class="row">
        <span>Still off by</span>
        <span class="value" data-loss=${last ? last[1] : ""}>${last ? last[1].toPrecision(2) : "–"}</span>
      </div>
      <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" preserveAspectRatio="none" aria-hidden="true">
        <line class="ground" x1="0" x2=${WIDTH} y1=${HEIGHT - 0.5} y2=${HEIGHT - 0.5} />
        ${this.losses.length > 1 ? svg`<path class="curve" d=${curve(this.losses, WIDTH, HEIGHT)} />` : ""}
      </svg>
    `;
  }
}
