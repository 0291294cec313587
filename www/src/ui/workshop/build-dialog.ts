import { msg, str } from "@lit/localize";
import { css, html, LitElement, nothing, type PropertyValues, type TemplateResult } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { count, decimal } from "../../words/numbers";
import { asSentence } from "../../words/sentences";
import type { Kind, MetalName, PaperName, Plan, Wishes } from "../../workshop/orders";
import { Workshop } from "../../workshop/workshop";
import { fileButtonStyle } from "../save/file-button-style";
import { dialogHeadStyle, dialogStyle } from "../shared/dialog-style";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";
import { stepPicture } from "./step-picture";

/** Who types a number means its last digit. */
const BREATH_MS = 250;

const METAL_WORDS: Readonly<Record<MetalName, string>> = { copper: msg("Copper"), aluminium: msg("Aluminium"), steel: msg("Steel") };
const PAPER_WORDS: Readonly<Record<PaperName, string>> = { a4: "A4", letter: msg("US Letter") };

const FILES: Readonly<Record<Kind, { readonly name: string; readonly use: string; readonly ending: string }>> = {
  pdf: { name: msg("Plan on paper"), use: msg("True size from three sides, bends, every step: PDF"), ending: "-plan.pdf" },
  md: { name: msg("Bend list"), use: msg("For hands: feed, turn, bend"), ending: "-bends.md" },
  csv: { name: msg("Bend list for machines"), use: msg("Feed, turn and bend: CSV"), ending: "-bends.csv" },
  jig: { name: msg("Jig to print"), use: msg("Numbered grooves that hold the wire: 3MF"), ending: "-jig.3mf" },
  "3mf": { name: msg("The wire to print"), use: msg("One solid: 3MF"), ending: "-print.3mf" },
  stl: { name: msg("The same as STL"), use: msg("For any slicer"), ending: "-print.stl" },
};

/** How to build the wire of real wire, or print it. `save` is handed each file with the end of its name, and answers with the whole of it. */
@customElement("build-dialog")
export class BuildDialog extends LitElement {
  /** A wire.json. */
  @property({ attribute: false }) file!: Uint8Array<ArrayBuffer>;
  @property({ attribute: false }) save!: (made: Blob, ending: string) => string;
  @state() private wishes: Wishes = { name: "", sizeMm: 200, wireMm: 1.6, metal: "copper", stockMm: 5000, paper: "a4", plate: false };
  @state() private plan: Plan | null = null;
  @state() private problem = "";
  @state() private said = "";
  @state() private busy: Kind | "plan" | null = null;
  @state() private at = 0;
  @query("dialog") private dialog!: HTMLDialogElement;
  private workshop!: Workshop;
  private soon: ReturnType<typeof setTimeout> | undefined;
  private asked = 0;

  static override styles = [
    controls,
    dialogStyle,
    dialogHeadStyle,
    fileButtonStyle,
    css`
      dialog {
        width: min(960px, calc(100vw - 32px));
      }
      .body {
        display: grid;
        grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
        align-items: start;
        gap: 24px;
        padding: 8px 24px 24px;
      }
      .wishes {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        gap: 12px;
      }
      label {
        display: grid;
        gap: 4px;
        min-width: 0;
        font-size: 13px;
        color: var(--quiet);
      }
      label.check {
        grid-column: 1 / -1;
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: 40px;
        font-size: 15px;
        color: var(--ink);
      }
      label input,
      label select {
        min-width: 0;
        font-size: 15px;
        color: var(--ink);
      }
      .verdict {
        margin: 16px 0;
        padding: 12px 16px;
        border-inline-start: 3px solid var(--copper);
        background: color-mix(in srgb, var(--ink) 4%, transparent);
      }
      .verdict p {
        margin: 0;
      }
      .verdict p + p {
        margin-block-start: 4px;
      }
      .verdict[aria-busy="true"] {
        opacity: 0.6;
      }
      h2 {
        margin: 0 0 8px;
        font-size: 15px;
        font-weight: 600;
      }
      .files {
        display: grid;
        gap: 8px;
      }
      .step svg {
        display: block;
        width: 100%;
        max-height: 46dvh;
        border-radius: 4px;
        background: color-mix(in srgb, var(--ink) 4%, transparent);
      }
      path.ahead {
        stroke: color-mix(in srgb, var(--ink) 14%, transparent);
      }
      path.done {
        stroke: var(--quiet);
      }
      path.new {
        stroke: var(--copper);
      }
      circle.new {
        fill: var(--copper);
      }
      .walk {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr) auto;
        align-items: center;
        gap: 8px;
        margin-block: 8px;
      }
      .problem {
        color: var(--error);
      }
      @media (max-width: 719px) {
        .body {
          grid-template-columns: minmax(0, 1fr);
          padding-inline: 16px;
        }
        header {
          padding-inline: 16px;
        }
      }
    `,
  ];

