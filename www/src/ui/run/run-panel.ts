import { msg, str } from "@lit/localize";
import { html, nothing, type TemplateResult } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { pause, reset, run, step, stop } from "../../state/actions/actions";
import { deskOf, showsExample, type Studio, type StudioState } from "../../state/studio";
import { timeLeft } from "../../words/sentences";
import { count } from "../../words/numbers";
import { Part } from "../../view/part";
import { icons } from "../shared/icons";
import { deviceOf, paceOf, reasonOf } from "../settings/device-words";
import type { PageTask } from "../shared/page-task";
import { barStyle, controls } from "../shared/shared";
import { runStyle } from "./run-style";

/** Run and what goes with it, and what is going on in words. Fires `own` when a person wants to give something of their own. */
@customElement("run-panel")
export class RunPanel extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @property({ attribute: false }) tasks!: readonly PageTask[];
  @query(".buttons") private buttons!: HTMLElement;
  /** The button that has the focus. */
  private pressed: Element | null = null;

  static override styles = [controls, barStyle, runStyle];

  override render() {
    const { phase, progress } = this.state;
    const percent = Math.round(100 * progress.share);
    return html`
      <div class="buttons ${phase === "idle" ? "" : "going"}" role="group" aria-label=${msg("The run")} tabindex="-1">${phase === "idle" ? this.idle() : this.going()}</div>
      <div class="bar" role="progressbar" aria-label=${msg("Progress of the run")} aria-valuenow=${percent} aria-valuetext="${percent}%"><i></i></div>
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

  /** The one that is looked at. */
  private get task(): PageTask {
    return this.named(this.state.doc.task);
  }

  private named(task: string): PageTask {
    return this.tasks.find(({ name }) => name === task)!;
  }

  private idle(): TemplateResult {
    const { doc, planned, restyled } = this.state;
    const { page, isBlank } = this.task;
    const example = showsExample(this.state);
    const { icon, instead, again } = page.own;
    return html`
      <button class="primary" @click=${() => this.studio.act(run)}>${icons.run} ${this.remixes ? msg("Remix") : example && !planned && !restyled ? msg("Make it again") : page.run}</button>
      <button class="wide" @click=${() => this.dispatchEvent(new Event("own"))}>${icons[icon]} ${example || (isBlank(doc.given[doc.task]) && !deskOf(doc).guide) ? instead : again}</button>
    `;
  }

  /** Whether the wire came with what it was made of, and a run goes on from that. */
  private get remixes(): boolean {
    const { doc } = this.state;
    const { made, guide } = deskOf(doc);
    return made?.carried === true && this.task.suffices(doc.given[doc.task], guide);
  }

  private going(): TemplateResult {
    const { studio, state } = this;
    const paused = state.phase === "paused";
    return html`
      <button class="pause" ?disabled=${!studio.can(pause)} @click=${() => studio.act(pause)}>
        ${paused ? icons.run : icons.pause} <span>${pause.says!(state)}</span>
      </button>
      <button class="pause stop" ?disabled=${!studio.can(stop)} aria-label=${stop.label} title=${msg("Stop and keep the best so far")} @click=${this.stop}>
        ${icons.stop} <span>${stop.label}</span>
      </button>
      <button ?disabled=${!studio.can(step)} aria-label=${step.label} title=${msg("One step, then pause")} @click=${() => studio.act(step)}>${icons.step} <span>${step.label}</span></button>
      <button ?disabled=${!studio.can(reset)} aria-label=${reset.label} title=${msg("Give the run up and go back to before it")} @click=${() => studio.act(reset)}>
        ${icons.reset} <span>${reset.label}</span>
      </button>
    `;
  }

  private words(): string {
    const { phase, running, comparing, doc } = this.state;
    if (phase === "idle") return this.wordsAtRest();
    const words = phase === "finishing" ? msg("Keeping the best wire so far") : phase === "paused" ? msg("Paused") : this.state.progress.words;
    if (running !== null && running !== doc.task) return `${this.named(running).page.tab}: ${words}`;
    if (comparing === null) return words;
    return comparing === "loose" ? msg(str`Loose strokes, to compare: ${words}`) : msg(str`Another wire, to lay beside: ${words}`);
  }

  private wordsAtRest(): string {
    const { said, doc } = this.state;
    if (said) return said;
    if (showsExample(this.state)) return msg("An example. Nothing leaves this device.");
    if (this.remixes) return msg("Opened with what it was made of. Remix makes it again from that.");
    const { suffices, words } = this.task;
    if (!suffices(doc.given[doc.task], deskOf(doc).guide)) return words.needs;
    return msg("Ready. Nothing leaves this device.");
  }

  private steps(): string {
    const { phase, progress } = this.state;
    if ((phase !== "running" && phase !== "paused") || progress.iterations === 0) return "";
    return msg(str`Step ${count(progress.iteration)} of ${count(progress.iterations)}`);
  }

  /** What computes the run, or will; why, for those who stay on it, and in the settings. */
  private device(): TemplateResult | typeof nothing {
    const { phase, where } = this.state;
    const { place, refusal } = where;
    if (!place) return nothing;
    const name = deviceOf(place);
    return html`<span class="device" data-backend=${place.backend} title="${name}. ${refusal || reasonOf(place)}">${phase === "idle" ? msg(str`Will use: ${name}`) : name}</span>`;
  }

  /** It comes to lie where Run was: the second click of two is still meant for that. */
  private readonly stop = ({ detail: clicks }: MouseEvent): void => {
    if (clicks < 2) this.studio.act(stop);
  };
}
