import { msg, str } from "@lit/localize";
import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { ExportFormat } from "../../engine/protocol";
import { deskOf, type Studio, type StudioState } from "../../state/studio";
import { isLocked } from "../../state/common/locks";
import { viewWords } from "../../view/heading";
import { Part } from "../../view/part";
import { download } from "./download";
import { fileButtonStyle } from "./file-button-style";
import { fileStem } from "./file-name";
import { foldStyle } from "../shared/fold";
import { icons } from "../shared/icons";
import type { PageTask } from "../shared/page-task";
import { controls } from "../shared/shared";
import { labelsOf } from "./labels";
import { savePanelStyle } from "./save-panel-style";

interface FileKind {
  readonly format: ExportFormat;
  readonly name: string;
  readonly use: string;
}

const FIRST: readonly FileKind[] = [
  { format: "glb", name: "GLB", use: msg("For 3D viewers and AR") },
  { format: "stl", name: "STL", use: msg("For 3D printing, 10 cm") },
];
const MORE: readonly FileKind[] = [
  { format: "wire.json", name: "wire.json", use: msg("To open here again") },
  { format: "obj", name: "OBJ", use: msg("For modelling programs") },
  { format: "lines.svg", name: msg("Centre lines"), use: msg("For pen plotters, SVG of the view above, 10 cm") },
  { format: "bend.csv", name: msg("Bend list"), use: msg("To bend it by hand, CSV") },
];

