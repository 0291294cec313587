import { css, html, nothing } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import type { WireShape } from "../../embed/shape";
import type { Made } from "../../state/keeping/document";
import { deskOf, SLOTS, type Job, type StudioState } from "../../state/studio";
import { count } from "../../view/count";
import "../../view/loss-curve";
import "../../view/match-panels";
import type { Match, MatchPanels } from "../../view/match-panels";
import { Part } from "../../view/part";
import { controls } from "../shared/shared";
import type { TurnedViews } from "./turned-views";
import { match, verdict } from "./verdict";

/** One array, so that it changes nothing. */
const FRONT = ["front"];
const DASH = "–";
const EXAMPLES: Readonly<Partial<Record<Job, string>>> = {
  multiview: "Three pictures in one wire. Make it again to watch how it gets there.",
  stroke: "One wire draws the picture, and goes on round the back. Make it again to watch how it gets there.",
};

/** The numbers that matter, the curve, and what they come to in a sentence. */
@customElement("result-panel")
export class ResultPanel extends Part {
  @property({ attribute: false }) state!: StudioState;
  @query("match-panels") private panels!: MatchPanels | null;
  @query("turned-views") private turned!: TurnedViews | null;
  private told: TurnedViews | null = null;
  private wire: WireShape | null = null;

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
      dt {
        color: var(--quiet);
      }
      dd {
        margin: 0;
        font-weight: 600;
        white-space: nowrap;
      }
    `,
  ];

  override render() {
    const { views, targets, track, looking, doc } = this.state;
    const one = doc.job === "stroke";
    const made = this.measured();
    const found = made?.finished.measures.views.map(matchOf) ?? [];
    return html`
      <h2>Match</h2>
      <div class=${one ? "beside" : ""}>
        <match-panels
          .expected=${one ? FRONT : SLOTS}
          .views=${one ? views.slice(0, 1) : views}
          .targets=${targets}
          .found=${found}
        ></match-panels>
        <p class="verdict small">${this.sentence(made)}</p>
      </div>
      ${one ? html`<turned-views></turned-views>` : nothing}
      <dl>
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
  }

  protected override firstUpdated(): void {
    this.panels?.setWire(this.wire);
  }

  /** Pictures from the sides come and go with the job, and their script comes when they are first wanted. */
  protected override updated(): void {
    const { turned } = this;
    if (turned === this.told) return;
    this.told = turned;
    if (turned) void customElements.whenDefined("turned-views").then(() => turned.setWire(this.wire));
  }

  /** The wire on the stage, where it is the finished one: only that has been measured. */
  private measured(): Made | null {
    const { doc, running, looking } = this.state;
    return running !== doc.job && looking === null ? deskOf(doc).made : null;
  }

  private sentence(made: Made | null): string {
    const { notes, looking, running, doc } = this.state;
    if (looking !== null) return "Looking back: numbers are for the finished wire.";
    if (running === doc.job) return notes.join(" ");
    if (!made) return "";
    return made.source === "example" ? (EXAMPLES[doc.job] ?? "") : verdict(made);
  }

  private numbers(made: Made | null): readonly (readonly [name: string, value: string])[] {
    const measures = made?.finished.measures;
    const points = measures?.control_points ?? (this.wire ? this.wire.controlPoints.length / 4 : 0);
    return [
      ["Pieces", measures ? count(measures.components) : DASH],
      ["Length", measures ? measures.length.toFixed(1) : DASH],
      ["Control points", points ? count(points) : DASH],
      ["Time", made?.seconds ? `${made.seconds.toFixed(1)} s` : DASH],
    ];
  }
}

function matchOf(view: Made["finished"]["measures"]["views"][number]): Match {
  return { name: view.name, share: match(view), asDrawn: view.bent ? view.soft_iou : null };
}
