/** Everything a person can do on the page, and the state that follows from it. Knows no elements. */

import { openShareCode, ShareCodeError } from "../embed/share/code";
import type { WireShape } from "../embed/shape";
import { EngineClient, Problem } from "../engine/client";
import type { Backend, Drawing, ExportFormat, Finished, Reading, SettingsTable, SettingValues } from "../engine/protocol";
import { sheetOf } from "../engine/sheet";
import { BLANK, SLOTS, type Doc, type Made, type Slot } from "./keeping/document";
import { EXAMPLE_VIEWS, exampleCode, examplePapers } from "./example/example";
import { sortFiles } from "./drawing/files";
import { known, presetOf, problemWith, readFragment, writeFragment } from "./address/fragment";
import { forOthers, readRenderer } from "./address/renderer";
import { mirrored, PAPER_PX, turned, type Paper, type PictureLayer } from "./drawing/paper";
import { readPicture } from "./drawing/picture";
import { NO_PROJECT, Project, type ProjectState } from "./keeping/project";
import { remember, remembered } from "./keeping/remember";
import { HiddenTab, WHEN_HIDDEN, type WhenHidden } from "./run/hidden-tab";
import { ANYWHERE, Placer, type Whereabouts } from "./run/placer";
import { NO_PREVIEW, Previewer, sheetsOf, type PadRemedy, type PreviewState } from "./run/previewer";
import { READY, Runner, type RunState } from "./run/runner";
import { Store } from "./store";
import type { Track } from "./run/track";
import { asSentence, explain, named } from "./words";

export { SLOTS, type Doc, type Made, type Slot } from "./keeping/document";
export { WHEN_HIDDEN, type WhenHidden } from "./run/hidden-tab";
export { ANYWHERE, INSTEAD, type Whereabouts } from "./run/placer";
export type { PadRemedy, PreviewBySlot } from "./run/previewer";
export type { Phase, Progress } from "./run/runner";

/** What is passing about a pad. */
export interface PadState {
  readonly busy: boolean;
  /** What was done to the last picture, or empty. */
  readonly note: string;
  /** What was wrong with the last picture that was given; the one before is kept. */
  readonly problem: string;
}

export interface StudioState extends ProjectState, RunState, PreviewState {
  readonly pads: Readonly<Record<Slot, PadState>>;
  /** The core's settings; null until it has told them. */
  readonly table: SettingsTable | null;
  /** A run that a reload or a crash cut off and that can go on. */
  readonly unfinished: { readonly iteration: number; readonly iterations: number } | null;
  readonly where: Whereabouts;
  readonly whenHidden: WhenHidden;
  readonly problem: string;
  /** What a person should know though nothing is wrong, until they close it. */
  readonly notices: readonly string[];
  /** A short word about what was just done, such as "Link copied". */
  readonly said: string;
}

const QUIET: PadState = { busy: false, note: "", problem: "" };
const QUIET_PADS = { front: QUIET, side: QUIET, top: QUIET };
/** Settings that say what is made, not how long it takes: a preset leaves them alone. */
const NOT_OF_PRESETS = ["seed", "backend"];

export class Studio {
  readonly store = new Store<StudioState>({
    ...NO_PROJECT,
    ...NO_PREVIEW,
    pads: QUIET_PADS,
    phase: "idle",
    progress: READY,
    track: null,
    looking: null,
    views: [],
    targets: [],
    notes: [],
    table: null,
    unfinished: null,
    where: ANYWHERE,
    whenHidden: WHEN_HIDDEN.find((choice) => choice === remembered("hidden")) ?? "go",
    problem: "",
    notices: [],
    said: "",
  });
  private readonly project = new Project((state) => {
    const before = this.store.get().doc;
    this.store.set(state);
    if (state.doc.made !== before.made && !this.opening) this.showMade();
    this.previewer.follow(state.doc);
    this.seekPlace();
  });
  private readonly engine = new EngineClient((news) => this.runner.hear(news));
  private readonly runner = new Runner(this.engine, {
    get: () => this.store.get(),
    set: (change) => this.store.set(change),
    wire: (wire) => this.showWire(wire),
    snapshot: (snapshot) => this.project.addSnapshot(snapshot),
    place: (place) => this.placer.hear(place),
  });
  private readonly placer = new Placer(
    (backend) => this.engine.call("place", { backend }),
    (where) => this.store.set({ where }),
    (words) => this.notify(words),
  );
  private readonly previewer = new Previewer(
    (drawings: readonly Drawing[], settings) => this.engine.call("preview", { drawings, settings }),
    (state) => this.store.set(state),
  );
  private readonly wireListeners = new Set<(wire: WireShape | null) => void>();
  private wire: WireShape | null = null;
  private recalled: Promise<Track | null> = Promise.resolve(null);
  /** A link's wire is on the stage and not yet in the document. */
  private opening = false;
  /** The run behind `unfinished`. */
  private cutOff: Track | null = null;
  /** Settings from the address, until the table says which of them there are. */
  private asked: SettingValues = {};

