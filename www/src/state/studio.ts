/** Puts together what there is behind the page: parts, each with a task of its own, and the state that follows from them. */

import type { WireShape } from "../embed/shape";
import { EngineClient } from "../engine/client";
import type { Backend, ExportFormat } from "../engine/protocol";
import type { Action, Parts } from "./actions/action";
import { addressed } from "./address/address";
import { writeFragment } from "./address/fragment";
import { fragmentIn } from "./address/pasted";
import { forOthers, readRenderer } from "./address/renderer";
import { Store } from "./common/store";
import { DURING_A_RUN, explain } from "./common/words";
import type { Bench } from "./contract/bench";
import { by, firstState, stateOf, wireFor, type BaseState, type StudioState, type StudioStore } from "./contract/state";
import type { Taker, Task } from "./contract/task";
import { deskOf, type Doc, type Made } from "./keeping/document";
import type { Forms } from "./keeping/keep";
import { Project } from "./keeping/project";
import { sortFiles } from "./opening/files";
import { Opener } from "./opening/opener";
import { HiddenTab } from "./run/hidden-tab";
import { Placer } from "./run/placer";
import { Runs } from "./run/runs";
import { Options } from "./settings/options";

export { deskOf, type Doc, type Made } from "./keeping/document";
export { ANYWHERE, showsExample, tableOf, WHEN_HIDDEN, type PadState, type Phase, type Progress, type StudioState, type Whereabouts, type WhenHidden } from "./contract/state";
export { INSTEAD } from "./run/placer";

export interface Given {
  /** The first is the one that people see who have not chosen. */
  readonly tasks: readonly Task[];
  /** How documents were kept before. */
  readonly before: Omit<Forms, "byTask">;
  /** Throws where the browser allows none. */
  readonly newWorker: () => Worker;
}

export class Studio implements Parts {
  readonly store: StudioStore;
  readonly project: Project;
  readonly bench: Bench;
  readonly options: Options;
  readonly runs: Runs;
  readonly opener: Opener;
  private readonly tasks: readonly Task[];
  private readonly engine: EngineClient;
  private readonly placer: Placer;
  private readonly takers: Readonly<Record<string, Taker>>;
  private readonly wireListeners = new Set<(wire: WireShape | null) => void>();
  /** Of the run under way. */
  private forming: WireShape | null = null;
  private wire: WireShape | null = null;

  constructor({ tasks, before, newWorker }: Given) {
    this.tasks = tasks;
    const first = firstState(tasks);
    this.store = new Store<BaseState, StudioState>(first, (base) => stateOf(base, tasks));
    this.engine = new EngineClient(newWorker);
    this.project = new Project(first.doc, { ...before, byTask: by(tasks, ({ form }) => form) }, (state) => this.store.set(state));
    this.bench = this.benchOf();
    this.options = new Options(this.bench, tasks);
    this.placer = new Placer(
      (backend) => this.engine.call("place", { backend }),
      (where) => this.store.set({ where }),
      (words) => this.notify(words),
    );
    this.runs = new Runs(this.bench, tasks, this.placer, (wire) => {
      this.forming = wire;
      this.showWire();
    });
    this.takers = by(tasks, (task) => task.open(this.bench));
    this.opener = new Opener(this.bench, tasks, this.options, (task) => this.takers[task]!);
    this.store.follow(() => this.showWire());
    this.store.watch(({ doc, phase, tables }) => [doc, phase, tables], () => this.seekPlace());
    const tab = new HiddenTab(() => this.store.get().whenHidden, { phase: () => this.store.get().phase, pauseOrGoOn: () => this.runs.pause() });
    this.store.follow(() => tab.look());
  }

  /** Brings back what was kept, opens what the address asks for, or shows the example on a first visit. */
  async begin({ hash, search }: Pick<Location, "hash" | "search">): Promise<void> {
    const { backend, problem } = readRenderer(search);
    if (backend) this.placer.obey(backend);
    if (problem) this.notify(problem);
    const recalled = this.project.recall();
    this.opener.await(recalled);
    // A link's wire is on the stage at once; into the document it comes as a step over what was kept.
    const opening = this.opener.fragment(hash);
    const asked = hash.length > 1 ? this.doc.task : null;
    this.runs.offer(await recalled);
    if (asked) this.opener.choose(asked);
    if (!(await opening)) await this.opener.example();
    this.engine.call("settings", { tasks: this.tasks.map(({ name }) => name) }).then(
      (tables) => this.options.learn(tables),
      (error: unknown) => this.warn(explain(error, "The engine")),
    );
  }

  /** Does what people can do, where it can be done now. */
  act<More extends readonly unknown[]>(action: Action<More>, ...more: More): void {
    if (this.can(action)) void action.act(this, ...more);
  }

  can(action: Pick<Action<never>, "can">): boolean {
    return action.can?.(this.store.get()) ?? true;
  }

  task(name = this.doc.task): Task {
    return this.tasks.find((task) => task.name === name)!;
  }

  /** What takes what people bring to a task. */
  taker<Takes extends Taker>({ name }: { readonly name: string; open(bench: Bench): Takes }): Takes {
    return this.takers[name] as Takes;
  }

