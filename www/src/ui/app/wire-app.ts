import { html, LitElement, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { LookName } from "../../embed/looks";
import { addressed } from "../../state/address/address";
import { nextTask } from "../../state/next-task";
import { SLOTS, Studio, type StudioState } from "../../state/studio";
import { layout, NARROW } from "./app-layout";
import type { EditRequest } from "../pads/drawing-pad";
import "./drop-hint";
import "./live-region";
import type { LiveRegion } from "./live-region";
import { pageTitle } from "./page-title";
import { loadParts, rendered } from "./parts";
import { remember, remembered } from "../../state/keeping/remember";
import type { ResultPanel } from "../run/result-panel";
import type { SavePanel } from "../save/save-panel";
import { controls } from "../shared/shared";
import { actionOf, isTaken, type Action } from "./shortcuts";
import { tabs, tabsStyle, type Tab } from "./tabs";
import "./top-bar";
import type { WireStage } from "../stage/wire-stage";

interface LookChange {
  readonly look: LookName;
  readonly room: boolean;
}

/** The whole page: its parts, and the wiring between them and the studio. */
@customElement("wire-app")
export class WireApp extends LitElement {
  private readonly studio = new Studio();
  private readonly narrow = matchMedia(NARROW);
  @state() private now: StudioState = this.studio.store.get();
  /** Before, parts may still move as others come: they are not shown. */
  @state() private opened = false;
  @state() private tab: Tab = "pictures";
  @state() private editing: EditRequest | null = null;
  @state() private look: LookChange = { look: (remembered("look") as LookName | null) ?? "copper", room: remembered("room") !== "off" };
  @query("wire-stage") private stage!: WireStage;
  @query("result-panel") private result!: ResultPanel;
  @query("save-panel") private saving!: SavePanel;
  @query("live-region") private live!: LiveRegion;
  /** Whether a run has ended since somebody last looked. */
  private unseen = false;
  private titled = "";
  private readonly ending = new AbortController();

  static override styles = [controls, tabsStyle, layout];

  override render() {
    const { studio, now, look, editing } = this;
    const idle = now.phase === "idle";
    return html`
      <top-bar role="banner" .studio=${studio} .state=${now} @share=${() => void this.saving.copyLink()} @help=${() => void this.help()}></top-bar>
      <main class=${this.opened ? "" : "coming"}>
        <div class="left" tabindex=${idle ? nothing : 0} role=${idle ? nothing : "group"} aria-label=${idle ? nothing : "Drawings, at rest during a run"}>
          <section id="part-pictures" role=${this.panel()} aria-label="Pictures" ?hidden=${this.folded("pictures")} @open-editor=${this.openEditor}>
            ${SLOTS.map((slot) => html`<drawing-pad .studio=${studio} .state=${now} .slotName=${slot}></drawing-pad>`)}
            <remedy-list .studio=${studio} .state=${now}></remedy-list>
          </section>
        </div>
        <wire-stage .look=${look.look} .room=${look.room} @look-change=${this.changeLook}></wire-stage>
        ${this.narrow.matches ? nothing : this.timeLine()}
        ${editing
          ? html`<pad-editor .studio=${studio} .state=${now} .slot=${editing.slot} .tab=${editing.tab} @close-editor=${this.closeEditor}></pad-editor>`
          : nothing}
        <notice-list .studio=${studio} .state=${now}></notice-list>
        <div class="right">
          <run-panel .studio=${studio} .state=${now} @draw=${() => this.edit({ slot: "front", tab: "draw" })}></run-panel>
          <section id="part-run" role=${this.panel()} aria-label="Run and match" ?hidden=${this.folded("run")}>
            ${this.narrow.matches ? this.timeLine() : nothing}
            <run-choices .studio=${studio} .state=${now}></run-choices>
            <result-panel .state=${now}></result-panel>
          </section>
          <section id="part-share" role=${this.panel()} aria-label="Save and share" ?hidden=${this.folded("share")}>
            <save-panel .studio=${studio} .state=${now} .picture=${() => this.stage.picture(2400, 1800)}></save-panel>
          </section>
          <section id="part-settings" role=${this.panel()} aria-label="Settings" ?hidden=${this.folded("settings")}>
            <settings-panel
              .studio=${studio}
              .table=${now.table}
              .settings=${now.doc.settings}
              .where=${now.where}
              .whenHidden=${now.whenHidden}
              ?locked=${!idle}
            >
              <look-panel .look=${look.look} .room=${look.room} @look-change=${this.changeLook}></look-panel>
            </settings-panel>
          </section>
        </div>
        ${this.narrow.matches ? tabs(this.tab, (tab) => (this.tab = tab)) : nothing}
      </main>
      <drop-hint ?locked=${!idle} @files=${(event: CustomEvent<DataTransfer | null>) => this.take(event.detail)}></drop-hint>
      <live-region></live-region>
    `;
  }

  protected override firstUpdated(): void {
    void this.open();
  }

  private async open(): Promise<void> {
    await nextTask();
    await loadParts();
    await rendered(this.renderRoot);
    this.opened = true;
    this.begin();
  }

  private begin(): void {
    const { signal } = this.ending;
    this.studio.store.follow((now) => this.follow(now));
    this.studio.followWire((wire) => {
      this.stage.setWire(wire);
      this.result.setWire(wire);
    });
    addEventListener("hashchange", () => void this.studio.openFragment(location.hash), { signal });
    addEventListener("paste", (event) => this.paste(event), { signal });
    addEventListener("keydown", (event) => this.press(event), { signal });
    addEventListener("pagehide", () => this.studio.save(), { signal });
    addEventListener("focus", () => this.seen(), { signal });
    addEventListener("theme-change", () => this.result.recolour(), { signal });
    document.addEventListener("visibilitychange", () => document.hidden || this.seen(), { signal });
    this.narrow.addEventListener("change", () => this.requestUpdate(), { signal });
    void this.studio.begin(location);
  }

  /** Once a frame: a run changes its state more often than anybody sees. */
  protected override async scheduleUpdate(): Promise<void> {
    if (!this.hasUpdated) await nextTask();
    else if (!document.hidden) await new Promise(requestAnimationFrame);
    super.scheduleUpdate();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.ending.abort();
  }

  private timeLine() {
    return html`<time-line .studio=${this.studio} .state=${this.now}></time-line>`;
  }

  private panel() {
    return this.narrow.matches ? "tabpanel" : nothing;
  }

  private folded(tab: Tab): boolean {
    return this.narrow.matches && tab !== this.tab;
  }

  private follow(now: StudioState): void {
    const before = this.now;
    this.now = now;
    this.live.state = now;
    if (before.phase !== "idle" && now.phase === "idle") this.ended(before, now);
    if (now.doc !== before.doc && now.undo !== null) this.readdress(now);
    this.retitle();
  }

  /** Settings show in the address as people change them. */
  private readdress({ doc }: StudioState): void {
    const hash = addressed(location.hash, doc);
    if (hash !== location.hash) history.replaceState(null, "", hash || location.pathname + location.search);
  }

  private ended(before: StudioState, now: StudioState): void {
    this.unseen = !document.hasFocus();
    if (now.doc.made !== before.doc.made) this.stage.tour();
  }

  private seen(): void {
    this.unseen = false;
    this.retitle();
  }

  private retitle(): void {
    const title = pageTitle(this.now.phase, this.now.progress.share, this.unseen);
    // Costs even where it changes nothing, and comes with every frame.
    if (title !== this.titled) document.title = this.titled = title;
  }

  private readonly openEditor = (event: Event): void => this.edit((event as CustomEvent<EditRequest>).detail);

  /** The editor is loaded when it is first wanted. */
  private edit(opened: EditRequest): void {
    void import("../pads/pad-editor");
    this.editing = opened;
  }

  private readonly closeEditor = (): void => void (this.editing = null);

  private readonly changeLook = (event: Event): void => {
    this.look = (event as CustomEvent<LookChange>).detail;
    remember("look", this.look.look);
    remember("room", this.look.room ? "on" : "off");
  };

  private paste(event: ClipboardEvent): void {
    if (!isTaken(event.composedPath(), "help")) this.take(event.clipboardData);
  }

  private take(data: DataTransfer | null): void {
    const files = [...(data?.files ?? [])];
    const entries = [...(data?.items ?? [])].map((item) => item.webkitGetAsEntry());
    const folders = entries.flatMap((entry) => (entry?.isDirectory ? [entry.name] : []));
    if (files.length) void this.studio.takeFiles(files, folders);
    else this.studio.takeText(data?.getData("text") ?? "");
  }

  private press(event: KeyboardEvent): void {
    const action = actionOf(event, remembered("keys") !== "off");
    if (!action || event.defaultPrevented || event.repeat || isTaken(event.composedPath(), action)) return;
    event.preventDefault();
    this.act(action);
  }

  private act(action: Action): void {
    const { studio, stage } = this;
    if (action === "run") this.now.phase === "idle" ? void studio.run() : studio.pause();
    else if (action === "undo") studio.undo();
    else if (action === "redo") studio.redo();
    else if (action === "share") void this.saving.copyLink();
    else if (action === "help") void this.help();
    else stage.flyTo(action);
  }

  /** Help is loaded when it is first wanted. */
  private async help(): Promise<void> {
    const { HelpDialog } = await import("./help-dialog");
    const dialog = document.querySelector<InstanceType<typeof HelpDialog>>("help-dialog") ?? document.body.appendChild(new HelpDialog());
    await dialog.updateComplete;
    dialog.show();
  }
}
