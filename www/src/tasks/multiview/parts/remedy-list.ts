import { msg, str } from "@lit/localize";
import { html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { BendPreview } from "../../../engine/protocol";
import { givenFor, passingOf } from "../../../state/contract/state";
import { deskOf, type Studio, type StudioState } from "../../../state/studio";
import { guidedAlone, laidOut, SLOTS } from "../given";
import type { PadRemedy, PreviewBySlot } from "../previewer";
import { movedBy } from "../arrangement";
import { multiview } from "../task";
import { decimal, percent } from "../../../words/numbers";
import { viewWords } from "../../../view/heading";
import { Part } from "../../../view/part";
import { AS_GOOD_AS_ALL } from "./drawing-pad";
import { icons } from "../../../ui/shared/icons";
import { controls } from "../../../ui/shared/shared";
import { remedyListStyle } from "./remedy-list-style";

const BENDS: Readonly<Record<string, string>> = { none: msg("Do not bend"), little: msg("Bend a little"), free: msg("Bend freely") };
const NAME = msg("What can be shown");
/** More than these are no help but a list to read. */
const MOST_REMEDIES = 3;

/** How much of the drawings can be shown together, and what would help. */
@customElement("remedy-list")
export class RemedyList extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;

  static override styles = [controls, remedyListStyle];

  override render() {
    const { preview, previewBusy, previewProblem } = passingOf(this.state, multiview);
    const { phase } = this.state;
    const drawings = laidOut(givenFor(this.state, multiview)).length;
    if (drawings < 2) return this.only(this.few(drawings));
    if (previewProblem) return html`<section aria-label=${NAME}><p class="small" role="alert">${previewProblem}</p></section>`;
    if (!preview) return this.only(previewBusy ? msg("Finding where the drawings agree…") : "");
    const locked = phase !== "idle";
    const now = preview.coverable;
    const remedies = preview.remedies.slice(0, MOST_REMEDIES);
    const bends = preview.bends.filter(({ bend, coverable, likeness }) => bend === "none" || (coverable !== null && likeness !== null));
    return html`<section class=${previewBusy ? "busy" : ""} aria-label=${NAME} aria-busy=${previewBusy}>
      ${now >= AS_GOOD_AS_ALL
        ? html`<p class="sum">${icons.check}${msg("All of the ink can be shown.")}</p>`
        : html`<p class="sum some"><span>${msg(str`Only ${percent(now)} of the ink can be shown together.`)}</span></p>`}
      ${this.arranged(preview, locked)}
      ${remedies.length > 0 ? html`<ul aria-label=${msg("What would help")}>${remedies.map((remedy) => this.remedy(remedy, now, locked))}</ul>` : nothing}
      ${bends.length > 1 && now < AS_GOOD_AS_ALL ? html`<ul aria-label=${msg("Bending")}>${bends.map((bend) => this.bend(bend, locked))}</ul>` : nothing}
      ${preview.notes.map((note) => html`<p class="small quiet">${note}</p>`)}
    </section>`;
  }

  private few(drawings: number): string {
    const { guide } = deskOf(this.state.doc, multiview.name);
    const words = guidedAlone(givenFor(this.state, multiview), guide).length;
    if (drawings + words === 0) return msg("Two or three drawings make a wire.");
    if (drawings + words === 1) return msg("One more drawing, and a wire can be made.");
    return drawings === 0 ? msg("Words alone will pull the wire.") : msg("A word will pull where nothing is drawn.");
  }

  private only(words: string): TemplateResult {
    return html`<section aria-label=${NAME}><p class="sum small quiet">${words}</p></section>`;
  }

  /** What arranging has gained, and the way back. */
  private arranged({ asGiven, coverable, drawings }: PreviewBySlot, locked: boolean): TemplateResult | typeof nothing {
    const moved = SLOTS.some((slot) => drawings[slot] && movedBy(slot, drawings[slot]!));
    if (!moved || this.studio.options.value("arrange") !== "on") return nothing;
    return html`<p class="arranged small quiet">
      <span>${msg(str`Arranged for you: ${percent(asGiven)} → ${percent(coverable)}.`)}</span>
      <button class="plain small" ?disabled=${locked} @click=${() => this.studio.options.set("arrange", "off")}>${msg("Keep as I put them")}</button>
    </p>`;
  }

  private remedy(remedy: PadRemedy, now: number, locked: boolean): TemplateResult {
    const [words, icon] = asked(remedy);
    return html`<li>
      <button class="small" ?disabled=${locked} @click=${() => this.studio.taker(multiview).applyRemedy(remedy)}>
        ${icon}<span class="words">${words}</span>
        <span class="gain">${percent(now)} → <b>${percent(remedy.coverable)}</b></span>
      </button>
    </li>`;
  }

  private bend(choice: BendPreview, locked: boolean): TemplateResult {
    const { bend, coverable, likeness, movedPx } = choice;
    const price = bend === "none" || likeness === null ? "" : msg(str`Ink moves by ${decimal(movedPx ?? 0, 1)} of 256 px; ${percent(likeness)} matches what was drawn`);
    return html`<li>
      <button
        class="small"
        aria-pressed=${this.studio.options.value("bend") === bend}
        ?disabled=${locked}
        @click=${() => this.studio.options.set("bend", bend)}
      >
        <span class="tick">${icons.check}</span>
        <span class="words">${BENDS[bend] ?? bend}${price ? html`<small>${price}</small>` : nothing}</span>
        ${coverable === null ? nothing : html`<span class="gain"><b>${percent(coverable)}</b></span>`}
      </button>
    </li>`;
  }
}

function turning(slot: string, quarterTurns: number): string {
  if (quarterTurns === 2) return msg(str`Turn the ${slot} drawing upside down`);
  return quarterTurns === 3 ? msg(str`Turn the ${slot} drawing right`) : msg(str`Turn the ${slot} drawing left`);
}

function asked({ kind, slots, quarterTurns }: PadRemedy): readonly [string, TemplateResult] {
  const [a, b] = slots;
  switch (kind) {
    case "mirror":
      return [msg(str`Mirror the ${viewWords(a!)} drawing`), icons.mirror];
    case "turn":
      return [turning(viewWords(a!), quarterTurns % 4), quarterTurns % 4 === 3 ? icons.turnRight : icons.turnLeft];
    case "swap":
      return [msg(str`Swap ${viewWords(a!)} and ${viewWords(b!)}`), icons.swap];
    case "arrange":
      return [msg("Arrange for me"), icons.arrange];
  }
}
