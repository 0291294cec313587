import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import type { WireShape } from "../../embed/shape";
import { viewFrom, type Heading } from "../../view/heading";
import { Part } from "../../view/part";
import { SMALL_PX, SmallPictures, type SmallPicture } from "../../view/small-pictures";
import { smallStyle } from "../../view/small-style";
import { controls } from "../shared/shared";

interface Turned extends Heading {
  readonly words: string;
}

const TURNED: readonly Turned[] = [
  { azimuth: 35, elevation: 0, words: "35° right" },
  { azimuth: 90, elevation: 0, words: "side" },
  { azimuth: 180, elevation: 0, words: "back" },
  { azimuth: -35, elevation: 0, words: "35° left" },
  { azimuth: 35, elevation: 40, words: "from above" },
  { azimuth: 0, elevation: 90, words: "top" },
];
const VIEWS = TURNED.map((turned) => viewFrom(turned, turned.words));

/** The wire from where no picture was given, as it forms. Fires `look-from` with the heading that a person wants to see it from. */
@customElement("turned-views")
export class TurnedViews extends Part {
  private readonly pictures = new SmallPictures(() => this.shown());

  static override styles = [
    controls,
    smallStyle,
    css`
      :host {
        display: grid;
        gap: 8px;
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
        border: 1px solid var(--line);
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
      .words {
        display: block;
      }
      .words::first-letter {
        text-transform: capitalize;
      }
    `,
  ];

  override render() {
    return html`
      <h2>As it turns</h2>
      <ul>
        ${TURNED.map(
          (turned) => html`<li>
            <button title="Look from there" @click=${() => this.look(turned)}>
              <canvas width=${SMALL_PX} height=${SMALL_PX} aria-hidden="true"></canvas>
              <span class="words"><span class="unseen">Look at it: </span>${turned.words}</span>
            </button>
          </li>`,
        )}
      </ul>
    `;
  }

  setWire(wire: WireShape | null): void {
    this.pictures.setWire(wire);
  }

  recolour(): void {
    this.pictures.recolour();
  }

  protected override firstUpdated(): void {
    this.pictures.repaint();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.pictures.rest();
  }

  private shown(): readonly SmallPicture[] {
    return [...this.renderRoot.querySelectorAll("canvas")].map((canvas, i) => ({ canvas, view: VIEWS[i]! }));
  }

  private look({ azimuth, elevation }: Heading): void {
    this.dispatchEvent(new CustomEvent<Heading>("look-from", { detail: { azimuth, elevation }, bubbles: true, composed: true }));
  }
}
