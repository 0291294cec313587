import { msg, str } from "@lit/localize";
import { html, LitElement, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { count } from "../../words/numbers";
import { deskOf, type Studio, type StudioState } from "../../state/studio";
import { dialogStyle } from "../shared/dialog-style";
import { icons } from "../shared/icons";
import type { PageTask } from "../shared/page-task";
import { segmented, segmentedStyle } from "../shared/segmented";
import { controls } from "../shared/shared";
import { walkTabs } from "../shared/tablist";
import { copied } from "./copied";
import { download } from "./download";
import "./embed-panel";
import { fileStem } from "./file-name";
import { labelsOf } from "./labels";
import { pngOfSvg } from "./png";
import { MOST_IN_QR, qrOf, qrSvg, type QrCode } from "./qr";
import { shareDialogStyle } from "./share-dialog-style";
import type { Simplified } from "../../engine/protocol";
import { simplified } from "./simplified";
import { webPage } from "./web-page";
import { altOf, titleOf } from "./wire-words";

/** Longer links are cut off by some mail and chat programs. */
const LONG_LINK = 8_000;
/** Pixels a side of a QR code as it is shown, and as a picture; about. */
const SHOWN_PX = 320;
const QR_PX = 1480;

const TABS = ["share", "embed"] as const;
type Tab = (typeof TABS)[number];
const TAB_WORDS: Readonly<Record<Tab, string>> = { share: msg("Share"), embed: msg("Embed") };

/** The wire for others: a link, a QR code, a file, or a piece of one's own page. */
@customElement("share-dialog")
export class ShareDialog extends LitElement {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) task!: PageTask;
  @state() private now!: StudioState;
  @state() private tab: Tab = "share";
  @state() private whole = "";
  @state() private simple: Simplified | null = null;
  @state() private simplify = false;
  /** What was just done, in words. */
  @state() private done = "";
  @state() private busy = false;
  @query("dialog") private dialog!: HTMLDialogElement;
  @query("#link") private field!: HTMLInputElement;

  static override styles = [controls, dialogStyle, segmentedStyle, shareDialogStyle];

  override render() {
    return html`<dialog aria-labelledby="title" @click=${this.clickedBeside}>
      <header>
        <h1 id="title">${this.now ? titleOf(this.labels) : nothing}</h1>
        <button class="plain square" aria-label=${msg("Close")} @click=${() => this.dialog.close()}>${icons.close}</button>
      </header>
      <div class="tabs" role="tablist" aria-label=${msg("How to share")} @keydown=${(event: KeyboardEvent) => walkTabs(event, TABS, (tab) => (this.tab = tab))}>
        ${TABS.map(
          (tab) => html`<button
            role="tab"
            id="tab-${tab}"
            aria-selected=${tab === this.tab}
            aria-controls="panel"
            tabindex=${tab === this.tab ? 0 : -1}
            @click=${() => (this.tab = tab)}
          >
            ${TAB_WORDS[tab]}
          </button>`,
        )}
      </div>
      <div id="panel" class="body" role="tabpanel" aria-labelledby="tab-${this.tab}">${this.now ? this.panel() : nothing}</div>
      <p class="unseen" role="status">${this.done}</p>
    </dialog>`;
  }

  /** Shows it for the wire that is on the stage; false where there is none. */
  async show(): Promise<boolean> {
    const link = this.studio.saver.link(location.href);
    if (!link) return false;
    this.now = this.studio.store.get();
    this.whole = link;
    this.simple = null;
    this.simplify = false;
    this.done = "";
    this.tab = "share";
    await this.updateComplete;
    if (!this.dialog.open) this.dialog.showModal();
    void this.lookForSimpler();
    return true;
  }

  private panel() {
    const { link, shareCode, labels } = this;
    if (this.tab === "share") return this.sharing(link);
    return html`<embed-panel .studio=${this.studio} .code=${shareCode} .alt=${altOf(labels)} .stem=${fileStem(labels)} .views=${this.views} .page=${() => this.page()} @done=${this.tell}></embed-panel>`;
  }

  private sharing(link: string) {
    const code = qrOf(link);
    return html`
      <p>${msg("Whoever opens this link gets the whole wire, to turn round and to go on with. No server keeps it.")}</p>
      ${this.longLink()}
      <div class="line">
        <input id="link" type="text" readonly aria-label=${msg("The link")} .value=${link} @focus=${(event: Event) => (event.target as HTMLInputElement).select()} />
        <button class="primary" autofocus @click=${() => void this.copy()}>${this.done === COPIED ? icons.check : icons.link} ${this.done === COPIED ? msg("Copied") : msg("Copy link")}</button>
      </div>
      ${"share" in navigator ? html`<button class="send" @click=${() => void this.send()}>${icons.share} ${msg("Send it with…")}</button>` : nothing}
      <hr />
      <div class=${code ? "ways with-code" : "ways"}>${code ? this.code(code) : nothing} ${this.aboutCode(code, link)} ${this.files()}</div>
    `;
  }

  private longLink() {
    const { simple, whole } = this;
    const long = whole.length > LONG_LINK;
    if (!simple) return long ? html`<p class="note">${icons.warning} <span>${msg(str`This wire makes a link of ${count(whole.length)} characters, and some programs cut those off. A file is safer.`)}</span></p>` : nothing;
    const words = msg(str`${count(whole.length)} characters`);
    const shorter = this.simpler!.length;
    return html`<div class="simpler">
      ${segmented({
        legend: long ? msg("Some programs cut off links this long.") : msg("The whole link is too long for a QR code."),
        name: "length",
        options: [
          { value: "whole", words: msg(str`Whole, ${words}`) },
          { value: "simple", words: msg(str`Simplified, ${count(shorter)}`) },
        ],
        value: this.simplify ? "simple" : "whole",
        choose: (value) => (this.simplify = value === "simple"),
      })}
      <p class="small quiet">${msg(str`Simplified, its lines move by ${px(simple.mean_px)} on average and by ${px(simple.most_px)} at most, seen 512 px wide.`)}</p>
    </div>`;
  }

  private code(code: QrCode) {
    return html`<svg class="code" viewBox="0 0 ${code.side} ${code.side}" width=${wholeModules(code)} role="img" aria-label=${msg("QR code of the link")} shape-rendering="crispEdges">
      <path fill="#fff" d="M0 0h${code.side}v${code.side}H0z" />
      <path fill="#000" d=${code.path} />
    </svg>`;
  }

  private aboutCode(code: QrCode | null, link: string) {
    return html`<section aria-labelledby="qr">
      <h2 id="qr">${msg("QR code")}</h2>
      ${code
        ? html`<p class="small quiet">${msg("Point a phone's camera at it: it holds the whole wire.")}</p>
            <div class="pair">
              <button @click=${() => void this.keepCode(code, "png")}>${icons.download} ${msg("PNG")}</button>
              <button @click=${() => void this.keepCode(code, "svg")}>${icons.download} ${msg("SVG")}</button>
            </div>`
        : html`<p class="small quiet">${msg(str`A code holds ${count(MOST_IN_QR)} characters at most, and this link has ${count(link.length)}.`)}</p>`}
    </section>`;
  }

  private files() {
    return html`<section aria-labelledby="files">
      <h2 id="files">${msg("As a file")}</h2>
      <button class="file" ?disabled=${this.busy} @click=${() => void this.savePage()}>
        ${icons.download}<span><b>${msg("Web page")}</b><span class="small quiet">${msg("One HTML file: shows it in 3D anywhere, without a network")}</span></span>
      </button>
      <button class="file" ?disabled=${this.busy} @click=${() => void this.saveProject()}>
        ${icons.file}<span><b>${msg("wire.json")}</b><span class="small quiet">${msg("To open here again and go on")}</span></span>
      </button>
    </section>`;
  }

  private get labels(): readonly string[] {
    return labelsOf(this.now, this.task);
  }

  private get views(): readonly string[] {
    return this.now.views.map(({ name }) => name);
  }

  private get finished() {
    return deskOf(this.now.doc).made!.finished;
  }

  private get shareCode(): string {
    return this.simplify && this.simple ? this.simple.code : this.finished.code;
  }

  private get simpler(): string | null {
    return this.simple && this.whole.replace(this.finished.code, this.simple.code);
  }

  private get link(): string {
    return (this.simplify && this.simpler) || this.whole;
  }

  /** One that fits where the whole does not: a chat, else a QR code. */
  private async lookForSimpler(): Promise<void> {
    const { whole } = this;
    if (whole.length <= MOST_IN_QR) return;
    const most = (whole.length > LONG_LINK ? LONG_LINK : MOST_IN_QR) - (whole.length - this.finished.code.length);
    const simple = await simplified(this.studio.bench.engine, this.finished.file, most);
    if (whole === this.whole) this.simple = simple;
  }

  private async copy(): Promise<void> {
    if (await copied(this.link, this.field)) this.done = COPIED;
    else this.done = msg("Copy the marked link with Ctrl or ⌘ and C");
  }

  private async send(): Promise<void> {
    try {
      await navigator.share({ title: titleOf(this.labels), url: this.link });
      this.done = msg("Sent");
    } catch (error) {
      // Whoever closes the sheet has changed their mind.
      if ((error as DOMException).name !== "AbortError") this.done = msg("It could not be sent. Copy the link instead.");
    }
  }

  private async keepCode(code: QrCode, kind: "png" | "svg"): Promise<void> {
    const text = qrSvg(code);
    const blob = kind === "svg" ? new Blob([text], { type: "image/svg+xml" }) : await pngOfSvg(text, QR_PX - (QR_PX % code.side) || code.side);
    this.keep(blob, `-qr.${kind}`);
  }

  private savePage(): Promise<void> {
    return this.saving(() => this.page(), ".html");
  }

  private saveProject(): Promise<void> {
    return this.saving(() => this.studio.saver.export("wire.json"), ".wire.json");
  }

  private async saving(make: () => Promise<Blob | null>, ending: string): Promise<void> {
    this.busy = true;
    try {
      const blob = await make();
      if (blob) this.keep(blob, ending);
      else this.done = msg("The file could not be made.");
    } catch (error) {
      console.error(error);
      this.done = msg("The file could not be made. Check the connection and try again.");
    }
    this.busy = false;
  }

  /** The wire as one HTML file. */
  private page(): Promise<Blob> {
    return webPage({ saver: this.studio.saver, code: this.finished.code, title: titleOf(this.labels), description: altOf(this.labels), view: this.views[0] ?? "front" });
  }

  private keep(blob: Blob, ending: string): void {
    const name = fileStem(this.labels) + ending;
    download(blob, name);
    this.done = msg(str`Saved ${name}`);
  }

  private readonly tell = ({ detail }: CustomEvent<string>): void => void (this.done = detail);

  private readonly clickedBeside = (event: Event): void => {
    if (event.target === this.dialog) this.dialog.close();
  };
}

const COPIED = msg("Link copied. It carries the whole wire.");
/** As wide as a code is shown: whole pixels a module. */
const wholeModules = ({ side }: QrCode): number => side * Math.max(1, Math.round(SHOWN_PX / side));
const px = (moved: number): string => `${moved.toFixed(1)} px`;