  constructor() {
    const tab = new HiddenTab(() => this.store.get().whenHidden, { phase: () => this.store.get().phase, pauseOrGoOn: () => this.pause() });
    this.store.follow(() => tab.look());
  }

  /** Brings back what was kept, opens what the address asks for, or shows the example on a first visit. */
  async begin({ hash, search }: Pick<Location, "hash" | "search">): Promise<void> {
    const { backend, problem } = readRenderer(search);
    if (backend) this.placer.obey(backend);
    if (problem) this.notify(problem);
    // A link's wire is on the stage at once; into the document it comes as a step over what was kept.
    const opening = this.openFragment(hash);
    this.recalled = this.project.recall();
    this.offer(await this.recalled);
    if (!(await opening) && !this.doc.made && sheetsOf(this.doc).length === 0) await this.showExample();
    this.engine.call("settings", {}).then(
      (table) => this.learn(table),
      (error: unknown) => this.store.set({ problem: explain(error, "The engine") }),
    );
  }

  /** The wire changes too often for the store. */
  followWire(listener: (wire: WireShape | null) => void): () => void {
    this.wireListeners.add(listener);
    listener(this.wire);
    return () => this.wireListeners.delete(listener);
  }

  // Drawings

  setPaper(slot: Slot, paper: Paper | null, label: string): void {
    this.setPad(slot, QUIET);
    this.edit(label, { papers: { ...this.doc.papers, [slot]: paper } });
  }

  /** Puts a file into a pad. A bad one leaves what was there. */
  async givePicture(slot: Slot, file: Blob, name: string): Promise<void> {
    this.setPad(slot, { ...QUIET, busy: true });
    try {
      const { note, width, height, rgba } = await readPicture(file, name);
      const picture = { name, width, height, rgba: new Blob([rgba]) };
      const reading: Reading = { ink: "auto", threshold: 0 };
      const found = await this.engine.call("read", { picture: { ...picture, rgba }, reading, sidePx: PAPER_PX }, [rgba.buffer]);
      const layer: PictureLayer = { kind: "picture", picture, reading, found, lay: { mirrored: false, quarterTurns: 0 } };
      this.setPaper(slot, { layers: [layer], label: name.replace(/\.\w+$/, "") }, `Put ${name} on the ${slot} pad`);
      this.setPad(slot, { ...QUIET, note });
    } catch (error) {
      this.setPad(slot, { ...QUIET, problem: explain(error, name) });
    }
  }

  /** Finds the ink of the pad's picture in another way. */
  async reread(slot: Slot, reading: Reading): Promise<void> {
    const paper = this.doc.papers[slot];
    const at = paper?.layers.findIndex((layer) => layer.kind === "picture") ?? -1;
    const layer = paper?.layers[at] as PictureLayer | undefined;
    if (!paper || !layer) return;
    this.setPad(slot, { ...QUIET, busy: true });
    try {
      const rgba = new Uint8ClampedArray(await layer.picture.rgba.arrayBuffer());
      const found = await this.engine.call("read", { picture: { ...layer.picture, rgba }, reading, sidePx: PAPER_PX }, [rgba.buffer]);
      // Unless the pad was drawn on meanwhile.
      if (this.doc.papers[slot] === paper) {
        this.edit("Find the ink in another way", {
          papers: { ...this.doc.papers, [slot]: { ...paper, layers: paper.layers.with(at, { ...layer, reading, found }) } },
        }, `reread ${slot}`);
      }
      this.setPad(slot, QUIET);
    } catch (error) {
      this.setPad(slot, { ...QUIET, problem: explain(error, layer.picture.name) });
    }
  }

  mirror(slot: Slot): void {
    this.change(slot, mirrored, `Mirror the ${slot} drawing`);
  }

