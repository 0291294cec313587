import { msg, str } from "@lit/localize";
import { html, nothing, svg } from "lit";
import { customElement, property } from "lit/decorators.js";
import { lookAt, useTool } from "../../state/actions/actions";
import { count, counted, percent } from "../../words/numbers";
import type { Insight, RunEvent, TermPull } from "../../engine/protocol";
import type { StudioState } from "../../state/studio";
import { eventWords } from "../../view/event-words";
import { Part } from "../../view/part";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";
import type { Glass } from "./glass";
import { glassStyle } from "./glass-style";
import "./level-views";
import { ALL, inkOf, OF_ALL, strength, termWords, type Ink } from "./terms";
import "./what-if";
import "./wire-strip";

/** Terms that most runs never have. */
const OF_SOME: readonly string[] = ["surface", "texture", "guidance"];

/** The glass box: which term pulls how, what each view sees, what happened, and what would be without. */
@customElement("glass-panel")
export class GlassPanel extends Part {
  @property({ attribute: false }) glass!: Glass;
  @property({ attribute: false }) state!: StudioState;
  /** Whether it is in a phone's sheet: what lies under the timeline of a desk is in it, too. */
  @property({ type: Boolean }) narrow = false;
  private stop: () => void = () => undefined;
  private readonly recolour = (): void => this.requestUpdate();

  static override styles = [controls, glassStyle];

  override connectedCallback(): void {
    super.connectedCallback();
    this.stop = this.glass.store.watch(({ insight, shown, stretched }) => [insight, shown, stretched], () => this.requestUpdate());
    addEventListener("theme-change", this.recolour);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop();
    removeEventListener("theme-change", this.recolour);
  }

  override render() {
    const { glass, state, narrow } = this;
    const { insight } = glass.store.get();
    return html`
      <header>
        <h2>${msg("Glass box: the optimiser, opened")}</h2>
        <button class="plain square" aria-label=${msg("Close the glass box")} title=${msg("Close the glass box")} @click=${() => glass.studio.act(useTool, null)}>${icons.close}</button>
      </header>
      <p class="small quiet">${this.hint()}</p>
      ${narrow ? html`<wire-strip .glass=${glass} .state=${state}></wire-strip>` : nothing}
      <section aria-labelledby="pulls">
        <h3 id="pulls">${msg("What pulls at the wire")}</h3>
        ${insight ? this.legend(insight) : html`<p class="small quiet">${msg("In a run, an arrow on each control point shows which way every part of the loss pulls it.")}</p>`}
      </section>
      <section aria-labelledby="scales">
        <h3 id="scales">${msg("What each view sees, scale by scale")}</h3>
        ${insight
          ? html`<level-views .insight=${insight}></level-views>`
          : html`<p class="small quiet">${msg("The wire and the picture are compared at every size, from fine to coarse: the coarse ones pull from afar.")}</p>`}
      </section>
      ${this.happened()}
      <section aria-labelledby="if">
        <h3 id="if">${msg("What if …?")}</h3>
        <what-if .studio=${glass.studio} .state=${state}></what-if>
      </section>
    `;
  }

  private hint(): string {
    const { phase, running, doc, looking } = this.state;
    const { insight } = this.glass.store.get();
    if (running !== null && running !== doc.task) return msg("The run under way is of another tab; this box looks into it there.");
    if (phase === "idle" || phase === "preparing" || phase === "finishing") {
      return insight
        ? msg(str`Nothing runs now: what is below is from step ${count(insight.iteration)}. Press Run, then Pause and Step.`)
        : msg("Press Run to see how the wire is found; Pause and Step go through it one step at a time.");
    }
    if (looking !== null) return msg("You look back: arrows are on the newest wire alone.");
    return insight ? msg(str`Step ${count(insight.iteration)}: each arrow shows the way a control point is pulled, against the gradient.`) : msg("Looking into the run …");
  }

  private legend(insight: Insight) {
    const { stretched } = this.glass.store.get();
    const strengths = insight.pulls.map(strength);
    const whole = strengths.reduce((sum, each) => sum + each, 0);
    // Others may pull later: rows that came with them would move those below.
    const isOn = ({ name }: TermPull, index: number): boolean => !OF_SOME.includes(name) || strengths[index]! > 0;
    const loss = insight.pulls.reduce((sum, { loss }) => sum + loss, 0);
    const of = (part: number, whole: number): string => whole > 0 && part > 0 ? (part < 0.005 * whole ? "<1%" : percent(part / whole)) : "0%";
    return html`<p class="heads" aria-hidden="true"><span class="share">${msg("Pull")}</span> <span class="loss">${msg("Loss")}</span></p>
      <ul class="legend">
        ${this.row(ALL, msg("All together"), OF_ALL, "", loss.toPrecision(2))}
        ${insight.pulls.map((term, index) => (isOn(term, index) ? this.row(term.name, termWords(term), inkOf(term, index), of(strengths[index]!, whole), of(term.loss, loss)) : nothing))}
      </ul>
      <label class="check">
        <input type="checkbox" .checked=${stretched} @change=${(event: Event) => this.glass.store.set({ stretched: (event.target as HTMLInputElement).checked })} />
        ${msg("Stretch each colour so that it can be read")}
      </label>
      ${this.state.track?.guide ? html`<p class="small quiet">${msg("What the words ask for is not among these.")}</p>` : nothing}`;
  }

  /** A term: whether its arrows are drawn, how they look, and its share of the pull and of the loss. */
  private row(name: string, words: string, ink: Ink, pull: string, loss: string) {
    const { shown } = this.glass.store.get();
    const colour = this.glass.colourOf(ink);
    return html`<li>
      <label>
        <input type="checkbox" .checked=${shown.includes(name)} @change=${(event: Event) => this.glass.show(name, (event.target as HTMLInputElement).checked)} />
        <svg class="swatch" viewBox="0 0 28 10" aria-hidden="true">
          ${svg`<path d="M1 5H20" fill="none" stroke=${colour} stroke-width=${1.2 * (ink.wide ?? 2)} stroke-dasharray=${ink.dash.join(" ")} /><path d="M27 5L19 1V9Z" fill=${colour} />`}
        </svg>
        <span class="words">${words}</span>
        <span class="share">${pull && html`<span class="unseen">${msg("Pull:")}</span> ${pull}`}</span>
        <span class="loss"><span class="unseen">${msg("Loss:")}</span> ${loss}</span>
      </label>
    </li>`;
  }

  private happened() {
    const { track } = this.state;
    const events = track?.events ?? [];
    if (!track || events.length === 0) return nothing;
    return html`<section aria-labelledby="happened">
      <h3 id="happened">${msg("What happened")}</h3>
      <ol class="events">
        ${events.map((event) => html`<li><button class="plain" @click=${() => this.lookBack(event)}>${counted(event.iteration, msg("After 1 step"), msg(str`After ${count(event.iteration)} steps`))}: ${eventWords(event)}</button></li>`)}
      </ol>
    </section>`;
  }

  /** To the first wire that is kept from after it. */
  private lookBack({ iteration }: RunEvent): void {
    const snapshots = this.state.track?.snapshots ?? [];
    const after = snapshots.findIndex((snapshot) => snapshot.iteration > iteration);
    if (snapshots.length) this.glass.studio.act(lookAt, after < 0 ? null : after);
  }
}
