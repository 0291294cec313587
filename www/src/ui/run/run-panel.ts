import { css, html, nothing, type TemplateResult } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { showsExample, type Studio, type StudioState } from "../../state/studio";
import { timeLeft } from "../../state/common/words";
import { count } from "../../state/common/count";
import { Part } from "../../view/part";
import { JOB_WORDS } from "../app/task-tabs";
import { icons } from "../shared/icons";
import { deviceOf, paceOf } from "../settings/device-words";
import { barStyle, controls } from "../shared/shared";

/** Run and what goes with it, and what is going on in words. Fires `draw`, `choose-picture` or `choose-mesh` when a person wants to. */
@customElement("run-panel")
export class RunPanel extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @query(".buttons") private buttons!: HTMLElement;
  /** The button that has the focus. */
  private pressed: Element | null = null;

  static override styles = [
    controls,
    barStyle,
    css`
      :host {
        display: block;
      }
      .buttons {
        display: grid;
        grid-template-columns: repeat(4, minmax(0, 1fr));
        gap: 8px;
      }
      button {
        grid-column: span 2;
        min-height: 40px;
        padding: 0 8px;
        white-space: nowrap;
      }
      .primary,
      .wide {
        grid-column: 1 / -1;
      }
      .primary svg.icon {
        fill: currentColor;
      }
      .primary,
      .pause {
        min-height: 48px;
      }
      .pause {
        grid-column: span 2;
        font-weight: 600;
      }
      .bar {
        margin-block-start: 16px;
      }
      /* Three lines are kept free, so that nothing below moves when a run starts. */
      p {
        display: flex;
        flex-wrap: wrap;
        align-content: start;
        gap: 0 8px;
        min-height: 54px;
        margin: 8px 0 0;
        font-size: 13px;
        line-height: 18px;
        white-space: nowrap;
        color: var(--quiet);
      }
      .words {
        flex: 1;
        min-width: 60%;
        overflow-wrap: anywhere;
        white-space: normal;
      }
      .device {
        flex: 1 0 100%;
        overflow: hidden;
        text-overflow: ellipsis;
      }
      .steps {
        flex: 1;
      }
      /* A strip between stage and sheet: one row of buttons, two lines of words. */
      @media (max-width: 819px), (max-width: 1099px) and (orientation: portrait) {
        :host {
          display: flex;
          flex-direction: column;
        }
        .bar {
          order: -1;
          margin: 0 -16px 8px;
          border-radius: 0;
        }
        .buttons {
          display: flex;
        }
        button {
          flex: 1 1 auto;
          min-height: 44px;
        }
        .primary {
          flex-grow: 3;
        }
        p {
          min-height: 36px;
          margin: 4px 0;
        }
        .words {
          overflow: hidden;
          text-overflow: ellipsis;
          white-space: nowrap;
        }
        /* Too wide to stand beside the words. */
        .device {
          flex: 1 1 60%;
          min-width: 0;
        }
        .steps {
          position: absolute;
          clip-path: inset(50%);
        }
      }
      @media (max-width: 479px) {
        .going button:not(.pause) span {
          display: none;
        }
      }
    `,
  ];

  override render() {
    const { phase, progress } = this.state;
    const percent = Math.round(100 * progress.share);
    return html`
      <div class="buttons ${phase === "idle" ? "" : "going"}" role="group" aria-label="The run" tabindex="-1">${phase === "idle" ? this.idle() : this.going()}</div>
      <div class="bar" role="progressbar" aria-label="Progress of the run" aria-valuenow=${percent} aria-valuetext="${percent}%"><i></i></div>
      <p data-phase=${phase}>
        <span class="words">${this.words()}</span>
        <span class="left">${phase === "running" && progress.secondsLeft !== null ? timeLeft(progress.secondsLeft) : nothing}</span>
        ${this.device()}
        <span class="steps">${this.steps()}</span>
        <span class="pace">${phase === "running" && progress.iterationsPerSecond > 0 ? paceOf(progress.iterationsPerSecond) : nothing}</span>
      </p>
    `;
  }

  protected override willUpdate(): void {
    this.pressed = this.shadowRoot?.activeElement ?? null;
  }

  protected override updated(): void {
    // Buttons come and go with the run. The focus stays among them, and on none: the next press of a key is not for another.
    if (this.pressed && !this.pressed.isConnected) this.buttons.focus();
    this.style.setProperty("--share", String(this.state.progress.share));
  }

  private idle(): TemplateResult {
    const { doc, planned, restyled } = this.state;
    const { job } = doc;
    const example = showsExample(this.state);
    return html`
      <button class="primary" @click=${() => void this.studio.run()}>${icons.run} ${example && !planned && !restyled ? "Make it again" : job === "fill" ? "Cover it" : "Run"}</button>
      ${job === "fill"
        ? html`<button class="wide" @click=${() => this.dispatchEvent(new Event("choose-mesh"))}>${icons.open} Open a mesh</button>`
        : job === "stroke"
        ? html`<button class="wide" @click=${() => this.dispatchEvent(new Event("choose-picture"))}>${icons.picture} ${example || given(this.state) === 0 ? "Use your own" : "Start over"}</button>`
        : html`<button class="wide" @click=${this.draw}>${icons.pencil} ${example || given(this.state) === 0 ? "Draw your own" : "Start over"}</button>`}
    `;
  }

  private going(): TemplateResult {
    const { phase } = this.state;
    const fitting = phase === "running" || phase === "paused";
    return html`
      <button class="pause" ?disabled=${!fitting} @click=${() => this.studio.pause()}>
        ${phase === "paused" ? html`${icons.run} <span>Go on</span>` : html`${icons.pause} <span>Pause</span>`}
      </button>
      <button class="pause stop" ?disabled=${phase === "finishing"} aria-label="Stop" title="Stop and keep the best so far" @click=${this.stop}>
        ${icons.stop} <span>Stop</span>
      </button>
      <button ?disabled=${!fitting} aria-label="Step" title="One step, then pause" @click=${() => this.studio.step()}>${icons.step} <span>Step</span></button>
      <button ?disabled=${phase === "finishing"} aria-label="Reset" title="Give the run up and go back to before it" @click=${() => this.studio.reset()}>
        ${icons.reset} <span>Reset</span>
      </button>
    `;
  }

  private words(): string {
    const { phase, running, comparing, doc } = this.state;
    if (phase === "idle") return this.wordsAtRest();
    const words = phase === "finishing" ? "Keeping the best wire so far" : phase === "paused" ? "Paused" : this.state.progress.words;
    if (running !== null && running !== doc.job) return `${JOB_WORDS[running]}: ${words}`;
    return comparing ? `Loose strokes, to compare: ${words}` : words;
  }

  private wordsAtRest(): string {
    const { said, doc } = this.state;
    if (said) return said;
    if (showsExample(this.state)) return "An example. Nothing leaves this device.";
    if (doc.job === "fill" && given(this.state) === 0) return "A wire needs a shape to cover.";
    if (doc.job === "stroke" && given(this.state) === 0) return "A wire needs a picture.";
    if (doc.job === "multiview" && given(this.state) < 2) return "A wire needs at least two drawings.";
    return "Ready. Nothing leaves this device.";
  }

  private steps(): string {
    const { phase, progress } = this.state;
    if ((phase !== "running" && phase !== "paused") || progress.iterations === 0) return "";
    return `Step ${count(progress.iteration)} of ${count(progress.iterations)}`;
  }

  /** What computes the run, or will; why, for those who stay on it, and in the settings. */
  private device(): TemplateResult | typeof nothing {
    const { phase, where } = this.state;
    const { place, refusal } = where;
    if (!place) return nothing;
    const name = deviceOf(place);
    return html`<span class="device" data-backend=${place.backend} title="${name}. ${refusal || place.why}">${phase === "idle" ? `Will use: ${name}` : name}</span>`;
  }

  /** It comes to lie where Run was: the second click of two is still meant for that. */
  private readonly stop = ({ detail: clicks }: MouseEvent): void => {
    if (clicks < 2) this.studio.stop();
  };

  private readonly draw = (): void => {
    if (given(this.state) > 0) this.studio.startOver();
    this.dispatchEvent(new Event("draw"));
  };
}

/** How many of what the job wants are there. */
function given({ doc }: StudioState): number {
  if (doc.job === "fill") return Number(doc.cover !== null);
  return doc.job === "stroke" ? Number(doc.subject !== null) : Object.values(doc.papers).filter(Boolean).length;
}
