import { msg, str } from "@lit/localize";
import { css, html, LitElement, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { Camera, GivenUp } from "../../photograph/camera";
import type { Pixels } from "../../photograph/orders";
import { percent } from "../../words/numbers";
import { asSentence, timeLeft } from "../../words/sentences";
import { filmDialogStyle } from "../film/film-dialog-style";
import { sizeWords } from "../film/plans";
import { dialogHeadStyle, dialogStyle } from "../shared/dialog-style";
import { icons } from "../shared/icons";
import { segmented, segmentedStyle } from "../shared/segmented";
import { barStyle, controls } from "../shared/shared";
import { FINISHES, FOCUS, FORMATS, PATIENCE, PLACES, SHADOWS, SKIES, wishesFor, type Choices } from "./choices";

/** Between a choice and its picture: who goes through choices sees the last. */
const BREATH_MS = 120;

/** What is photographed. */
export interface Sitter {
  /** A wire.json. */
  readonly file: Uint8Array<ArrayBuffer>;
  /** Where the stage's camera is, degrees; null where there is none. */
  readonly stage: { readonly azimuth: number; readonly elevation: number } | null;
  readonly place: Choices["place"];
}

/** A photograph of the wire, with real lamps and real shadows. `save` is handed it with the end of its file's name, and answers with the whole of it; `carrying` puts the wire into it. */
@customElement("photograph-dialog")
export class PhotographDialog extends LitElement {
  @property({ attribute: false }) sitter!: Sitter;
  @property({ attribute: false }) save!: (made: Blob, ending: string) => string;
  @property({ attribute: false }) carrying!: (picture: Blob) => Promise<Blob>;
  @state() private choices: Choices = { finish: "copper", shadows: "soft", focus: "all", patience: "good", format: "wide", place: "room", sky: "room", from: "corner" };
  /** Passes that are done of the photograph that is being taken; null while none is. */
  @state() private passes: number | null = null;
  @state() private said = "";
  @state() private problem = "";
  @query("dialog") private dialog!: HTMLDialogElement;
  @query("canvas") private canvas!: HTMLCanvasElement;
  private readonly camera = new Camera();
  private startMs = 0;
  private soon: ReturnType<typeof setTimeout> | undefined;

  static override styles = [
    controls,
    barStyle,
    dialogStyle,
    dialogHeadStyle,
    segmentedStyle,
    filmDialogStyle,
    css`
      dialog {
        width: min(960px, calc(100vw - 32px));
      }
      .body {
        grid-template-columns: minmax(0, 1.6fr) minmax(0, 1fr);
      }
      .picture {
        display: grid;
        place-items: center;
        align-self: stretch;
        min-height: 260px;
        border-radius: 4px;
        background: color-mix(in srgb, var(--ink) 6%, transparent);
      }
      canvas {
        display: block;
        max-width: 100%;
        max-height: 56dvh;
        border-radius: 4px;
      }
      @media (max-width: 719px) {
        .body {
          grid-template-columns: minmax(0, 1fr);
        }
        .picture {
          min-height: 0;
        }
        canvas {
          max-height: 34dvh;
        }
      }
    `,
  ];

  override render() {
    const { choices, busy } = this;
    const { width, height } = FORMATS[choices.format].size;
    return html`<dialog aria-labelledby="title" @click=${this.clickedBeside} @cancel=${this.cancelled} @close=${this.closed}>
      <header>
        <h1 id="title">${msg("Photograph")}</h1>
        <button class="plain square" aria-label=${msg("Close")} @click=${() => this.dialog.close()}>${icons.close}</button>
      </header>
      <div class="body">
        <div class="picture"><canvas role="img" aria-label=${msg("The photograph so far")} width=${width} height=${height}></canvas></div>
        <div class="choices">
          <label class="field">${msg("The wire is of")}
            <select id="finish" ?disabled=${busy} @change=${(event: Event) => this.change({ finish: (event.target as HTMLSelectElement).value as Choices["finish"] })}>
              ${Object.entries(FINISHES).map(([name, { words }]) => html`<option value=${name} .selected=${name === choices.finish}>${words}</option>`)}
            </select>
          </label>
          ${this.choice("shadows", msg("Shadows"), SHADOWS)} ${this.choice("focus", msg("In focus"), FOCUS)}
          ${this.choice("place", msg("Shadows fall on"), PLACES)} ${this.choice("sky", msg("Other light"), SKIES)}
          ${this.sitter.stage ? this.choice("from", msg("Seen from"), { corner: { words: msg("The corner") }, stage: { words: msg("As on the stage") } }) : nothing}
          ${this.choice("format", msg("Size"), FORMATS)} ${this.choice("patience", msg("Patience"), PATIENCE)}
        </div>
      </div>
      <footer>
        <div>
          <p class="small ${this.problem ? "problem" : "quiet"}" role="status">${this.problem || this.said || (busy ? msg("Taking the photograph.") : msg(str`${width} × ${height} pixels`))}</p>
          ${busy ? this.course() : nothing}
        </div>
        ${busy
          ? html`<button id="cancel" @click=${() => this.giveUp()}>${icons.stop} ${msg("Cancel")}</button>`
          : html`<button id="make" class="primary" @click=${() => void this.make()}>${icons.camera} ${msg("Take it")}</button>`}
      </footer>
    </dialog>`;
  }

  show(): void {
    this.choices = { ...this.choices, place: this.sitter.place };
    this.dialog.showModal();
    this.look();
  }

  protected override updated(changed: PropertyValues): void {
    this.renderRoot.querySelector<HTMLElement>(".bar i")?.style.setProperty("--share", String((this.passes ?? 0) / this.all));
    const before = changed.get("passes") as number | null | undefined;
    if (before !== undefined && (before === null) !== (this.passes === null)) this.renderRoot.querySelector<HTMLElement>(this.busy ? "#cancel" : "#make")?.focus();
  }

  private get busy(): boolean {
    return this.passes !== null;
  }

  private get all(): number {
    return PATIENCE[this.choices.patience].passes;
  }

  private choice<Name extends "shadows" | "focus" | "place" | "sky" | "from" | "format" | "patience">(name: Name, legend: string, options: Readonly<Record<string, { readonly words: string }>>) {
    return segmented({
      legend,
      name,
      locked: this.busy,
      options: Object.entries(options).map(([value, { words }]) => ({ value, words })),
      value: this.choices[name],
      choose: (value) => this.change({ [name]: value } as Partial<Choices>),
    });
  }

  private change(change: Partial<Choices>): void {
    this.choices = { ...this.choices, ...change };
    [this.said, this.problem] = ["", ""];
    clearTimeout(this.soon);
    this.soon = setTimeout(() => this.look(), BREATH_MS);
  }

  /** Shows small what it would be. */
  private look(): void {
    const { file, stage } = this.sitter;
    if (this.isConnected && !this.busy) this.camera.look(file, wishesFor(this.choices, stage), { picture: (pixels) => this.paint(pixels), progress: () => undefined });
  }

  private paint({ rgba, width, height }: Pixels): void {
    const { canvas } = this;
    [canvas.width, canvas.height] = [width, height];
    // Small ones are shown as large as the whole will be.
    canvas.style.width = `${FORMATS[this.choices.format].size.width}px`;
    canvas.style.aspectRatio = `${width} / ${height}`;
    canvas.getContext("2d")!.putImageData(new ImageData(rgba, width, height), 0, 0);
  }

  private async make(): Promise<void> {
    clearTimeout(this.soon);
    const { file, stage } = this.sitter;
    [this.said, this.problem, this.passes, this.startMs] = ["", "", 0, performance.now()];
    try {
      const pixels = await this.camera.take(file, wishesFor(this.choices, stage), this.all, {
        picture: (pixels, passes) => {
          this.paint(pixels);
          this.passes = passes;
        },
        progress: (passes) => (this.passes = passes),
      });
      this.paint(pixels);
      const png = await new Promise<Blob | null>((resolve) => this.canvas.toBlob(resolve, "image/png"));
      if (!png) throw new Error(msg("this browser could not write the picture"));
      const made = await this.carrying(png);
      const name = this.save(made, "-photograph.png");
      this.said = msg(str`Saved ${name}, ${sizeWords(made.size)}`);
    } catch (error) {
      if (error instanceof GivenUp) {
        this.said = msg("Cancelled. Nothing was saved.");
      } else {
        console.error(error);
        this.problem = asSentence((error as Error).message);
      }
    }
    this.passes = null;
  }

  private course() {
    const share = (this.passes ?? 0) / this.all;
    const seconds = (performance.now() - this.startMs) / 1000;
    const left = share > 0 ? timeLeft(Math.ceil((seconds / share) * (1 - share))) : "";
    const words = left ? msg(str`${percent(share)}, ${left}`) : msg("Setting up the lamps…");
    return html`<p id="course" class="small quiet">${words}</p>
      <div class="bar" role="progressbar" aria-labelledby="course" aria-valuenow=${Math.round(100 * share)}><i></i></div>`;
  }

  private giveUp(): void {
    this.camera.giveUp();
  }

  /** Escape gives a photograph up first, and closes then. */
  private readonly cancelled = (event: Event): void => {
    if (!this.busy) return;
    event.preventDefault();
    this.giveUp();
  };

  private readonly closed = (): void => {
    clearTimeout(this.soon);
    this.camera.giveUp();
    this.remove();
  };

  private readonly clickedBeside = (event: Event): void => {
    if (event.target === this.dialog && !this.busy) this.dialog.close();
  };
}

export async function openPhotograph(sitter: Sitter, how: Pick<PhotographDialog, "save" | "carrying">): Promise<void> {
  const dialog = document.body.appendChild(new PhotographDialog());
  Object.assign(dialog, { sitter, ...how });
  await dialog.updateComplete;
  dialog.show();
}
