/** Everything a person can do on the page, and the state that follows from it. Knows no elements. */

import type { WireShape } from "../embed/shape";
import { EngineClient } from "../engine/client";
import type { Backend, Drawing, ExportFormat, Ink, PatternName } from "../engine/protocol";
import { addressed } from "./address/address";
import { writeFragment } from "./address/fragment";
import { fragmentIn } from "./address/pasted";
import { forOthers, readRenderer } from "./address/renderer";
import { sortFiles } from "./opening/files";
import { Dressing } from "../tasks/fill/taking";
import { Pads } from "../tasks/multiview/pads";
import { Sitting } from "../tasks/stroke/taking";
import { BLANK, deskOf, SLOTS, untouched, type Doc, type Job, type Made } from "./keeping/document";
import { Project } from "./keeping/project";
import { remember } from "./common/remember";
import { Opener } from "./opening/opener";
import { Coverer } from "../tasks/fill/coverer";
import { HiddenTab, type WhenHidden } from "./run/hidden-tab";
import { Placer } from "./run/placer";
import { Previewer, type PadRemedy } from "../tasks/multiview/previewer";
import { Runs } from "./run/runs";
import { Options } from "./settings/options";
import { Store } from "./common/store";
import type { Solid } from "../tasks/fill/given";
import { Planning } from "../tasks/fill/planning";
import { AT_FIRST, type Bench, type StudioState } from "./contract/state";
import { DURING_A_RUN, explain } from "./common/words";

export { deskOf, JOBS, SLOTS, type Doc, type Job, type Made, type Slot } from "./keeping/document";
export { WHEN_HIDDEN, type WhenHidden } from "./run/hidden-tab";
export { ANYWHERE, INSTEAD, type Whereabouts } from "./run/placer";
export type { PadRemedy, PreviewBySlot } from "../tasks/multiview/previewer";
export type { Phase, Progress } from "./run/runner";
export { showsExample, tableOf, type PadState, type StudioState } from "./contract/state";

export class Studio {
  readonly store = new Store<StudioState>(AT_FIRST);
  private readonly project = new Project((state) => this.changed(state));
  private readonly engine = new EngineClient((news) => (news.news === "covering" ? this.coverer.hear(news.share) : this.runs.hear(news)));
  private readonly bench = this.benchOf();
  /** The drawings of the first job. */
  readonly pads = new Pads(this.bench);
  /** The picture of the second. */
  readonly sitting = new Sitting(this.bench);
  /** The shape of the third, and its style. */
  readonly dressing = new Dressing(this.bench);
  readonly options = new Options(this.bench);
  private readonly placer = new Placer(
    (backend) => this.engine.call("place", { backend }),
    (where) => this.store.set({ where }),
    (words) => this.notify(words),
  );
  private readonly runs = new Runs(this.bench, this.placer, () => this.backend, (wire) => this.showWire(wire), (made) => this.planning.standIn(made));
  private readonly opener = new Opener(this.bench, this.options, {
    recalled: () => this.recalled,
    choose: (job) => this.setJob(job),
    wire: (wire) => this.showWire(wire),
    show: () => {
      this.runs.show();
      this.planning.follow(false);
    },
    awaits: () => this.planning.awaits(),
  });
  private readonly previewer = new Previewer(
    (drawings: readonly Drawing[], settings) => this.engine.call("preview", { drawings, settings }),
    (state) => this.store.set(state),
  );
  private readonly coverer = new Coverer(
    {
      surface: (solid) => this.engine.call("surface", { solid }),
      curve: (covered, settings) => this.engine.call("curve", { covered, settings }),
      cancel: () => this.engine.cancel(),
    },
    (state) => {
      this.store.set(state);
      // Whoever looks back sees it afterwards.
      if ("curve" in state && this.doc.job === "fill" && this.store.get().looking === null) this.runs.show();
    },
  );
  private readonly planning = new Planning(this.bench, this.options, this.coverer);
  private readonly patterns = new Map<PatternName, Promise<Ink>>();
  private readonly wireListeners = new Set<(wire: WireShape | null) => void>();
  private wire: WireShape | null = null;
  private recalled: Promise<unknown> = Promise.resolve();

  constructor() {
    let before = this.store.get();
    this.store.follow((now) => {
      // A run has begun or ended, the settings have come, or the stage is to show another curve.
      const [changed, planned] = [now.phase !== before.phase || now.tables !== before.tables, now.planned !== before.planned];
      before = now;
      if (changed) this.planning.follow(this.opener.ahead);
      else if (planned) this.runs.show();
    });
    const tab = new HiddenTab(() => this.store.get().whenHidden, { phase: () => this.store.get().phase, pauseOrGoOn: () => this.pause() });
    this.store.follow(() => tab.look());
  }

