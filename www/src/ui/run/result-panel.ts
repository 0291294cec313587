import { msg } from "@lit/localize";
import { html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { WireShape } from "#sculpture/scene/shape";
import type { Faults } from "../../engine/protocol";
import { deskOf, type Made, type StudioState } from "../../state/studio";
import { match } from "../../view/likeness";
import "../../view/loss-curve";
import "../../view/match-panels";
import type { Match } from "../../view/match-panels";
import { Part } from "../../view/part";
import type { PageTask, TaskParts } from "../shared/page-task";
import { controls } from "../shared/shared";
import { FAULTS, faultWords } from "./faults";
import { DASH, figuresOf } from "./figures";
import { resultStyle } from "./result-style";

/** Pictures of a wire, once their script is there. */
interface Pictures extends HTMLElement {
  setWire?(wire: WireShape | null): void;
  recolour?(): void;
}

/** The numbers that matter, the curve, and what they come to in a sentence. Fires `mark` with the places to mark. */
@customElement("result-panel")
export class ResultPanel extends Part {
  @property({ attribute: false }) task!: PageTask;
  /** Null until they are there. */
  @property({ attribute: false }) parts: TaskParts | null = null;
  @property({ attribute: false }) state!: StudioState;
  /** Those that know the wire. */
  private readonly told = new WeakSet<Element>();
  private wire: WireShape | null = null;
  /** The faults that are marked on the stage, where a wire has any. */
  @state() private marked: keyof Faults | null = null;
  private places: Faults[keyof Faults] | null = null;

  static override styles = [controls, resultStyle];

  override render() {
    const { task, parts, state } = this;
    const { track, looking } = state;
    const made = this.measured();
    const { compared } = task;
    const forming = this.wire ? this.wire.controlPoints.length / 4 : 0;
    return html`
      <h2>${task.page.result}</h2>
      <div class=${compared.length === 1 ? "beside" : ""}>
        ${compared.length ? this.compared(made) : nothing}
        <p class="verdict small">${this.sentence(made)}</p>
      </div>
      ${parts?.result?.(state, made) ?? nothing}
      <dl>
        ${(parts?.figures?.(made) ?? []).map(([name, value]) => html`<div class="wide"><dt>${name}</dt><dd>${value}</dd></div>`)}
        ${this.faults(made)}
        ${figuresOf(made, forming).map(([name, value]) => html`<div><dt>${name}</dt><dd>${value}</dd></div>`)}
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
    for (const pictures of this.pictures) pictures.setWire?.(wire);
  }

  recolour(): void {
    for (const pictures of this.pictures) pictures.recolour?.();
  }

  /** Pictures come and go with the task, and the script of some when they are first wanted: they may be gone before it is there. */
  protected override updated(): void {
    const places = (this.marked && this.measured()?.finished.faults?.[this.marked]) || null;
    if (places !== this.places) {
      this.places = places;
      this.dispatchEvent(new CustomEvent("mark", { detail: places, bubbles: true, composed: true }));
    }
    for (const pictures of this.pictures) {
      if (this.told.has(pictures)) continue;
      this.told.add(pictures);
      void customElements.whenDefined(pictures.localName).then(() => pictures.setWire?.(this.wire));
    }
  }

  private get pictures(): readonly Pictures[] {
    return [...this.renderRoot.querySelectorAll<Pictures>(".pictures")];
  }

  private compared(made: Made | null) {
    const { views, targets } = this.state;
    const { compared } = this.task;
    return html`<match-panels
      class="pictures"
      .expected=${compared}
      .views=${views.slice(0, compared.length)}
      .targets=${targets}
      .found=${made?.finished.measures.views.map(matchOf) ?? []}
    ></match-panels>`;
  }

  /** The wire on the stage, where it is the finished one: only that has been measured. */
  private measured(): Made | null {
    const { doc, running, looking, planned } = this.state;
    return running !== doc.task && looking === null && !planned ? deskOf(doc).made : null;
  }

  private sentence(made: Made | null): string {
    const { notes, looking, running, doc, planned } = this.state;
    const { page, verdict } = this.task;
    if (looking !== null) return msg("Looking back: numbers are for the finished wire.");
    if (running === doc.task) return notes.join(" ");
    if (planned) return (deskOf(doc).made ? page.planned?.made : page.planned?.none) ?? "";
    if (!made) return "";
    return made.source === "example" ? page.example : verdict(made);
  }

  /** Where the wire fails; pressed, the words mark the places. */
  private faults(made: Made | null) {
    return (["tight", "penetrating"] as const).map((fault) => {
      const places = made?.finished.faults?.[fault].length;
      const words = places === undefined ? DASH : faultWords(fault, places);
      const press = (): void => void (this.marked = this.marked === fault ? null : fault);
      return html`<div class="wide">
        <dt>${FAULTS[fault]}</dt>
        <dd class="fault ${fault}">${places ? html`<button title=${msg("Mark on the stage")} aria-pressed=${String(this.marked === fault)} @click=${press}>${words}</button>` : words}</dd>
      </div>`;
    });
  }
}

function matchOf(view: Made["finished"]["measures"]["views"][number]): Match {
  return { name: view.name, share: match(view), asDrawn: view.bent ? view.soft_iou : null };
}
