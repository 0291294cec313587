import { msg, str } from "@lit/localize";
import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { compare } from "../../state/actions/actions";
import { variantOf } from "../../state/keeping/track";
import { deskOf, type Made, type Studio, type StudioState } from "../../state/studio";
import { count } from "../../words/numbers";
import { Part } from "../../view/part";
import { controls } from "../shared/shared";
import { compared, gapOf, matchWords, shareWords } from "./compared";
import "./wire-pair";
import type { PairRow } from "./wire-pair";

/** One wire and loose strokes of the same pictures side by side: what it costs to be connected, and what it gains. */
@customElement("wire-comparison")
export class WireComparison extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
      p {
        margin: 0;
      }
    `,
  ];

  override render() {
    const { doc, comparing, running } = this.state;
    const { made, loose } = deskOf(doc);
    const both = made && loose && variantOf(loose.track) === "loose" ? ([made, loose] as const) : null;
    const views = this.studio.task().compared.length;
    return html`
      <h2>${msg("Wire or loose strokes")}</h2>
      <p class="small quiet">${both ? compared(...both, views) : msg("What does it cost to be in one piece? The same once more, in strokes that need not touch.")}</p>
      <button ?disabled=${!this.studio.can(compare)} @click=${() => this.studio.act(compare)}>
        ${comparing === "loose" && running === doc.task ? msg("Laying loose strokes…") : both ? msg("Compare once more") : compare.label}
      </button>
      ${both ? this.pair(both, views) : nothing}
    `;
  }

  private pair(both: readonly [Made, Made], views: number) {
    const rows: readonly PairRow[] = [
      [msg("Match"), (made) => matchWords(made, views)],
      [msg("Pieces"), ({ finished }) => count(finished.measures.components)],
      [msg("To join"), (made) => (gapOf(made) > 0 ? msg(str`${shareWords(gapOf(made))} more wire`) : "nothing")],
      [msg("Points"), ({ finished }) => count(finished.measures.control_points)],
    ];
    const names = [[msg("One wire"), msg("The wire")], [msg("Loose strokes"), msg("The loose strokes")]];
    return html`<wire-pair .pair=${both} .names=${names} .rows=${rows}></wire-pair>`;
  }
}
