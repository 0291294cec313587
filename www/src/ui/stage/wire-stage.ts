import { html, nothing, svg, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { keyed } from "lit/directives/keyed.js";
import { startWorker } from "#sculpture/aside";
import type { BodyShape } from "#sculpture/body";
import { LOOK_NAMES, lookOf, type LookName } from "#sculpture/looks";
import type { Vec3 } from "#sculpture/matrix";
import type { WireShape } from "#sculpture/shape";
import { Stage, StageUnavailable, type Vantage, type ViewName } from "#sculpture/stage";
import { nextTurn } from "../../state/common/next-turn";
import type { Heading } from "../../view/heading";
import { Part } from "../../view/part";
import type { StageWords } from "../shared/page-task";
import { controls } from "../shared/shared";
import { isDark } from "../shared/theme";
import { wireStageStyle } from "./wire-stage-style";

const LOOK_WORDS: Readonly<Record<LookName, string>> = {
  copper: "Copper",
  steel: "Black steel",
  parameter: "Along the wire",
  width: "By width",
};
function from(azimuth: number, elevation: number): Vantage {
  return { azimuthRad: (azimuth * Math.PI) / 180, elevationRad: (elevation * Math.PI) / 180 };
}

const TURN_RAD = Math.PI / 8;
const ZOOM = 1.25;

const icon = (path: string): TemplateResult => html`<svg class="icon" viewBox="0 0 20 20" aria-hidden="true">${svg`<path d=${path} />`}</svg>`;
const ICONS = {
  left: icon("M3.5 4v4h4M4 8a7 7 0 1 1-.6 4.5"),
  right: icon("M16.5 4v4h-4M16 8a7 7 0 1 0 .6 4.5"),
  closer: icon("M10 4v12M4 10h12"),
  further: icon("M4 10h12"),
  room: icon("M10 10.5V3m0 7.5L3 14.5m7-4 7 4M3 14.5V6l7-3 7 3v8.5L10 18z"),
  far: icon("M10 3a7 7 0 1 0 0 14 7 7 0 0 0 0-14M3.2 9c2 2.6 11.6 2.6 13.6 0M5 14.5c2-1.3 3-1.5 5-1.5M10 13c2 0 3 .2 5 1.5"),
  more: icon("M3 6h6m4 0h4M3 14h2m4 0h8M9 6a2 2 0 1 0 4 0 2 2 0 0 0-4 0M5 14a2 2 0 1 0 4 0 2 2 0 0 0-4 0"),
};

interface ButtonState {
  readonly pressed?: boolean;
  readonly expanded?: boolean;
}

/**
 * The stage with its controls. Tells `hold` when a person takes hold of the camera, and `look-change` with
 * `{ look, room }` when they change how the wire looks, and `see-through` when they want to see the far side, or no more.
 */
@customElement("wire-stage")
export class WireStage extends Part {
  /** What there is to see of the wire. */
  @property({ attribute: false }) words!: StageWords;
  @property() look: LookName = "copper";
  /** Off: the wire alone. */
  @property({ type: Boolean }) room = true;
  /** What the wire covers. */
  @property({ attribute: false }) body: BodyShape | null = null;
  /** Whether the wire is seen through it. */
  @property({ type: Boolean }) through = false;
  @query("canvas") private canvas!: HTMLCanvasElement;
  @state() private problem = false;
  @state() private lost = false;
  @state() private view: ViewName | null = "room";
  /** On narrow stages: whether the second row of controls is there. */
  @state() private open = false;
  /** A canvas lives as long as its context; another life, another canvas. */
  @state() private life = 0;
  private stage: Stage | null = null;
  private wire: WireShape | null = null;
  private places: readonly Vec3[] | null = null;
  private swaying = true;
  /** Whether a worker draws; where it turns out not to be able to, the page does. */
  private aside = typeof Worker === "function" && "transferControlToOffscreen" in HTMLCanvasElement.prototype;

  static override styles = [controls, wireStageStyle];

  override render() {
    if (this.problem) {
      return html`<div class="problem" role="status">
        ${ICONS.room}
        <h2>This browser cannot draw in 3D here</h2>
        <p>
          WebGL 2 is missing or switched off. Everything else works: wires are made, measured, saved and shared as ever, and
          the small pictures show yours from several sides.
        </p>
      </div>`;
    }
    return html`
      ${keyed(
        this.life,
        html`<canvas tabindex="0" role="application" aria-label="The wire in 3D" aria-describedby="view keys"></canvas>`,
      )}
      <div class="ring"></div>
      ${this.lost ? html`<p class="lost" role="status">The graphics card is busy elsewhere. The picture comes back by itself.</p>` : nothing}
      <p id="view" class="unseen">${(this.named && this.words.views[this.named]) ?? "Turned by hand."}</p>
      <p id="keys" class="unseen">
        Arrow keys turn it, with shift they move it, plus and minus zoom, 1, 2 and 3 show the front, the ${this.views.includes("side") ? "side" : "right"} and
        the top, F the whole room.
      </p>
      <div class="bar">
        <div class="group views ${this.views.length > 4 ? "many" : ""}" role="group" aria-label="Look from">
          ${this.views.map(
            (view) => html`<button aria-pressed=${String(view === this.named)} @click=${() => this.take(() => this.flyTo(view))}>${view}</button>`,
          )}
        </div>
        <div class="group toggle">
          ${this.square("more", "Turn, zoom and look", () => (this.open = !this.open), { expanded: this.open })}
        </div>
        <div id="more" class=${this.open ? "more open" : "more"}>
          <div class="group" role="group" aria-label="Turn and zoom">
            ${this.square("left", "Turn left", () => this.stage?.step(-TURN_RAD, 1))}
            ${this.square("right", "Turn right", () => this.stage?.step(TURN_RAD, 1))}
            ${this.square("further", "Zoom out", () => this.stage?.step(0, ZOOM))}
            ${this.square("closer", "Zoom in", () => this.stage?.step(0, 1 / ZOOM))}
          </div>
          <div class="group" role="group" aria-label="Look">
            <select aria-label="Look of the wire" title="Look of the wire" @change=${this.chooseLook}>
              ${LOOK_NAMES.map((look) => html`<option value=${look} .selected=${look === this.look}>${LOOK_WORDS[look]}</option>`)}
            </select>
            ${this.square("room", "Room with the shadows", this.toggleRoom, { pressed: this.room })}
            ${this.words.farSide ? this.square("far", "Lines on the far side", () => this.tell("see-through"), { pressed: this.through }) : nothing}
          </div>
        </div>
      </div>
    `;
  }

  /** Those with a button. */
  private get views(): readonly ViewName[] {
    return Object.keys(this.words.views) as ViewName[];
  }

  /** The view by the name of its button: the right may be a side. */
  private get named(): ViewName | null {
    return this.view === "side" && !this.views.includes("side") ? "right" : this.view;
  }

  private square(name: keyof typeof ICONS, label: string, action: () => void, { pressed, expanded }: ButtonState = {}): TemplateResult {
    return html`<button
      class="square"
      aria-label=${label}
      title=${label}
      aria-pressed=${pressed === undefined ? nothing : String(pressed)}
      aria-expanded=${expanded === undefined ? nothing : String(expanded)}
      aria-controls=${expanded === undefined ? nothing : "more"}
      @click=${action}
    >
      ${ICONS[name]}
    </button>`;
  }

  setWire(wire: WireShape | null): void {
    this.wire = wire;
    this.stage?.setWire(wire);
  }

  /** Rings round these places; null for none. */
  mark(places: readonly Vec3[] | null): void {
    this.places = places;
    this.stage?.mark(places);
  }

  flyTo(view: ViewName): void {
    this.stage?.flyTo(view);
  }

  /** To where no button leads. */
  lookFrom({ azimuth, elevation }: Heading): void {
    this.take(() => this.stage?.flyTo(from(azimuth, elevation)));
  }

  /** Whether the camera sways while nobody holds it. */
  sway(on: boolean): void {
    this.swaying = on;
    this.stage?.sway(on);
  }

  /** Shows a wire that is done from all there is to see of it, and goes back to the room; ends when somebody takes hold. */
  tour(): void {
    this.stage?.tour(this.words.tour.map((stop) => (typeof stop === "string" ? stop : from(stop.azimuth, stop.elevation))));
  }

  /** A PNG of what the stage shows. */
  async picture(widthPx: number, heightPx: number): Promise<Blob> {
    if (!this.stage) throw new Error("This browser cannot draw in 3D here, so there is no picture to save.");
    return this.stage.picture(widthPx, heightPx);
  }

  override connectedCallback(): void {
    super.connectedCallback();
    addEventListener("theme-change", this.relook);
    if (this.hasUpdated) this.life++;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("theme-change", this.relook);
    this.stage?.dispose();
    this.stage = null;
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (!this.stage && !this.problem && this.isConnected) void nextTurn().then(() => this.start());
    else if (changed.has("look") || changed.has("room")) this.relook();
    if (changed.has("body")) this.stage?.setBody(this.body);
    if (changed.has("through")) this.stage?.seeThrough(this.through);
  }

  private start(): void {
    if (this.stage || this.problem || !this.isConnected) return;
    try {
      const worker = this.aside ? startWorker() : null;
      const events = {
        hold: () => this.tell("hold"),
        view: (view: ViewName | null) => (this.view = view),
        lost: (lost: boolean) => (this.lost = lost),
        unavailable: () => this.stayHere(),
      };
      this.stage = new Stage(this.canvas, lookOf(this.look, isDark(), this.room), events, worker);
      if (this.body) this.stage.setBody(this.body);
      this.stage.seeThrough(this.through);
      this.stage.setWire(this.wire);
      this.stage.mark(this.places);
      this.stage.sway(this.swaying);
    } catch (error) {
      if (!(error instanceof StageUnavailable)) console.error(error);
      this.problem = true;
    }
  }

  private stayHere(): void {
    this.stage?.dispose();
    this.stage = null;
    this.aside = false;
    this.life++;
  }

  private readonly relook = (): void => this.stage?.setLook(lookOf(this.look, isDark(), this.room));

  /** Something a person does with the camera by a button. */
  private take(action: () => void): void {
    this.tell("hold");
    action();
  }

  private chooseLook(event: Event): void {
    this.look = (event.target as HTMLSelectElement).value as LookName;
    this.tell("look-change", { look: this.look, room: this.room });
  }

  private readonly toggleRoom = (): void => {
    this.room = !this.room;
    this.tell("look-change", { look: this.look, room: this.room });
  };

  private tell(name: string, detail?: unknown): void {
    this.dispatchEvent(new CustomEvent(name, { detail, bubbles: true, composed: true }));
  }
}
