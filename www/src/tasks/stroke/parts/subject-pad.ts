import { msg, str } from "@lit/localize";
import { html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { paintSample, sampleFile, SAMPLES, type Sample } from "../example/samples";
import { isPointedAt, objectAt, type Box, type Subject } from "../given";
import { Part } from "../../../view/part";
import { foldStyle } from "../../../ui/shared/fold";
import { icons } from "../../../ui/shared/icons";
import { segmented, segmentedStyle } from "../../../ui/shared/segmented";
import { chosenFile, Landing, problemOver } from "../../../ui/shared/drop";
import { controls } from "../../../ui/shared/shared";
import { padStyle } from "../../../ui/shared/pad-style";
import { subjectPadStyle } from "./subject-pad-style";
import { tell } from "./subject-events";
import "./subject-canvas";
import { MOST_NUMBERS, type Spot, type Tool } from "./subject-canvas";

/** How far a tap may miss a thing, a share of the picture's longer side. */
const REACH = 0.04;
const SHELF_PX = 96;
const CHOOSE: Tool = { kind: "choose" };

/** The one picture of a stroke: given here, shown with what is taken for its object, and corrected. Fires `SubjectEvents`. */
@customElement("subject-pad")
export class SubjectPad extends Part {
  @property({ attribute: false }) subject: Subject | null = null;
  /** While the picture is read or its object sought. */
  @property({ type: Boolean }) busy = false;
  /** What went wrong, a sentence, or empty. */
  @property() problem = "";
  /** What else is worth saying, a sentence, or empty. */
  @property() note = "";
  @property({ type: Boolean }) locked = false;
  private readonly landing = new Landing(this, { isLocked: () => this.locked, give: (file) => this.give(file) });
  @state() private shooting = false;
  /** The problem somebody has read and closed. */
  @state() private readProblem = "";
  @query("#file") private file!: HTMLInputElement;
  @query("#depth-file") private depthFile!: HTMLInputElement;
  private readonly hasCamera = "mediaDevices" in navigator;

  static override styles = [controls, segmentedStyle, foldStyle, problemOver, padStyle, subjectPadStyle];

  protected override willUpdate(changed: PropertyValues<this>): void {
    // The same may go wrong twice.
    if (changed.has("problem")) this.readProblem = "";
    if (this.locked) this.shooting = false;
  }

  override render() {
    const { subject, busy, problem } = this;
    return html`
      <section
        class="${this.landing.over ? "over" : ""} ${busy ? "busy" : ""} ${subject || busy ? "" : "empty"}"
        aria-label=${msg("Picture")}
        aria-busy=${busy}
        @dragover=${this.landing.dragOver}
        @dragleave=${this.landing.dragLeave}
        @drop=${this.landing.drop}
        @paste=${this.paste}
      >
        <div class="head">
          <h2>${msg("Picture")}</h2>
          <span class="aside small quiet" title=${subject?.picture.name ?? nothing}>${subject?.picture.name}</span>
        </div>
        <div class="row">
          <div class="sheet">
            <subject-canvas class="shown" .subject=${subject} name=${this.described()} .tool=${CHOOSE} ?asks=${this.asks} @tap=${this.tapped} @box=${this.boxed}></subject-canvas>
            ${subject || busy ? nothing : this.invitation()}
            ${this.landing.over ? html`<div class="landing">${msg("Drop it here")}</div>` : nothing}
            ${problem && problem !== this.readProblem
              ? html`<p class="problem small" role="alert">
                  <button class="plain square" aria-label=${msg("Close this message")} @click=${() => (this.readProblem = problem)}>${icons.close}</button>${problem}
                </p>`
              : nothing}
          </div>
          ${subject || busy
            ? html`<div class="tools" role="group" aria-label=${msg("Tools for the picture")}>
                ${this.tool(msg("Mark"), msg("Say what is meant, with a box, marks or a brush"), icons.brush, () => tell(this, "open-brush", null))}
                ${this.tool(msg("Replace"), msg("Choose another picture"), icons.picture, () => this.file.click())}
                ${this.tool(msg("Clear"), msg("Take the picture away"), icons.clear, () => tell(this, "clear-subject", null))}
              </div>`
            : this.shelf()}
        </div>
        <p class="line small quiet" role="status">${this.line()}</p>
        ${subject && isPointedAt(subject) ? this.pointed(subject) : nothing}
        ${subject ? [this.choice(subject), this.depth(subject)] : nothing}
        <input id="file" type="file" accept="image/*" hidden tabindex="-1" aria-label=${msg("Picture")} @change=${(event: Event) => this.chosen(event, "give")} />
        <input id="depth-file" type="file" accept="image/*" hidden tabindex="-1" aria-label=${msg("Depth picture")} @change=${(event: Event) => this.chosen(event, "give-depth")} />
        ${this.shooting ? html`<camera-dialog @close-camera=${this.putCameraAway}></camera-dialog>` : nothing}
      </section>
    `;
  }

  protected override updated(): void {
    for (const canvas of this.renderRoot.querySelectorAll<HTMLCanvasElement>(".shelf canvas:not(.painted)")) {
      const sample = SAMPLES.find(({ name }) => name === canvas.dataset["sample"])!;
      canvas.getContext("2d")!.drawImage(paintSample(sample, SHELF_PX), 0, 0);
      canvas.classList.add("painted");
    }
  }

  private tool(words: string, title: string, icon: unknown, act: () => void) {
    return html`<button class="plain" title=${title} ?disabled=${this.locked || !this.subject} @click=${act}>${icon}<span>${words}</span></button>`;
  }

  private invitation() {
    const { locked } = this;
    return html`<div class="invitation">
      <p>${msg("Drop, paste or choose one picture")}</p>
      <div class="ways">
        <button ?disabled=${locked} @click=${() => this.file.click()}>${icons.picture}${msg("Choose picture")}</button>
        ${this.hasCamera ? html`<button id="camera" ?disabled=${locked} @click=${this.shoot}>${icons.camera}${msg("Camera")}</button>` : nothing}
      </div>
    </div>`;
  }

  private shelf() {
    return html`<div class="shelf small quiet" role="group" aria-label=${msg("Pictures to try")}>
      <p>${msg("Or try one of these")}</p>
      ${SAMPLES.map(
        (sample) => html`<button title=${sample.name} aria-label=${msg(str`Try the ${sample.name.toLowerCase()}`)} ?disabled=${this.locked} @click=${() => this.take(sample)}>
          <canvas width=${SHELF_PX} height=${SHELF_PX} data-sample=${sample.name}></canvas>
        </button>`,
      )}
    </div>`;
  }

  /** One line, always there: nothing jumps when it is filled. */
  private line() {
    const { subject, busy, note } = this;
    if (busy) return subject ? msg("Looking for the object…") : "Reading…";
    if (!subject) return msg("Your picture stays on this device.");
    if (this.asks && !note) return msg("Which thing is it? Drag a box round it, or mark it.");
    const words = note || subject.found?.notes.join(" ");
    if (words) return html`<span title=${words}>${words}</span>`;
    if (subject.strokes.length > 0) return msg("In colour: the object, with your strokes.");
    if (isPointedAt(subject)) return msg("Found. Mark what is missing or too much.");
    return subject.found ? msg("In colour: what is taken for the object.") : msg("Nothing found. Press Mark and paint over the object.");
  }

  /** Whether it is not clear what is meant, and nobody has said. */
  private get asks(): boolean {
    const { subject, locked } = this;
    return !locked && subject?.found?.isSure === false && !isPointedAt(subject) && subject.strokes.length === 0;
  }

  private boxed({ detail: box }: CustomEvent<Box>): void {
    if (!this.locked && !this.busy) tell(this, "give-box", { box });
  }

  private described(): string {
    const { subject } = this;
    if (!subject) return msg("Picture: none yet");
    const { picture, found, strokes, object } = subject;
    const which = found && found.count > 1 ? msg(str`, thing ${object} of ${found.count}`) : "";
    return `${picture.name}, ${found ? msg(str`its object in colour${which}`) : msg("no object found")}${strokes.length > 0 ? msg(", corrected by hand") : ""}`;
  }

  private pointed({ box, marks }: Subject) {
    const idle = !this.locked && !this.busy;
    return html`<div class="pointed">
      ${box ? html`<button ?disabled=${!idle} @click=${() => tell(this, "give-box", { box: null })}>${msg("Remove the box")}</button>` : nothing}
      ${marks?.length ? html`<button ?disabled=${!idle} @click=${() => tell(this, "clear-marks", null)}>${msg("Clear marks")}</button>` : nothing}
    </div>`;
  }

  /** The same as tapping a thing in the picture, for keys. */
  private choice({ found, object }: Subject) {
    if (!found || found.count < 2) return nothing;
    const most = Math.min(found.count, MOST_NUMBERS);
    const shown = Array.from({ length: most }, (_, i) => i + 1);
    if (object > most) shown.push(object);
    return segmented({
      legend: msg(str`${found.count} things found; tap another to choose it`),
      name: "object",
      options: shown.map((number) => ({ value: String(number), words: String(number), title: number === 1 ? msg("The largest") : "" })),
      value: String(object),
      locked: this.locked || this.busy,
      choose: (value) => tell(this, "choose-object", { object: Number(value) }),
    });
  }

  private depth({ picture: { width, height }, depth }: Subject) {
    const { locked } = this;
    return html`<details>
      <summary><span class="small">${msg("Depth picture")}</span><span class="aside small quiet">${depth ? depth.name : "none"}</span>${icons.more}</summary>
      <div class="group">
        <p class="small quiet">
          ${msg(str`Where you have one, it says how near each place is: light is near, dark is far. It must have the picture's size, ${width} × ${height}.`)}
        </p>
        ${depth
          ? html`<button ?disabled=${locked} @click=${() => tell(this, "clear-depth", null)}>${icons.clear}${msg("Take it away")}</button>`
          : html`<button ?disabled=${locked} @click=${() => this.depthFile.click()}>${icons.picture}${msg("Add a depth picture")}</button>`}
      </div>
    </details>`;
  }

  private tapped({ detail: [x, y] }: CustomEvent<Spot>): void {
    const { subject, locked, busy } = this;
    if (!subject || locked || busy) return;
    const object = subject.found ? objectAt(subject.found, x, y, REACH) : 0;
    if (object > 0 && object !== subject.object) tell(this, "choose-object", { object });
    else tell(this, "open-brush", null);
  }

  private async take(sample: Sample): Promise<void> {
    tell(this, "give", { file: await sampleFile(sample), name: sample.name });
  }

  /** The camera's dialog is loaded when it is first wanted; what it gives bubbles on. */
  private shoot(): void {
    void import("./camera-dialog");
    this.shooting = true;
  }

  private putCameraAway(): void {
    this.shooting = false;
    this.renderRoot.querySelector<HTMLElement>("#camera")?.focus();
  }

  private give(file: File, kind: "give" | "give-depth" = "give"): void {
    if (!this.locked) tell(this, kind, { file, name: file.name || (kind === "give" ? msg("The picture") : msg("The depth picture")) });
  }

  private chosen(event: Event, kind: "give" | "give-depth"): void {
    const file = chosenFile(event);
    if (file) this.give(file, kind);
  }

  private paste(event: ClipboardEvent): void {
    const file = [...(event.clipboardData?.files ?? [])].find(({ type }) => type.startsWith("image/"));
    if (!file || this.locked) return;
    event.preventDefault();
    event.stopPropagation();
    this.give(file);
  }
}
