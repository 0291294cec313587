import { msg, str } from "@lit/localize";
import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { compareWith } from "../../state/actions/actions";
import { count, decimal } from "../../words/numbers";
import { variantOf, type Variant } from "../../state/keeping/track";
import { changesOf, type Change } from "../../state/run/variants";
import { deskOf, tableOf, type Made, type Studio, type StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { matchWords, shareWords, weighed } from "../run/compared";
import "../run/wire-pair";
import type { PairRow } from "../run/wire-pair";
import { controls } from "../shared/shared";

/** The same run with one thing switched off, side by side with the wire on the stage. */
@customElement("what-if")
export class WhatIf extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @state() private chosen: Variant | null = null;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
      label {
        display: grid;
        gap: 4px;
        font-size: 13px;
      }
      p {
        margin: 0;
      }
    `,
  ];

  override render() {
    const { doc, comparing, running } = this.state;
    const { made, loose, settings } = deskOf(doc);
    const { track } = made ?? {};
    const fewer = this.studio.task().fewer?.(track?.given ?? doc.given[doc.task]) ?? null;
    const changes = changesOf(track?.settings ?? settings, tableOf(this.state), made, fewer);
    const change = changes.find(({ variant }) => variant === this.chosen) ?? changes.find(({ variant }) => variant === "clearance") ?? changes[0];
    if (!change) return nothing;
    const beside = variantOf(loose?.track);
    const both = made && loose && beside ? ([made, loose] as const) : null;
    const views = this.studio.task().compared.length;
    return html`
      <label>
        ${msg("The same pictures, settings and seed, but")}
        <select @change=${(event: Event) => (this.chosen = (event.target as HTMLSelectElement).value as Variant)}>
          ${changes.map((each) => html`<option value=${each.variant} .selected=${each === change}>${changeWords(each)}</option>`)}
        </select>
      </label>
      <button ?disabled=${!this.studio.can(compareWith)} @click=${() => this.studio.act(compareWith, change)}>
        ${comparing !== null && running === doc.task ? msg("Making the other wire…") : msg("Run it and lay it beside")}
      </button>
      ${both && beside ? html`<p class="small">${weighed(...both, views)}</p>${this.pair(both, beside, changes, views)}` : nothing}
    `;
  }

  private pair(both: readonly [Made, Made], beside: Variant, changes: readonly Change[], views: number) {
    const other = changes.find(({ variant }) => variant === beside);
    const share = (value: number | undefined): string => (value === undefined ? "–" : shareWords(value));
    const rows: readonly PairRow[] = [
      [msg("Match"), (made) => matchWords(made, views)],
      [msg("Length"), ({ finished }) => decimal(finished.measures.length, 1)],
      [msg("Tight bends"), ({ finished }) => share(finished.measures.tight_share)],
      [msg("Through itself"), ({ finished }) => share(finished.measures.penetrating_share)],
      [msg("Pieces"), ({ finished }) => count(finished.measures.components)],
      [msg("Points"), ({ finished }) => count(finished.measures.control_points)],
    ];
    const words = other ? changeWords(other) : msg("the other wire");
    const names = [[msg("As it is"), msg("The wire")], [words, msg(str`The wire, ${words},`)]];
    return html`<wire-pair .pair=${both} .names=${names} .rows=${rows}></wire-pair>`;
  }
}

/** As in "The same, but …". */
function changeWords({ variant, without }: Change): string {
  switch (variant) {
    case "loose":
      return msg("in loose strokes");
    case "reinit":
      return without ? msg("no point is moved to where ink lacks") : msg("points that vanish move to where ink lacks");
    case "refine":
      return without ? msg("no points are added") : msg("points are added where pictures pull");
    case "respace":
      return msg("points are never laid anew");
    case "smoothness":
      return msg("bending costs nothing");
    case "tightness":
      return msg("tight bends cost nothing");
    case "clearance":
      return msg("strands may touch");
    case "level_weight":
      return msg("only the finest scale counts");
    case "bend":
      return msg("drawings do not bend");
    case "picture":
      return msg("the last picture is left out");
    case "start":
      return msg("it starts as a tangle");
  }
}
