import { msg, str } from "@lit/localize";
import { html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { redo, undo } from "../../../state/actions/actions";
import { givenFor, passingOf } from "../../../state/contract/state";
import type { Slot } from "../given";
import type { Pads } from "../pads";
import type { Reading } from "../protocol";
import { movedBy } from "../arrangement";
import { multiview } from "../task";
import { withStamp, withStroke, type Paper, type StampLayer } from "../paper";
import type { Studio, StudioState } from "../../../state/studio";
import { FONTS, MOST_LETTERS, write, type Font, type Lettering } from "./drawing/word";
import { NARROW } from "../../../ui/shared/narrow";
import { FIRST_PEN, inkOf, pictureIn, titled, type EditorTab } from "./drawing-pad";
import { sheetAndTools } from "../../../ui/shared/editor-style";
import "./icon-shelf";
import "./word-pull";
import type { TakenIcon } from "./icon-shelf";
import { chosenFile } from "../../../ui/shared/drop";
import { icons } from "../../../ui/shared/icons";
import "./ink-canvas";
import type { Pen } from "./ink-canvas";
import { segmented, segmentedStyle } from "../../../ui/shared/segmented";
import { controls } from "../../../ui/shared/shared";
import { walkTabs } from "../../../ui/shared/tablist";

const TABS: readonly { readonly tab: EditorTab; readonly words: string; readonly icon: TemplateResult }[] = [
  { tab: "draw", words: msg("Draw"), icon: icons.pencil },
  { tab: "type", words: msg("Type"), icon: icons.type },
  { tab: "icons", words: msg("Icons"), icon: icons.shapes },
  { tab: "picture", words: msg("Picture"), icon: icons.picture },
];
const WIDTH_PX = { least: 4, most: 64 };
/** A word is written, and a picture read again, when fingers have rested this long. */
const REST_MS = 120;

/** One drawing, large: over the stage on a desk, over everything on a phone. Fires `close-editor`. */
@customElement("pad-editor")
export class PadEditor extends LitElement {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @property({ attribute: false }) override slot: Slot = "front";
  @property({ attribute: false }) tab: EditorTab | undefined = "draw";
  @state() private pen: Pen = FIRST_PEN;
  @state() private asSeen = false;
  @state() private over = false;
  @state() private text = "";
  @state() private lettering: Lettering = { font: "round", bold: true };
  @state() private unknown: readonly string[] = [];
  /** For which icons are looked. */
  @state() private sought = "";
  /** What is typed, not yet on the sheet. */
  @state() private stamp: Omit<StampLayer, "kind"> | null = null;
  /** Whether what is typed is not on the sheet as it is typed now. */
  private pending = false;
  /** Where the slider is, while the picture is not read again yet. */
  @state() private reading: Reading | null = null;
  @query("dialog") private dialog!: HTMLDialogElement;
  @query("#file") private file!: HTMLInputElement;
  @query("#camera") private camera!: HTMLInputElement;
  private draft: Paper | null = null;
  private draftOf: readonly [Paper | null, unknown] = [null, null];
  private resting: ReturnType<typeof setTimeout> | undefined;
  private readonly narrow = matchMedia(NARROW);

  static override styles = [controls, segmentedStyle, sheetAndTools];

  private get paper(): Paper | null {
    return givenFor(this.state, multiview)[this.slot];
  }

  private get pads(): Pads {
    return this.studio.taker(multiview);
  }

  private get locked(): boolean {
    return this.state.phase !== "idle";
  }

  private get shownTab(): EditorTab {
    return this.tab ?? "draw";
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.narrow.addEventListener("change", this.show);
    if (this.hasUpdated) this.show();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.narrow.removeEventListener("change", this.show);
    clearTimeout(this.resting);
  }

  protected override firstUpdated(): void {
    this.show();
    const field = this.renderRoot.querySelector<HTMLElement>("#text");
    (field ?? this.renderRoot.querySelector<HTMLElement>("[role=tab][aria-selected=true]"))?.focus();
  }

  /** A phone has room for nothing else; on a desk all the rest stays at hand. */
  private readonly show = (): void => {
    if (this.dialog.open) this.dialog.close();
    if (this.narrow.matches) this.dialog.showModal();
    else this.dialog.show();
  };

  protected override willUpdate(changed: PropertyValues): void {
    const { paper, stamp } = this;
    if (changed.has("slot") && changed.get("slot") !== undefined) this.forget();
    if (this.draftOf[0] !== paper || this.draftOf[1] !== stamp) {
      this.draftOf = [paper, stamp];
      this.draft = this.stamp ? withStamp(paper, this.stamp) : paper;
    }
  }

  override render() {
    const { state, slot, locked, draft } = this;
    const preview = this.paper && !this.stamp ? passingOf(state, multiview).preview?.drawings[slot] : undefined;
    const seen = this.asSeen ? preview : undefined;
    const drawing = this.shownTab === "draw" && !locked && !seen;
    const nothingToErase = this.pen.erase && !this.paper;
    return html`<dialog
      aria-labelledby="title"
      @cancel=${this.escape}
      @keydown=${this.key}
      @paste=${this.paste}
      @dragover=${this.dragOver}
      @dragleave=${() => (this.over = false)}
      @drop=${this.drop}
    >
      <div class="all ${this.over ? "over" : ""}">
        <header>
          <h2 id="title">${msg(str`${titled(slot)} drawing`)}</h2>
          <span class="moved small quiet">${preview ? movedBy(slot, preview) : ""}</span>
          ${this.step(msg("Undo"), icons.undo, state.undo, () => this.studio.act(undo))} ${this.step(msg("Redo"), icons.redo, state.redo, () => this.studio.act(redo))}
          <button class="primary" @click=${this.done}>${msg("Done")}</button>
        </header>
        <div class="body ${this.shownTab}">
          <div class="room">
            <div class="sheet">
              <ink-canvas
                .ink=${seen?.seen ?? (draft ? inkOf(draft) : null)}
                .missing=${seen?.missing ?? null}
                .pen=${drawing && !nothingToErase ? this.pen : null}
                fingers
                keys
                name="${titled(slot)} sheet"
                @stroke=${this.drawn}
              ></ink-canvas>
              ${draft || !drawing ? nothing : html`<p class="hint">${nothingToErase ? msg("Nothing to erase yet") : msg("Draw here")}</p>`}
            </div>
          </div>
          <div class="side" ?inert=${locked}>
            ${this.tabs()}
            <div class="panel" id="panel" role="tabpanel" aria-labelledby="tab-${this.shownTab}">${this.panel()}</div>
          </div>
        </div>
      </div>
      <input id="file" type="file" accept="image/*" hidden @change=${this.chosen} />
      <input id="camera" type="file" accept="image/*" capture="environment" hidden @change=${this.chosen} />
    </dialog>`;
  }

  protected override updated(): void {
    // The dot is as wide as the pen is on the sheet.
    const dot = this.renderRoot.querySelector<HTMLElement>(".penwidth i");
    const sheet = this.renderRoot.querySelector(".sheet")!.clientWidth;
    dot?.style.setProperty("--width", `${(this.pen.widthPx * sheet) / 512}px`);
  }

  private step(words: string, icon: TemplateResult, label: string | null, act: () => void) {
    const full = label ? `${words}: ${label}` : words;
    return html`<button class="plain square" aria-label=${full} title=${full} ?disabled=${!label || this.locked} @click=${act}>${icon}</button>`;
  }

  private tabs() {
    return html`<div class="tabs" role="tablist" aria-label=${msg("Ways to make a drawing")} data-keys @keydown=${this.tabKey}>
      ${TABS.map(
        ({ tab, words, icon }) => html`<button
          role="tab"
          id="tab-${tab}"
          aria-selected=${tab === this.shownTab}
          aria-controls="panel"
          tabindex=${tab === this.shownTab ? 0 : -1}
          @click=${() => this.turnTo(tab)}
        >
          ${icon}${words}
        </button>`,
      )}
    </div>`;
  }

  private panel() {
    switch (this.shownTab) {
      case "draw":
        return this.drawPanel();
      case "type":
        return this.typePanel();
      case "icons":
        return html`<icon-shelf
          .taken=${this.paper?.layers.find(({ kind }) => kind === "stamp") ? this.paper.label : ""}
          @take=${this.takeIcon}
          @seek=${({ detail }: CustomEvent<string>) => (this.sought = detail)}
        >
          <word-pull .studio=${this.studio} .state=${this.state} .pad=${this.slot} .typed=${this.sought}></word-pull>
        </icon-shelf>`;
      case "picture":
        return this.picturePanel();
    }
  }

  private drawPanel() {
    const { pen } = this;
    const preview = passingOf(this.state, multiview).preview?.drawings[this.slot];
    const setWidth = (event: Event): void => {
      const value = (event.target as HTMLInputElement).valueAsNumber;
      if (value >= WIDTH_PX.least && value <= WIDTH_PX.most) this.pen = { ...pen, widthPx: value };
    };
    return html`
      ${segmented({
        legend: msg("Tool"),
        name: "tool",
        options: [
          { value: "pen", words: msg("Pen") },
          { value: "eraser", words: msg("Eraser") },
        ],
        value: pen.erase ? "eraser" : "pen",
        choose: (tool) => (this.pen = { ...pen, erase: tool === "eraser" }),
      })}
      <div class="field">
        <span id="width-label">${msg("Width, of a sheet 512 wide")}</span>
        <div class="amount">
          <input type="range" aria-labelledby="width-label" min=${WIDTH_PX.least} max=${WIDTH_PX.most} .value=${String(pen.widthPx)} @input=${setWidth} />
          <input type="number" aria-labelledby="width-label" min=${WIDTH_PX.least} max=${WIDTH_PX.most} .value=${String(pen.widthPx)} @change=${setWidth} />
        </div>
      </div>
      <div class="penwidth ${pen.erase ? "erase" : ""}" aria-hidden="true"><i></i></div>
      <label class="check">
        <input
          type="checkbox"
          ?disabled=${!preview}
          .checked=${this.asSeen && !!preview}
          @change=${(event: Event) => (this.asSeen = (event.target as HTMLInputElement).checked)}
        />
        ${msg("Show as the wire sees it")}
      </label>
      <button ?disabled=${!this.paper} @click=${() => this.pads.clearPad(this.slot)}>${icons.clear} ${msg("Clear the sheet")}</button>
      <p class="small quiet fine">${msg("With keys:")} <kbd>${msg("Tab")}</kbd> ${msg("to the sheet, arrows move,")} <kbd>${msg("Space")}</kbd> ${msg("puts the pen down and lifts it.")}</p>
    `;
  }

  private typePanel() {
    const { font, bold } = this.lettering;
    return html`
      <label class="field">
        <span>${msg("A word, some letters or an emoji")}</span>
        <input
          id="text"
          type="text"
          dir="auto"
          maxlength=${MOST_LETTERS}
          autocomplete="off"
          enterkeyhint="done"
          .value=${this.text}
          @input=${(event: InputEvent) => this.type((event.target as HTMLInputElement).value)}
          @keydown=${(event: KeyboardEvent) => event.key === "Enter" && !event.isComposing && void this.keepWord()}
        />
      </label>
      <label class="field">
        <span>${msg("Letters")}</span>
        <select
          @change=${(event: Event) => this.letter({ font: (event.target as HTMLSelectElement).value as Font })}
        >
          ${Object.entries(FONTS).map(([name, { label }]) => html`<option value=${name} .selected=${name === font}>${label}</option>`)}
        </select>
      </label>
      ${segmented({
        legend: msg("Weight"),
        name: "weight",
        options: [
          { value: "regular", words: msg("Regular") },
          { value: "bold", words: msg("Bold") },
        ],
        value: bold ? "bold" : "regular",
        choose: (weight) => this.letter({ bold: weight === "bold" }),
      })}
      <button class="primary" ?disabled=${!this.stamp} @click=${this.keepWord}>${icons.check} ${msg("Put on the sheet")}</button>
      <p class="small status ${this.unknown.length ? "problem" : "quiet"}" role="status">${this.aboutWord()}</p>
    `;
  }

  private aboutWord(): string {
    const { unknown, text, stamp } = this;
    if (unknown.length > 0) return msg(str`This device has no letters for ${unknown.slice(0, 5).join(" ")}. Try another word, or draw it.`);
    if (stamp) return msg("Not on the sheet yet. Enter puts it there.");
    return text.trim() ? "" : msg("Short words make the best wires. Emoji become line drawings.");
  }

  private picturePanel() {
    const layer = pictureIn(this.paper);
    const { busy, problem, note } = passingOf(this.state, multiview).pads[this.slot];
    const reading = this.reading ?? layer?.reading;
    const percentage = Math.round(100 * (reading?.threshold ?? 0));
    const setThreshold = (event: Event): void => {
      const value = (event.target as HTMLInputElement).valueAsNumber;
      if (reading && value >= 0 && value <= 100) this.reread({ ...reading, threshold: value / 100 });
    };
    return html`
      <button class=${layer ? "" : "primary"} @click=${() => this.file.click()}>${icons.picture} ${layer ? msg("Choose another picture") : msg("Choose a picture")}</button>
      <button class="coarse" @click=${() => this.camera.click()}>${icons.camera} ${msg("Take a photo")}</button>
      <p class="small status ${problem ? "problem" : "quiet"}" role=${problem ? "alert" : "status"}>
        ${problem || (busy ? "Reading…" : note || msg("Or drop or paste one here. It stays on this device."))}
      </p>
      ${layer && reading
        ? html`${segmented({
              legend: msg("Ink is"),
              name: "ink",
              options: [
                { value: "auto", words: layer.reading.ink === "auto" ? msg(str`Auto (${layer.found.polarity})`) : msg("Auto") },
                { value: "dark", words: msg("Dark") },
                { value: "light", words: msg("Light") },
              ],
              value: reading.ink,
              choose: (ink) => this.reread({ ...reading, ink: ink as Reading["ink"] }),
            })}
            <div class="field">
              <span id="threshold-label">${msg("Leave out faint ink, up to %")}</span>
              <div class="amount">
                <input type="range" aria-labelledby="threshold-label" min="0" max="100" .value=${String(percentage)} @input=${setThreshold} />
                <input type="number" aria-labelledby="threshold-label" min="0" max="100" .value=${String(percentage)} @change=${setThreshold} />
              </div>
            </div>`
        : nothing}
    `;
  }

  private turnTo(tab: EditorTab): void {
    void this.keepWord();
    this.tab = tab;
  }

  private tabKey(event: KeyboardEvent): void {
    walkTabs(event, TABS.map(({ tab }) => tab), (tab) => this.turnTo(tab));
  }

  private drawn(event: CustomEvent<Float32Array<ArrayBuffer>>): void {
    const { pen, paper } = this;
    this.pads.set(this.slot, withStroke(paper, { ...pen, points: event.detail }), pen.erase ? msg("Erase") : msg("Draw a stroke"));
  }

  private type(text: string): void {
    this.text = text;
    this.pending = true;
    clearTimeout(this.resting);
    this.resting = setTimeout(() => void this.writeWord(), REST_MS);
  }

  private letter(change: Partial<Lettering>): void {
    this.lettering = { ...this.lettering, ...change };
    this.pending = true;
    void this.writeWord();
  }

  private async writeWord(): Promise<void> {
    const { text, lettering } = this;
    if (!text.trim()) {
      this.stamp = null;
      this.unknown = [];
      return;
    }
    const { ink, unknown } = await write(text, lettering);
    if (this.text !== text || this.lettering !== lettering) return;
    this.unknown = unknown;
    this.stamp = unknown.length === 0 ? { label: text.trim(), ink } : null;
  }

  /** Puts on the sheet what is typed, as it is typed now. */
  private async keepWord(): Promise<void> {
    if (!this.pending) return;
    clearTimeout(this.resting);
    const { slot } = this;
    await this.writeWord();
    const { stamp, locked } = this;
    if (stamp && !locked && slot === this.slot) {
      this.pads.set(slot, withStamp(this.paper, stamp), msg(str`Write “${stamp.label}”`));
      this.pending = false;
    }
    this.stamp = null;
  }

  private takeIcon({ detail: { name, ink } }: CustomEvent<TakenIcon>): void {
    this.pads.set(this.slot, withStamp(this.paper, { label: name, ink }), msg(str`Take the icon ${name}`));
  }

  private reread(reading: Reading): void {
    this.reading = reading;
    clearTimeout(this.resting);
    this.resting = setTimeout(async () => {
      await this.pads.reread(this.slot, reading);
      if (this.reading === reading) this.reading = null;
    }, REST_MS);
  }

  private give(file: File | undefined): void {
    if (!file || this.locked) return;
    this.forget();
    this.tab = "picture";
    void this.pads.give(this.slot, file, file.name || msg("The picture"));
  }

  private chosen(event: Event): void {
    this.give(chosenFile(event));
  }

  private paste(event: ClipboardEvent): void {
    const file = [...(event.clipboardData?.files ?? [])].find(({ type }) => type.startsWith("image/"));
    if (!file) return;
    event.preventDefault();
    event.stopPropagation();
    this.give(file);
  }

  private dragOver(event: DragEvent): void {
    if (this.locked || !event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    event.stopPropagation();
    this.over = true;
  }

  private drop(event: DragEvent): void {
    this.over = false;
    if (!event.dataTransfer?.files.length) return;
    event.preventDefault();
    event.stopPropagation();
    this.give(event.dataTransfer.files[0]);
  }

  private key(event: KeyboardEvent): void {
    if (event.key !== "Escape" || event.defaultPrevented) return;
    event.preventDefault();
    event.stopPropagation();
    this.escape();
  }

  /** Leaves without what is typed but not put on the sheet. */
  private escape(event?: Event): void {
    event?.preventDefault();
    this.forget();
    this.close();
  }

  private async done(): Promise<void> {
    await this.keepWord();
    this.close();
  }

  private forget(): void {
    clearTimeout(this.resting);
    this.text = "";
    this.pending = false;
    this.stamp = null;
    this.unknown = [];
    this.reading = null;
  }

  /** Closing gives the focus back to whatever opened it. */
  private close(): void {
    this.dialog.close();
    this.dispatchEvent(new CustomEvent("close-editor", { bubbles: true, composed: true }));
  }
}
