import { msg, str } from "@lit/localize";
import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Ink } from "../../../engine/protocol";
import { givenFor, passingOf } from "../../../state/contract/state";
import { SLOTS, type Slot } from "../given";
import { movedBy } from "../arrangement";
import { multiview } from "../task";
import { compose, PAPER_PX, withStroke, type Paper, type PictureLayer } from "../paper";
import { deskOf, type Studio, type StudioState } from "../../../state/studio";
import { percent } from "../../../words/numbers";
import { Part } from "../../../view/part";
import { icons } from "../../../ui/shared/icons";
import "./ink-canvas";
import type { Pen } from "./ink-canvas";
import { chosenFile, Landing, problemOver } from "../../../ui/shared/drop";
import { padStyle } from "../../../ui/shared/pad-style";
import { controls } from "../../../ui/shared/shared";
import { viewWords } from "../../../view/heading";
import { localeTag } from "../../../words/language";
import { drawingPadStyle } from "./drawing-pad-style";

export type EditorTab = "draw" | "type" | "icons" | "picture";

export interface EditRequest {
  readonly slot: Slot;
  readonly tab: EditorTab;
}

export const FIRST_PEN: Pen = { erase: false, widthPx: 16 };
/** From here on all of the ink counts as shown. */
export const AS_GOOD_AS_ALL = 0.985;

export const titled = (slot: Slot): string => viewWords(slot).charAt(0).toLocaleUpperCase(localeTag()) + viewWords(slot).slice(1);

/** The paper's ink as an image. */
export const inkOf = (paper: Paper): Ink => ({ width: PAPER_PX, height: PAPER_PX, ink: compose(paper) });

export const pictureIn = (paper: Paper | null): PictureLayer | undefined =>
  paper?.layers.find((layer): layer is PictureLayer => layer.kind === "picture");

/**
 * One view's drawing: the ink as the optimiser sees it, to be drawn on at once with mouse or pen. Fires `open-editor`
 * (an EditRequest) when somebody wants the large sheet.
 */
