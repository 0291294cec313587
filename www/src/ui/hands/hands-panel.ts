import { msg, str } from "@lit/localize";
import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { useTool } from "../../state/actions/actions";
import type { StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";
import type { Hands, Point } from "./hands";

const NAMES = ["x", "y", "z"] as const;
/** World units a press of an arrow key moves a point, and thickens the wire. */
const STEP = 0.01;
const WIDTH_STEP = 0.002;

/** The wire in hand: a point by its number, where it is, and what can be done with it. */
@customElement("hands-panel")
export class HandsPanel extends Part {
  @property({ attribute: false }) hands!: Hands;
  @property({ attribute: false }) state!: StudioState;
  private stop: () => void = () => undefined;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: 16px;
        align-content: start;
        padding: 8px 16px 24px;
      }
      header,
      .row {
        display: flex;
        align-items: center;
        gap: 8px;
      }
      header {
        justify-content: space-between;
        margin-inline-end: -8px;
      }
      p {
        margin: 0;
      }
      .row {
        flex-wrap: wrap;
      }
      .row > button:not(.square) {
        flex: 1 1 96px;
      }
      .places {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        gap: 8px;
      }
      label {
        display: grid;
        gap: 4px;
        font-size: 13px;
      }
      input {
        width: 100%;
        font-variant-numeric: tabular-nums;
      }
      .which {
        flex: 1 1 80px;
      }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    this.stop = this.hands.store.follow(() => this.requestUpdate());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop();
  }

  override render() {
    const { wire, said } = this.hands.store.get();
    return html`
      <header>
        <h2>${msg("Hands on the wire")}</h2>
        <button class="plain square" aria-label=${msg("Leave the wire")} title=${msg("Leave the wire")} @click=${() => this.hands.studio.act(useTool, null)}>${icons.close}</button>
      </header>
      ${wire ? this.tools() : html`<p class="small quiet">${this.state.phase === "idle" ? msg("There is no wire yet: make one, then take it in hand.") : msg("The wire is being made. Take it in hand when it is done.")}</p>`}
      <p class="small" role="status">${said}</p>
    `;
  }

  private tools() {
    const { hands } = this;
    const { held, end } = hands.store.get();
    const [x, y, z, width] = hands.point();
    const place = [x, y, z] as const;
    return html`
      <p class="small quiet">${msg("Drag a point on the stage, or choose it here. Beside the points the camera turns as ever.")}</p>
      <div class="row" role="group" aria-label=${msg("Point")}>
        <button class="square" aria-label=${msg("Point before")} ?disabled=${held === 0} @click=${() => hands.hold(held - 1)}>−</button>
        <label class="which">${msg(str`Point of ${hands.count}`)}<input id="point" type="number" min="1" max=${hands.count} .value=${String(held + 1)} @change=${(event: Event) => hands.hold(numberIn(event) - 1)} /></label>
        <button class="square" aria-label=${msg("Next point")} ?disabled=${held === hands.count - 1} @click=${() => hands.hold(held + 1)}>+</button>
      </div>
      <div class="places" role="group" aria-label=${msg("Where it is, and how thick the wire is there")}>
        ${NAMES.map((name, c) => html`<label>${name}<input id=${name} type="number" step=${STEP} value=${place[c]!.toFixed(3)} .value=${place[c]!.toFixed(3)} @change=${(event: Event) => this.move(c, numberIn(event))} /></label>`)}
        <label>${msg("Width")}<input id="width" type="number" step=${WIDTH_STEP} value=${width.toFixed(4)} .value=${width.toFixed(4)} @change=${(event: Event) => this.move(3, numberIn(event))} /></label>
      </div>
      <div class="row">
        <button id="insert" @click=${() => hands.edit({ kind: "insert", after: held }, msg("Insert a point"), () => msg("One point more; the curve is where it was."))}>${msg("Insert after")}</button>
        <button id="remove" @click=${() => hands.edit({ kind: "remove", index: held }, msg("Take a point away"), (strayed) => msg(str`One point less; the curve moved by ${strayed.toFixed(3)} at most.`))}>${msg("Take away")}</button>
      </div>
      <div class="row" role="group" aria-label=${msg("A stretch")}>
        <label class="which">${msg("Stretch to point")}<input id="end" type="number" min="1" max=${hands.count} .value=${String(end + 1)} @change=${(event: Event) => hands.stretchTo(numberIn(event) - 1)} /></label>
        <button id="smooth" @click=${() => hands.edit({ kind: "smooth", from: held, to: end }, msg("Smooth a stretch"), () => msg("The stretch bends less. Again, and it bends less still."))}>${msg("Smooth it")}</button>
        <button id="straighten" @click=${() => hands.edit({ kind: "straighten", from: held, to: end }, msg("Straighten a stretch"), () => msg("The stretch is straight."))}>${msg("Straighten")}</button>
      </div>
      ${Math.abs(end - held) < 2 ? html`<p class="small quiet">${msg("A stretch has at least one point between its ends.")}</p>` : nothing}
    `;
  }

  private move(which: number, value: number): void {
    const { hands } = this;
    const { held } = hands.store.get();
    const to = hands.point().map((before, c) => (c === which ? value : before)) as unknown as Point;
    if (to.every(Number.isFinite)) void hands.edit({ kind: "move", index: held, to }, msg(str`Move point ${held + 1}`));
    else this.requestUpdate();
  }
}

function numberIn(event: Event): number {
  return (event.target as HTMLInputElement).valueAsNumber;
}
