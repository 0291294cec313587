import { msg, str } from "@lit/localize";
import { css, html, type PropertyValues } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { WireShape } from "#sculpture/scene/shape";
import type { Target, View } from "../engine/protocol";
import { percent } from "../words/numbers";
import { viewWords } from "./heading";
import { Part } from "./part";
import { SMALL_PX, SmallPictures, type SmallPicture } from "./small-pictures";
import { smallStyle } from "./small-style";

/** How well a view matches, 0 to 1: the drawing as bent, and as given where that is something else. */
export interface Match {
  readonly name: string;
  readonly share: number | null;
  readonly asDrawn: number | null;
}

/** One small picture a view: the drawing in copper, the wire over it. Copper that is left over is missing from the wire. */
@customElement("match-panels")
export class MatchPanels extends Part {
  /** Names of what there is no view of yet. */
  @property({ attribute: false }) expected: readonly string[] = [];
  @property({ attribute: false }) views: readonly View[] = [];
  @property({ attribute: false }) targets: readonly Target[] = [];
  @property({ attribute: false }) found: readonly Match[] = [];
  private readonly pictures = new SmallPictures(this, () => this.shownPictures());

  static override styles = [
    smallStyle,
    css`
      :host {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: 8px;
      }
      .match {
        font-weight: 600;
      }
      /* Kept free, so that nothing moves when it is known. */
      .drawn {
        flex-basis: 100%;
        min-height: 18px;
        color: var(--quiet);
      }
    `,
  ];

  override render() {
    return this.shown().map(
      ({ name, share, asDrawn }) => html`<figure>
        <canvas width=${SMALL_PX} height=${SMALL_PX} role="img" aria-label=${inWords(name, share, asDrawn)}></canvas>
        <figcaption>
          <span class="name">${viewWords(name)}</span>
          <span class="match" data-view=${name}>${share === null ? "–" : percent(share)}</span>
          <span class="drawn">${asDrawn === null ? "" : msg(str`${percent(asDrawn)} as drawn`)}</span>
        </figcaption>
      </figure>`,
    );
  }

  private shown(): readonly Match[] {
    const names = this.views.length === 0 ? this.expected : this.views.map(({ name }) => name);
    return names.map((name) => this.found.find((match) => match.name === name) ?? { name, share: null, asDrawn: null });
  }

  setWire(wire: WireShape | null): void {
    this.pictures.setWire(wire);
  }

  /** The colours changed. */
  recolour(): void {
    this.pictures.recolour();
  }

  protected override updated(changed: PropertyValues<this>): void {
    if (changed.has("targets") || changed.has("views")) this.pictures.repaint();
  }

  private shownPictures(): readonly SmallPicture[] {
    const canvases = this.renderRoot.querySelectorAll("canvas");
    return this.views.flatMap((view, i) => {
      const canvas = canvases[i];
      return canvas ? [{ canvas, view, under: this.targets.find((target) => target.view.name === view.name) }] : [];
    });
  }
}

function inWords(name: string, share: number | null, asDrawn: number | null): string {
  const seen = msg(str`The wire seen from the ${viewWords(name)}, over its drawing`);
  const known = share === null ? "" : msg(str`; ${percent(share)} match`);
  return seen + known + (asDrawn === null ? "" : msg(str`, ${percent(asDrawn)} with the drawing as it was before bending`));
}
