import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { Made } from "../../../state/studio";
import { pageColours } from "../../../view/colours";
import { headingOf, viewWords } from "../../../view/heading";
import { paintInk } from "../../../view/paint";
import { Part } from "../../../view/part";
import { outlooks, outlookStyle } from "../../../ui/shared/outlooks";
import { controls } from "../../../ui/shared/shared";
import "./strand-histogram";

/** A finished wire on its shape: from each side, as the fit sees it, and how far apart its lines lie. Fires `look-from`. */
@customElement("covered-views")
export class CoveredViews extends Part {
  @property({ attribute: false }) made: Made | null = null;
  /** Whether the stage shows another wire. */
  @property({ type: Boolean, reflect: true }) past = false;

  static override styles = [
    controls,
    outlookStyle,
    css`
      :host {
        display: block;
        container-type: inline-size;
      }
      /* Five make a block: the front, and the others beside it. */
      ul {
        grid-template-columns: minmax(0, 2.55fr) repeat(2, minmax(0, 1fr));
      }
      li:first-child {
        grid-row: span 2;
      }
      button {
        display: grid;
        grid-template-columns: minmax(0, 1fr);
        align-content: space-between;
        gap: 0;
        height: 100%;
      }
      strand-histogram {
        display: block;
        margin-block-start: 12px;
      }
      :host([past]) {
        --vivid: 0.35;
      }
      canvas {
        opacity: var(--vivid, 1);
      }
      /* A wide sheet. */
      @container (min-width: 480px) {
        ul {
          grid-template-columns: repeat(5, minmax(0, 1fr));
        }
        li:first-child {
          grid-row: auto;
        }
      }
    `,
  ];

  override render() {
    const { shown = [], views = [], measures } = this.made?.finished ?? {};
    return html`
      ${shown.length ? outlooks(views.slice(0, shown.length).map((view) => ({ ...headingOf(view), words: viewWords(view.name) }))) : nothing}
      ${measures?.surface ? html`<strand-histogram .strands=${measures.surface.strands}></strand-histogram>` : nothing}
    `;
  }

  protected override updated(): void {
    this.recolour();
  }

  recolour(): void {
    const shown = this.made?.finished.shown ?? [];
    this.renderRoot.querySelectorAll("canvas").forEach((canvas, i) => paintInk(canvas, shown[i]!, pageColours().ink));
  }
}
