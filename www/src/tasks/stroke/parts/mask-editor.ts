import { html, LitElement, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { remembered } from "../../../state/common/remember";
import type { Brush, MaskStroke, Subject } from "../given";
import { NARROW } from "../../../ui/shared/narrow";
import { sheetAndTools } from "../../../ui/shared/editor-style";
import { icons } from "../../../ui/shared/icons";
import { segmented, segmentedStyle } from "../../../ui/shared/segmented";
import { controls } from "../../../ui/shared/shared";
import "./subject-canvas";
import { tell } from "./subject-events";
import { maskEditorStyle } from "./mask-editor-style";

/** Percent of the picture's longer side. */
const WIDTH = { least: 1, most: 25 };
const FIRST_WIDTH = 6;

/**
 * The picture, large, with a brush that adds to its object and takes away from it: over the stage on a desk, over
 * everything on a phone. Fires `paint` with the new list at each stroke, `undo`, `redo` and `close-editor`.
 */
@customElement("mask-editor")
export class MaskEditor extends LitElement {
  @property({ attribute: false }) subject!: Subject;
  @property({ type: Boolean }) locked = false;
  @property({ type: Boolean }) busy = false;
  /** What the next undo takes back and redo brings again; null if there is nothing. */
  @property({ attribute: false }) undo: string | null = null;
  @property({ attribute: false }) redo: string | null = null;
  @state() private adds = true;
  /** Percent. */
  @state() private width = FIRST_WIDTH;
  @query("dialog") private dialog!: HTMLDialogElement;
  private readonly narrow = matchMedia(NARROW);
  private brush: Brush = { adds: true, width: FIRST_WIDTH / 100 };

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
    const { adds, width } = this;
    if (this.brush.adds !== adds || this.brush.width !== width / 100) this.brush = { adds, width: width / 100 };
  }

  override render() {
    const { subject, adds, width, locked, busy } = this;
    const painted = subject.strokes.length;
    return html`<dialog aria-labelledby="title" @cancel=${this.escape} @keydown=${this.key}>
      <div class="all ${busy ? "busy" : ""}">
        <header>
          <h2 id="title">Brush</h2>
          <span class="moved small quiet">${subject.picture.name}</span>
          ${this.step("Undo", icons.undo, this.undo, "undo")} ${this.step("Redo", icons.redo, this.redo, "redo")}
          <button class="primary" @click=${this.close}>Done</button>
        </header>
        <div class="body">
          <div class="room">
            <subject-canvas .subject=${subject} .brush=${locked || busy ? null : this.brush} name="Picture to paint on" @stroke=${this.painted}></subject-canvas>
          </div>
          <div class="side" ?inert=${locked}>
            <div class="panel">
              ${segmented({
                legend: "Strokes",
                name: "brush",
                options: [
                  { value: "add", words: "Add", title: "Paint what belongs to the object (X)" },
                  { value: "remove", words: "Remove", title: "Paint what does not (X)" },
                ],
                value: adds ? "add" : "remove",
                choose: (value) => (this.adds = value === "add"),
              })}
              <div class="field">
                <label for="width">Size, % of the picture</label>
                <div class="amount">
                  <input id="width" type="range" min=${WIDTH.least} max=${WIDTH.most} .value=${String(width)} @input=${this.setWidth} />
                  <input type="number" aria-label="Size, percent of the picture" min=${WIDTH.least} max=${WIDTH.most} .value=${String(width)} @change=${this.setWidth} />
                </div>
              </div>
              <button ?disabled=${painted === 0} @click=${() => tell(this, "paint", { strokes: [] })}>${icons.reset} ${subject.found ? "Use what was found" : "Take the strokes away"}</button>
              <p class="small quiet status" role="status">${this.told(painted)}</p>
              <p class="small quiet fine">
                With keys: <kbd>Tab</kbd> to the picture, arrows move, <kbd>Space</kbd> starts and ends a stroke, <kbd>X</kbd> swaps add and remove,
                <kbd>[</kbd> <kbd>]</kbd> change the size.
              </p>
            </div>
          </div>
        </div>
      </div>
    </dialog>`;
  }

  private told(painted: number): string {
    if (this.busy) return "Looking for the object…";
    if (painted === 0) return this.subject.found ? "In colour: the object as it was found." : "Nothing found. Paint over the object.";
    const strokes = painted === 1 ? "1 stroke" : `${painted} strokes`;
    return this.subject.found ? `${strokes} over what was found.` : `${strokes}. Nothing was found to begin with.`;
  }

  private step(words: string, icon: TemplateResult, label: string | null, kind: "undo" | "redo") {
    const full = label ? `${words}: ${label}` : words;
    const act = (): boolean => this.dispatchEvent(new CustomEvent(kind, { bubbles: true, composed: true }));
    return html`<button class="plain square" aria-label=${full} title=${full} ?disabled=${!label || this.locked} @click=${act}>${icon}</button>`;
  }

  private painted({ detail }: CustomEvent<MaskStroke>): void {
    tell(this, "paint", { strokes: [...this.subject.strokes, detail] });
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
    else if (event.key.toLowerCase() === "x") this.adds = !this.adds;
    else if (event.key === "[") this.width = Math.max(WIDTH.least, this.width - 1);
    else if (event.key === "]") this.width = Math.min(WIDTH.most, this.width + 1);
    else return;
    event.preventDefault();
    event.stopPropagation();
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