  /** Counter-clockwise. */
  turn(slot: Slot, quarterTurns: number): void {
    this.change(slot, (paper) => turned(paper, quarterTurns), `Turn the ${slot} drawing`);
  }

  swap(a: Slot, b: Slot): void {
    const { papers } = this.doc;
    this.edit(`Swap ${a} and ${b}`, { papers: { ...papers, [a]: papers[b], [b]: papers[a] } });
  }

  clear(slot: Slot): void {
    this.setPaper(slot, null, `Clear the ${slot} pad`);
  }

  applyRemedy({ kind, slots, quarterTurns }: PadRemedy): void {
    const [a, b] = slots;
    if (kind === "arrange") this.set("arrange", "on");
    else if (kind === "mirror") this.mirror(a!);
    else if (kind === "turn") this.turn(a!, quarterTurns);
    else this.swap(a!, b!);
  }

  /** Files dropped or pasted anywhere: pictures into the empty pads first, then from the front on; a wire onto the stage. */
  async takeFiles(files: readonly File[], folders: readonly string[] = []): Promise<void> {
    if (this.busy || files.length === 0) return;
    const { pictures, wire, note } = sortFiles(files, folders, SLOTS.length);
    this.store.set({ problem: note });
    if (wire && pictures.length === 0) await this.openFile(wire);
    const { papers } = this.doc;
    const order = [...SLOTS.filter((slot) => !papers[slot]), ...SLOTS.filter((slot) => papers[slot])];
    // One after the other: each is an undo step of its own.
    for (const [i, file] of pictures.entries()) await this.givePicture(order[i]!, file, file.name || `the ${order[i]!} picture`);
  }

  /** Text pasted or dropped on the page: a link is opened, for anything else there is a better place. */
  takeText(text: string): void {
    if (this.busy || !text.trim()) return;
    const hash = /#\S*\bw=\S+/.exec(text)?.[0];
    if (hash) void this.openFragment(hash);
    else this.warn("That was text. To make a wire of a word, open a pad, choose Type and write it there.");
  }

  // Settings

  /** The value a run would take. */
  value(name: string): string {
    const { table, doc } = this.store.get();
    return doc.settings[name] ?? (table ? presetOf(doc.settings, table)[name] : undefined) ?? "";
  }

  set(name: string, value: string): void {
    const { table } = this.store.get();
    if (table && problemWith(name, value, table)) return;
    const { settings } = this.doc;
    const kept = name === "preset" ? this.besidesPreset(settings) : settings;
    const next = { ...kept, [name]: value };
    const label = `Set ${name.replaceAll("_", " ")}`;
    this.edit(label, { settings: table ? known(next, table) : next }, `set ${name}`);
  }

  resetSettings(): void {
    this.edit("Reset the settings", { settings: {} });
  }

  setWhenHidden(choice: WhenHidden): void {
    remember("hidden", choice);
    this.store.set({ whenHidden: choice });
  }

  // Run

  async run(): Promise<void> {
    if (this.busy) return;
    const sheets = sheetsOf(this.doc);
    if (sheets.length < 2) {
      this.warn("A wire needs at least two drawings. Put one into another pad, then press Run.");
      return;
    }
    await this.fit({ sheets, settings: this.doc.settings, iterations: 0, losses: [], events: [], snapshots: [] });
  }

  pause(): void {
    this.runner.pause();
  }

  step(): void {
    this.runner.step();
  }

  stop(): void {
    this.runner.stop();
  }

  /** Throws the run away; the wire before it is back. */
  reset(): void {
    this.runner.cancel();
  }

  lookAt(index: number | null): void {
    if (this.busy) this.runner.lookAt(index);
    else {
      const snapshot = index === null ? null : this.store.get().track?.snapshots[index];
      this.store.set({ looking: snapshot ? index : null });
      this.showWire(snapshot?.wire ?? this.doc.made?.finished.wire ?? null);
    }
  }

  /** Goes on from a snapshot, with the settings as they are now; what came after it is dropped. */
  async continueFrom(index: number): Promise<void> {
    const track = this.runner.at(index);
    if (!track) return;
    this.runner.cancel();
    await this.settled();
    await this.resume(track);
  }

  async continueUnfinished(): Promise<void> {
    const track = this.cutOff;
    if (track && !this.busy) await this.resume({ ...track, settings: this.doc.settings });
  }