  override render() {
    const { wishes } = this;
    return html`<dialog aria-labelledby="title" @click=${this.clickedBeside} @close=${this.closed}>
      <header>
        <h1 id="title">${msg("Build it")}</h1>
        <button class="plain square" aria-label=${msg("Close")} @click=${() => this.dialog.close()}>${icons.close}</button>
      </header>
      <div class="body">
        <div>
          <div class="wishes">
            ${this.number("sizeMm", msg("Longest side, mm"), 20, 2000, 10)} ${this.number("wireMm", msg("Thickness of the wire, mm"), 0.4, 12, 0.1)}
            ${this.select("metal", msg("Metal"), METAL_WORDS)} ${this.select("paper", msg("Paper"), PAPER_WORDS)}
            <label>${msg("Name")}<input type="text" maxlength="40" .value=${wishes.name} @change=${(event: Event) => this.change({ name: (event.target as HTMLInputElement).value.trim() })} /></label>
            ${this.number("stockMm", msg("A piece of wire, mm"), 100, 100_000, 100)}
            <label class="check"><input type="checkbox" .checked=${wishes.plate} @change=${(event: Event) => this.change({ plate: (event.target as HTMLInputElement).checked })} /> ${msg("Print it on a plate with its name")}</label>
          </div>
          <div class="verdict" role="status" aria-busy=${this.busy === "plan"}>${this.verdict()}</div>
          <h2>${msg("Take along")}</h2>
          <div class="files">${(Object.keys(FILES) as Kind[]).map((kind) => this.fileButton(kind))}</div>
          <p class="small ${this.problem ? "problem" : "quiet"}" role="status">${this.problem ? nothing : this.said}</p>
        </div>
        ${this.plan ? this.step(this.plan) : html`<div></div>`}
      </div>
    </dialog>`;
  }

  show(name: string): void {
    this.workshop = new Workshop(this.file);
    // Letters that a plate can have; others stand on paper alone.
    this.wishes = { ...this.wishes, name };
    this.dialog.showModal();
    void this.think();
  }

  protected override updated(changed: PropertyValues): void {
    if (changed.has("plan") && this.plan) this.at = Math.min(this.at, this.plan.steps.length - 1);
  }

  private verdict(): TemplateResult | string {
    if (this.problem) return html`<p class="problem">${this.problem}</p>`;
    const { plan } = this;
    if (!plan) return html`<p>${msg("Measuring the wire…")}</p>`;
    const grams = plan.mass_g < 10 ? decimal(plan.mass_g, 1) : count(Math.round(plan.mass_g));
    return html`<p><b>${plan.passes ? msg("It can be bent like this.") : msg("It cannot be bent like this.")}</b></p>
      ${plan.sentences.map((sentence) => html`<p class="small">${asSentence(sentence)}</p>`)}
      <p class="small quiet">${msg(str`${decimal(plan.length_mm / 1000, 2)} m of wire, ${grams} g, ${count(plan.bends)} bends`)}</p>`;
  }