  /** The wire changes too often for the store. */
  followWire(listener: (wire: WireShape | null) => void): () => void {
    this.wireListeners.add(listener);
    listener(this.wire);
    return () => this.wireListeners.delete(listener);
  }

  /** Turns to another task. What the one before has, given and made, stays with it; a run goes on. */
  choose(task: string): void {
    if (task === this.doc.task) return;
    this.opener.choose(task);
    void this.opener.example();
  }

  /** Files dropped or pasted anywhere: pictures to where the task wants them, a mesh to where it is covered, a wire onto the stage. */
  async takeFiles(files: readonly File[], folders: readonly string[] = []): Promise<void> {
    if (this.bench.busy || files.length === 0) return;
    const { takes } = this.task();
    const { meshes, pictures, wire, note } = sortFiles(files, folders, takes.pictures, takes.meshes);
    this.store.set({ problem: note });
    if (wire && pictures.length === 0 && meshes.length === 0) await this.opener.file(wire);
    const elsewhere = meshes.length && !takes.meshes ? this.tasks.find(({ takes }) => takes.meshes) : undefined;
    if (elsewhere) this.choose(elsewhere.name);
    await this.takers[this.doc.task]!.take({ meshes, pictures: elsewhere ? [] : pictures });
  }

  /** Text pasted or dropped on the page: a link is opened, for anything else there is a better place. */
  takeText(text: string): void {
    if (this.bench.busy || !text.trim()) return;
    const hash = fragmentIn(text);
    if (hash) void this.openFragment(hash);
    else this.warn(this.task().words.text);
  }

  /** Shows what an address asks for. */
  async openFragment(hash: string): Promise<void> {
    if (this.bench.busy) this.warn(DURING_A_RUN);
    else if (!(await this.opener.fragment(hash))) await this.opener.example();
  }

  /** The page may be about to go. */
  save(): void {
    this.project.save();
  }

  /** The wire as a file; `view` is the one an SVG draws. */
  async export(format: ExportFormat, view = "front"): Promise<Blob | null> {
    const { made } = deskOf(this.doc);
    if (!made) return null;
    try {
      const how = { file: made.finished.file, format, view };
      const seen = format.endsWith("svg") ? this.takers[this.doc.task]!.exportSeen?.(made, how) : null;
      const bytes = await (seen ?? this.engine.call("export", how));
      return new Blob([bytes as Uint8Array<ArrayBuffer>], { type: MIME[format] });
    } catch (error) {
      this.warn(explain(error, "The file"));
      return null;
    }
  }

  /** A link that carries the whole wire and the settings. */
  link(page: string): string | null {
    const { made } = deskOf(this.doc);
    return made && forOthers(page) + this.address(writeFragment(this.doc.task, made.finished.code, {}, {}, this.tasks));
  }

  /** What should stand in the address in place of `hash`. */
  address(hash: string): string {
    const { made } = deskOf(this.doc);
    return addressed(hash, this.doc, this.tasks, made && this.madeOf(made));
  }

  /** Whether the stage shows what a link carries, ahead of the document. */
  get ahead(): boolean {
    return this.opener.ahead;
  }

  say(said: string): void {
    this.store.set({ said });
  }

  warn(problem: string): void {
    this.store.set({ problem });
  }

  private madeOf(made: Made): unknown {
    return this.takers[this.doc.task]!.madeOf?.(made) ?? null;
  }

  private notify(notice: string): void {
    const { notices } = this.store.get();
    this.store.set({ notices: [...notices.filter((other) => other !== notice), notice] });
  }

  /** Once there is a table, so that the engine is loaded and the setting is one that it knows. */
  private seekPlace(): void {
    if (this.store.get().tables && !this.bench.busy) this.placer.follow((this.options.value("backend") || "auto") as Backend);
  }

  private get doc(): Doc {
    return this.project.doc;
  }

  private showWire(): void {
    const wire = wireFor(this.store.get(), this.tasks, this.forming);
    if (wire === undefined || wire === this.wire) return;
    this.wire = wire;
    for (const listener of this.wireListeners) listener(wire);
  }

  private benchOf(): Bench {
    const { engine, store, project } = this;
    const studio = this;
    return {
      engine,
      store,
      project,
      get settings() {
        return studio.options;
      },
      get doc() {
        return project.doc;
      },
      get busy() {
        return store.get().phase !== "idle";
      },
      // Edits wait for the end of a run.
      edit: (label, change, kind) => void (store.get().phase === "idle" && project.edit(label, change, kind)),
      pass: ({ name }, change) => {
        const { passing } = store.get();
        store.set({ passing: { ...passing, [name]: { ...passing[name], ...change } } });
      },
      warn: (problem) => this.warn(problem),
    };
  }
}

const MIME: Readonly<Record<ExportFormat, string>> = {
  glb: "model/gltf-binary",
  stl: "model/stl",
  obj: "model/obj",
  svg: "image/svg+xml",
  "lines.svg": "image/svg+xml",
  "wire.json": "application/json",
  "bend.csv": "text/csv",
};
