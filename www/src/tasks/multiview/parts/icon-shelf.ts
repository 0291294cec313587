import { msg, str } from "@lit/localize";
import { html, LitElement, nothing, svg, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { find } from "./drawing/shelf";
import type { Shape, ShelfIcon } from "./drawing/shelf-icons";
import { icons } from "../../../ui/shared/icons";
import { controls } from "../../../ui/shared/shared";
import { iconShelfStyle } from "./icon-shelf-style";

type Shelf = typeof import("./drawing/shelf-icons");

export interface TakenIcon {
  readonly name: string;
  readonly ink: Uint8Array<ArrayBuffer>;
}

const PAGE = 60;
/** As many icons as are drawn at once: typing waits for no more. */
const BATCH = 15;
/** Of the icons' square of 24; the usual width of 2 is more than a wire has to give. */
const WIDTH = { least: 0.5, most: 3, step: 0.25, first: 1 };
/** What makes a good wire, and good sets of three. */
const FIRST =
  "cat dog bird fish rabbit squirrel turtle snail bug rat paw-print feather heart star moon sun cloud snowflake flower flower-2 clover leaf tree-pine tree-palm sprout apple cherry banana carrot pizza croissant ice-cream-cone cup-soda coffee wine bike car bus plane rocket sailboat ship anchor tent house castle church lightbulb key umbrella glasses scissors music guitar drum bell crown gem gift ghost skull smile hand eye".split(
    " ",
  );
const SUGGESTIONS = ["animal", "music", "weather"];

/** Icons to take: fires `take` with a TakenIcon, and `seek` with what is looked for. What is on it is loaded when it is first shown. */
@customElement("icon-shelf")
export class IconShelf extends LitElement {
  /** What the sheet's icon is called, if there is one. */
  @property() taken = "";
  @state() private shelf: Shelf | null = null;
  @state() private failed = false;
  @state() private search = "";
  /** Icons that are drawn, and that are to be drawn bit by bit. */
  @state() private shown = BATCH;
  private wanted = PAGE;
  @state() private strokeWidth = WIDTH.first;
  /** The one icon that Tab reaches. */
  @state() private current = 0;
  @query(".grid") private grid!: HTMLElement | null;
  private found: readonly ShelfIcon[] = [];
  private last: ShelfIcon | null = null;
  private growing: ReturnType<typeof setTimeout> | undefined;

  static override styles = [controls, iconShelfStyle];

  override connectedCallback(): void {
    super.connectedCallback();
    void this.load();
  }

  private async load(): Promise<void> {
    this.failed = false;
    try {
      this.shelf ??= await import("./drawing/shelf-icons");
    } catch {
      this.failed = true;
    }
  }

  protected override willUpdate(changed: PropertyValues): void {
    if (this.shelf && (changed.has("shelf") || changed.has("search"))) {
      this.found = this.search.trim() ? find(this.shelf.icons, this.search) : startingWith(this.shelf.icons, FIRST);
      this.shown = BATCH;
      this.wanted = PAGE;
      this.current = 0;
      this.dispatchEvent(new CustomEvent<string>("seek", { detail: this.search }));
    }
  }

  override render() {
    return html`
      <label class="search">
        <span class="unseen">${msg("Search icons")}</span>
        ${icons.search}
        <input
          type="search"
          placeholder=${msg("Search: cat, bike, love…")}
          autocomplete="off"
          spellcheck="false"
          enterkeyhint="search"
          maxlength="60"
          .value=${this.search}
          @input=${(event: InputEvent) => (this.search = (event.target as HTMLInputElement).value)}
          @keydown=${this.searchKey}
        />
      </label>
      <label class="width small quiet">
        ${msg("Line")}
        <input
          type="range"
          min=${WIDTH.least}
          max=${WIDTH.most}
          step=${WIDTH.step}
          aria-label=${msg("Width of the icon's lines")}
          .value=${String(this.strokeWidth)}
          @input=${this.setWidth}
          @change=${this.takeAgain}
        />
        <output>${this.strokeWidth.toFixed(2)}</output>
      </label>
      <div class="scroll">${this.content()}</div>
      <slot></slot>
      ${this.shelf
        ? html`<details class="small">
            <summary>${msg("Icons: Lucide, ISC licence")}</summary>
            <pre tabindex="0" aria-label=${msg("Licence of the icons")}>${this.shelf.licence}</pre>
          </details>`
        : nothing}
    `;
  }

  protected override updated(): void {
    clearTimeout(this.growing);
    if (this.shown < Math.min(this.wanted, this.found.length)) this.growing = setTimeout(() => (this.shown += BATCH));
    this.grid?.style.setProperty("--stroke", String(this.strokeWidth));
  }

  private content() {
    if (this.failed) {
      return html`<div class="nothing small" role="alert">
        <p>${msg("The icons did not load. Nothing is lost; please try again.")}</p>
        <button @click=${this.load}>${msg("Try again")}</button>
      </div>`;
    }
    if (!this.shelf) return html`<div class="nothing small"><p>${msg("Getting the icons…")}</p></div>`;
    if (this.found.length === 0) {
      return html`<div class="nothing small">
        <p>${msg(str`No icon for “${this.search.trim()}”. It may be there under another word:`)}</p>
        <div>${SUGGESTIONS.map((word) => html`<button @click=${() => (this.search = word)}>${word}</button>`)}</div>
      </div>`;
    }
    const shown = this.found.slice(0, this.shown);
    const rest = this.found.length - this.wanted;
    return html`
      <div class="grid" data-keys role="group" aria-label=${msg(str`${this.found.length} icons`)} @keydown=${this.gridKey}>
        ${shown.map(
          (icon, i) => html`<button
            aria-label=${wordsOf(icon)}
            title=${wordsOf(icon)}
            aria-pressed=${wordsOf(icon) === this.taken}
            tabindex=${i === Math.min(this.current, shown.length - 1) ? 0 : -1}
            @focus=${() => (this.current = i)}
            @click=${() => this.take(icon)}
          >
            <svg viewBox="0 0 24 24" aria-hidden="true">${icon.shapes.map(drawn)}</svg>
          </button>`,
        )}
      </div>
      ${rest > 0 ? html`<button class="rest small" @click=${this.more}>${msg(str`Show ${Math.min(PAGE, rest)} more of ${rest}`)}</button>` : nothing}
    `;
  }

  private more(): void {
    this.wanted += PAGE;
    this.shown += BATCH;
  }

  private take(icon: ShelfIcon): void {
    const detail: TakenIcon = { name: wordsOf(icon), ink: this.shelf!.iconInk(icon, this.strokeWidth) };
    this.last = icon;
    this.dispatchEvent(new CustomEvent<TakenIcon>("take", { detail }));
  }

  private setWidth(event: InputEvent): void {
    this.strokeWidth = Number((event.target as HTMLInputElement).value);
  }

  /** The icon that is on the sheet takes the new width when the slider is let go. */
  private takeAgain(): void {
    if (this.last && wordsOf(this.last) === this.taken) this.take(this.last);
  }

  private searchKey(event: KeyboardEvent): void {
    if (event.key === "ArrowDown") {
      event.preventDefault();
      this.grid?.querySelector<HTMLElement>("[tabindex='0']")?.focus();
    } else if (event.key === "Enter" && this.search.trim() && this.found[0]) {
      event.preventDefault();
      this.take(this.found[0]);
    } else if (event.key === "Escape" && this.search) {
      event.preventDefault();
      event.stopPropagation();
      this.search = "";
    }
  }

  private gridKey(event: KeyboardEvent): void {
    const buttons = [...this.grid!.querySelectorAll<HTMLElement>("button")];
    const columns = buttons.filter((button) => button.offsetTop === buttons[0]!.offsetTop).length;
    const forward = getComputedStyle(this).direction === "rtl" ? -1 : 1;
    const last = buttons.length - 1;
    const to = {
      ArrowRight: this.current + forward,
      ArrowLeft: this.current - forward,
      ArrowDown: this.current + columns,
      ArrowUp: this.current - columns,
      Home: 0,
      End: last,
    }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if (to < 0 && event.key === "ArrowUp") this.renderRoot.querySelector<HTMLElement>(".search input")!.focus();
    else buttons[Math.min(last, Math.max(0, to))]!.focus();
  }
}

const wordsOf = ({ name }: ShelfIcon): string => name.replaceAll("-", " ");

/** The named icons, then all others as they come. */
function startingWith(all: readonly ShelfIcon[], names: readonly string[]): readonly ShelfIcon[] {
  const first = names.flatMap((name) => all.find((icon) => icon.name === name) ?? []);
  return [...first, ...all.filter((icon) => !first.includes(icon))];
}

function drawn([kind, a]: Shape) {
  const fill = a["fill"] ?? "none";
  switch (kind) {
    case "path":
      return svg`<path d=${a["d"]} fill=${fill} />`;
    case "circle":
      return svg`<circle cx=${a["cx"]} cy=${a["cy"]} r=${a["r"]} fill=${fill} />`;
    case "ellipse":
      return svg`<ellipse cx=${a["cx"]} cy=${a["cy"]} rx=${a["rx"]} ry=${a["ry"]} fill=${fill} />`;
    case "line":
      return svg`<line x1=${a["x1"]} y1=${a["y1"]} x2=${a["x2"]} y2=${a["y2"]} />`;
    case "rect":
      return svg`<rect x=${a["x"]} y=${a["y"]} width=${a["width"]} height=${a["height"]} rx=${a["rx"] ?? a["ry"] ?? 0} fill=${fill} />`;
    case "polyline":
      return svg`<polyline points=${a["points"]} fill=${fill} />`;
    case "polygon":
      return svg`<polygon points=${a["points"]} fill=${fill} />`;
    default:
      return nothing;
  }
}
