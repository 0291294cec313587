import { css, html, LitElement } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { WireShape } from "../embed/shape";
import { Stage, type Look, type ViewName } from "../embed/stage";
import { controls } from "./shared";

const LIGHT: Look = { wall: "#f6f3ee", shadow: "#4a4038", metal: "#c77f43", sky: "#f4f1ec", ground: "#8d7460", byParameter: false, room: true };
const DARK: Look = { wall: "#302d29", shadow: "#0d0c0b", metal: "#d08a50", sky: "#a8a29a", ground: "#3a2d22", byParameter: false, room: true };
const VIEWS: readonly (ViewName | "room")[] = ["room", "front", "side", "top"];

/** The stage with its buttons. */
@customElement("wire-stage")
export class WireStage extends LitElement {
  @query("canvas") private canvas!: HTMLCanvasElement;
  @state() private problem = "";
  private stage: Stage | null = null;
  private wire: WireShape | null = null;
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");

  static override styles = [
    controls,
    css`
      :host {
        display: flex;
        flex-direction: column;
        overflow: hidden;
        background: var(--stage);
      }
      canvas {
        display: block;
        flex: 1;
        min-height: 0;
        width: 100%;
        mask-image: linear-gradient(to right, transparent, #000 8%, #000 92%, transparent);
        touch-action: none;
        cursor: grab;
      }
      canvas:active {
        cursor: grabbing;
      }
      canvas:focus-visible {
        outline-offset: -3px;
      }
      .views {
        display: flex;
        align-self: center;
        flex: none;
        margin: 8px 0 16px;
        padding: 3px;
        border: 1px solid var(--line);
        border-radius: 9px;
        background: var(--raised);
        box-shadow: var(--shadow);
      }
      .views button {
        min-height: 32px;
        padding: 0 12px;
        border: 0;
        background: none;
        font-size: 13px;
        text-transform: capitalize;
      }
      .views button:hover {
        background: var(--paper);
      }
      .problem {
        margin: auto;
        padding: 24px;
        text-align: center;
        color: var(--quiet);
      }
      @media (pointer: coarse) {
        .views {
          margin: 4px 0 8px;
        }
        .views button {
          min-height: 44px;
        }
      }
    `,
  ];

  override render() {
    if (this.problem) return html`<p class="problem">${this.problem}</p>`;
    return html`
      <canvas
        tabindex="0"
        role="application"
        aria-label="The wire in its room. Arrow keys turn it, plus and minus zoom, 1, 2 and 3 show the views, F the whole room."
      ></canvas>
      <div class="views" role="group" aria-label="Look from">
        ${VIEWS.map((view) => html`<button @click=${() => this.stage?.flyTo(view)}>${view}</button>`)}
      </div>
    `;
  }

  setWire(wire: WireShape | null): void {
    this.wire = wire;
    this.stage?.setWire(wire);
  }

  /** Whether the camera sways while nobody holds it. */
  sway(on: boolean): void {
    this.stage?.sway(on);
  }

  flyTo(view: ViewName | "room"): void {
    this.stage?.flyTo(view);
  }

  protected override firstUpdated(): void {
    try {
      this.stage = new Stage(this.canvas, this.dark.matches ? DARK : LIGHT);
      this.stage.setWire(this.wire);
      this.stage.sway(true);
      this.dark.addEventListener("change", this.relook);
    } catch (error) {
      console.error(error);
      this.problem = "This browser cannot draw in 3D here (WebGL 2 is missing or switched off). Everything else works.";
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.dark.removeEventListener("change", this.relook);
    this.stage?.dispose();
    this.stage = null;
  }

  private readonly relook = (): void => this.stage?.setLook(this.dark.matches ? DARK : LIGHT);
}
