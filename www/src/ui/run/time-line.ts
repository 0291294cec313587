import { msg, str } from "@lit/localize";
import { html } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { RunEvent, Snapshot } from "../../engine/protocol";
import { continueFrom, lookAt } from "../../state/actions/actions";
import type { Studio, StudioState } from "../../state/studio";
import { count } from "../../words/numbers";
import { eventWords } from "../../view/event-words";
import { Part } from "../../view/part";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";
import { timeLineStyle } from "./time-line-style";

const SHOWN_EACH_MS = 50;

/** The run as time: back to any wire it went through, on from there, and the whole of it as a film. */
@customElement("time-line")
export class TimeLine extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @state() private playing = false;
  private timer: ReturnType<typeof setInterval> | undefined;

  static override styles = [controls, timeLineStyle];

  override render() {
    const { track, looking } = this.state;
    const snapshots = track?.snapshots ?? [];
    if (!track || snapshots.length < 2) {
      return html`<div class="all"><p class="hint small quiet">${msg("When a run is on, its way here shows: go back to any wire, and on from there.")}</p></div>`;
    }
    const at = looking ?? snapshots.length - 1;
    const { iteration } = snapshots[at]!;
    const words = msg(str`Step ${count(iteration)} of ${count(track.iterations)}`);
    return html`<div class="all">
      <button
        class="play square"
        aria-label=${this.playing ? msg("Stop watching") : msg("Watch it form")}
        title=${this.playing ? msg("Stop watching") : msg("Watch it form")}
        @click=${() => (this.playing ? this.rest() : this.play())}
      >
        ${this.playing ? icons.pause : icons.run}
      </button>
      <span class="label">${looking === null ? msg("The newest wire,") : msg("Looking back at")} <b>${msg(str`step ${count(iteration)} of ${count(track.iterations)}`)}</b></span>
      <div class="way">
        <ul class="marks" aria-label=${msg("What happened")}>
          ${track.events.map((event) => this.mark(event, track.iterations))}
        </ul>
        <input
          type="range"
          aria-label=${msg("The run, wire by wire")}
          aria-valuetext=${words}
          min="0"
          max=${track.iterations}
          step="any"
          .value=${String(iteration)}
          @keydown=${this.press}
          @input=${this.scrub}
        />
      </div>
      <div class="acts">
        <button ?disabled=${looking === null || !this.studio.can(continueFrom)} @click=${() => looking !== null && this.studio.act(continueFrom, looking)}>${continueFrom.label}</button>
        <button ?disabled=${looking === null} @click=${() => this.studio.act(lookAt, null)}>${icons.newest} ${msg("Newest")}</button>
      </div>
    </div>`;
  }

  protected override updated(): void {
    // Set by script: the page's policy allows no style attributes.
    for (const mark of this.renderRoot.querySelectorAll<HTMLElement>(".marks li")) {
      mark.style.insetInlineStart = `${100 * Number(mark.dataset["at"])}%`;
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.rest();
  }

  private mark(event: RunEvent, iterations: number) {
    const words = msg(str`${eventWords(event)}, at step ${count(event.iteration)}`);
    return html`<li class=${event.kind} data-at=${event.iteration / Math.max(1, iterations)} title=${words}><span class="unseen">${words}</span></li>`;
  }

  private readonly scrub = (event: Event): void => {
    this.rest();
    const iteration = Number((event.target as HTMLInputElement).value);
    const at = this.snapshots.findLastIndex((snapshot) => snapshot.iteration <= iteration);
    this.look(Math.max(0, at));
  };

  /** Arrows go from wire to wire, however far apart they are. */
  private readonly press = (event: KeyboardEvent): void => {
    const forward = getComputedStyle(this).direction === "rtl" ? -1 : 1;
    const by = { ArrowRight: forward, ArrowLeft: -forward, ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    this.rest();
    // What is drawn may be a frame behind keys that repeat.
    this.look(Math.max(0, (this.studio.store.get().looking ?? this.snapshots.length - 1) + by));
  };

  private look(index: number): void {
    this.studio.act(lookAt, index >= this.snapshots.length - 1 ? null : index);
  }

  private get snapshots(): readonly Snapshot[] {
    return this.state.track?.snapshots ?? [];
  }

  /** From the first wire to the newest; where motion is not wanted, straight to the first, to go on by hand. */
  private play(): void {
    this.look(0);
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    this.playing = true;
    this.timer = setInterval(() => {
      const { looking } = this.studio.store.get();
      if (looking === null) this.rest();
      else this.look(looking + 1);
    }, SHOWN_EACH_MS);
  }

  private rest(): void {
    clearInterval(this.timer);
    this.playing = false;
  }
}