  /** Brings back what was kept, opens what the address asks for, or shows the example on a first visit. */
  async begin({ hash, search }: Pick<Location, "hash" | "search">): Promise<void> {
    const { backend, problem } = readRenderer(search);
    if (backend) this.placer.obey(backend);
    if (problem) this.notify(problem);
    const recalled = this.project.recall();
    this.recalled = recalled;
    // A link's wire is on the stage at once; into the document it comes as a step over what was kept.
    const opening = this.opener.fragment(hash);
    const asked = hash.length > 1 ? this.doc.job : null;
    this.runs.offer(await recalled);
    if (asked) this.setJob(asked);
    if (!(await opening)) await this.showExample();
    this.engine.call("settings", {}).then(
      (tables) => {
        this.options.learn(tables);
        this.seekPlace();
      },
      (error: unknown) => this.store.set({ problem: explain(error, "The engine") }),
    );
  }

  /** The wire changes too often for the store. */
  followWire(listener: (wire: WireShape | null) => void): () => void {
    this.wireListeners.add(listener);
    listener(this.wire);
    return () => this.wireListeners.delete(listener);
  }

  /** Turns to another job. What the one before has, given and made, stays with it; a run goes on. */
  choose(job: Job): void {
    if (job === this.doc.job) return;
    this.setJob(job);
    void this.showExample();
  }

  /** Files dropped or pasted anywhere: pictures to where the job wants them, a mesh to be covered, a wire onto the stage. */
  async takeFiles(files: readonly File[], folders: readonly string[] = []): Promise<void> {
    if (this.busy || files.length === 0) return;
    const { job } = this.doc;
    const one = job !== "multiview";
    const { meshes, pictures, wire, note } = sortFiles(files, folders, one ? 1 : SLOTS.length, job === "fill");
    this.store.set({ problem: note });
    if (wire && pictures.length === 0 && meshes.length === 0) await this.opener.file(wire);
    if (job === "fill") {
      for (const file of meshes) await this.dressing.open(file, file.name || "the mesh");
      for (const file of pictures) await this.dressing.picture(file, file.name || "the picture");
      return;
    }
    if (meshes.length) {
      this.choose("fill");
      await this.dressing.open(meshes[0]!, meshes[0]!.name);
      return;
    }
    if (one) {
      for (const file of pictures) await this.sitting.give(file, file.name || "the picture");
      return;
    }
    // Into the empty pads first, then from the front on; one after the other: each is an undo step of its own.
    const { papers } = this.doc;
    const order = [...SLOTS.filter((slot) => !papers[slot]), ...SLOTS.filter((slot) => papers[slot])];
    for (const [i, file] of pictures.entries()) await this.pads.give(order[i]!, file, file.name || `the ${order[i]!} picture`);
  }

  /** Text pasted or dropped on the page: a link is opened, for anything else there is a better place. */
  takeText(text: string): void {
    if (this.busy || !text.trim()) return;
    const hash = fragmentIn(text);
    if (hash) void this.openFragment(hash);
    else if (this.doc.job === "stroke") this.warn("That was text. Here a wire is made of a picture: paste or drop one.");
    else if (this.doc.job === "fill") this.warn("That was text. Here a wire covers a shape: drop a mesh, or a picture for its style.");
    else this.warn("That was text. To make a wire of a word, open a pad, choose Type and write it there.");
  }

  applyRemedy({ kind, slots, quarterTurns }: PadRemedy): void {
    const [a, b] = slots;
    if (kind === "arrange") this.options.set("arrange", "on");
    else if (kind === "mirror") this.pads.mirror(a!);
    else if (kind === "turn") this.pads.turn(a!, quarterTurns);
    else this.pads.swap(a!, b!);
  }

  startOver(): void {
    if (this.doc.job === "stroke") this.sitting.clear();
    else if (this.doc.job === "fill") this.dressing.clear();
    else this.edit("Start with empty pads", { papers: BLANK.papers });
  }

  setWhenHidden(choice: WhenHidden): void {
    remember("hidden", choice);
    this.store.set({ whenHidden: choice });
  }

  // Run

  run(): Promise<void> {
    return this.runs.run();
  }

  /** Loose strokes beside the wire on the stage. */
  compare(): Promise<void> {
    return this.runs.compare();
  }

  pause(): void {
    this.runs.pause();
  }

  step(): void {
    this.runs.step();
  }

  stop(): void {
    this.runs.stop();
  }

  /** Throws the run away; the wire before it is back. */
  reset(): void {
    this.runs.cancel();
  }

  lookAt(index: number | null): void {
    this.runs.lookAt(index);
  }

