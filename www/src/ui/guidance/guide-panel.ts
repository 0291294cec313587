import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { ICONS, type Guide } from "../../engine/protocol";
import { suggested } from "../../guidance/icon-words";
import { explain } from "../../state/common/words";
import { deskOf, type Studio, type StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { controls } from "../shared/shared";
import "./model-shelf";
import type { Facts } from "./model-shelf";

const WEIGHTS = { usual: 0.3, most: 3, step: 0.1 } as const;

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
    if (views.length === 0) return html`<p class="small quiet">Words guide wires that have pictures to be like. Look at Three views or One picture.</p>`;
    return html`
      <p class="small quiet">A word pulls the wire besides the picture, towards what a network thinks the word looks like. That is an experiment: it can be wrong, and it takes longer.</p>
      <div class="words">
        ${views.map((view) => this.word(view))}
        <datalist id="meant">${this.meant.map((word) => html`<option value=${word}></option>`)}</datalist>
      </div>
      <label class="strength">
        How strongly <output>${guide?.weight ?? WEIGHTS.usual}</output>
        <input
          type="range"
          min="0"
          max=${WEIGHTS.most}
          step=${WEIGHTS.step}
          .value=${String(guide?.weight ?? WEIGHTS.usual)}
          ?disabled=${this.locked}
          @change=${(event: Event) => this.change({ weight: Number((event.target as HTMLInputElement).value) })}
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
        ${view.charAt(0).toUpperCase() + view.slice(1)}
        <input
          type="text"
          list="meant"
          maxlength="60"
          autocomplete="off"
          spellcheck="false"
          placeholder="a word, or nothing"
          .value=${this.guide?.words[view] ?? ""}
          ?disabled=${this.locked}
          aria-describedby=${unknown ? `unknown-${view}` : nothing}
          @input=${(event: Event) => this.suggest((event.target as HTMLInputElement).value)}
          @change=${(event: Event) => this.say(view, (event.target as HTMLInputElement).value.trim())}
        />
      </label>
      ${unknown ? html`<p class="small quiet" id="unknown-${view}">${unknown}</p>` : nothing}`;
  }

  /** The networks there are, and what each is. */
  private who() {
    const by = this.guide?.by ?? ICONS;
    return html`<div class="by">
      <label>
        Whose idea of the words counts
        <select ?disabled=${this.locked} @change=${(event: Event) => this.change({ by: (event.target as HTMLSelectElement).value })}>
          <option value=${ICONS} .selected=${by === ICONS}>Small networks that know icons</option>
          ${this.models.map(({ sha256, name }) => html`<option value=${sha256} .selected=${sha256 === by}>${name}</option>`)}
        </select>
      </label>
      ${by === ICONS
        ? html`<p class="small quiet">
            Two networks of ours, trained on icons: with their words and a runtime about 7 MB, fetched when you press Run. They know nothing of photographs, and not every word. Licence: as this page; what they
            were trained on is MIT, ISC, Apache-2.0 or CC0.
          </p>`
        : nothing}
      <details>
        <summary class="small">A network of your own</summary>
        <model-shelf .engine=${this.studio.bench.engine} .prefer=${this.state.where.place?.backend === "gpu" ? "webgpu" : "wasm"} @models=${this.hear}></model-shelf>
      </details>
    </div>`;
  }

  private readonly hear = ({ detail }: CustomEvent<readonly Facts[]>): void => {
    this.models = detail.filter(({ kind }) => kind === "guidance-v1");
  };

  private change(change: Partial<Guide>): void {
    const guide = { words: {}, weight: WEIGHTS.usual, by: ICONS, ...this.guide, ...change };
    const idle = guide.by === ICONS && guide.weight === WEIGHTS.usual && !Object.values(guide.words).some(Boolean);
    this.studio.options.guideBy(idle ? null : guide);
  }

  private async say(view: string, word: string): Promise<void> {
    this.change({ words: { ...this.guide?.words, [view]: word } });
    this.unknown = { ...this.unknown, [view]: word && (this.guide?.by ?? ICONS) === ICONS ? await this.taken(word) : "" };
  }

  /** What a word is taken for, if it is not what was typed. */
  private async taken(word: string): Promise<string> {
    try {
      const [first] = await suggested(word, 1);
      if (!first) return "Not a word that these networks know. Try a plainer one.";
      return first.toLowerCase() === word.toLowerCase() ? "" : `Taken for “${first}”.`;
    } catch (error) {
      return explain(error, "The table of words");
    }
  }

  private async suggest(typed: string): Promise<void> {
    const known = typed.length > 1 && (this.guide?.by ?? ICONS) === ICONS;
    this.meant = known ? await suggested(typed).catch(() => []) : [];
  }
}
