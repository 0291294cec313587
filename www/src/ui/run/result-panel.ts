import { css, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { WireShape } from "../../embed/shape";
import type { Faults } from "../../engine/protocol";
import type { Made } from "../../state/keeping/document";
import { percent } from "../../state/common/words";
import { deskOf, SLOTS, type Job, type StudioState } from "../../state/studio";
import { count } from "../../state/common/count";
import "../../view/loss-curve";
import "../../view/match-panels";
import type { Match, MatchPanels } from "../../view/match-panels";
import { Part } from "../../view/part";
import { controls } from "../shared/shared";
import { covered, worldLength } from "../../tasks/fill/verdict";
import type { CoveredViews } from "../../tasks/fill/parts/covered-views";
import { FAULTS, faultWords } from "./faults";
import type { TurnedViews } from "../../tasks/stroke/parts/turned-views";
import { match, verdict } from "../../tasks/multiview/verdict";

/** One array, so that it changes nothing. */
const FRONT = ["front"];
const DASH = "–";
const EXAMPLES: Readonly<Record<Job, string>> = {
  multiview: "Three pictures in one wire. Make it again to watch how it gets there.",
  stroke: "One wire draws the picture, and goes on round the back. Make it again to watch how it gets there.",
  fill: "One closed wire covers the whole shape. Make it again to watch how it gets there.",
};

type Figure = readonly [name: string, value: string];

/** The numbers that matter, the curve, and what they come to in a sentence. Fires `mark` with the places to mark. */
@customElement("result-panel")
export class ResultPanel extends Part {
  @property({ attribute: false }) state!: StudioState;
  @query("match-panels") private panels!: MatchPanels | null;
  @query("turned-views") private turned!: TurnedViews | null;
  @query("covered-views") private covered!: CoveredViews | null;
  /** Those that know the wire. */
  private readonly told = new WeakSet<Element>();
  private wire: WireShape | null = null;
  /** The faults that are marked on the stage, where a wire has any. */
  @state() private marked: keyof Faults | null = null;
  private places: Faults[keyof Faults] | null = null;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
      /* Four lines are kept free: nothing below moves when there is something to say. */
      p {
        min-height: 73px;
        margin: 0;
        overflow-wrap: anywhere;
      }
      .beside {
        display: grid;
        grid-template-columns: minmax(0, 1fr) minmax(0, 2fr);
        gap: 8px;
        margin-block-end: 8px;
      }
      .beside match-panels {
        grid-template-columns: minmax(0, 1fr);
      }
      dl {
        display: grid;
        grid-template-columns: 1.6fr 1fr;
        gap: 0 16px;
        margin: 0 0 8px;
        font-size: 13px;
      }
      dl div {
        display: flex;
        justify-content: space-between;
        gap: 8px;
        padding-block: 4px;
        border-block-end: 1px solid var(--line);
      }
      dl .wide {
        grid-column: 1 / -1;
      }
      dt {
        color: var(--quiet);
      }
      dd {
        margin: 0;
        font-weight: 600;
        white-space: nowrap;
      }
      .fault {
        text-align: end;
        text-wrap: balance;
        white-space: normal;
      }
      /* Two lines in most columns, and nothing below moves when they come. */
      .tight {
        min-height: 2lh;
      }
      .fault button {
        min-height: 24px;
        padding: 0;
        border: 0;
        background: none;
        font-weight: inherit;
        text-align: inherit;
        text-decoration: underline;
        text-decoration-color: #d81b60;
      }
      .fault button[aria-pressed="true"] {
        text-decoration-thickness: 3px;
      }
    `,
  ];

  override render() {
    const { track, looking, doc } = this.state;
    const { job } = doc;
    const made = this.measured();
    return html`
      <h2>${job === "fill" ? "Cover" : "Match"}</h2>
      <div class=${job === "stroke" ? "beside" : ""}>
        ${job === "fill" ? nothing : this.compared(made)}
        <p class="verdict small">${this.sentence(made)}</p>
      </div>
      ${job === "stroke" ? html`<turned-views></turned-views>` : nothing}
      ${job === "fill" ? html`<covered-views .made=${deskOf(doc).made} ?past=${!made}></covered-views>` : nothing}
      <dl>
        ${job === "fill" ? this.onSurface(made).map(([name, value]) => html`<div class="wide"><dt>${name}</dt><dd>${value}</dd></div>`) : nothing}
        ${this.faults(made)}
        ${this.numbers(made).map(([name, value]) => html`<div><dt>${name}</dt><dd>${value}</dd></div>`)}
      </dl>
      <loss-curve
        .losses=${track?.losses ?? []}
        .events=${track?.events ?? []}
        .iterations=${track?.iterations ?? 0}
        .at=${looking === null ? null : (track?.snapshots[looking]?.iteration ?? null)}
      ></loss-curve>
    `;
  }

  /** Comes with every frame of a run: not by the state. */
  setWire(wire: WireShape | null): void {
    this.wire = wire;
    this.panels?.setWire(wire);
    this.turned?.setWire?.(wire);
  }

  recolour(): void {
    this.panels?.recolour();
    this.turned?.recolour?.();
    this.covered?.recolour?.();
  }

  /** Pictures come and go with the job, and the script of some when they are first wanted: they may be gone before it is there. */
  protected override updated(): void {
    const places = (this.marked && this.measured()?.finished.faults?.[this.marked]) || null;
    if (places !== this.places) {
      this.places = places;
      this.dispatchEvent(new CustomEvent("mark", { detail: places, bubbles: true, composed: true }));
    }
    for (const pictures of [this.panels, this.turned]) {
      if (!pictures || this.told.has(pictures)) continue;
      this.told.add(pictures);
      void customElements.whenDefined(pictures.localName).then(() => pictures.setWire?.(this.wire));
    }
  }

  private compared(made: Made | null) {
    const { views, targets, doc } = this.state;
    const one = doc.job === "stroke";
    return html`<match-panels
      .expected=${one ? FRONT : SLOTS}
      .views=${one ? views.slice(0, 1) : views}
      .targets=${targets}
      .found=${made?.finished.measures.views.map(matchOf) ?? []}
    ></match-panels>`;
  }

  /** The wire on the stage, where it is the finished one: only that has been measured. */
  private measured(): Made | null {
    const { doc, running, looking, planned } = this.state;
    return running !== doc.job && looking === null && !planned ? deskOf(doc).made : null;
  }

  private sentence(made: Made | null): string {
    const { notes, looking, running, doc, planned } = this.state;
    if (looking !== null) return "Looking back: numbers are for the finished wire.";
    if (running === doc.job) return notes.join(" ");
    if (planned) return deskOf(doc).made ? "The lines would run another way now: cover it to make that wire. The one made before is kept until then." : "The thin line on the stage is the way of the wire. Cover it, and it thickens and bends into the style.";
    if (!made) return "";
    if (made.source === "example") return EXAMPLES[doc.job];
    return doc.job === "fill" ? covered(made) : verdict(made);
  }

  /** Where the wire fails; pressed, the words mark the places. */
  private faults(made: Made | null) {
    return (["tight", "penetrating"] as const).map((fault) => {
      const places = made?.finished.faults?.[fault].length;
      const words = places === undefined ? DASH : faultWords(fault, places);
      const press = (): void => void (this.marked = this.marked === fault ? null : fault);
      return html`<div class="wide">
        <dt>${FAULTS[fault]}</dt>
        <dd class="fault ${fault}">${places ? html`<button title="Mark on the stage" aria-pressed=${String(this.marked === fault)} @click=${press}>${words}</button>` : words}</dd>
      </div>`;
    });
  }

  private numbers(made: Made | null): readonly Figure[] {
    const measures = made?.finished.measures;
    const points = measures?.control_points ?? (this.wire ? this.wire.controlPoints.length / 4 : 0);
    return [
      ["Pieces", measures ? count(measures.components) : DASH],
      ["Length", measures ? measures.length.toFixed(1) : DASH],
      ["Control points", points ? count(points) : DASH],
      ["Over its lines", known(measures?.length_over_lines, (ratio) => `${ratio.toFixed(2)} ×`)],
      ["Turning", known(measures?.turning_per_unit, (turning) => turning.toFixed(1))],
      ["Kinks", known(measures?.kinks, count)],
      ["Bent tightly", known(measures?.tight_share, percent)],
      ["Touching", known(measures?.touching_share, percent)],
      ["Within itself", known(measures?.penetrating_share, percent)],
      ["Time", made?.seconds ? `${made.seconds.toFixed(1)} s` : DASH],
    ];
  }

  /** Shares of the shape's size. */
  private onSurface(made: Made | null): readonly Figure[] {
    const surface = made?.finished.measures.surface;
    return [
      ["99 of 100 spots are nearer than", surface ? worldLength(surface.p99 * surface.spacing) : DASH],
      ["Off the surface, on average", surface ? worldLength(surface.drift_mean) : DASH],
    ];
  }
}

function known(value: number | null | undefined, words: (value: number) => string): string {
  return value == null ? DASH : words(value);
}

function matchOf(view: Made["finished"]["measures"]["views"][number]): Match {
  return { name: view.name, share: match(view), asDrawn: view.bent ? view.soft_iou : null };
}
