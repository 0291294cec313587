import { msg, str } from "@lit/localize";
import { html, LitElement, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { LookName } from "#sculpture/scene/looks";
import type { Studio } from "../../state/studio";
import { viewWords } from "../../view/heading";
import { icons } from "../shared/icons";
import { segmented, segmentedStyle } from "../shared/segmented";
import { controls } from "../shared/shared";
import { copied } from "./copied";
import { download } from "./download";
import { defineElement, siteFolder } from "./element-module";
import { embedPanelStyle } from "./embed-panel-style";
import { elementSnippet, iframeSnippet, isMetal, svgSnippet, type Showing, type Size } from "./snippets";

const KINDS = { element: msg("Element"), iframe: msg("Iframe"), svg: "SVG", html: msg("One file") } as const;
type Kind = keyof typeof KINDS;
const ABOUT: Readonly<Record<Kind, string>> = {
  element: msg("A script and a tag. It can be styled and driven by your page."),
  iframe: msg("For blogs and course pages that take no script."),
  svg: msg("A still picture, sharp at any size. Save it beside your page."),
  html: msg("The whole page as one HTML file: upload it anywhere, or open it from a disk."),
};

const LOOKS: Readonly<Record<LookName, string>> = { copper: msg("Copper"), steel: msg("Steel"), parameter: msg("Along it"), width: msg("By width") };
const SIZES: Readonly<Record<string, Size & { readonly words: string }>> = {
  fluid: { words: msg("Full width"), width: null, height: 480 },
  medium: { words: "640 × 480", width: 640, height: 480 },
  square: { words: "360 × 360", width: 360, height: 360 },
};
/** A metal's own colour, where somebody begins to choose one. */
const FIRST_COLOUR = "#b87333";

/** The wire as a piece of somebody's own page: how it is to look, and what to paste. */
@customElement("embed-panel")
export class EmbedPanel extends LitElement {
  @property({ attribute: false }) studio!: Studio;
  @property() code = "";
  @property() alt = "";
  /** Of its files' names. */
  @property() stem = "";
  @property({ attribute: false }) views: readonly string[] = [];
  /** Makes the one file. */
  @property({ attribute: false }) page!: () => Promise<Blob>;
  @state() private kind: Kind = "element";
  @state() private size = "fluid";
  @state() private view = "";
  @state() private ready: boolean | null = null;
  @state() private busy = false;
  @state() private copiedKind: Kind | null = null;
  @state() private showing: Omit<Showing, "size"> = { look: "copper", color: null, room: true, turning: false, buttons: true };
  @query("pre code") private shown!: HTMLElement | null;

  static override styles = [controls, segmentedStyle, embedPanelStyle];

  override connectedCallback(): void {
    super.connectedCallback();
    defineElement().then(
      () => (this.ready = true),
      () => (this.ready = false),
    );
  }

  override render() {
    return html`
      <div class="look">${this.preview()} ${this.choices()}</div>
      <div class="take">
        ${segmented({
          legend: msg("As"),
          name: "kind",
          options: Object.entries(KINDS).map(([value, words]) => ({ value, words })),
          value: this.kind,
          choose: (kind) => {
            this.kind = kind as Kind;
            this.copiedKind = null;
          },
        })}
        <p class="small quiet">${ABOUT[this.kind]} <a href="./docs.html" target="_blank">${msg("All that it can do")}</a></p>
        ${this.taking()}
      </div>
    `;
  }

  private preview() {
    if (this.ready === false) return html`<p class="preview quiet">${msg("The preview could not be loaded. The snippets are right all the same.")}</p>`;
    const { look, color, room, turning, buttons } = this.showing;
    return html`<div class="preview">
      ${this.ready
        ? html`<wire-sculpture
            class=${this.size}
            code=${this.code}
            alt=${this.alt}
            look=${look}
            color=${color !== null && isMetal(look) ? color : nothing}
            ?shadow=${room}
            ?auto-rotate=${turning}
            views=${buttons ? "" : nothing}
            camera-controls
          ></wire-sculpture>`
        : nothing}
    </div>`;
  }

  private choices() {
    const { look, color, room, turning, buttons } = this.showing;
    return html`<div class="choices">
      ${segmented({
        legend: msg("Look"),
        name: "look",
        options: Object.entries(LOOKS).map(([value, words]) => ({ value, words })),
        value: look,
        choose: (look) => this.change({ look: look as LookName }),
      })}
      ${isMetal(look)
        ? html`<div class="colour">
            <label><input type="checkbox" .checked=${color !== null} @change=${() => this.change({ color: color === null ? FIRST_COLOUR : null })} /> ${msg("A colour of its own")}</label>
            ${color === null ? nothing : html`<input type="color" aria-label=${msg("Colour of the wire")} .value=${color} @input=${(event: Event) => this.change({ color: (event.target as HTMLInputElement).value })} />`}
          </div>`
        : nothing}
      ${segmented({
        legend: msg("Size"),
        name: "size",
        options: Object.entries(SIZES).map(([value, { words }]) => ({ value, words })),
        value: this.size,
        choose: (size) => (this.size = size),
      })}
      <label><input type="checkbox" .checked=${room} @change=${() => this.change({ room: !room })} /> ${msg("Room with the shadows")}</label>
      <label><input type="checkbox" .checked=${turning} @change=${() => this.change({ turning: !turning })} /> ${msg("Turns by itself")}</label>
      <label><input type="checkbox" .checked=${buttons} @change=${() => this.change({ buttons: !buttons })} /> ${msg("Buttons for its views")}</label>
    </div>`;
  }

  private taking() {
    if (this.kind === "html") return html`<button class="primary" ?disabled=${this.busy} @click=${() => void this.save(this.page, ".html")}>${icons.download} ${msg("Save the HTML file")}</button>`;
    const done = this.copiedKind === this.kind;
    return html`
      <pre tabindex="0" aria-label=${msg("Snippet")}><code>${this.snippet}</code></pre>
      <div class="pair">
        <button class="primary" @click=${() => void this.copy()}>${done ? icons.check : icons.link} ${done ? msg("Copied") : msg("Copy snippet")}</button>
        ${this.kind === "svg"
          ? html`<button ?disabled=${this.busy} @click=${() => void this.save(() => this.studio.saver.export("svg", this.seen), this.ending)}>${icons.download} ${msg("Save the SVG")}</button>
              <label class="of">${msg("of")} <select aria-label=${msg("View of the picture")} @change=${(event: Event) => (this.view = (event.target as HTMLSelectElement).value)}>
                ${this.views.map((name) => html`<option value=${name} .selected=${name === this.seen}>${viewWords(name)}</option>`)}
              </select></label>`
          : nothing}
      </div>
    `;
  }

  private get snippet(): string {
    const size = SIZES[this.size]!;
    const embedded = { site: siteFolder(), code: this.code, alt: this.alt, showing: { ...this.showing, size } };
    if (this.kind === "element") return elementSnippet(embedded);
    if (this.kind === "iframe") return iframeSnippet(embedded);
    return svgSnippet(this.stem + this.ending, this.alt, size);
  }

  private get seen(): string {
    return this.views.includes(this.view) ? this.view : (this.views[0] ?? "front");
  }

  private get ending(): string {
    return `-${this.seen.replace(/[^\w-]+/g, "-")}.svg`;
  }

  private change(change: Partial<Showing>): void {
    this.showing = { ...this.showing, ...change };
    this.copiedKind = null;
  }

  private async copy(): Promise<void> {
    const done = await copied(this.snippet, this.shown!);
    this.copiedKind = done ? this.kind : null;
    this.tell(done ? msg("Snippet copied") : msg("Copy the marked snippet with Ctrl or ⌘ and C"));
  }

  private async save(make: () => Promise<Blob | null>, ending: string): Promise<void> {
    this.busy = true;
    try {
      const blob = await make();
      if (blob) download(blob, this.stem + ending);
      this.tell(blob ? msg(str`Saved ${this.stem}${ending}`) : msg("The file could not be made."));
    } catch (error) {
      console.error(error);
      this.tell(msg("The file could not be made. Check the connection and try again."));
    }
    this.busy = false;
  }

  private tell(detail: string): void {
    this.dispatchEvent(new CustomEvent("done", { detail }));
  }
}
