import { msg, str } from "@lit/localize";
import { html, LitElement, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { BodyShape } from "#sculpture/scene/body";
import type { Size } from "#sculpture/film/darkroom";
import { LOOK_NAMES, type LookName } from "#sculpture/scene/looks";
import type { Pose, Vantage, ViewName } from "#sculpture/scene/orbit";
import type { WireShape } from "#sculpture/scene/shape";
import { bestChoice, formatWords, GIF, sizeFor, type Choice } from "../../film/formats";
import { Filmer, GivenUp } from "../../film/filmer";
import { secondsOf, type Progress } from "../../film/orders";
import { timeLeft } from "../../words/sentences";
import { viewWords } from "../../view/heading";
import { dialogHeadStyle, dialogStyle } from "../shared/dialog-style";
import { icons } from "../shared/icons";
import { segmented, segmentedStyle } from "../shared/segmented";
import { barStyle, controls } from "../shared/shared";
import { filmDialogStyle } from "./film-dialog-style";
import "./film-preview";
import type { Previewed } from "./film-preview";
import { LOOK_WORDS, lookFor } from "./looks";
import { KINDS, LEAST_PX, MOST_PX, SHAPES, side, sizeWords, type Kind, type Shape } from "./plans";
import { wiresFor } from "./wires";

/** What pictures can be of, as the stage shows it. */
export interface Scenery {
  readonly wire: WireShape;
  /** The wires of the run that it came from, in their order; none where nobody kept them. */
  readonly way: readonly WireShape[];
  readonly body: BodyShape | null;
  readonly through: boolean;
  readonly look: LookName;
  readonly room: boolean;
  readonly dark: boolean;
  /** Where one can look from by name; the one that the stage shows, null where somebody turned it; and its camera, if there is one. */
  readonly views: readonly ViewName[];
  readonly view: ViewName | null;
  readonly pose: Pose | null;
}

type Ground = "light" | "dark" | "clear";

/** What people choose. */
interface Choices {
  readonly kind: Kind;
  readonly shape: Shape;
  readonly custom: Size;
  readonly room: boolean;
  readonly ground: Ground;
  readonly look: LookName;
  readonly from: ViewName | "stage";
  readonly asGif: boolean;
}

/** Pictures and films to post. `carrying` puts the wire into a picture, `save` is handed each with the end of its file's name, and answers with the whole of it. */
@customElement("film-dialog")
export class FilmDialog extends LitElement {
  @property({ attribute: false }) scenery!: Scenery;
  @property({ attribute: false }) save!: (made: Blob, ending: string) => string;
  @property({ attribute: false }) carrying!: (picture: Blob) => Promise<Blob>;
  @state() private kind: Kind = "picture";
  @state() private shape: Shape = "square";
  @state() private custom: Size = { width: 1600, height: 1200 };
  @state() private room = true;
  @state() private ground: Ground = "light";
  @state() private look: LookName = "copper";
  @state() private from: ViewName | "stage" = "room";
  @state() private asGif = false;
  /** What films of this size can be here; null until that is known. */
  @state() private best: Choice | null = null;
  @state() private progress: Progress | null = null;
  @state() private busy = false;
  @state() private said = "";
  @state() private problem = "";
  @state() private version = 0;
  @query("dialog") private dialog!: HTMLDialogElement;
  private readonly filmer = new Filmer();
  /** What stands before its camera. */
  private shown = "";

  static override styles = [controls, barStyle, dialogStyle, dialogHeadStyle, segmentedStyle, filmDialogStyle];

  override render() {
    const { kind, busy } = this;
    return html`<dialog aria-labelledby="title" @click=${this.clickedBeside} @cancel=${this.cancelled} @close=${this.closed}>
      <header>
        <h1 id="title">${msg("Pictures and films")}</h1>
        <button class="plain square" aria-label=${msg("Close")} @click=${() => this.dialog.close()}>${icons.close}</button>
      </header>
      <div class="body">
        <film-preview .filmer=${this.filmer} .of=${this.previewed} .version=${this.version} .rests=${busy} label=${msg(str`Preview: ${KINDS[kind].words.toLowerCase()}`)}></film-preview>
        <div class="choices">
          ${segmented({ ...this.segment("kind", msg("What")), options: this.kinds, value: kind, choose: (kind) => this.change({ kind: kind as Kind }) })}
          ${this.scenery.way.length < 2 ? html`<p class="small quiet">${msg(str`“${KINDS.found.words}” is there after a run of your own.`)}</p>` : nothing}
          ${segmented({ ...this.segment("shape", msg("Size")), options: SHAPE_OPTIONS, value: this.shape, choose: (shape) => this.change({ shape: shape as Shape }) })}
          ${this.shape === "custom" ? this.sides() : nothing}
          <div class="pair">
            ${segmented({ ...this.segment("room", msg("Show")), options: ROOM_OPTIONS, value: this.room ? "room" : "wire", choose: (what) => this.change({ room: what === "room" }) })}
            ${segmented({ ...this.segment("ground", msg("On")), options: kind === "picture" ? GROUNDS : GROUNDS.slice(0, 2), value: this.behind, choose: (ground) => this.change({ ground: ground as Ground }) })}
          </div>
          <div class="pair">
            ${this.field(msg("Look"), LOOK_NAMES.map((name) => [name, LOOK_WORDS[name]]), this.look, (look) => this.change({ look: look as LookName }))}
            ${kind === "picture" ? this.field(msg("Seen from"), this.vantages, this.from, (from) => this.change({ from: from as ViewName })) : this.formats()}
          </div>
        </div>
      </div>
      <footer>
        <div>
          <p class="small ${this.problem ? "problem" : "quiet"}" role="status">${this.problem || this.said || this.summary}</p>
          ${busy ? this.course() : nothing}
        </div>
        ${busy && kind !== "picture"
          ? html`<button id="cancel" @click=${() => this.filmer.giveUp()}>${icons.stop} ${msg("Cancel")}</button>`
          : html`<button id="make" class="primary" ?disabled=${busy || (kind !== "picture" && !this.choice)} @click=${() => void this.make()}>${icons.download} ${KINDS[kind].button}</button>`}
      </footer>
    </dialog>`;
  }

  /** Opens over the page, with what the stage shows. */
  show(): void {
    const { look, room, dark, view, pose } = this.scenery;
    Object.assign(this, { look, room, ground: dark ? "dark" : "light", from: view ?? (pose ? "stage" : "room"), kind: this.kind === "found" && this.scenery.way.length < 2 ? "picture" : this.kind });
    this.change({});
    if (!this.dialog.open) this.dialog.showModal();
  }

  protected override updated(changed: PropertyValues): void {
    this.renderRoot.querySelector<HTMLElement>(".bar i")?.style.setProperty("--share", String(this.progress ? this.progress.done / this.progress.frames : 0));
    if (changed.has("busy")) this.renderRoot.querySelector<HTMLElement>(this.busy ? "#cancel" : "#make")?.focus();
  }

  /** Something else is chosen: the last word about what was made goes. */
  private change(change: Partial<Choices>): void {
    Object.assign(this, change, { said: "", problem: "" });
    const { wire, way, body, through } = this.scenery;
    const subject = [this.kind === "found", this.look, this.dim, this.room].join();
    if (subject !== this.shown) {
      this.shown = subject;
      this.filmer.show({ wires: wiresFor(this.kind === "found" ? way : [], wire), look: lookFor(this.look, this.dim, this.room), body, through });
    }
    this.version++;
    void this.chooseFormat();
  }
  private async chooseFormat(): Promise<void> {
    const { size } = this;
    const best = await bestChoice(size);
    if (size.width === this.size.width && size.height === this.size.height) this.best = best;
  }

  private get choice(): Choice | null {
    return this.asGif ? GIF : this.best;
  }

  /** As it was chosen. */
  private get size(): Size {
    if (this.shape === "custom") return this.custom;
    const { width, height } = SHAPES[this.shape];
    return { width, height };
  }

  /** As it will be. */
  private get madeSize(): Size {
    return this.kind === "picture" || !this.choice ? this.size : sizeFor(this.choice, this.size);
  }

  /** A film has no clear ground: it keeps the walls that the page has. */
  private get behind(): Ground {
    return this.kind !== "picture" && this.ground === "clear" ? (this.scenery.dark ? "dark" : "light") : this.ground;
  }

  /** Whether the walls are dark; where nothing is behind them, those of the page. */
  private get dim(): boolean {
    return this.behind === "clear" ? this.scenery.dark : this.behind === "dark";
  }

  private get vantage(): Vantage | Pose {
    return this.from === "stage" ? (this.scenery.pose ?? "room") : this.from;
  }

  private get still() {
    return { from: this.vantage, ground: this.behind === "clear" ? ("transparent" as const) : ("wall" as const) };
  }

  private get previewed(): Previewed {
    const { kind, madeSize: size } = this;
    return kind === "picture" ? { ...this.still, size } : { film: kind, size };
  }

  /** How far it is: not for those who listen to be told at every frame. */
  private course() {
    const { progress } = this;
    const { done = 0, frames = 1, msLeft = 0 } = progress ?? {};
    const words = progress ? msg(str`Frame ${done} of ${frames}, ${timeLeft(Math.ceil(msLeft / 1000))}`) : "";
    return html`<p id="course" class="small quiet">${words}</p>
      <div class="bar" role="progressbar" aria-labelledby="course" aria-valuenow=${Math.round((100 * done) / frames)}><i></i></div>`;
  }

  /** What is being made, or would be. */
  private get summary(): string {
    const { kind, choice } = this;
    if (this.busy) return kind === "picture" ? msg("Drawing the picture.") : msg("Making the film.");
    const { width, height } = this.madeSize;
    const pixels = msg(str`${width} × ${height} pixels`);
    if (kind === "picture") return msg(str`${pixels}, PNG`);
    return choice ? msg(str`${pixels}, ${secondsOf(kind)} seconds. ${formatWords(choice, this.asGif)}`) : "";
  }

  private get kinds() {
    return (Object.keys(KINDS) as Kind[]).filter((kind) => kind !== "found" || this.scenery.way.length > 1).map((kind) => ({ value: kind, words: KINDS[kind].words }));
  }

  private get vantages(): (readonly [string, string])[] {
    return [...(this.scenery.pose ? [["stage", msg("As on the stage")] as const] : []), ...this.scenery.views.map((view) => [view, viewWords(view)] as const)];
  }

  private segment(name: string, legend: string) {
    return { name, legend, locked: this.busy };
  }

  private field(words: string, options: readonly (readonly [string, string])[], value: string, choose: (value: string) => void) {
    return html`<label class="field">${words}
      <select ?disabled=${this.busy} @change=${(event: Event) => choose((event.target as HTMLSelectElement).value)}>
        ${options.map(([name, words]) => html`<option value=${name} .selected=${name === value}>${words}</option>`)}
      </select>
    </label>`;
  }

  private formats() {
    if (!this.best || this.best.format === "gif") return nothing;
    const { format } = this.best;
    const options = [{ value: format, words: format === "mp4" ? "MP4" : "WebM" }, { value: "gif", words: "GIF" }];
    return segmented({ ...this.segment("format", msg("As")), options, value: this.asGif ? "gif" : format, choose: (as) => this.change({ asGif: as === "gif" }) });
  }

  private sides() {
    const field = (name: "width" | "height") => html`<input
      type="number"
      aria-label=${msg(str`${name === "width" ? msg("Width") : msg("Height")} in pixels`)}
      min=${LEAST_PX}
      max=${MOST_PX}
      ?disabled=${this.busy}
      .value=${String(this.custom[name])}
      @change=${({ target }: Event) => {
        const input = target as HTMLInputElement;
        this.change({ custom: { ...this.custom, [name]: side(input.valueAsNumber, this.custom[name]) } });
        input.value = String(this.custom[name]);
      }}
    />`;
    return html`<div class="sides">${field("width")}<span aria-hidden="true">×</span>${field("height")}</div>`;
  }

  private async make(): Promise<void> {
    const { kind, choice, madeSize: size } = this;
    Object.assign(this, { busy: true, progress: null, said: "", problem: "" });
    try {
      const made = kind === "picture" || !choice ? await this.carrying(await this.filmer.still({ ...this.still, size })) : await this.filmer.film({ film: kind, size, choice }, (progress) => (this.progress = progress));
      const name = this.save(made, `${KINDS[kind].ending}.${kind === "picture" || !choice ? "png" : choice.format}`);
      this.said = msg(str`Saved ${name}, ${sizeWords(made.size)}`);
    } catch (error) {
      if (error instanceof GivenUp) {
        this.said = msg("Cancelled. Nothing was saved.");
      } else {
        console.error(error);
        const instead = kind === "picture" ? msg("A smaller size may do.") : choice?.format === "gif" ? msg("A smaller size, or a picture, may do.") : msg("A smaller size, or a GIF, may do.");
        this.problem = msg(str`It could not be made: ${(error as Error).message}. Nothing is lost. ${instead}`);
      }
    }
    this.busy = false;
  }

  /** Escape gives up a film first, and closes then. */
  private readonly cancelled = (event: Event): void => {
    if (!this.busy) return;
    event.preventDefault();
    this.filmer.giveUp();
  };

  private readonly closed = (): void => {
    this.filmer.giveUp();
    this.remove();
  };

  private readonly clickedBeside = (event: Event): void => {
    if (event.target === this.dialog && !this.busy) this.dialog.close();
  };
}

const SHAPE_OPTIONS = [...Object.entries(SHAPES).map(([value, { words, width, height }]) => ({ value, words, title: `${width} × ${height}` })), { value: "custom", words: msg("Other") }];
const ROOM_OPTIONS = [{ value: "room", words: msg("Room") }, { value: "wire", words: msg("Wire") }];
const GROUNDS = [{ value: "light", words: msg("Light") }, { value: "dark", words: msg("Dark") }, { value: "clear", words: msg("Clear") }];
