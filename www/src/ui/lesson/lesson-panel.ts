import { msg, str } from "@lit/localize";
import { html, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { pause, run, step, stop } from "../../state/actions/actions";
import { isLocked } from "../../state/common/locks";
import { stepOf, type Kind, type LessonState, type Step } from "../../state/lesson/lesson";
import { deskOf, type Studio, type StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { icons } from "../shared/icons";
import { barStyle, controls } from "../shared/shared";
import { Idle } from "./idle";
import { lessonPanelStyle } from "./lesson-panel-style";
import { figuresTable } from "./figures-table";

/** A lesson, a step at a time: what to read, to guess, to try, and what to make of it. Fires `share-wire` when somebody wants to share theirs. */
@customElement("lesson-panel")
export class LessonPanel extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @query("h3") private heading!: HTMLElement;
  private readonly idle = new Idle(this, {
    watches: () => this.lesson?.kiosk === true,
    over: () => this.studio.lessons?.restart(),
  });

  static override styles = [controls, barStyle, lessonPanelStyle];

  override render() {
    const { lesson } = this;
    if (!lesson) return nothing;
    const { texts, at, kiosk } = lesson;
    const { steps } = lesson.lesson;
    const step = stepOf(lesson);
    const last = at === steps.length - 1;
    return html`
      <header>
        <h2>${texts["title"]}</h2>
        ${this.leaves ? html`<button class="plain square" aria-label=${msg("Leave the lesson")} title=${msg("Leave the lesson")} @click=${this.leave}>${icons.close}</button>` : nothing}
      </header>
      <div class="bar" role="progressbar" aria-label=${msg("The lesson")} aria-valuemin="1" aria-valuemax=${steps.length} aria-valuenow=${at + 1} aria-valuetext=${this.place}><i></i></div>
      <p class="small quiet"><span>${this.place}</span> <span class="kind">${kindWords(step.kind)}</span></p>
      <h3 tabindex="-1">${this.text("title")}</h3>
      ${this.text("text").split("\n").map((words) => html`<p>${words}</p>`)}
      ${step.watch ? html`<p class="watch">${icons.search}<span>${this.text("watch")}</span></p>` : nothing}
      ${step.table ? figuresTable(step.table, (key) => this.text(key)) : nothing}
      ${step.question ? this.question(step.question) : nothing}
      ${this.doing(step)}
      <nav aria-label=${msg("Steps of the lesson")}>
        <button ?disabled=${at === 0} @click=${() => this.go(at - 1)}>${msg("Back")}</button>
        ${last
          ? this.leaves
            ? html`<button class="primary" @click=${this.leave}>${msg("Finish")}</button>`
            : html`<button class="primary" @click=${() => this.studio.lessons?.restart()}>${msg("From the beginning")}</button>`
          : html`<button class="primary next" @click=${() => this.go(at + 1)}>${msg("Next")}</button>`}
      </nav>
      ${kiosk ? this.stand() : nothing}
    `;
  }

  protected override updated(changed: PropertyValues<this>): void {
    const { lesson } = this;
    if (!lesson) return;
    this.style.setProperty("--share", String((lesson.at + 1) / lesson.lesson.steps.length));
    const before = changed.get("state")?.lesson;
    // Below what was chosen, on a small sheet out of sight.
    if (before?.at === lesson.at && before.answers !== lesson.answers) this.renderRoot.querySelector(".says")?.scrollIntoView({ block: "nearest" });
    if (before && (before.at !== lesson.at || before.lesson !== lesson.lesson)) this.begin();
    this.idle.look();
  }

  private get lesson(): LessonState | null {
    return this.state.lesson;
  }

  private get place(): string {
    const { at, lesson } = this.lesson!;
    return msg(str`Step ${at + 1} of ${lesson.steps.length}`);
  }

  private get leaves(): boolean {
    return !isLocked(this.state, "leave");
  }

  private get shares(): boolean {
    return this.state.phase === "idle" && deskOf(this.state.doc).made !== null && !isLocked(this.state, "share");
  }

  private text(key: string): string {
    return this.lesson!.texts[`${stepOf(this.lesson!).id}.${key}`] ?? "";
  }

  /** Each step is read from its heading on. */
  private begin(): void {
    this.scrollTop = 0;
    this.scrollIntoView({ block: "nearest" });
    this.heading.focus({ preventScroll: false });
  }

  private question({ choices, right }: NonNullable<Step["question"]>): TemplateResult {
    const { answers, lesson, at } = this.lesson!;
    const { id } = lesson.steps[at]!;
    const answer = answers[id];
    return html`<fieldset>
        <legend>${this.text("question")}</legend>
        ${choices.map(
          (choice) => html`<label class=${choice === answer ? "chosen" : ""}>
            <input type="radio" name=${id} value=${choice} .checked=${choice === answer} @change=${() => this.studio.lessons?.answer(choice)} />
            <span>${this.text(`choice.${choice}`)}</span>
          </label>`,
        )}
      </fieldset>
      <div class="says" role="status">
        ${answer === undefined ? nothing : html`<p class=${answer === right ? "right" : ""}><b>${answer === right ? msg("Yes.") : msg("Not quite.")}</b> ${this.text(`says.${answer}`)}</p>`}
      </div>`;
  }

  /** What there is to press in such a step. */
  private doing({ kind, open }: Step): TemplateResult | typeof nothing {
    const again = html`<button class="plain small" @click=${() => this.studio.lessons?.again()}>${icons.reset} ${msg("Start this step again")}</button>`;
    if (kind === "run" || kind === "make") return html`${this.running()} ${open ? again : nothing}`;
    if (kind === "try" || (kind === "predict" && open)) return again;
    if (kind === "wall") return html`<button class="primary wide" ?disabled=${!this.shares} @click=${() => this.dispatchEvent(new Event("share-wire"))}>${icons.share} ${msg("Share my wire")}</button>
        <button class="wide" @click=${this.wall}>${icons.pictures} ${msg("Open the wall")}</button>`;
    return nothing;
  }

  private running(): TemplateResult {
    const { studio, state } = this;
    const idle = state.phase === "idle";
    const { words, share } = state.progress;
    return html`<div class="running">
      ${idle
        ? html`<button class="primary wide" ?disabled=${!studio.can(run)} @click=${() => studio.act(run)}>${icons.run} ${msg("Run")}</button>`
        : html`<div class="going">
            <button ?disabled=${!studio.can(stop)} @click=${() => studio.act(stop)}>${icons.stop} ${msg("Stop")}</button>
            <button ?disabled=${!studio.can(pause)} @click=${() => studio.act(pause)}>${state.phase === "paused" ? msg("Go on") : msg("Pause")}</button>
            <button ?disabled=${!studio.can(step)} @click=${() => studio.act(step)}>${msg("Step")}</button>
          </div>`}
      <p class="small quiet">${idle ? nothing : html`${words} <span class="percent">${new Intl.NumberFormat(document.documentElement.lang, { style: "percent" }).format(share)}</span>`}</p>
    </div>`;
  }

  /** For whoever comes by. */
  private stand(): TemplateResult {
    const { secondsLeft } = this.idle;
    return html`<div class="stand">
        ${document.fullscreenEnabled && !document.fullscreenElement ? html`<button @click=${() => void document.documentElement.requestFullscreen()}>${msg("Full screen")}</button>` : nothing}
        <button @click=${() => this.studio.lessons?.restart()}>${icons.reset} ${msg("From the beginning")}</button>
      </div>
      <div class="idle" ?hidden=${secondsLeft === null}>
        <!-- The seconds are for eyes alone: to read them all out would say nothing else. -->
        ${secondsLeft === null ? nothing : html`<b aria-hidden="true">${secondsLeft}</b><p role="alert">${msg("Still there? Touch anywhere to go on, or the lesson begins anew.")}</p>`}
      </div>`;
  }

  private readonly wall = async (): Promise<void> => {
    const { openWall } = await import("./wire-wall");
    await openWall();
  };

  private readonly leave = (): void => void this.studio.lessons?.leave();

  private go(at: number): void {
    this.studio.lessons?.go(at);
  }
}

function kindWords(kind: Kind): string {
  const words: Readonly<Record<Kind, string>> = {
    read: msg("Read"),
    predict: msg("Guess first"),
    try: msg("Try it"),
    run: msg("Run it"),
    explain: msg("Why"),
    make: msg("Make your own"),
    wall: msg("Show and tell"),
  };
  return words[kind];
}
