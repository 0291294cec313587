import { msg } from "@lit/localize";
import { css, html, nothing } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { givenFor } from "../../../state/contract/state";
import type { PatternName } from "../protocol";
import { fill } from "../task";
import type { Studio, StudioState } from "../../../state/studio";
import { pageColours } from "../../../view/colours";
import { paintInk } from "../../../view/paint";
import { Part } from "../../../view/part";
import { chosenFile } from "../../../ui/shared/drop";
import { icons } from "../../../ui/shared/icons";
import { controls } from "../../../ui/shared/shared";
import { tiles, tilesStyle } from "./tiles";

const NONE = "none";
const PATTERN_WORDS: Readonly<Record<PatternName, string>> = {
  petals: msg("Petals"),
  waves: msg("Waves"),
  calligraphy: msg("Calligraphy"),
  scales: msg("Scales"),
  leaves: msg("Leaves"),
};

/** What the wire should look like: a style by formula, a picture of one's own, or nothing in particular. */
@customElement("style-shelf")
export class StyleShelf extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @query("#picture") private file!: HTMLInputElement;

  static override styles = [
    controls,
    tilesStyle,
    css`
      canvas {
        width: 100%;
        height: 100%;
        object-fit: cover;
      }
      .plain-style {
        width: 100%;
        height: 100%;
        background: repeating-linear-gradient(transparent 0 5px, var(--line-strong) 5px 6.5px);
        forced-color-adjust: none;
      }
      #own {
        grid-column: 1 / -1;
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: 36px;
        padding: 0 10px;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--raised);
        color: var(--ink);
      }
      #own.chosen {
        border-color: var(--copper);
        box-shadow: 0 0 0 1px var(--copper);
      }
      #own .words {
        flex: 1;
        margin: 0;
        text-align: start;
      }
      @media (pointer: coarse) {
        #own {
          min-height: 44px;
        }
      }
    `,
  ];

  override render() {
    const cover = givenFor(this.state, fill);
    const style = cover?.style ?? null;
    const locked = this.state.phase !== "idle" || !cover;
    const own = style !== null && typeof style !== "string" ? style : null;
    const patterns = Object.entries(PATTERN_WORDS).map(([value, words]) => ({
      value,
      words,
      picture: html`<canvas data-pattern=${value} width="96" height="76" aria-hidden="true"></canvas>`,
    }));
    const none = { value: NONE, words: msg("None"), picture: html`<span class="plain-style"></span>` };
    return html`
      <h2 id="style">${msg("Style")}</h2>
      <fieldset class="tiles" aria-labelledby="style">
        ${tiles("style", [none, ...patterns], own ? null : (style as PatternName | null) ?? NONE, locked, (value) =>
          this.studio.taker(fill).pattern(value === NONE ? null : (value as PatternName)),
        )}
        <button id="own" class=${own ? "chosen" : ""} ?disabled=${locked} @click=${() => this.file.click()}>
          ${icons.picture}<span class="words" title=${own ? own.name : nothing}>${own ? own.name : msg("Your own picture…")}</span>
        </button>
      </fieldset>
      <input id="picture" type="file" accept="image/*" hidden tabindex="-1" aria-label=${msg("Picture of a style")} @change=${this.chosen} />
    `;
  }

  protected override firstUpdated(): void {
    void this.paint();
    addEventListener("theme-change", this.repaint);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    removeEventListener("theme-change", this.repaint);
  }

  private readonly repaint = (): void => void this.paint();

  /** The styles' own pictures; where the core cannot be had that is said elsewhere, and the words are there. */
  private async paint(): Promise<void> {
    for (const canvas of this.renderRoot.querySelectorAll<HTMLCanvasElement>("canvas[data-pattern]")) {
      const ink = await this.studio.taker(fill).patternPicture(canvas.dataset["pattern"] as PatternName).catch(() => null);
      if (ink) paintInk(canvas, ink, pageColours().ink, 0.85);
    }
  }

  private readonly chosen = (event: Event): void => {
    const file = chosenFile(event);
    if (file) void this.studio.taker(fill).picture(file, file.name || msg("the picture"));
  };
}
