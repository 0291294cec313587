import { html, nothing, type PropertyValues } from "lit";
import { customElement, property } from "lit/decorators.js";
import { compare } from "../../state/actions/actions";
import { deskOf, type Made, type Studio, type StudioState } from "../../state/studio";
import { percent } from "../../state/common/words";
import { count } from "../../state/common/count";
import { viewFrom } from "../../view/heading";
import { Part } from "../../view/part";
import { SMALL_PX, SmallPictures, type SmallPicture } from "../../view/small-pictures";
import { smallStyle } from "../../view/small-style";
import { controls } from "../shared/shared";
import { compared, gapOf, meanMatch } from "./compared";
import { wireComparisonStyle } from "./wire-comparison-style";

const TURNED = viewFrom({ azimuth: 35, elevation: 15 }, "turned");

/** One wire and loose strokes of the same pictures side by side: what it costs to be connected, and what it gains. */
@customElement("wire-comparison")
export class WireComparison extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  private readonly pictures = [new SmallPictures(this, () => this.shown(0)), new SmallPictures(this, () => this.shown(1))] as const;
  /** What they are painted of. */
  private painted: Made | null = null;

  static override styles = [controls, smallStyle, wireComparisonStyle];

  override render() {
    const { doc, comparing, running } = this.state;
    const { made, loose } = deskOf(doc);
    const both = made && loose ? ([made, loose] as const) : null;
    return html`
      <h2>Wire or loose strokes</h2>
      <p class="small quiet">${both ? compared(...both, this.views) : "What does it cost to be in one piece? The same once more, in strokes that need not touch."}</p>
      <button ?disabled=${!this.studio.can(compare)} @click=${() => this.studio.act(compare)}>
        ${comparing && running === doc.task ? "Laying loose strokes…" : loose ? "Compare once more" : compare.label}
      </button>
      ${both ? this.table(both) : nothing}
    `;
  }

  /** How many views have a picture to be like. */
  private get views(): number {
    return this.studio.task().compared.length;
  }

  private table(both: readonly [Made, Made]) {
    const row = (name: string, tell: (made: Made) => string) => html`<tr>
      <th scope="row">${name}</th>
      ${both.map((made) => html`<td>${tell(made)}</td>`)}
    </tr>`;
    const pictures = (name: string, words: string) => html`<tr class="picture">
      <th scope="row">${name}</th>
      ${["The wire", "The loose strokes"].map(
        (what) => html`<td><canvas width=${SMALL_PX} height=${SMALL_PX} role="img" aria-label="${what} ${words}"></canvas></td>`,
      )}
    </tr>`;
    return html`<table>
      <thead>
        <tr>
          <th scope="col"><span class="unseen">What</span></th>
          <th scope="col">One wire</th>
          <th scope="col">Loose strokes</th>
        </tr>
      </thead>
      <tbody>
        ${pictures("Front", "from the front")} ${pictures("Turned", "turned to the right and seen from above")}
        ${row("Match", (made) => shareOf(meanMatch(made, this.views)))} ${row("Pieces", ({ finished }) => count(finished.measures.components))}
        ${row("To join", (made) => (gapOf(made) > 0 ? `${percentOf(gapOf(made))} more wire` : "nothing"))}
        ${row("Points", ({ finished }) => count(finished.measures.control_points))}
      </tbody>
    </table>`;
  }

  recolour(): void {
    for (const pictures of this.pictures) pictures.recolour();
  }

  protected override updated(_changed: PropertyValues<this>): void {
    const { made, loose } = deskOf(this.state.doc);
    if (!made || !loose || loose === this.painted) return;
    this.painted = loose;
    this.pictures[0].setWire(made.finished.wire);
    this.pictures[1].setWire(loose.finished.wire);
  }

  /** The pictures of a column: row by row, the two stand side by side. */
  private shown(column: 0 | 1): readonly SmallPicture[] {
    const desk = deskOf(this.state.doc);
    const made = column === 0 ? desk.made : desk.loose;
    const canvases = [...this.renderRoot.querySelectorAll("canvas")].filter((_, i) => i % 2 === column);
    const [front] = made?.finished.views ?? [];
    if (!made || !front || canvases.length < 2) return [];
    return [
      { canvas: canvases[0]!, view: front, under: made.finished.targets.find(({ view }) => view.name === front.name) },
      { canvas: canvases[1]!, view: TURNED },
    ];
  }
}

const shareOf = (share: number | null): string => (share === null ? "–" : percent(share));
const percentOf = (share: number): string => (share < 0.01 ? "under 1%" : percent(share));
