import { msg, str } from "@lit/localize";
import { html, LitElement, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { LookName } from "#sculpture/scene/looks";
import type { Faults } from "../../engine/protocol";
import { isHidden, isLocked, type Part as PagePart } from "../../state/common/locks";
import { nextTurn } from "../../state/common/next-turn";
import { remember, remembered } from "../../state/common/remember";
import { explain } from "../../words/sentences";
import { deskOf, tableOf, type Made, type Studio, type StudioState } from "../../state/studio";
import type { Tool } from "../../state/contract/state";
import { useTool } from "../../state/actions/actions";
import type { Heading } from "../../view/heading";
import type { ResultPanel } from "../run/result-panel";
import { givenLabels } from "../save/labels";
import type { SavePanel } from "../save/save-panel";
import { NARROW } from "../shared/narrow";
import type { Page, PageTask, TaskParts } from "../shared/page-task";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";
import type { ToolParts } from "../stage/tool";
import { description } from "../stage/description";
import type { WireStage } from "../stage/wire-stage";
import { glass, hands, help, share, type PageAction, type PageParts } from "./actions";
import { layout } from "./app-layout";
import "./drop-hint";
import "./live-region";
import type { LiveRegion } from "./live-region";
import { pageTitle } from "./page-title";
import { loadParts, rendered } from "./parts";
import { actionOf, isTaken } from "./shortcuts";
import { LESSON_TAB, TABS, tabs, tabsStyle, type Tab } from "./tabs";
import { TOOL_PARTS } from "./tools";
import "./top-bar";

/** What stands in the right column. */
const RIGHT: readonly PagePart[] = ["run", "result", "save", "settings"];

interface LookChange {
  readonly look: LookName;
  readonly room: boolean;
}

/** The whole page: its parts, and the wiring between them and the studio. */
@customElement("wire-app")
export class WireApp extends LitElement {
  private readonly narrow = matchMedia(NARROW);
  @state() private now: StudioState;
  /** Before, parts may still move as others come: they are not shown. */
  @state() private opened = false;
  @state() private tab: Tab = "pictures";
  /** Elements of the tasks that were looked at. */
  @state() private parts: Readonly<Record<string, TaskParts>> = {};
  /** Of the tools that were opened. */
  @state() private tools: Partial<Record<Tool, ToolParts>> = {};
  /** What lies open over the stage, in the words of the task that is looked at. */
  @state() private editing: unknown = null;
  @state() private throughNow: boolean | null = null;
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

  constructor(
    private readonly studio: Studio,
    private readonly tasks: readonly PageTask[],
  ) {
    super();
    this.now = studio.store.get();
  }

  override render() {
    const { studio, now, look, tasks, task } = this;
    const idle = now.phase === "idle";
    const { page } = task;
    const resting = !idle && !now.lesson;
    const parts = this.parts[task.name] ?? null;
    const ofTask = this.page;
    const { panel } = page;
    const tool = now.tool && this.tools[now.tool];
    return html`
      <top-bar role="banner" .studio=${studio} .state=${now} .tasks=${tasks} .act=${this.act}></top-bar>
      <main class=${this.opened ? "" : "coming"}>
        <div class="left" tabindex=${resting ? 0 : nothing} role=${resting ? "group" : nothing} aria-label=${resting ? msg(str`${panel}, at rest during a run`) : nothing}>
          ${now.lesson ? this.lesson() : nothing}
          <section
            id="part-pictures"
            class=${task.takes.pictures > 1 ? "" : "one"}
            role=${this.panel()}
            aria-label=${panel}
            ?inert=${isLocked(now, "pads")}
            ?hidden=${this.folded("pictures") || isHidden(now, "pads")}
          >
            ${parts?.pads(ofTask) ?? nothing} ${this.narrow.matches ? this.links() : nothing}
          </section>
        </div>
        <wire-stage
          .words=${task.stage}
          .alt=${description(shownWire(now), givenLabels(now, task))}
          .look=${look.look}
          .room=${look.room}
          .body=${parts?.body?.(now) ?? null}
          .through=${this.through}
          .busy=${!idle && now.phase !== "paused"}
          .covered=${this.editing !== null}
          @look-change=${this.changeLook}
          @see-through=${this.seeThrough}
        ></wire-stage>
        <div class="tool-buttons">
          <button ?hidden=${isHidden(now, "hands")} ?disabled=${!studio.can(hands)} aria-pressed=${String(now.tool === "hands")} title=${msg("Take the wire in hand, or leave it (E)")} @click=${() => this.act(hands)}>${icons.hand} <span>${msg("Hands on")}</span></button>
          <button ?hidden=${isHidden(now, "glass")} ?disabled=${!studio.can(glass)} aria-pressed=${String(now.tool === "glass")} title=${msg("Open the optimiser, or close it (G)")} @click=${() => this.act(glass)}>${icons.glass} <span>${msg("Glass box")}</span></button>
        </div>
        ${this.narrow.matches ? nothing : this.timeLine()}
        ${tool ? html`<div class="tool" role="region" aria-label=${msg("Beside the stage")}>${tool.panel(now, this.narrow.matches)}</div>` : nothing}
        ${tool?.under && !this.narrow.matches ? html`<div class="under">${tool.under(now)}</div>` : nothing}
        ${parts?.editor?.(ofTask) ?? nothing}
        <notice-list .studio=${studio} .state=${now}></notice-list>
        <div class="right" ?hidden=${RIGHT.every((part) => isHidden(now, part))}>
          <run-panel ?inert=${isLocked(now, "run")} ?hidden=${isHidden(now, "run") || (this.narrow.matches && this.tab === LESSON_TAB)} .studio=${studio} .state=${now} .tasks=${tasks} @own=${() => this.parts[task.name]?.own(this.page)}></run-panel>
          <section id="part-run" role=${this.panel()} aria-label=${msg("Run and match")} ?inert=${isLocked(now, "result")} ?hidden=${this.folded("run") || isHidden(now, "result")} @look-from=${this.lookFrom} @mark=${this.mark}>
            ${this.narrow.matches ? this.timeLine() : nothing}
            ${parts?.choices(ofTask) ?? nothing}
            <result-panel .task=${task} .parts=${parts} .state=${now}></result-panel>
            <wire-comparison .studio=${studio} .state=${now} ?hidden=${task.compared.length === 0}></wire-comparison>
          </section>
          <section id="part-share" role=${this.panel()} aria-label=${msg("Save and share")} ?inert=${isLocked(now, "save")} ?hidden=${this.folded("share") || isHidden(now, "save")}>
            <save-panel .studio=${studio} .state=${now} .task=${task} .picture=${async () => studio.saver.carrying(await this.stage.picture(2400, 1800))} .film=${() => void this.film()} .photograph=${() => void this.photograph()} .build=${() => void this.build()}></save-panel>
          </section>
          <section id="part-settings" role=${this.panel()} aria-label=${msg("Settings")} ?inert=${isLocked(now, "settings")} ?hidden=${this.folded("settings") || isHidden(now, "settings")}>
            <settings-panel
              .studio=${studio}
              .table=${tableOf(now)}
              .settings=${deskOf(now.doc).settings}
              .elsewhere=${task.elsewhere}
              .where=${now.where}
              .whenHidden=${now.whenHidden}
              .locks=${now.locks}
              ?locked=${!idle}
            >
              <guide-fold .studio=${studio} .state=${now} ?locked=${!idle}></guide-fold>
              <look-panel .look=${look.look} .room=${look.room} @look-change=${this.changeLook}></look-panel>
              <class-fold .studio=${studio} .state=${now}></class-fold>
            </settings-panel>
          </section>
        </div>
        ${this.narrow.matches && (tool || this.shownTabs.length > 1) ? tabs(tool ? null : this.tab, panel, (tab) => this.choose(tab), this.shownTabs) : nothing}
      </main>
      <drop-hint ?locked=${!idle || isLocked(now, "files") || isLocked(now, "leave")} .what=${page.drops} @files=${(event: CustomEvent<DataTransfer | null>) => this.take(event.detail)}></drop-hint>
      <live-region .tasks=${tasks}></live-region>
    `;
  }

  /** The one that is looked at. */
  private get task(): PageTask {
    return this.tasks.find(({ name }) => name === this.now.doc.task)!;
  }

  /** For the task's own elements. */
  private get page(): Page {
    return {
      studio: this.studio,
      state: this.now,
      editing: this.editing,
      edit: (what) => (this.editing = what),
      toPads: async () => {
        this.tab = "pictures";
        await this.updateComplete;
        return this.renderRoot;
      },
    };
  }

  protected override firstUpdated(): void {
    void this.open();
  }

  private async open(): Promise<void> {
    await nextTurn();
    await Promise.all([loadParts(), this.loadPartsOf(this.now.doc.task)]);
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
    addEventListener("hashchange", () => void this.studio.receiver.fragment(location.hash), { signal });
    addEventListener("paste", (event) => this.paste(event), { signal });
    addEventListener("keydown", (event) => this.press(event), { signal });
    addEventListener("pagehide", () => this.studio.save(), { signal });
    addEventListener("focus", () => this.seen(), { signal });
    addEventListener(
      "theme-change",
      () => this.result.recolour(),
      { signal },
    );
    document.addEventListener("visibilitychange", () => document.hidden || this.seen(), { signal });
    this.narrow.addEventListener("change", () => this.requestUpdate(), { signal });
    void this.studio.begin(location);
  }

  /** Once a frame, for a run changes its state more often than anybody sees; and after it, for the frame has enough to do. */
  protected override async scheduleUpdate(): Promise<void> {
    if (this.hasUpdated && !document.hidden) await new Promise(requestAnimationFrame);
    await nextTurn();
    super.scheduleUpdate();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.ending.abort();
  }

  /** Beside the stage on a desk, a part of the sheet on a phone. */
  private lesson() {
    return html`<lesson-panel id="part-lesson" @share-wire=${() => this.act(share)} ?kiosk=${this.now.lesson?.kiosk === true} role=${this.panel()} aria-label=${msg("The lesson")} ?hidden=${this.folded(LESSON_TAB)} .studio=${this.studio} .state=${this.now}></lesson-panel>`;
  }

  private links() {
    return html`<a class="gallery" href="./gallery.html" ?hidden=${isHidden(this.now, "gallery")}>${msg("Gallery")}</a>
      <a class="gallery" href="./teachers.html" ?hidden=${isHidden(this.now, "gallery")}>${msg("Lessons")}</a>`;
  }

  private get shownTabs(): readonly Tab[] {
    const parts: Readonly<Record<Tab, PagePart | null>> = { lesson: null, pictures: "pads", run: "result", settings: "settings", share: "save" };
    return TABS.filter((tab) => (tab === LESSON_TAB ? this.now.lesson !== null : parts[tab] === null || !isHidden(this.now, parts[tab])));
  }

  private timeLine() {
    return html`<time-line ?inert=${isLocked(this.now, "timeline")} ?hidden=${isHidden(this.now, "timeline")} .studio=${this.studio} .state=${this.now}></time-line>`;
  }

  private panel() {
    return this.narrow.matches ? "tabpanel" : nothing;
  }

  private folded(tab: Tab): boolean {
    return this.narrow.matches && (tab !== this.tab || this.isTooled);
  }

  private choose(tab: Tab): void {
    this.tab = tab;
    this.studio.act(useTool, null);
  }

  /** Whether a tool lies open. */
  private get isTooled(): boolean {
    return this.now.tool !== null && this.tools[this.now.tool] !== undefined;
  }

  protected override willUpdate(): void {
    this.toggleAttribute("tooled", this.isTooled);
  }

  /** What a tool brings comes when it is first opened. */
  private async openTool(tool: Tool): Promise<void> {
    const load = TOOL_PARTS[tool];
    if (this.tools[tool] || !load) return;
    try {
      const { open } = await load();
      this.tools = { ...this.tools, [tool]: this.tools[tool] ?? open(this.studio, this.stage) };
    } catch (error) {
      this.studio.act(useTool, null);
      this.studio.warn(explain(error, msg("This part of the page")));
    }
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
    if (now.tool && now.tool !== before.tool) void this.openTool(now.tool);
    if (hasJustMade(before, now)) this.stage.tour();
    if (now.doc.task !== before.doc.task) this.turnTo(now.doc.task);
    if (now.lesson !== before.lesson) void this.teach(before.lesson, now.lesson);
    if (now.doc !== before.doc && (now.undo !== null || now.doc.task !== before.doc.task)) this.readdress();
    this.retitle();
  }

  /** A lesson has begun, turned to another step, or ended. */
  private async teach(before: StudioState["lesson"], now: StudioState["lesson"]): Promise<void> {
    this.toggleAttribute("lesson", now !== null);
    this.toggleAttribute("kiosk", now?.kiosk === true);
    if (!before !== !now) this.tab = now ? LESSON_TAB : "pictures";
    if (!now || (before?.lesson === now.lesson && before.at === now.at)) return;
    // In a sheet, what is to be read goes before the tool, which is opened by its own button.
    if (this.narrow.matches) this.studio.act(useTool, null);
    const view = now.lesson.steps[now.at]!.view;
    if (view) this.stage.flyTo(view);
    await import("../lesson/lesson-panel").catch((error: unknown) => this.studio.warn(explain(error, msg("The lesson"))));
  }

  private turnTo(task: string): void {
    this.editing = null;
    this.throughNow = null;
    this.loadPartsOf(task).catch((error: unknown) => this.studio.warn(explain(error, msg("This part of the page"))));
    this.stage.flyTo("room");
  }

  /** What only one of the tasks needs comes when that is first looked at. */
  private async loadPartsOf(task: string): Promise<void> {
    if (this.parts[task]) return;
    const { parts } = await this.tasks.find(({ name }) => name === task)!.parts();
    this.parts = { ...this.parts, [task]: parts };
    await this.updateComplete;
  }

  /** Settings show in the address as people change them; a link that is being opened stays there. */
  private readdress(): void {
    if (this.studio.opener.ahead || this.now.lesson) return;
    const own = this.studio.saver.address(location.hash);
    const hash = this.studio.lessons?.addressOver(own) ?? own;
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

  private readonly lookFrom = ({ detail }: CustomEvent<Heading>): void => this.stage.lookFrom(detail);

  private readonly mark = ({ detail }: CustomEvent<Faults[keyof Faults] | null>): void => this.stage.mark(detail);

  /** Whether the far side's lines are seen: a setting, or what somebody wants to see while a run keeps it as it is. */
  private get through(): boolean {
    const { farSide } = this.task.stage;
    return this.throughNow ?? (farSide !== undefined && this.studio.options.value(farSide) === "true");
  }

  private readonly seeThrough = (): void => this.see(!this.through);

  private see(through: boolean): void {
    const idle = this.now.phase === "idle";
    this.throughNow = idle ? null : through;
    const { farSide } = this.task.stage;
    if (farSide && idle && through !== this.through) this.studio.options.set(farSide, String(through));
  }

  private readonly changeLook = (event: Event): void => {
    this.look = (event as CustomEvent<LookChange>).detail;
    remember("look", this.look.look);
    remember("room", this.look.room ? "on" : "off");
  };

  private paste(event: ClipboardEvent): void {
    if (!isTaken(event.composedPath(), help)) this.take(event.clipboardData);
  }

  private take(data: DataTransfer | null): void {
    if (!this.studio.takesFiles()) return;
    const files = [...(data?.files ?? [])];
    const entries = [...(data?.items ?? [])].map((item) => item.webkitGetAsEntry());
    const folders = entries.flatMap((entry) => (entry?.isDirectory ? [entry.name] : []));
    if (files.length) void this.studio.receiver.files(files, folders);
    else this.studio.receiver.text(data?.getData("text") ?? "");
  }

  private press(event: KeyboardEvent): void {
    const action = actionOf(event, this.now, remembered("keys") !== "off");
    if (!action || event.defaultPrevented || event.repeat || isTaken(event.composedPath(), action)) return;
    event.preventDefault();
    this.act(action);
  }

  private readonly act = (action: PageAction): void => {
    if (this.studio.can(action)) void action.act(this.all);
  };

  /** What actions work with. */
  private get all(): PageParts {
    const { bench, project, runs, opener } = this.studio;
    return { bench, project, runs, opener, flyTo: (view) => this.stage.flyTo(view), share: () => void this.saving.share(), help: () => void this.help() };
  }

  /** Pictures and films, loaded when they are first wanted: of what the stage shows. */
  private async film(): Promise<void> {
    const { made } = deskOf(this.now.doc);
    if (!made) return;
    const [{ openFilms }, { isDark }] = await Promise.all([import("../film/open-films"), import("../shared/theme")]);
    const body = this.parts[this.task.name]?.body?.(this.now) ?? null;
    await openFilms({
      made,
      body,
      through: this.through,
      ...this.look,
      dark: isDark(),
      views: this.task.stage.views,
      seen: this.stage.getState(),
      save: (blob, ending) => this.saving.keep(blob, ending),
      carrying: (picture) => this.studio.saver.carrying(picture),
    });
  }

  /** So is the camera. */
  private async photograph(): Promise<void> {
    const { made } = deskOf(this.now.doc);
    if (!made) return;
    const { openPhotograph } = await import("../photograph/photograph-dialog");
    const { file } = made.finished;
    await openPhotograph(
      { file, stage: this.stage.getState().camera, place: "room" },
      { save: (blob, ending) => this.saving.keep(blob, ending), carrying: (picture) => this.studio.saver.carrying(picture) },
    );
  }

  /** And the workshop. */
  private async build(): Promise<void> {
    const { made } = deskOf(this.now.doc);
    if (!made) return;
    const [{ openWorkshop }, { titleOf }] = await Promise.all([import("../workshop/build-dialog"), import("../save/wire-words")]);
    await openWorkshop(made.finished.file, titleOf(givenLabels(this.now, this.task)), (blob, ending) => this.saving.keep(blob, ending));
  }

  /** Help is loaded when it is first wanted. */
  private async help(): Promise<void> {
    const [{ HelpDialog }, ...tasks] = await Promise.all([import("./help-dialog"), ...this.tasks.map((task) => task.help())]);
    const dialog = document.querySelector<InstanceType<typeof HelpDialog>>("help-dialog") ?? document.body.appendChild(new HelpDialog());
    dialog.tasks = tasks.map(({ help }) => help);
    await dialog.updateComplete;
    dialog.show();
  }
}

/** The wire on the stage, where it is one that was made. */
function shownWire({ doc, running, looking, ahead }: StudioState): Made | null {
  return running === doc.task || looking !== null || ahead?.task === doc.task ? null : deskOf(doc).made;
}

/** Whether the run that was looked at has come to its wire. */
function hasJustMade(before: StudioState, now: StudioState): boolean {
  const { made } = deskOf(now.doc);
  return made !== deskOf(before.doc).made && made?.source === "run" && made.track === before.track;
}
