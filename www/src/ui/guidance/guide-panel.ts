import { msg, str } from "@lit/localize";
import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { DENOISER, ICONS, USUAL_WEIGHT, type Guide } from "../../engine/protocol";
import { DENOISER_FILES } from "../../guidance/denoiser-files";
import { size } from "../../guidance/fault";
import { suggested, takenFor } from "../../guidance/icon-words";
import { deskOf, type Studio, type StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { viewWords } from "../../view/heading";
import { localeTag } from "../../words/language";
import { segmented, segmentedStyle } from "../shared/segmented";
import { controls } from "../shared/shared";
import "./model-shelf";
import type { Facts } from "./model-shelf";

const WEIGHTS = { most: 3, step: 0.1 } as const;
/** The paper's, for patches; and what a diffusion model takes. */
const [OF_PATCHES, OF_DIFFUSION] = [0.5, 1];
const NEUTRAL = msg("a wire");

/** Whether words are those of the table that comes with the page. */
const isOurs = (by: string): boolean => by === ICONS || by === DENOISER;

/** Words beside each picture, how strongly they pull, and whose idea of them counts. */
@customElement("guide-panel")
export class GuidePanel extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @property({ type: Boolean }) locked = false;
  /** Words that may be meant, for the field that is typed in. */
  @state() private meant: readonly string[] = [];
  @state() private unknown: Readonly<Record<string, string>> = {};
  /** Networks that can guide, besides ours. */
  @state() private models: readonly Facts[] = [];

  static override styles = [
    controls,
    segmentedStyle,
    css`
      :host {
        display: grid;
        gap: 16px;
        padding-block: 4px 16px;
      }
      .words,
      .by {
        display: grid;
        gap: 8px;
      }
      label {
        display: grid;
        gap: 4px;
      }
      .word {
        grid-template-columns: 5em minmax(0, 1fr);
        align-items: center;
      }
      .turned {
        grid-template-columns: auto minmax(0, 1fr);
        align-items: center;
        gap: 8px;
      }
      .strength {
        grid-template-columns: minmax(0, 1fr) auto;
        align-items: center;
      }
      .strength input {
        grid-column: 1 / -1;
      }
      p {
        margin: 0;
        overflow-wrap: anywhere;
      }
      summary {
        min-height: 32px;
        cursor: pointer;
      }
    `,
  ];

  override render() {
    const { guide, views } = this;
    if (views.length === 0) return html`<p class="small quiet">${msg("Words guide wires that have pictures to be like. Look at Three views or One picture.")}</p>`;
    return html`
      <p class="small quiet">A word pulls the wire besides the picture${views.length > 1 ? msg(", or alone where nothing is drawn,") : ""} towards what a network thinks the word looks like. That is an experiment: it can be wrong, and it takes longer.</p>
      <div class="words">
        ${views.map((view) => this.word(view))}
        <datalist id="meant">${this.meant.map((word) => html`<option value=${word}></option>`)}</datalist>
      </div>
      ${views.length === 1 ? this.turned() : nothing}
      <label class="strength">
        ${msg("How strongly")} <output>${guide?.weight ?? USUAL_WEIGHT}</output>
        <input
          type="range"
          min="0"
          max=${WEIGHTS.most}
          step=${WEIGHTS.step}
          .value=${String(guide?.weight ?? USUAL_WEIGHT)}
          ?disabled=${this.locked}
          @change=${(event: Event) => this.studio.options.guideBy({ weight: Number((event.target as HTMLInputElement).value) })}
        />
      </label>
      ${this.who()}
    `;
  }

  private get guide(): Guide | null {
    return deskOf(this.state.doc).guide;
  }

  private get views(): readonly string[] {
    return this.studio.task().compared;
  }

  private word(view: string) {
    const unknown = this.unknown[view];
    return html`<label class="word">
        ${viewWords(view).charAt(0).toLocaleUpperCase(localeTag()) + viewWords(view).slice(1)}
        <input
          type="text"
          list="meant"
          maxlength="60"
          autocomplete="off"
          spellcheck="false"
          placeholder=${msg("a word, or nothing")}
          .value=${this.guide?.words[view] ?? ""}
          ?disabled=${this.locked}
          aria-describedby=${unknown ? `unknown-${view}` : nothing}
          @input=${(event: Event) => this.suggest((event.target as HTMLInputElement).value)}
          @change=${(event: Event) => this.say(view, (event.target as HTMLInputElement).value.trim())}
        />
      </label>
      ${unknown ? html`<p class="small quiet" id="unknown-${view}">${unknown}</p>` : nothing}`;
  }

  /** Of one picture: its other sides. A diffusion model compares no pictures. */
  private turned() {
    const { likePicture = false, by = ICONS } = this.guide ?? {};
    const diffuses = this.diffuses(by);
    return html`<label class="turned">
        <input type="checkbox" .checked=${likePicture && !diffuses} ?disabled=${this.locked || diffuses} @change=${(event: Event) => this.studio.options.guideBy({ likePicture: (event.target as HTMLInputElement).checked })} />
        ${msg("Turned views are to be like the picture")}
      </label>
      <p class="small quiet">${diffuses ? msg("A diffusion model compares no pictures: choose networks that do.") : msg("As the networks below see both. Without a word, too.")}</p>`;
  }

  /** The networks there are, and what each is. */
  private who() {
    const by = this.guide?.by ?? ICONS;
    return html`<div class="by">
      <label>
        ${msg("Whose idea of the words counts")}
        <select ?disabled=${this.locked} @change=${(event: Event) => this.choose({ by: (event.target as HTMLSelectElement).value })}>
          <option value=${ICONS} .selected=${by === ICONS}>${msg("Small networks that know icons")}</option>
          ${DENOISER_FILES ? html`<option value=${DENOISER} .selected=${by === DENOISER}>${msg("A small diffusion model of ours")}</option>` : nothing}
          ${this.models.map(({ sha256, name }) => html`<option value=${sha256} .selected=${sha256 === by}>${name}</option>`)}
        </select>
      </label>
      ${this.about(by)}
      <details>
        <summary class="small">${msg("A network of your own")}</summary>
        <model-shelf .engine=${this.studio.bench.engine} .prefer=${this.state.where.place?.backend === "gpu" ? "webgpu" : "wasm"} @models=${this.hear}></model-shelf>
      </details>
    </div>`;
  }

  /** What one is and how large, and how it looks where that can be chosen. */
  private about(by: string) {
    if (by === ICONS) {
      return html`<p class="small quiet">
        ${msg("Two networks of ours, trained on icons: with their words and a runtime about 7 MB, fetched when you press Run. They know nothing of photographs, and not every word. Licence: as this page; what they were trained on is MIT, ISC, Apache-2.0 or CC0.")}
      </p>`;
    }
    if (by === DENOISER && DENOISER_FILES) {
      return html`<p class="small quiet">
        ${msg(str`It says what it would take from a noisy picture for that to show the word, and the wire follows. Trained by us on the same icons: ${size(DENOISER_FILES.bytes)} besides words and runtime (about 7 MB), fetched when you press Run; it runs on the processor. Licence: as this page.`)}
      </p>`;
    }
    const model = this.models.find(({ sha256 }) => sha256 === by);
    const what = model ? msg(str`${size(model.bytes)}, and about ${size(model.memory)} of memory.`) : msg("It is not here any more: open its files again.");
    if (model?.kind === "eps-v1") return html`<p class="small quiet">${msg(str`A diffusion model of your own: ${what} Where it sees no pixels, open its encoder, too.`)}</p>`;
    return html`<p class="small quiet">${msg(str`A network of your own: ${what}`)}</p>
      ${this.look()}`;
  }

  private look() {
    const { look = "views", neutral = "" } = this.guide ?? {};
    return html`${segmented({
      legend: msg("How it looks"),
      name: "look",
      options: [
        { value: "views", words: msg("At whole views") },
        { value: "patches", words: msg("At patches") },
      ],
      value: look,
      locked: this.locked,
      choose: (value) => this.lookAt(value as "views" | "patches"),
    })}
    ${look === "patches"
      ? html`<label>
            ${msg("Neutral words")}
            <input type="text" maxlength="60" autocomplete="off" .value=${neutral} placeholder=${msg("none")} ?disabled=${this.locked} aria-describedby="neutral" @change=${(event: Event) => this.studio.options.guideBy({ neutral: (event.target as HTMLInputElement).value.trim() })} />
          </label>
          <p class="small quiet" id="neutral">${msg("Sixteen patches of each view depart from the first wire as the view’s words differ from these: finer, and slower. With none, each patch is to be like the words.")}</p>`
      : nothing}`;
  }

  private lookAt(look: "views" | "patches"): void {
    this.choose({ look, ...(look === "patches" && this.guide?.neutral === undefined ? { neutral: NEUTRAL } : {}) });
  }

  /** The weight goes along where nobody chose one. */
  private choose(change: Partial<Guide>): void {
    const before = { weight: USUAL_WEIGHT, by: ICONS, ...this.guide };
    const weight = before.weight === this.usual(before) ? this.usual({ ...before, ...change }) : before.weight;
    this.studio.options.guideBy({ ...change, weight });
  }

  private usual({ by, look }: Pick<Guide, "by" | "look">): number {
    if (this.diffuses(by)) return OF_DIFFUSION;
    return look === "patches" && !isOurs(by) ? OF_PATCHES : USUAL_WEIGHT;
  }

  private diffuses(by: string): boolean {
    return by === DENOISER || this.models.some(({ sha256, kind }) => sha256 === by && kind === "eps-v1");
  }

  private readonly hear = ({ detail }: CustomEvent<readonly Facts[]>): void => {
    this.models = detail.filter(({ kind }) => kind === "guidance-v1" || kind === "eps-v1");
  };

  private async say(view: string, word: string): Promise<void> {
    this.studio.options.say(view, word);
    this.unknown = { ...this.unknown, [view]: word && isOurs(this.guide?.by ?? ICONS) ? await takenFor(word) : "" };
  }

  private async suggest(typed: string): Promise<void> {
    const known = typed.length > 1 && isOurs(this.guide?.by ?? ICONS);
    this.meant = known ? await suggested(typed).catch(() => []) : [];
  }
}
