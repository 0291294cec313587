import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { headingOf } from "../../view/heading";
import { deskOf, type Made, type StudioState } from "../../state/studio";
import { pageColours } from "../../view/colours";
import { count } from "../../view/count";
import "../../view/loss-curve";
import { paintInk } from "../../view/paint";
import { Part } from "../../view/part";
import { smallStyle } from "../../view/small-style";
import { controls } from "../shared/shared";
import "./strand-histogram";
import { covered, DASH, worldLength } from "./covered";

const SIDES = ["front", "right", "back", "left", "top"];

/** How well a wire covers its shape: in a sentence, in pictures, and in the numbers that matter. Fires `look-from`. */
@customElement("surface-result")
export class SurfaceResult extends Part {
  @property({ attribute: false }) state!: StudioState;
  /** What the pictures are painted of. */
  private painted: Made | null = null;

  static override styles = [
    controls,
    smallStyle,
    css`
      :host {
        display: block;
        container-type: inline-size;
      }
      .all {
        display: grid;
        grid-template-columns: minmax(0, 1fr);
        gap: 8px;
      }
      /* Kept free: nothing below moves when there is something to say. */
      .verdict {
        min-height: 73px;
        margin: 0;
        overflow-wrap: anywhere;
      }
      ul {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: 8px;
        margin: 0;
        padding: 0;
        list-style: none;
      }
      button {
        display: block;
        width: 100%;
        min-height: 0;
        padding: 0 0 4px;
        overflow: hidden;
        font-size: 13px;
        line-height: 18px;
        color: var(--quiet);
      }
      button:hover {
        color: var(--ink);
      }
      canvas {
        border: 0;
        border-radius: 0;
        background: none;
      }
      /* A wide sheet. */
      @container (min-width: 480px) {
        ul {
          grid-template-columns: repeat(5, minmax(0, 1fr));
        }
      }
      .words {
        display: block;
      }
      .words::first-letter {
        text-transform: capitalize;
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
    const { track, looking } = this.state;
    const made = this.measured();
    const surface = made?.finished.measures.surface ?? null;
    return html`<div class="all">
      <h2>Cover</h2>
      <p class="verdict small">${this.sentence(made)}</p>
      ${made?.finished.shown?.length ? this.pictures(made) : nothing}
      ${surface ? html`<strand-histogram .strands=${surface.strands}></strand-histogram>` : nothing}
      <dl>
        ${this.numbers(made).map(([name, value]) => html`<div><dt>${name}</dt><dd>${value}</dd></div>`)}
      </dl>
      <loss-curve
        .losses=${track?.losses ?? []}
        .events=${track?.events ?? []}
        .iterations=${track?.iterations ?? 0}
        .at=${looking === null ? null : (track?.snapshots[looking]?.iteration ?? null)}
      ></loss-curve>
    </div>`;
  }

  /** As the result of pictures has it; here all pictures are of the finished wire. */
  setWire(): void {}

  recolour(): void {
    this.painted = null;
    this.requestUpdate();
  }

  protected override updated(): void {
    const made = this.measured();
    if (made === this.painted) return;
    this.painted = made;
    const shown = made?.finished.shown ?? [];
    this.renderRoot.querySelectorAll("canvas").forEach((canvas, i) => shown[i] && paintInk(canvas, shown[i], pageColours().ink));
  }

  private pictures({ finished }: Made) {
    return html`<ul>
      ${finished.shown.map((_, i) => {
        const view = finished.views[i];
        const name = view?.name ?? SIDES[i] ?? "";
        return html`<li>
          <button title="Look from there" @click=${() => view && this.look(view)}>
            <canvas aria-hidden="true"></canvas>
            <span class="words"><span class="unseen">Look at it: </span>${name}</span>
          </button>
        </li>`;
      })}
    </ul>`;
  }

  private look(view: Made["finished"]["views"][number]): void {
    this.dispatchEvent(new CustomEvent("look-from", { detail: headingOf(view), bubbles: true, composed: true }));
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
    if (planned && doc.desks.fill.made) return "The lines would run another way now: cover it to make that wire. The one made before is kept until then.";
    if (!made) return doc.cover ? "The thin line on the stage is the way of the wire. Cover it, and it thickens and bends into the style." : "";
    return covered(made);
  }

  private numbers(made: Made | null): readonly (readonly [name: string, value: string])[] {
    const measures = made?.finished.measures;
    const surface = measures?.surface;
    return [
      ["Within", surface ? worldLength(surface.p99 * surface.spacing) : DASH],
      ["Pieces", measures ? count(measures.components) : DASH],
      ["Off the surface", surface ? worldLength(surface.drift_mean) : DASH],
      ["Length", measures ? measures.length.toFixed(1) : DASH],
      ["Control points", measures ? count(measures.control_points) : DASH],
      ["Time", made?.seconds ? `${made.seconds.toFixed(1)} s` : DASH],
    ];
  }
}