/** The wire to take along: a link, or a file. */
@customElement("save-panel")
export class SavePanel extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @property({ attribute: false }) task!: PageTask;
  /** Takes the picture of the stage. */
  @property({ attribute: false }) picture!: () => Promise<Blob>;
  /** Opens pictures and films. */
  @property({ attribute: false }) film!: () => void;
  /** Opens the photograph. */
  @property({ attribute: false }) photograph!: () => void;
  /** Opens how to build it. */
  @property({ attribute: false }) build!: () => void;
  /** The link, where the clipboard is not to be had. */
  @state() private byHand = "";
  @state() private busy = "";
  @state() private view = "front";
  @query("#link") private field!: HTMLInputElement | null;

  static override styles = [controls, foldStyle, fileButtonStyle, savePanelStyle];

  override render() {
    const none = !deskOf(this.state.doc).made || this.state.phase !== "idle";
    const unshared = none || isLocked(this.state, "share");
    const { views, shown } = this;
    return html`
      <h2>${msg("Save and share")}</h2>
      <div class="links">
        <button class="link" ?disabled=${unshared} @click=${() => void this.copyLink()}>${icons.link} ${msg("Copy link")}</button>
        <button class="more" ?disabled=${unshared} @click=${() => void this.share()}>${msg("QR, embed…")}</button>
      </div>
      ${this.byHand
        ? html`<label class="small quiet" for="link">${msg("Copy it from here:")}</label><input id="link" type="text" readonly .value=${this.byHand} />`
        : nothing}
      <p class="small quiet">${this.carried()}</p>
      ${FIRST.map((kind) => this.file(kind, none))}
      <button class="file" ?disabled=${none || this.busy !== ""} @click=${() => void this.savePicture()}>
        ${icons.camera}<span><b>${msg("PNG")}</b><span class="small quiet">${msg("A picture of the stage")}</span></span>
      </button>
      <button class="file" ?disabled=${none} @click=${() => this.film()}>
        ${icons.pictures}<span><b>${msg("Pictures and films")}</b><span class="small quiet">${msg("To post: PNG, MP4, GIF")}</span></span>
      </button>
      <button class="file" ?disabled=${none} @click=${() => this.photograph()}>
        ${icons.aperture}<span><b>${msg("Photograph")}</b><span class="small quiet">${msg("With real lamps and shadows: PNG")}</span></span>
      </button>
      <button class="file" ?disabled=${none} @click=${() => this.build()}>
        ${icons.build}<span><b>${msg("Build it")}</b><span class="small quiet">${msg("Bend it by hand, or print it")}</span></span>
      </button>
      <div class="svg">
        ${this.file({ format: "svg", name: "SVG", use: msg("Lines of one view") }, none)}
        <select aria-label=${msg("View of the SVG")} ?disabled=${none} @change=${(event: Event) => (this.view = (event.target as HTMLSelectElement).value)}>
          ${views.map((name) => html`<option value=${name} .selected=${name === shown}>${viewWords(name)}</option>`)}
        </select>
      </div>
      <details>
        <summary>${msg("More files")} ${icons.more}</summary>
        <div class="group">${MORE.map((kind) => this.file(kind, none))}</div>
      </details>
      ${this.state.keeping === "off"
        ? html`<p class="small quiet">${msg("This browser keeps nothing between visits; save your wire to a file or link.")}</p>`
        : nothing}
    `;
  }

  private get views(): readonly string[] {
    const { views } = this.state;
    return views.length ? views.map(({ name }) => name) : ["front", "side", "top"];
  }

  /** The view that an SVG draws: the one that was chosen last, if this wire has it. */
  private get shown(): string {
    return this.views.includes(this.view) ? this.view : this.views[0]!;
  }

  private carried(): string {
    const { doc, planned } = this.state;
    const stays = this.task.stays?.(doc.given[doc.task]);
    const last = planned && deskOf(doc).made ? msg("All of these are of the wire that was made last.") : "";
    return [last, msg("The link carries the whole wire; no server keeps it."), stays].filter(Boolean).join(" ");
  }

  async copyLink(): Promise<void> {
    const link = this.studio.saver.link(location.href);
    if (!link) return;
    this.address(link);
    try {
      await navigator.clipboard.writeText(link);
      this.byHand = "";
      this.studio.say(msg("Link copied. It carries the whole wire."));
    } catch {
      this.byHand = link;
      await this.updateComplete;
      this.field?.select();
      this.studio.say(msg("The link is in the address bar, and here to copy."));
    }
  }

  /** More ways, which come when they are first wanted. */
  async share(): Promise<void> {
    const link = this.studio.saver.link(location.href);
    if (!link) return;
    this.address(link);
    const { ShareDialog } = await import("./share-dialog");
    const dialog = document.querySelector<InstanceType<typeof ShareDialog>>("share-dialog") ?? document.body.appendChild(new ShareDialog());
    Object.assign(dialog, { studio: this.studio, task: this.task });
    await dialog.show();
  }

  /** The wire's address, unless a lesson or a class has one of its own there. */
  private address(link: string): void {
    const { lesson, locks } = this.state;
    if (!lesson && locks.lock.length + locks.hide.length === 0) history.replaceState(null, "", new URL(link).hash);
  }

  private file({ format, name, use }: FileKind, none: boolean) {
    return html`<button class="file" ?disabled=${none || this.busy !== ""} aria-busy=${this.busy === format} @click=${() => void this.save(format)}>
      ${format === "wire.json" ? icons.file : icons.download}<span><b>${name}</b><span class="small quiet">${use}</span></span>
    </button>`;
  }

  private async save(format: ExportFormat): Promise<void> {
    this.busy = format;
    const view = this.shown;
    const blob = await this.studio.saver.export(format, view);
    this.busy = "";
    if (!blob) return;
    const ofView = `-${view.replace(/[^\w-]+/g, "-")}`;
    const endings: Partial<Record<ExportFormat, string>> = { svg: `${ofView}.svg`, "lines.svg": `${ofView}-lines.svg`, "bend.csv": "-bends.csv" };
    this.keep(blob, endings[format] ?? `.${format}`);
  }

  private async savePicture(): Promise<void> {
    this.busy = "png";
    try {
      this.keep(await this.picture(), ".png");
    } catch (error) {
      console.error(error);
      this.studio.warn(msg("The picture could not be taken. Nothing is lost; a screenshot of the page does it, too."));
    }
    this.busy = "";
  }

  /** Hands it to the browser's downloads; the name it has there. */
  keep(blob: Blob, ending: string): string {
    const name = fileStem(labelsOf(this.state, this.task)) + ending;
    download(blob, name);
    this.studio.say(msg(str`Saved ${name}`));
    return name;
  }
}