  dropUnfinished(): void {
    this.offer(null);
    this.project.endRun();
  }

  undo(): void {
    if (!this.busy) this.project.undo();
  }

  redo(): void {
    if (!this.busy) this.project.redo();
  }

  startOver(): void {
    this.edit("Start with empty pads", { papers: BLANK.papers });
  }

  // Opening

  /** Shows the wire and takes the settings that an address carries; false if it carries no wire. */
  async openFragment(hash: string): Promise<boolean> {
    const { code, settings, newer } = readFragment(hash);
    this.warn("");
    if (newer) {
      this.warn("This link was made by a newer Wire4D. Reload the page to get it, then open the link again.");
      return false;
    }
    this.asked = settings;
    const { table } = this.store.get();
    if (table) this.learn(table);
    return code !== null && this.openCode(code, "link");
  }

  async showExample(): Promise<void> {
    try {
      // Aside, as codes are; here where there is no worker.
      const read = (drawing: Blob) => this.engine.call("sheet", { drawing }).catch(() => sheetOf(drawing));
      const [code, papers] = await Promise.all([exampleCode(), examplePapers(read)]);
      // Unless the person was quicker.
      if (this.busy || this.store.get().undo !== null) return;
      this.project.replace({ papers });
      await this.openCode(code, "example");
    } catch (error) {
      this.warn(explain(error, "The example"));
    }
  }

  /** This tab keeps the project from now on. */
  keepHere(): void {
    this.project.keepHere();
  }

  /** The page may be about to go. */
  save(): void {
    this.project.save();
  }

  // Taking along

  /** The wire as a file; `view` is the one an SVG draws. */
  async export(format: ExportFormat, view = "front"): Promise<Blob | null> {
    const { made } = this.doc;
    if (!made) return null;
    try {
      const bytes = await this.engine.call("export", { file: made.finished.file, format, view });
      return new Blob([bytes], { type: MIME[format] });
    } catch (error) {
      this.warn(explain(error, "The file"));
      return null;
    }
  }

  /** A link that carries the whole wire and the settings. */
  link(page: string): string | null {
    const code = this.doc.made?.finished.code;
    return code ? forOthers(page) + writeFragment(code, this.doc.settings) : null;
  }

  say(said: string): void {
    this.store.set({ said });
  }

  warn(problem: string): void {
    this.store.set({ problem });
  }

  /** The person has read it. */
  dismiss(notice: string): void {
    this.store.set({ notices: this.store.get().notices.filter((other) => other !== notice) });
  }

  // Inside

  private notify(notice: string): void {
    this.dismiss(notice);
    this.store.set({ notices: [...this.store.get().notices, notice] });
  }

  /** Once there is a table, so that the engine is loaded and the setting is one that it knows. */
  private seekPlace(): void {
    if (this.store.get().table) this.placer.follow(this.backend);
  }

  private get backend(): Backend {
    return (this.value("backend") || "auto") as Backend;
  }

  private get doc(): Doc {
    return this.project.doc;
  }

  private get busy(): boolean {
    return this.store.get().phase !== "idle";
  }

  /** Edits wait for the end of a run. */
  private edit(label: string, change: Partial<Doc>, kind = ""): void {
    if (!this.busy) this.project.edit(label, change, kind);
  }

  private change(slot: Slot, how: (paper: Paper) => Paper, label: string): void {
    const paper = this.doc.papers[slot];
    if (paper) this.setPaper(slot, how(paper), label);
  }

  private showMade(): void {
    const { made } = this.doc;
    const { views = [], targets = [], wire = null } = made?.finished ?? {};
    this.store.set({ views, targets, track: made?.track ?? null, looking: null });
    this.showWire(wire);
  }

  private showWire(wire: WireShape | null): void {
    this.wire = wire;
    for (const listener of this.wireListeners) listener(wire);
  }

  private setPad(slot: Slot, pad: PadState): void {
    this.store.set({ pads: { ...this.store.get().pads, [slot]: pad } });
  }

  private learn(table: SettingsTable): void {
    const asked = known(this.asked, table);
    this.asked = {};
    this.store.set({ table });
    const { settings } = this.doc;
    const next = Object.keys(asked).length ? asked : known(settings, table);
    if (JSON.stringify(next) !== JSON.stringify(settings)) this.project.replace({ settings: next });
    this.seekPlace();
  }

