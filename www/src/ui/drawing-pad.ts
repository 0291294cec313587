import { css, html, LitElement, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Ink } from "../engine/protocol";
import type { Pad, Slot } from "../state/studio";
import { paintInk } from "../view/paint";
import { icons } from "./icons";
import { controls } from "./shared";

/** One view's drawing: click, drop or paste a picture; shows the ink the core sees in it. Fires `give` and `clear`. */
@customElement("drawing-pad")
export class DrawingPad extends LitElement {
  @property() slotName: Slot = "front";
  @property({ attribute: false }) pad!: Pad;
  @property({ type: Boolean }) locked = false;
  @state() private over = false;
  @query("canvas") private canvas!: HTMLCanvasElement;
  @query("input") private input!: HTMLInputElement;

  static override styles = [
    controls,
    css`
      :host {
        display: block;
        min-width: 0;
      }
      .head {
        display: flex;
        align-items: center;
        justify-content: space-between;
        height: 32px;
      }
      .head h2 {
        text-transform: capitalize;
        color: var(--ink);
      }
      .clear {
        width: 32px;
        min-height: 32px;
        padding: 0;
        border-color: transparent;
        background: none;
        color: var(--quiet);
      }
      .pad {
        position: relative;
        display: block;
        width: 100%;
        aspect-ratio: 1.25;
        padding: 0;
        overflow: hidden;
        background: var(--raised);
        box-shadow: var(--shadow);
      }
      .pad.over {
        border-color: var(--copper);
        outline: 2px solid var(--copper);
      }
      canvas {
        position: absolute;
        inset: 6px;
        width: calc(100% - 12px);
        height: calc(100% - 12px);
        object-fit: contain;
      }
      .empty {
        display: grid;
        justify-items: center;
        gap: 6px;
        padding: 8px;
        color: var(--quiet);
        font-size: 13px;
        line-height: 1.3;
      }
      .line {
        min-height: 20px;
        margin: 4px 0 0;
        font-size: 13px;
        line-height: 1.4;
        color: var(--quiet);
        overflow-wrap: anywhere;
      }
      .problem {
        color: var(--error);
      }
      @media (max-width: 819px), (max-width: 1099px) and (orientation: portrait) {
        .pad {
          aspect-ratio: 1;
        }
        .empty span {
          display: none;
        }
        /* Two lines, so that nothing jumps when a run says where the drawing went. */
        .line {
          min-height: 37px;
        }
      }
      @media (pointer: coarse) {
        .clear {
          width: 44px;
          min-height: 44px;
          margin: -6px -10px -6px 0;
        }
      }
    `,
  ];

  override render() {
    const { pad, slotName, locked } = this;
    return html`
      <div class="head">
        <h2>${slotName}</h2>
        ${pad.picture && !locked
          ? html`<button class="clear" aria-label="Clear the ${slotName} drawing" @click=${() => this.dispatchEvent(new Event("clear"))}>
              ${icons.close}
            </button>`
          : nothing}
      </div>
      <button
        class="pad ${this.over ? "over" : ""}"
        ?disabled=${locked}
        aria-label="Choose a picture for the ${slotName} view"
        aria-describedby="line"
        @click=${() => this.input.click()}
        @dragover=${this.dragOver}
        @dragleave=${() => (this.over = false)}
        @drop=${this.drop}
      >
        <canvas ?hidden=${!pad.ink}></canvas>
        ${pad.ink
          ? nothing
          : html`<span class="empty">${icons.picture}<span>${pad.busy ? "Reading…" : "Choose, drop or paste a picture"}</span></span>`}
      </button>
      <p id="line" class="line ${pad.problem ? "problem" : ""}" role=${pad.problem ? "alert" : nothing}>${pad.problem || pad.placed || pad.note}</p>
      <input type="file" accept="image/*" hidden tabindex="-1" @change=${this.chosen} />
    `;
  }

  protected override updated(changed: PropertyValues<this>): void {
    const before = changed.get("pad") as Pad | undefined;
    if (changed.has("pad") && this.pad.ink && this.pad.ink !== before?.ink) this.paint(this.pad.ink);
  }

  /** Ink in the text's colour; painted anew when the colours change. */
  paint(ink: Ink | null = this.pad.ink): void {
    if (ink) paintInk(this.canvas, ink, getComputedStyle(this).color);
  }

  private give(file: File | null | undefined): void {
    if (file) this.dispatchEvent(new CustomEvent<File>("give", { detail: file }));
  }

  private chosen(): void {
    this.give(this.input.files?.[0]);
    this.input.value = "";
  }

  private dragOver(event: DragEvent): void {
    if (this.locked) return;
    event.preventDefault();
    this.over = true;
  }

  private drop(event: DragEvent): void {
    this.over = false;
    if (this.locked) return;
    event.preventDefault();
    event.stopPropagation();
    this.give(event.dataTransfer?.files[0]);
  }
}