  private step(plan: Plan): TemplateResult {
    const last = plan.steps.length - 1;
    const at = Math.min(this.at, last);
    const go = (to: number): void => void (this.at = Math.max(0, Math.min(last, to)));
    return html`<div class="step">
      <h2>${msg("Step by step")}</h2>
      ${stepPicture(plan, at)}
      <div class="walk">
        <button class="square" aria-label=${msg("The step before")} ?disabled=${at === 0} @click=${() => go(at - 1)}>${icons.undo}</button>
        <input type="range" aria-label=${msg("Step of bending")} aria-valuetext=${msg(str`Step ${at + 1} of ${last + 1}`)} min="0" max=${last} .value=${String(at)} @input=${(event: Event) => go((event.target as HTMLInputElement).valueAsNumber)} />
        <button class="square" aria-label=${msg("The next step")} ?disabled=${at === last} @click=${() => go(at + 1)}>${icons.redo}</button>
      </div>
      <p class="small"><b>${msg(str`Step ${at + 1} of ${last + 1}`)}</b> ${asSentence(plan.steps[at]!.sentence)}</p>
    </div>`;
  }

  private number(name: "sizeMm" | "wireMm" | "stockMm", words: string, min: number, max: number, step: number): TemplateResult {
    return html`<label>${words}<input id=${name} type="number" min=${min} max=${max} step=${step} .value=${String(this.wishes[name])} @input=${(event: Event) => {
      const { valueAsNumber: value } = event.target as HTMLInputElement;
      if (Number.isFinite(value)) this.change({ [name]: value });
    }} /></label>`;
  }

  private select<Name extends "metal" | "paper">(name: Name, words: string, options: Readonly<Record<Wishes[Name], string>>): TemplateResult {
    return html`<label>${words}<select id=${name} @change=${(event: Event) => this.change({ [name]: (event.target as HTMLSelectElement).value } as Partial<Wishes>)}>
      ${Object.entries<string>(options).map(([value, words]) => html`<option value=${value} .selected=${value === this.wishes[name]}>${words}</option>`)}
    </select></label>`;
  }

  private fileButton(kind: Kind): TemplateResult {
    const { name, use } = FILES[kind];
    return html`<button class="file" ?disabled=${this.busy !== null || this.problem !== ""} aria-busy=${this.busy === kind} @click=${() => void this.make(kind)}>
      ${icons.download}<span><b>${name}</b><span class="small quiet">${this.busy === kind ? msg("Being made…") : use}</span></span>
    </button>`;
  }

  private change(change: Partial<Wishes>): void {
    this.wishes = { ...this.wishes, ...change };
    this.said = "";
    clearTimeout(this.soon);
    this.soon = setTimeout(() => void this.think(), BREATH_MS);
  }

  private async think(): Promise<void> {
    const asked = ++this.asked;
    this.busy = "plan";
    try {
      const plan = await this.workshop.plan(this.wishes);
      if (asked === this.asked) [this.plan, this.problem] = [plan, ""];
    } catch (error) {
      if (asked === this.asked && this.isConnected) [this.plan, this.problem] = [null, plainly(error)];
    }
    if (asked === this.asked) this.busy = null;
  }

  private async make(kind: Kind): Promise<void> {
    [this.busy, this.said] = [kind, ""];
    try {
      const made = await this.workshop.made(this.wishes, kind);
      const name = this.save(new Blob([made]), FILES[kind].ending);
      this.said = msg(str`Saved ${name}`);
    } catch (error) {
      // The wire can still be built: only this file is not to be had.
      this.said = plainly(error);
    }
    this.busy = null;
  }

  private readonly closed = (): void => {
    clearTimeout(this.soon);
    this.asked++;
    this.workshop.close();
    this.remove();
  };

  private readonly clickedBeside = (event: Event): void => {
    if (event.target === this.dialog) this.dialog.close();
  };
}

/** The core names settings as the command line does. */
const plainly = (error: unknown): string => asSentence((error as Error).message.replace(/^--size-mm\b/, msg("the longest side")).replace(/^--wire-mm\b/, msg("the wire")).replace(/^--stock-mm\b/, msg("a piece of wire")));

export async function openWorkshop(file: Uint8Array<ArrayBuffer>, name: string, save: BuildDialog["save"]): Promise<void> {
  const dialog = document.body.appendChild(new BuildDialog());
  Object.assign(dialog, { file, save });
  await dialog.updateComplete;
  dialog.show(name);
}