  private besidesPreset(settings: SettingValues): SettingValues {
    const rows = this.store.get().table?.rows ?? [];
    const stays = (name: string): boolean => NOT_OF_PRESETS.includes(name) || rows.find((row) => row.name === name)?.group === "views";
    return Object.fromEntries(Object.entries(settings).filter(([name]) => stays(name)));
  }

  private async resume(track: Track): Promise<void> {
    const papers = Object.fromEntries(SLOTS.map((slot) => [slot, track.sheets.find((sheet) => sheet.slot === slot)?.paper ?? null]));
    const same = SLOTS.every((slot) => papers[slot] === this.doc.papers[slot]);
    if (!same) this.edit("Bring back the drawings of the run", { papers: papers as Doc["papers"] });
    await this.fit({ ...track, settings: this.doc.settings });
  }

  private async fit(track: Track): Promise<void> {
    this.offer(null);
    this.store.set({ problem: "", notices: [], said: "" });
    this.project.beginRun(track);
    const startMs = performance.now();
    let failed = false;
    try {
      const finished = await this.runner.run(track, this.placer.begin(this.backend));
      if (finished) this.finish(finished, (performance.now() - startMs) / 1000);
      else this.showMade();
    } catch (error) {
      failed = true;
      this.warn(explain(error, "The run"));
      const { track } = this.store.get();
      const went = track !== null && track.snapshots.length > 0;
      this.showMade();
      if (went) return this.offer(track);
    } finally {
      this.placer.end(failed);
    }
    this.project.endRun();
  }

  private finish(finished: Finished, seconds: number): void {
    const { track } = this.store.get();
    const stopped = track !== null && !track.events.some(({ kind }) => kind === "done");
    this.edit("Make the wire", { made: { finished, source: "run", track, stopped, seconds } });
  }

  /** Once the run that was called off has ended. */
  private settled(): Promise<void> {
    return new Promise((resolve) => {
      const stop = this.store.follow(({ phase }) => {
        if (phase !== "idle") return;
        setTimeout(() => {
          stop();
          resolve();
        });
      });
    });
  }

  private offer(track: Track | null): void {
    this.cutOff = track;
    const { iteration = 0, iterations = 0 } = track?.snapshots.at(-1) ?? {};
    this.store.set({ unfinished: track && { iteration, iterations } });
  }

  /** Shows the wire at once; the worker measures it when it comes to that. */
  private async openCode(code: string, source: "link" | "example"): Promise<boolean> {
    this.opening = true;
    try {
      // Read aside, to keep nobody waiting; here where there is no worker, or to hear what is wrong.
      const { wire, views } = await this.engine.call("peek", { code }).catch(() => openShareCode(code));
      this.showWire(wire);
      this.store.set({ views, targets: [], track: null, looking: null });
    } catch (error) {
      this.opening = false;
      if (!(error instanceof ShareCodeError)) throw error;
      this.warn(asSentence(error.message));
      return false;
    }
    void this.adopt(code, source);
    return true;
  }

  private async adopt(code: string, source: "link" | "example"): Promise<void> {
    try {
      const finished = await this.engine.call("open", { code });
      await this.recalled;
      this.opening = false;
      // The code as it came: the same link again.
      this.opened({ ...finished, code }, source, "Open the link");
    } catch (error) {
      // It is on the stage all the same.
      this.opening = false;
      if (!(error instanceof Problem)) console.error(error);
    }
  }

  private async openFile(file: File): Promise<void> {
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      this.opened(await this.engine.call("open", { file: bytes, name: file.name }), "file", `Open ${file.name}`);
    } catch (error) {
      this.warn(explain(error, named(file.name)));
    }
  }

  private opened(finished: Finished, source: Made["source"], label: string): void {
    if (this.busy) return;
    const made: Made = { finished, source, track: null, stopped: false, seconds: 0 };
    if (source !== "example") return this.edit(label, { made });
    const measures = { ...finished.measures, views: EXAMPLE_VIEWS };
    this.project.replace({ made: { ...made, finished: { ...finished, measures } } });
  }
}

const MIME: Readonly<Record<ExportFormat, string>> = {
  glb: "model/gltf-binary",
  stl: "model/stl",
  obj: "model/obj",
  svg: "image/svg+xml",
  "wire.json": "application/json",
  "bend.csv": "text/csv",
};