  /** Goes on from a snapshot, with the settings as they are now; what came after it is dropped. */
  continueFrom(index: number): Promise<void> {
    return this.runs.continueFrom(index);
  }

  continueUnfinished(): Promise<void> {
    return this.runs.continueUnfinished();
  }

  dropUnfinished(): void {
    this.runs.dropUnfinished();
  }

  undo(): void {
    if (!this.busy) this.project.undo();
  }

  redo(): void {
    if (!this.busy) this.project.redo();
  }

  // Opening, keeping and taking along

  /** Shows what an address asks for. */
  async openFragment(hash: string): Promise<void> {
    if (this.busy) this.warn(DURING_A_RUN);
    else if (!(await this.opener.fragment(hash))) await this.showExample();
  }

  /** This tab keeps the project from now on. */
  keepHere(): void {
    this.project.keepHere();
  }

  /** The page may be about to go. */
  save(): void {
    this.project.save();
  }

  /** The wire as a file; `view` is the one an SVG draws, with lines on the far side if the stage has them. */
  async export(format: ExportFormat, view = "front"): Promise<Blob | null> {
    const { made } = deskOf(this.doc);
    if (!made) return null;
    try {
      const covered = format.endsWith("svg") ? this.hiding(made) : null;
      const bytes = await this.engine.call("export", { file: made.finished.file, format, view, covered });
      return new Blob([bytes], { type: MIME[format] });
    } catch (error) {
      this.warn(explain(error, "The file"));
      return null;
    }
  }

  /** A link that carries the whole wire and the settings. */
  link(page: string): string | null {
    const { made } = deskOf(this.doc);
    return made && forOthers(page) + this.address(writeFragment(this.doc.job, made.finished.code, {}));
  }

  /** What should stand in the address in place of `hash`. */
  address(hash: string): string {
    const { made } = deskOf(this.doc);
    return addressed(hash, this.doc, made && this.planning.coverOf(made));
  }

  /** Whether the stage shows what a link carries, ahead of the document. */
  get ahead(): boolean {
    return this.opener.ahead;
  }

  /** The picture of a style by formula. */
  pattern(pattern: PatternName): Promise<Ink> {
    let picture = this.patterns.get(pattern);
    if (!picture) {
      picture = this.engine.call("pattern", { pattern, sidePx: PATTERN_PX });
      picture.catch(() => this.patterns.delete(pattern));
      this.patterns.set(pattern, picture);
    }
    return picture;
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

  private changed(state: Pick<StudioState, "doc" | "undo" | "redo" | "keeping">): void {
    const before = this.store.get().doc;
    this.store.set(state);
    const { doc } = state;
    if ((doc.job !== before.job || deskOf(doc).made !== deskOf(before).made) && !this.opener.ahead) this.runs.show();
    this.previewer.follow({ papers: doc.papers, settings: doc.desks.multiview.settings });
    this.planning.follow(this.opener.ahead);
    this.seekPlace();
  }

  /** The shape that hides the far side of a wire that covers it. */
  private hiding(made: Made): Solid | null {
    if (this.doc.job !== "fill" || this.options.value("hidden_lines") === "true") return null;
    return this.planning.coverOf(made)?.solid ?? null;
  }

  private setJob(job: Job): void {
    if (job !== this.doc.job) this.project.replace({ job });
  }

  private async showExample(): Promise<void> {
    const { doc } = this;
    if (untouched(doc, doc.job)) await this.opener.example(doc.job);
  }

  private notify(notice: string): void {
    this.dismiss(notice);
    this.store.set({ notices: [...this.store.get().notices, notice] });
  }

  /** Once there is a table, so that the engine is loaded and the setting is one that it knows. */
  private seekPlace(): void {
    if (this.store.get().tables && !this.busy) this.placer.follow(this.backend);
  }

  private get backend(): Backend {
    return (this.options.value("backend") || "auto") as Backend;
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

  private benchOf(): Bench {
    const { engine, store, project } = this;
    const now = { doc: () => this.doc, busy: () => this.busy };
    return {
      engine,
      store,
      project,
      get doc() {
        return now.doc();
      },
      get busy() {
        return now.busy();
      },
      edit: (label, change, kind) => this.edit(label, change, kind),
      warn: (problem) => this.warn(problem),
    };
  }

  private showWire(wire: WireShape | null): void {
    this.wire = wire;
    for (const listener of this.wireListeners) listener(wire);
  }
}

/** Of the pictures on the shelf. */
const PATTERN_PX = 160;

const MIME: Readonly<Record<ExportFormat, string>> = {
  glb: "model/gltf-binary",
  stl: "model/stl",
  obj: "model/obj",
  svg: "image/svg+xml",
  "lines.svg": "image/svg+xml",
  "wire.json": "application/json",
  "bend.csv": "text/csv",
};
