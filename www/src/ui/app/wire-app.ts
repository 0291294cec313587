import { html, LitElement, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { LookName } from "../../embed/looks";
import type { Faults } from "../../engine/protocol";
import { nextTask } from "../../state/common/next-turn";
import { explain } from "../../state/common/words";
import { deskOf, SLOTS, Studio, tableOf, type Job, type StudioState } from "../../state/studio";
import { layout, NARROW } from "./app-layout";
import type { EditRequest } from "../../tasks/multiview/parts/drawing-pad";
import "./drop-hint";
import "./live-region";
import type { LiveRegion } from "./live-region";
import { pageTitle } from "./page-title";
import { loadParts, loadPartsOf, rendered } from "./parts";
import { remember, remembered } from "../../state/common/remember";
import type { ResultPanel } from "../run/result-panel";
import type { ShapePad } from "../../tasks/fill/parts/shape-pad";
import type { SavePanel } from "../save/save-panel";
import { controls } from "../shared/shared";
import { actionOf, isTaken, type Action } from "./shortcuts";
import { tabs, tabsStyle, type Tab } from "./tabs";
import "./top-bar";
import type { Subject } from "../../tasks/stroke/given";
import { solidKey } from "../../tasks/fill/given";
import type { SubjectEvents } from "../../tasks/stroke/parts/subject-events";
import type { Heading } from "../../view/heading";
import type { WireComparison } from "../run/wire-comparison";
import type { WireStage } from "../stage/wire-stage";

interface LookChange {
  readonly look: LookName;
  readonly room: boolean;
}

const PANELS: Readonly<Record<Job, string>> = { multiview: "Pictures", stroke: "Picture", fill: "Shape" };
const DROPS: Readonly<Record<Job, string>> = {
  multiview: "pictures or a wire.json",
  stroke: "a picture or a wire.json",
  fill: "a mesh, a picture for its style, or a wire.json",
};

/** The whole page: its parts, and the wiring between them and the studio. */
@customElement("wire-app")
export class WireApp extends LitElement {
  private readonly studio = new Studio();
  private readonly narrow = matchMedia(NARROW);
  @state() private now: StudioState = this.studio.store.get();
  /** Before, parts may still move as others come: they are not shown. */
  @state() private opened = false;
  @state() private tab: Tab = "pictures";
  /** Whether the object of the one picture is being painted. */
  @state() private brushing = false;
  @state() private editing: EditRequest | null = null;
  @state() private throughNow: boolean | null = null;
  @state() private look: LookChange = { look: (remembered("look") as LookName | null) ?? "copper", room: remembered("room") !== "off" };
  @query("wire-stage") private stage!: WireStage;
  @query("result-panel") private result!: ResultPanel;
  @query("save-panel") private saving!: SavePanel;
  @query("wire-comparison") private comparison!: WireComparison;
  @query("live-region") private live!: LiveRegion;
  /** Whether a run has ended since somebody last looked. */
  private unseen = false;
  private titled = "";
  private readonly ending = new AbortController();

  static override styles = [controls, tabsStyle, layout];

  override render() {
    const { studio, now, look, editing } = this;
    const idle = now.phase === "idle";
    const { job } = now.doc;
    return html`
      <top-bar role="banner" .studio=${studio} .state=${now} @share=${() => void this.saving.copyLink()} @help=${() => void this.help()}></top-bar>
      <main class=${this.opened ? "" : "coming"}>
        <div class="left" tabindex=${idle ? nothing : 0} role=${idle ? nothing : "group"} aria-label=${idle ? nothing : `${PANELS[job]}, at rest during a run`}>
          <section
            id="part-pictures"
            class=${job === "multiview" ? "" : "one"}
            role=${this.panel()}
            aria-label=${PANELS[job]}
            ?hidden=${this.folded("pictures")}
            @open-editor=${this.openEditor}
          >
            ${job === "multiview" ? this.pads() : job === "stroke" ? this.subject() : this.shape()}
          </section>
        </div>
        <wire-stage
          .job=${job}
          .look=${look.look}
          .room=${look.room}
          .body=${this.body()}
          .through=${this.through}
          @look-change=${this.changeLook}
          @see-through=${this.seeThrough}
        ></wire-stage>
        ${this.narrow.matches ? nothing : this.timeLine()}
        ${editing
          ? html`<pad-editor .studio=${studio} .state=${now} .slot=${editing.slot} .tab=${editing.tab} @close-editor=${this.closeEditor}></pad-editor>`
          : nothing}
        ${job === "stroke" && this.brushing && now.doc.subject ? this.maskEditor(now.doc.subject) : nothing}
        <notice-list .studio=${studio} .state=${now}></notice-list>
        <div class="right">
          <run-panel .studio=${studio} .state=${now} @draw=${() => this.edit({ slot: "front", tab: "draw" })} @choose-picture=${this.choosePicture} @choose-mesh=${this.chooseMesh}></run-panel>
          <section id="part-run" role=${this.panel()} aria-label="Run and match" ?hidden=${this.folded("run")} @look-from=${this.lookFrom} @mark=${this.mark}>
            ${this.narrow.matches ? this.timeLine() : nothing}
            ${job === "stroke"
              ? html`<stroke-choices .studio=${studio} .state=${now}></stroke-choices>`
              : html`<run-choices .studio=${studio} .state=${now}></run-choices>`}
            <result-panel .state=${now}></result-panel>
            <wire-comparison .studio=${studio} .state=${now} ?hidden=${job === "fill"}></wire-comparison>
          </section>
          <section id="part-share" role=${this.panel()} aria-label="Save and share" ?hidden=${this.folded("share")}>
            <save-panel .studio=${studio} .state=${now} .picture=${() => this.stage.picture(2400, 1800)}></save-panel>
          </section>
          <section id="part-settings" role=${this.panel()} aria-label="Settings" ?hidden=${this.folded("settings")}>
            <settings-panel
              .studio=${studio}
              .table=${tableOf(now)}
              .settings=${deskOf(now.doc).settings}
              .where=${now.where}
              .whenHidden=${now.whenHidden}
              ?locked=${!idle}
            >
              <look-panel .look=${look.look} .room=${look.room} @look-change=${this.changeLook}></look-panel>
            </settings-panel>
          </section>
        </div>
        ${this.narrow.matches ? tabs(this.tab, job, (tab) => (this.tab = tab)) : nothing}
      </main>
      <drop-hint ?locked=${!idle} .what=${DROPS[job]} @files=${(event: CustomEvent<DataTransfer | null>) => this.take(event.detail)}></drop-hint>
      <live-region></live-region>
    `;
  }

  private pads() {
    const { studio, now } = this;
    return html`${SLOTS.map((slot) => html`<drawing-pad .studio=${studio} .state=${now} .slotName=${slot}></drawing-pad>`)}
      <remedy-list .studio=${studio} .state=${now}></remedy-list>`;
  }

  private subject() {
    const { sitting } = this.studio;
    const { doc, phase, sitting: passing } = this.now;
    return html`<subject-pad
      .subject=${doc.subject}
      .busy=${passing.busy}
      .problem=${passing.problem}
      .note=${passing.note}
      .locked=${phase !== "idle"}
      @give=${({ detail }: Told<"give">) => void sitting.give(detail.file, detail.name)}
      @choose-object=${({ detail }: Told<"choose-object">) => void sitting.chooseObject(detail.object)}
      @clear-subject=${() => sitting.clear()}
      @open-brush=${this.openBrush}
      @give-depth=${({ detail }: Told<"give-depth">) => void sitting.giveDepth(detail.file, detail.name)}
      @clear-depth=${() => sitting.clearDepth()}
    ></subject-pad>`;
  }

  private shape() {
    const { studio, now } = this;
    return html`<shape-pad .studio=${studio} .state=${now}></shape-pad>
      <style-shelf .studio=${studio} .state=${now}></style-shelf>
      <fill-choices .studio=${studio} .state=${now}></fill-choices>`;
  }

  /** What the wire on the stage covers; while somebody looks back at a run over another shape, that is not at hand. */
  private body() {
    const { doc, surface, looking, track } = this.now;
    if (doc.job !== "fill") return null;
    const given = looking !== null && track?.given.job === "fill" ? track.given.cover : doc.cover;
    return given && doc.cover && solidKey(given.solid) === solidKey(doc.cover.solid) ? surface : null;
  }

  private maskEditor(subject: Subject) {
    const { studio, now } = this;
    return html`<mask-editor
      .subject=${subject}
      .busy=${now.sitting.busy}
      .locked=${now.phase !== "idle"}
      .undo=${now.undo}
      .redo=${now.redo}
      @paint=${({ detail }: Told<"paint">) => studio.sitting.paint(detail.strokes)}
      @undo=${() => studio.undo()}
      @redo=${() => studio.redo()}
      @close-editor=${() => (this.brushing = false)}
    ></mask-editor>`;
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
    addEventListener(
      "theme-change",
      () => {
        this.result.recolour();
        this.comparison.recolour();
      },
      { signal },
    );
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
    if (before.phase !== "idle" && now.phase === "idle") {
      this.unseen = !document.hasFocus();
      // What was looked through during the run stays so.
      if (this.throughNow !== null) queueMicrotask(() => this.throughNow !== null && this.see(this.throughNow));
    }
    if (hasJustMade(before, now)) this.stage.tour();
    if (now.doc.job !== before.doc.job) this.turnTo(now);
    if (now.doc !== before.doc && (now.undo !== null || now.doc.job !== before.doc.job)) this.readdress();
    this.retitle();
  }

  private turnTo({ doc }: StudioState): void {
    this.editing = null;
    this.brushing = false;
    this.throughNow = null;
    loadPartsOf(doc.job).catch((error: unknown) => this.studio.warn(explain(error, "This part of the page")));
    this.stage.flyTo("room");
  }

  /** Settings show in the address as people change them; a link that is being opened stays there. */
  private readdress(): void {
    if (this.studio.ahead) return;
    const hash = this.studio.address(location.hash);
    if (hash !== location.hash) history.replaceState(null, "", hash || location.pathname + location.search);
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
    void import("../../tasks/multiview/parts/pad-editor");
    this.editing = opened;
  }

  private readonly closeEditor = (): void => void (this.editing = null);

  /** Loaded when it is first wanted. */
  private readonly openBrush = (): void => {
    void import("../../tasks/stroke/parts/mask-editor");
    this.brushing = true;
  };

  private readonly lookFrom = ({ detail }: CustomEvent<Heading>): void => this.stage.lookFrom(detail);

  private readonly mark = ({ detail }: CustomEvent<Faults[keyof Faults] | null>): void => this.stage.mark(detail);

  /** Whether the far side's lines are seen: a setting, or what somebody wants to see while a run keeps it as it is. */
  private get through(): boolean {
    return this.throughNow ?? this.studio.options.value("hidden_lines") === "true";
  }

  private readonly seeThrough = (): void => this.see(!this.through);

  private see(through: boolean): void {
    const idle = this.now.phase === "idle";
    this.throughNow = idle ? null : through;
    if (idle && through !== this.through) this.studio.options.set("hidden_lines", String(through));
  }

  private readonly chooseMesh = async (): Promise<void> => {
    this.tab = "pictures";
    await this.updateComplete;
    this.renderRoot.querySelector<ShapePad>("shape-pad")?.openFile?.();
  };

  /** An empty pad, with all the ways to fill it. */
  private readonly choosePicture = async (): Promise<void> => {
    this.tab = "pictures";
    this.studio.startOver();
    await this.updateComplete;
    const pad = this.renderRoot.querySelector<LitElement>("subject-pad");
    await pad?.updateComplete;
    pad?.renderRoot.querySelector<HTMLElement>(".ways button")?.focus();
  };

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

type Told<Kind extends keyof SubjectEvents> = CustomEvent<SubjectEvents[Kind]>;

/** Whether the run that was looked at has come to its wire. */
function hasJustMade(before: StudioState, now: StudioState): boolean {
  const { made } = deskOf(now.doc);
  return made !== deskOf(before.doc).made && made?.source === "run" && made.track === before.track;
}
