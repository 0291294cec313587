import { css, html, LitElement, svg } from "lit";
import { customElement, property } from "lit/decorators.js";

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
        ${this.losses.length > 1 ? svg`<path class="curve" d=${curve(this.losses)} />` : ""}
      </svg>
    `;
  }
}

/** At most one point every other pixel, however long the run. */
export function curve(losses: readonly (readonly [number, number])[]): string {
  const every = Math.max(1, Math.ceil(losses.length / (WIDTH / 2)));
  const kept = losses.filter((_, i) => i % every === 0 || i === losses.length - 1);
  const logs = kept.map(([, loss]) => Math.log10(Math.max(loss, 1e-9)));
  const [low, high] = [Math.min(...logs), Math.max(...logs)];
  const first = kept[0]![0];
  const span = Math.max(1, kept.at(-1)![0] - first);
  return kept
    .map(([iteration], i) => {
      const x = ((iteration - first) / span) * WIDTH;
      const y = 3 + (1 - (logs[i]! - low) / Math.max(1e-6, high - low)) * (HEIGHT - 8);
      return `${i ? "L" : "M"}${x.toFixed(1)} ${y.toFixed(1)}`;
    })
    .join("");
}
