import { msg } from "@lit/localize";
import { html, type PropertyValues } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Made } from "../../state/studio";
import { viewFrom } from "../../view/heading";
import { Part } from "../../view/part";
import { SMALL_PX, SmallPictures, type SmallPicture } from "../../view/small-pictures";
import { smallStyle } from "../../view/small-style";
import { controls } from "../shared/shared";
import { wirePairStyle } from "./wire-pair-style";

const TURNED = viewFrom({ azimuth: 35, elevation: 15 }, "turned");

/** A number of a wire: its name, and what it is of one. */
export type PairRow = readonly [name: string, tell: (made: Made) => string];

/** Two wires side by side: from the front, turned, and in numbers. */
@customElement("wire-pair")
export class WirePair extends Part {
  @property({ attribute: false }) pair!: readonly [Made, Made];
  /** Over the columns, and in the middle of a sentence. */
  @property({ attribute: false }) names!: readonly [heading: string, inWords: string][];
  @property({ attribute: false }) rows!: readonly PairRow[];
  private readonly pictures = [new SmallPictures(this, () => this.shown(0)), new SmallPictures(this, () => this.shown(1))] as const;
  private readonly recolour = (): void => this.pictures.forEach((pictures) => pictures.recolour());

  static override styles = [controls, smallStyle, wirePairStyle];

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("theme-change", this.recolour);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("theme-change", this.recolour);
  }

  override render() {
    const pictures = (name: string, words: string) => html`<tr class="picture">
      <th scope="row">${name}</th>
      ${this.names.map(([, what]) => html`<td><canvas width=${SMALL_PX} height=${SMALL_PX} role="img" aria-label="${what} ${words}"></canvas></td>`)}
    </tr>`;
    return html`<table>
      <thead>
        <tr>
          <th scope="col"><span class="unseen">${msg("What")}</span></th>
          ${this.names.map(([heading]) => html`<th scope="col">${heading}</th>`)}
        </tr>
      </thead>
      <tbody>
        ${pictures(msg("Front"), msg("from the front"))} ${pictures(msg("Turned"), msg("turned to the right and seen from above"))}
        ${this.rows.map(
          ([name, tell]) => html`<tr>
            <th scope="row">${name}</th>
            ${this.pair.map((made) => html`<td>${tell(made)}</td>`)}
          </tr>`,
        )}
      </tbody>
    </table>`;
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (changed.has("pair")) this.pictures.forEach((pictures, column) => pictures.setWire(this.pair[column]!.finished.wire));
  }

  /** The pictures of a column: row by row, the two stand side by side. */
  private shown(column: 0 | 1): readonly SmallPicture[] {
    const { views, targets } = this.pair[column].finished;
    const canvases = [...this.renderRoot.querySelectorAll("canvas")].filter((_, i) => i % 2 === column);
    const [front] = views;
    if (!front || canvases.length < 2) return [];
    return [
      { canvas: canvases[0]!, view: front, under: targets.find(({ view }) => view.name === front.name) },
      { canvas: canvases[1]!, view: TURNED },
    ];
  }
}
