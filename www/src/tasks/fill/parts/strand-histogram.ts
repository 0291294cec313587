import { msg, str } from "@lit/localize";
import { css, html, svg } from "lit";
import { customElement, property } from "lit/decorators.js";
import { percent } from "../../../words/numbers";
import { Part } from "../../../view/part";
import { controls } from "../../../ui/shared/shared";

const WIDTH = 210;
const HEIGHT = 44;

/** How far lines lie from their neighbours: a bar a tenth of the distance they were laid at. */
@customElement("strand-histogram")
export class StrandHistogram extends Part {
  /** Share of the wire by the distance to the nearest other line: bar `k` from `k / 10` spacings on. */
  @property({ attribute: false }) strands: readonly number[] = [];

  static override styles = [
    controls,
    css`
      figure {
        margin: 0;
      }
      svg {
        display: block;
        width: 100%;
        max-height: 72px;
        overflow: visible;
        opacity: var(--vivid, 1);
      }
      rect {
        fill: var(--copper);
      }
      .asked {
        stroke: var(--ink);
        stroke-width: 1;
        stroke-dasharray: 2 2;
      }
      .ground {
        stroke: var(--line-strong);
        stroke-width: 1;
      }
      /* As the bars, which no direction of writing turns round. */
      figcaption {
        direction: ltr;
        display: flex;
        justify-content: space-between;
        gap: 8px;
      }
    `,
  ];

  override render() {
    const { strands } = this;
    const most = Math.max(1e-9, ...strands);
    const step = WIDTH / Math.max(1, strands.length);
    const near = strands.reduce((sum, share, k) => sum + (k >= 7 && k < 14 ? share : 0), 0);
    const words = msg(str`From line to line: ${percent(near)} of the wire is as far from its neighbour as it should be, give or take a third.`);
    return html`<figure>
      <svg viewBox="0 -2 ${WIDTH} ${HEIGHT + 4}" preserveAspectRatio="none" role="img" aria-label=${words}>
        ${strands.map((share, k) => svg`<rect x=${k * step + 0.5} y=${HEIGHT * (1 - share / most)} width=${step - 1} height=${(HEIGHT * share) / most} />`)}
        <path class="ground" d="M0 ${HEIGHT}H${WIDTH}" />
        <path class="asked" d="M${10 * step} 0V${HEIGHT}" />
      </svg>
      <figcaption class="small quiet"><span>${msg("touching")}</span><span>${msg("From line to line")}</span><span>${msg("twice as far")}</span></figcaption>
    </figure>`;
  }
}
