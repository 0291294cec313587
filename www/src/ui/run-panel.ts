import { css, html, LitElement, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { StudioState } from "../state/studio";
import { timeLeft } from "../state/words";
import { icons } from "./icons";
import { controls } from "./shared";

/** Run, pause and stop, and what is going on in words. Fires `run`, `pause` and `stop`. */
@customElement("run-panel")
export class RunPanel extends LitElement {
  @property({ attribute: false }) state!: StudioState;

  static override styles = [
    controls,
    css`
      .buttons {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 8px;
      }
      button {
        min-height: 44px;
        font-weight: 600;
      }
      .run {
        grid-column: 1 / -1;
        border-color: transparent;
        background: var(--copper-fill);
        color: var(--on-copper);
        box-shadow: var(--shadow);
      }
      .run:hover:not(:disabled) {
        filter: brightness(1.08);
      }
      .bar {
        height: 4px;
        margin-top: 12px;
        overflow: hidden;
        border-radius: 2px;
        background: var(--line);
      }
      .bar i {
        display: block;
        width: 100%;
        height: 100%;
        background: var(--copper);
        transform: scaleX(var(--share, 0));
        transform-origin: left;
        transition: transform 150ms linear;
      }
      .words {
        display: flex;
        justify-content: space-between;
        gap: 8px;
        min-height: 36px;
        margin: 6px 0 0;
        font-size: 13px;
        color: var(--quiet);
      }
      .left {
        white-space: nowrap;
      }
    `,
  ];

  override render() {
    const { phase, progress, said } = this.state;
    const going = phase !== "idle";
    const words = going ? (phase === "finishing" ? "Keeping the best wire so far" : phase === "paused" ? "Paused" : progress.words) : said || "Everything runs on this device.";
    return html`
      <div class="buttons">
        ${going
          ? html`
              <button ?disabled=${phase !== "running" && phase !== "paused"} @click=${() => this.fire("pause")}>
                ${phase === "paused" ? html`${icons.run} Go on` : html`${icons.pause} Pause`}
              </button>
              <button ?disabled=${phase === "finishing"} @click=${() => this.fire("stop")}>${icons.stop} Stop</button>
            `
          : html`<button class="run" @click=${() => this.fire("run")}>${icons.run} Run</button>`}
      </div>
      <div class="bar" role="progressbar" aria-label="Progress" aria-valuenow=${Math.round(100 * progress.share)}><i></i></div>
      <p class="words" data-phase=${phase}>
        <span>${words}</span>
        <span class="left">${phase === "running" && progress.secondsLeft !== null ? timeLeft(progress.secondsLeft) : nothing}</span>
      </p>
    `;
  }

  protected override updated(): void {
    this.style.setProperty("--share", String(this.state.progress.share));
  }

  private fire(name: "run" | "pause" | "stop"): void {
    this.dispatchEvent(new Event(name));
  }
}
