import { msg, str } from "@lit/localize";
import { css, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { DENOISER, ICONS } from "../../../engine/protocol";
import { takenFor } from "../../../guidance/icon-words";
import { givenFor } from "../../../state/contract/state";
import { deskOf, type Studio, type StudioState } from "../../../state/studio";
import { icons } from "../../../ui/shared/icons";
import { controls } from "../../../ui/shared/shared";
import { Part } from "../../../view/part";
import { viewWords } from "../../../view/heading";
import type { Slot } from "../given";
import { multiview } from "../task";

/** The other way from a word to a view: no icon is drawn, the word pulls the wire. */
@customElement("word-pull")
export class WordPull extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @property() pad: Slot = "front";
  /** What is looked for. */
  @property() typed = "";
  /** What the word is taken for, if it is not what was typed. */
  @state() private taken = "";

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
      p {
        margin: 0;
        overflow-wrap: anywhere;
      }
    `,
  ];

  override render() {
    const { word, taken } = this;
    const typed = this.typed.trim();
    return html`${typed && typed !== word ? html`<button @click=${() => this.say(typed)}>${icons.type} ${msg(str`Let “${typed}” pull the wire`)}</button>` : nothing}
      ${word ? html`<button class="plain" @click=${() => this.say("")}>${icons.clear} ${msg(str`No longer let “${word}” pull`)}</button>` : nothing}
      ${word && this.isDrawn ? html`<button class="plain" @click=${this.alone}>${icons.pencil} ${msg("Take the drawing away")}</button>` : nothing}
      <p class="small quiet" role="status">${word ? msg(str`“${word}” pulls the ${viewWords(this.pad)} view. ${taken}`) : nothing}</p>
      ${typed || word ? html`<p class="small quiet">${msg(str`Experimental, with a drawing or without: ${this.who} An icon makes the cleaner picture.`)}</p>` : nothing}`;
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    if (changed.has("pad")) this.taken = "";
  }

  private get word(): string {
    return deskOf(this.state.doc, multiview.name).guide?.words[this.pad] ?? "";
  }

  private get isDrawn(): boolean {
    return givenFor(this.state, multiview)[this.pad] !== null;
  }

  private get by(): string {
    return deskOf(this.state.doc, multiview.name).guide?.by ?? ICONS;
  }

  private get who(): string {
    if (this.by === ICONS) return msg("two small networks of ours say what it looks like, about 7 MB with what runs them, fetched when you press Run.");
    if (this.by === DENOISER) return msg("a small diffusion model of ours says what it looks like, fetched when you press Run.");
    return msg("the network that is chosen under Settings says what it looks like.");
  }

  private readonly alone = (): void => this.studio.taker(multiview).set(this.pad, null, msg("Let the word alone pull"));

  private async say(word: string): Promise<void> {
    this.taken = "";
    this.studio.options.say(this.pad, word);
    if (word && (this.by === ICONS || this.by === DENOISER)) this.taken = await takenFor(word);
  }
}
