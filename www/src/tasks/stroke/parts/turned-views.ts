import { msg } from "@lit/localize";
import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import type { WireShape } from "#sculpture/scene/shape";
import { viewFrom } from "../../../view/heading";
import { Part } from "../../../view/part";
import { SmallPictures, type SmallPicture } from "../../../view/small-pictures";
import { outlooks, outlookStyle, type Outlook } from "../../../ui/shared/outlooks";
import { controls } from "../../../ui/shared/shared";

const TURNED: readonly Outlook[] = [
  { azimuth: 35, elevation: 0, words: msg("35° right") },
  { azimuth: 90, elevation: 0, words: msg("side") },
  { azimuth: 180, elevation: 0, words: msg("back") },
  { azimuth: -35, elevation: 0, words: msg("35° left") },
  { azimuth: 35, elevation: 40, words: msg("from above") },
  { azimuth: 0, elevation: 90, words: msg("top") },
];
const VIEWS = TURNED.map((turned) => viewFrom(turned, turned.words));

/** The wire from where no picture was given, as it forms. Fires `look-from`. */
@customElement("turned-views")
export class TurnedViews extends Part {
  private readonly pictures = new SmallPictures(this, () => this.shown());

  static override styles = [
    controls,
    outlookStyle,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
    `,
  ];

  override render() {
    return html`
      <h2>${msg("As it turns")}</h2>
      ${outlooks(TURNED)}
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

  private shown(): readonly SmallPicture[] {
    return [...this.renderRoot.querySelectorAll("canvas")].map((canvas, i) => ({ canvas, view: VIEWS[i]! }));
  }
}
