import { msg, str } from "@lit/localize";
import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";

/** Lets files be dropped anywhere on the page, and says so while they are over it. Fires `files`. */
@customElement("drop-hint")
export class DropHint extends LitElement {
  @property({ type: Boolean, reflect: true }) over = false;
  /** While a run goes on nothing is taken. */
  @property({ type: Boolean }) locked = false;
  /** What may be dropped. */
  @property() what = "";
  /** Elements entered and not left yet. */
  private depth = 0;
  private ending = new AbortController();

  static override styles = [
    controls,
    css`
      :host {
        position: fixed;
        z-index: 10;
        inset: 8px;
        display: none;
        place-content: center;
        justify-items: center;
        gap: 8px;
        border: 2px dashed var(--copper);
        border-radius: 6px;
        background: color-mix(in srgb, var(--paper) 80%, transparent);
        font-size: 20px;
        font-weight: 600;
        text-align: center;
        pointer-events: none;
      }
      :host([over]) {
        display: grid;
      }
    `,
  ];

  override render() {
    return html`${icons.pictures}${this.locked ? msg("Wait for the run to end") : msg(str`Drop ${this.what}`)}`;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.ending = new AbortController();
    const { signal } = this.ending;
    addEventListener("dragenter", (event) => this.move(event, 1), { signal });
    addEventListener("dragleave", (event) => this.move(event, -1), { signal });
    addEventListener("dragover", (event) => event.preventDefault(), { signal });
    // Before a pad takes it for itself.
    addEventListener("drop", () => this.clear(), { signal, capture: true });
    addEventListener("drop", (event) => this.drop(event), { signal });
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.ending.abort();
  }

  private move(event: DragEvent, by: number): void {
    if (!event.dataTransfer?.types.includes("Files")) return;
    this.depth = Math.max(0, this.depth + by);
    this.over = this.depth > 0;
  }

  private clear(): void {
    this.depth = 0;
    this.over = false;
  }

  private drop(event: DragEvent): void {
    if (event.defaultPrevented) return;
    event.preventDefault();
    this.dispatchEvent(new CustomEvent<DataTransfer | null>("files", { detail: event.dataTransfer }));
  }
}
