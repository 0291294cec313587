import { msg, str } from "@lit/localize";
import { html, LitElement, nothing, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { remembered } from "../../../state/common/remember";
import { isPointedAt, type Box, type MaskStroke, type Subject } from "../given";
import type { FoundObject } from "../protocol";
import { NARROW } from "../../../ui/shared/narrow";
import { sheetAndTools } from "../../../ui/shared/editor-style";
import { icons } from "../../../ui/shared/icons";
import { segmented, segmentedStyle } from "../../../ui/shared/segmented";
import { controls } from "../../../ui/shared/shared";
import { counted, listed } from "../../../words/numbers";
import "./subject-canvas";
import type { Tool } from "./subject-canvas";
import { tell } from "./subject-events";
import { maskEditorStyle } from "./mask-editor-style";

/** Percent of the picture's longer side. */
const WIDTH = { least: 1, most: 25 };
const FIRST_WIDTH = 6;
/** Of marks: a share of the picture's longer side. */
const MARK_WIDTH = 0.016;

type Choice = "box" | "this" | "not-this" | "fine";
const CHOICES: readonly { readonly value: Choice; readonly words: string; readonly title: string }[] = [
  { value: "box", words: msg("Box"), title: msg("Drag a box round what is meant") },
  { value: "this", words: msg("This"), title: msg("Draw on what is meant (X)") },
  { value: "not-this", words: msg("Not this"), title: msg("Draw on what is not meant (X)") },
  { value: "fine", words: msg("Fine-tune"), title: msg("Paint the object itself with a brush") },
];
const SIDES = [msg("Left"), msg("Top"), msg("Right"), msg("Bottom")] as const;
/** Of the picture, where nobody has dragged a box yet. */
const ALL: Box = [0, 0, 1, 1];
/** Percent between opposite sides of a box. */
const LEAST_SIDE = 1;

/**
 * The picture, large, with all ways to say what of it is meant: a box, marks by which the app finds it, a brush that adds to
 * what it found and takes away from it. Over the stage on a desk, over everything on a phone. Fires `give-box`, `mark`,
 * `clear-marks`, `paint` with the new list at each stroke, `undo`, `redo` and `close-editor`.
 */
@customElement("mask-editor")
export class MaskEditor extends LitElement {
  @property({ attribute: false }) subject!: Subject;
  @property({ type: Boolean }) locked = false;
  @property({ type: Boolean }) busy = false;
  /** What went wrong, a sentence, or empty. */
  @property() problem = "";
  /** What a mark would find that is still being drawn. */
  @property({ attribute: false }) foresee: ((mark: MaskStroke) => Promise<FoundObject | null>) | null = null;
  /** What the next undo takes back and redo brings again; null if there is nothing. */
  @property({ attribute: false }) undo: string | null = null;
  @property({ attribute: false }) redo: string | null = null;
  @state() private choice: Choice = "this";
  @state() private adds = true;
  /** Percent. */
  @state() private width = FIRST_WIDTH;
  @query("dialog") private dialog!: HTMLDialogElement;
  private readonly narrow = matchMedia(NARROW);
  private tool: Tool = { kind: "box" };

  static override styles = [controls, segmentedStyle, sheetAndTools, maskEditorStyle];

  override connectedCallback(): void {
    super.connectedCallback();
    this.narrow.addEventListener("change", this.show);
    if (this.hasUpdated) this.show();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.narrow.removeEventListener("change", this.show);
  }

  protected override firstUpdated(): void {
    this.show();
    this.renderRoot.querySelector<HTMLElement>("input:checked")?.focus();
  }

  /** A phone has room for nothing else; on a desk all the rest stays at hand. */
  private readonly show = (): void => {
    if (this.dialog.open) this.dialog.close();
    if (this.narrow.matches) this.dialog.showModal();
    else this.dialog.show();
  };

  protected override willUpdate(): void {
    // Where nothing is found there is paint.
    if (!this.hasUpdated && !this.subject.found) this.choice = "fine";
    const { choice, adds, width, tool } = this;
    const brush = choice === "fine" ? { adds, width: width / 100 } : { adds: choice === "this", width: MARK_WIDTH };
    const kind = choice === "fine" ? "paint" : choice === "box" ? "box" : "mark";
    const known = "brush" in tool ? tool.brush : null;
    if (tool.kind === kind && (!known || (known.adds === brush.adds && known.width === brush.width))) return;
    this.tool = kind === "box" ? { kind } : { kind, brush };
  }

  override render() {
    const { subject, choice, locked, busy } = this;
    return html`<dialog aria-labelledby="title" @cancel=${this.escape} @keydown=${this.key}>
      <div class="all ${busy ? "busy" : ""}">
        <header>
          <h2 id="title">${msg("Mark")}</h2>
          <span class="moved small quiet">${subject.picture.name}</span>
          ${this.step(msg("Undo"), icons.undo, this.undo, "undo")} ${this.step(msg("Redo"), icons.redo, this.redo, "redo")}
          <button class="primary" @click=${this.close}>${msg("Done")}</button>
        </header>
        <div class="body">
          <div class="room">
            <subject-canvas
              .subject=${subject}
              .tool=${locked || busy ? null : this.tool}
              .foresee=${this.foresee}
              .problem=${this.problem}
              name="Picture to draw on"
              @stroke=${this.drawn}
              @box=${({ detail: box }: CustomEvent<Box>) => tell(this, "give-box", { box })}
            ></subject-canvas>
          </div>
          <div class="side" ?inert=${locked}>
            <div class="panel">
              ${segmented({
                legend: msg("Say it with"),
                name: "tool",
                options: CHOICES,
                value: choice,
                choose: (value) => (this.choice = value as Choice),
              })}
              <div class="of-tool">${choice === "fine" ? this.painting() : choice === "box" ? this.boxing() : this.marking()}</div>
              ${this.problem ? html`<p class="small problem" role="alert">${this.problem}</p>` : nothing}
              <p class="small quiet status" role="status">${this.told()}</p>
              <p class="small quiet fine">
                ${msg("With keys:")} <kbd>${msg("Tab")}</kbd> ${msg("to the picture, arrows move,")} <kbd>${msg("Space")}</kbd> ${msg(str`starts and ends a ${choice === "box" ? "box" : "stroke"}`)}${choice === "box"
                  ? nothing
                  : html`, <kbd>X</kbd> ${msg(str`swaps ${choice === "fine" ? msg("add and remove") : msg("this and not this")}`)}`}${choice === "fine" ? html`, <kbd>[</kbd> <kbd>]</kbd> ${msg("change the size")}` : nothing}.
              </p>
            </div>
          </div>
        </div>
      </div>
    </dialog>`;
  }

  private boxing() {
    const { subject, busy } = this;
    const box = subject.box ?? null;
    return html`<p class="small quiet how">${msg("Drag a box round what is meant, or give its sides in % of the picture.")}</p>
      <div class="sides">
        ${SIDES.map((side, i) => {
          const percent = String(Math.round(100 * (box ?? ALL)[i]!));
          return html`<label class="small quiet">${side}<input type="number" min="0" max="100" ?disabled=${busy} .value=${percent} @change=${(event: Event) => this.setSide(i, event)} /></label>`;
        })}
      </div>
      <button ?disabled=${!box || busy} @click=${() => tell(this, "give-box", { box: null })}>${icons.clear}${msg("Remove the box")}</button>`;
  }

  private marking() {
    const count = this.subject.marks?.length ?? 0;
    const how = this.choice === "this" ? msg("Draw a line on what is meant and not in colour yet.") : msg("Draw a line on what is in colour and not meant.");
    return html`<p class="small quiet how">${msg(str`${how} A short one will do; a tap is a dot.`)}</p>
      <button ?disabled=${count === 0 || this.busy} @click=${() => tell(this, "clear-marks", null)}>${icons.clear}${msg("Clear marks")}</button>`;
  }

  private painting() {
    const { subject, adds, width } = this;
    return html`${segmented({
        legend: msg("The brush"),
        name: "brush",
        options: [
          { value: "add", words: msg("Adds"), title: msg("Paint what belongs to the object (X)") },
          { value: "remove", words: msg("Removes"), title: msg("Paint what does not (X)") },
        ],
        value: adds ? "add" : "remove",
        choose: (value) => (this.adds = value === "add"),
      })}
      <div class="field">
        <label for="width">${msg("Size, % of the picture")}</label>
        <div class="amount">
          <input id="width" type="range" min=${WIDTH.least} max=${WIDTH.most} .value=${String(width)} @input=${this.setWidth} />
          <input type="number" aria-label=${msg("Size, percent of the picture")} min=${WIDTH.least} max=${WIDTH.most} .value=${String(width)} @change=${this.setWidth} />
        </div>
      </div>
      <button ?disabled=${subject.strokes.length === 0} @click=${() => tell(this, "paint", { strokes: [] })}>
        ${icons.reset} ${subject.found ? msg("Use what was found") : msg("Take the strokes away")}
      </button>`;
  }

  private told(): string {
    const { found, strokes, marks, box } = this.subject;
    if (this.busy) return msg("Looking for the object…");
    const painted = counted(strokes.length, msg("1 stroke"), msg(str`${strokes.length} strokes`));
    if (!found) return strokes.length === 0 ? msg("Nothing found. Paint over the object.") : msg(str`${painted}. Nothing was found to begin with.`);
    if (strokes.length > 0) return msg(str`${painted} of the brush over what was found.`);
    if (isPointedAt(this.subject)) {
      const number = marks?.length ?? 0;
      const by = listed([box ? msg("a box") : "", number > 0 ? counted(number, msg("1 mark"), msg(str`${number} marks`)) : ""].filter(Boolean));
      return msg(str`Found, by ${by}. Draw on what is missing or too much.`);
    }
    return found.isSure === false ? msg("Which thing is it? Draw on it, or drag a box round it.") : msg("In colour: what was found. Draw on what is missing or too much.");
  }

  private step(words: string, icon: TemplateResult, label: string | null, kind: "undo" | "redo") {
    const full = label ? `${words}: ${label}` : words;
    const act = (): boolean => this.dispatchEvent(new CustomEvent(kind, { bubbles: true, composed: true }));
    return html`<button class="plain square" aria-label=${full} title=${full} ?disabled=${!label || this.locked} @click=${act}>${icon}</button>`;
  }

  private drawn({ detail }: CustomEvent<MaskStroke>): void {
    if (this.choice === "fine") tell(this, "paint", { strokes: [...this.subject.strokes, detail] });
    else tell(this, "mark", { mark: detail });
  }

  /** One side of the box by its number; the opposite one stays beyond it. */
  private setSide(side: number, event: Event): void {
    const input = event.target as HTMLInputElement;
    const sides = [...(this.subject.box ?? ALL)] as [number, number, number, number];
    const [low, high] = side < 2 ? [0, 100 * sides[side + 2]! - LEAST_SIDE] : [100 * sides[side - 2]! + LEAST_SIDE, 100];
    const percent = Number.isNaN(input.valueAsNumber) ? 100 * sides[side]! : Math.min(high, Math.max(low, input.valueAsNumber));
    input.value = String(Math.round(percent));
    if (percent === 100 * sides[side]!) return;
    sides[side] = percent / 100;
    tell(this, "give-box", { box: sides });
  }

  private setWidth(event: Event): void {
    const { valueAsNumber } = event.target as HTMLInputElement;
    if (valueAsNumber >= WIDTH.least && valueAsNumber <= WIDTH.most) this.width = valueAsNumber;
  }

  private key(event: KeyboardEvent): void {
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
    const inNumber = event.composedPath().some((target) => target instanceof HTMLInputElement && target.type === "number");
    if (event.key === "Escape") this.escape();
    else if (!plain || inNumber || remembered("keys") === "off") return;
    else if (event.key.toLowerCase() === "x" && this.choice !== "box") this.swap();
    else if (this.choice !== "fine") return;
    else if (event.key === "[") this.width = Math.max(WIDTH.least, this.width - 1);
    else if (event.key === "]") this.width = Math.min(WIDTH.most, this.width + 1);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  private swap(): void {
    if (this.choice === "fine") this.adds = !this.adds;
    else this.choice = this.choice === "this" ? "not-this" : "this";
  }

  private escape(event?: Event): void {
    event?.preventDefault();
    this.close();
  }

  /** Closing gives the focus back to whatever opened it. */
  private close(): void {
    this.dialog.close();
    this.dispatchEvent(new CustomEvent("close-editor", { bubbles: true, composed: true }));
  }
}