@customElement("drawing-pad")
export class DrawingPad extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @property() slotName: Slot = "front";
  private readonly landing = new Landing(this, { isLocked: () => this.locked, give: (file) => this.give(file) });
  /** The problem somebody has read and closed. */
  @state() private readProblem = "";
  @query("input") private input!: HTMLInputElement;
  @query(".menu") private menu!: HTMLElement;
  @query(".opener") private opener!: HTMLElement;

  static override styles = [controls, problemOver, padStyle, drawingPadStyle];

  private get paper(): Paper | null {
    return givenFor(this.state, multiview)[this.slotName];
  }

  /** What pulls the wire here, drawing or not. */
  private get word(): string {
    return deskOf(this.state.doc, multiview.name).guide?.words[this.slotName] ?? "";
  }

  private get locked(): boolean {
    return this.state.phase !== "idle";
  }

  override render() {
    const { state, slotName, paper, locked } = this;
    const { pads, preview: previewed } = passingOf(state, multiview);
    const { busy, problem } = pads[slotName];
    const preview = paper ? previewed?.drawings[slotName] : undefined;
    const moved = [preview ? movedBy(slotName, preview) : "", paper && this.word ? msg(str`pulled by “${this.word}”`) : ""].filter(Boolean).join(", ");
    const name = titled(slotName);
    return html`
      <section
        class="${this.landing.over ? "over" : ""} ${busy ? "busy" : ""} ${locked ? "locked" : ""}"
        aria-label=${msg(str`${name} drawing`)}
        aria-busy=${busy}
        @dragover=${this.landing.dragOver}
        @dragleave=${this.landing.dragLeave}
        @drop=${this.landing.drop}
      >
        <div class="head">
          <h2>${name}</h2>
          <span class="aside small quiet" title=${moved || nothing}>${moved}</span>
          <button
            class="opener plain square"
            aria-label=${msg(str`More for the ${slotName} drawing`)}
            title=${msg("More")}
            aria-haspopup="menu"
            ?disabled=${locked}
            @click=${this.openMenu}
          >
            ${icons.ellipsis}
          </button>
        </div>
        <div class="row">
          <div class="sheet" @click=${this.tapped}>
            <ink-canvas
              class="shown"
              .ink=${preview?.seen ?? (paper ? inkOf(paper) : null)}
              .missing=${preview?.missing ?? null}
              .pen=${locked || busy ? null : FIRST_PEN}
              name=${this.described(preview?.coverable)}
              @stroke=${this.drawn}
            ></ink-canvas>
            ${paper || busy ? nothing : this.invitation()}
            ${problem && problem !== this.readProblem
              ? html`<p class="problem small" role="alert">
                  <button class="plain square" aria-label=${msg("Close this message")} @click=${() => (this.readProblem = problem)}>${icons.close}</button>${problem}
                </p>`
              : nothing}
          </div>
          <div class="tools" role="group" aria-label=${msg(str`Tools for the ${slotName} drawing`)}>
            ${this.tool(msg("Draw"), icons.pencil, () => this.edit("draw"))} ${this.tool(msg("Type a word or an emoji"), icons.type, () => this.edit("type"))}
            ${this.tool(msg("Take an icon"), icons.shapes, () => this.edit("icons"))} ${this.tool(msg("Choose a picture"), icons.picture, () => this.input.click())}
          </div>
        </div>
        <p class="line small quiet">${this.line(preview?.coverable)}</p>
        <div class="menu small" role="menu" aria-label=${msg(str`More for the ${slotName} drawing`)} popover @keydown=${this.menuKey} @click=${this.closeMenu}>
          ${this.menuItems()}
        </div>
        <input type="file" accept="image/*" hidden tabindex="-1" @change=${this.chosen} />
      </section>
    `;
  }

  private tool(words: string, icon: unknown, act: () => void) {
    return html`<button class="plain square" aria-label="${words}, ${viewWords(this.slotName)}" title=${words} ?disabled=${this.locked} @click=${act}>${icon}</button>`;
  }

  private invitation() {
    const { word } = this;
    if (word && !this.landing.over) return html`<div class="invitation small">${icons.type}<span>${msg(str`“${word}” pulls here`)}</span></div>`;
    const words = this.landing.over
      ? msg("Drop it here")
      : html`<span class="long">${msg("Draw here, or drop a picture")}</span><span class="short">${msg("Draw")}</span>`;
    return html`<div class="invitation small">${icons.pencil}${words}</div>`;
  }

  /** One line, always there: nothing jumps when it is filled. */
  private line(coverable: number | undefined) {
    const { busy, note } = passingOf(this.state, multiview).pads[this.slotName];
    if (busy) return html`<span>${msg("Reading…")}</span>`;
    if (coverable !== undefined && coverable < AS_GOOD_AS_ALL) {
      return html`<i class="hatch"></i><span><b>${percent(coverable)}</b> <span class="more">${msg("of it can be")} </span>${msg("shown")}</span>`;
    }
    if (note) return html`<span title=${note}>${note}</span>`;
    return html`<span>${coverable === undefined ? (this.paper?.label ?? "") : msg("All can be shown")}</span>`;
  }

  private described(coverable: number | undefined): string {
    const { paper, slotName } = this;
    if (!paper) return `${titled(slotName)}: ${this.word ? msg(str`no drawing, “${this.word}” pulls the wire`) : msg("empty sheet")}`;
    return `${titled(slotName)}: ${paper.label}${coverable === undefined ? "" : msg(str`, ${percent(coverable)} of it can be shown`)}`;
  }

  private menuItems() {
    const { studio, slotName, paper, state } = this;
    const pads = studio.taker(multiview);
    const picture = pictureIn(paper);
    const item = (words: string, icon: unknown, act: () => void, off = !paper) =>
      html`<button role="menuitem" tabindex="-1" ?disabled=${off} @click=${act}>${icon}<span>${words}</span></button>`;
    const invert = (): void => {
      const dark = picture!.found.polarity === "dark";
      void pads.reread(slotName, { ...picture!.reading, ink: dark ? "light" : "dark" });
    };
    return html`
      ${item(msg("Draw, type or take an icon"), icons.pencil, () => this.edit("draw"), false)}
      ${item(msg("Choose a picture"), icons.picture, () => this.input.click(), false)}
      <hr role="separator" />
      ${item(msg("Mirror"), icons.mirror, () => pads.mirror(slotName))} ${item(msg("Turn left"), icons.turnLeft, () => pads.turn(slotName, 1))}
      ${item(msg("Turn right"), icons.turnRight, () => pads.turn(slotName, 3))}
      ${SLOTS.filter((other) => other !== slotName).map((other) =>
        item(msg(str`Swap with ${other}`), icons.swap, () => pads.swap(slotName, other), !paper && !givenFor(state, multiview)[other]),
      )}
      ${picture
        ? html`<hr role="separator" />
            ${item(msg("Swap ink and ground"), icons.invert, invert)} ${item(msg("Set how dark ink is"), icons.settings, () => this.edit("picture"))}`
        : nothing}
      <hr role="separator" />
      ${item(msg("Clear"), icons.clear, () => pads.clearPad(slotName), !paper && !this.word)}
    `;
  }

  private edit(tab: EditorTab): void {
    if (this.locked) return;
    this.dispatchEvent(new CustomEvent<EditRequest>("open-editor", { detail: { slot: this.slotName, tab }, bubbles: true, composed: true }));
  }

  /** A finger is too thick for a small sheet: it gets the large one. */
  private tapped(event: MouseEvent): void {
    const onButton = event.composedPath().some((target) => target instanceof HTMLButtonElement);
    if (!onButton && event instanceof PointerEvent && event.pointerType === "touch") this.edit("draw");
  }

  private drawn(event: CustomEvent<Float32Array<ArrayBuffer>>): void {
    this.studio.taker(multiview).set(this.slotName, withStroke(this.paper, { ...FIRST_PEN, points: event.detail }), msg("Draw a stroke"));
  }

  private give(file: File | undefined): void {
    if (file && !this.locked) void this.studio.taker(multiview).give(this.slotName, file, file.name || msg("The picture"));
  }

  private chosen(event: Event): void {
    this.give(chosenFile(event));
  }

  private openMenu(): void {
    const { menu, opener } = this;
    menu.showPopover();
    const around = opener.getBoundingClientRect();
    const { width, height } = menu.getBoundingClientRect();
    const left = getComputedStyle(this).direction === "rtl" ? around.left : around.right - width;
    const below = around.bottom + 4;
    const top = below + height <= innerHeight - 8 ? below : Math.max(8, innerHeight - 8 - height);
    menu.style.setProperty("left", `${Math.min(innerWidth - width - 8, Math.max(8, left))}px`);
    menu.style.setProperty("top", `${top}px`);
    this.menuButtons()[0]?.focus();
  }

  private closeMenu(): void {
    this.menu.hidePopover();
    this.opener.focus();
  }

  private menuButtons(): readonly HTMLButtonElement[] {
    return [...this.menu.querySelectorAll<HTMLButtonElement>("button:not(:disabled)")];
  }

  private menuKey(event: KeyboardEvent): void {
    const buttons = this.menuButtons();
    const at = buttons.indexOf(this.shadowRoot!.activeElement as HTMLButtonElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
    if (event.key === "Tab") this.closeMenu();
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    buttons.at(to % buttons.length)?.focus();
  }
}
