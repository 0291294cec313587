/** Puts together what there is behind the page: its parts, and the state that follows from them. */

import { msg } from "@lit/localize";
import type { WireShape } from "#sculpture/scene/shape";
import { EngineClient } from "../engine/client";
import type { Backend } from "../engine/protocol";
import type { Action, Parts } from "./actions/action";
import { readRenderer } from "./address/renderer";
import { isLocked } from "./common/locks";
import { Store } from "./common/store";
import { explain } from "../words/sentences";
import type { Bench } from "./contract/bench";
import { by, firstState, stateOf, wireFor, type BaseState, type StudioState, type StudioStore } from "./contract/state";
import type { Taker, Task } from "./contract/task";
import type { Doc } from "./keeping/document";
import type { Forms } from "./keeping/keep";
import { Project } from "./keeping/project";
import { Opener } from "./opening/opener";
import { namesBeside, Receiver } from "./opening/receiver";
import { HiddenTab } from "./run/hidden-tab";
import { Placer } from "./run/placer";
import { Runs } from "./run/runs";
import { Saver } from "./saving/saver";
import { Options } from "./settings/options";
import type { Lessons } from "./teaching/lessons";

export { deskOf, type Doc, type Made } from "./keeping/document";
export { ANYWHERE, showsExample, tableOf, WHEN_HIDDEN, type PadState, type Phase, type Progress, type StudioState, type Whereabouts, type WhenHidden } from "./contract/state";
export { INSTEAD } from "./run/placer";

export interface Setup {
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
  readonly receiver: Receiver;
  readonly saver: Saver;
  /** Null until an address has asked for one, or for a class. */
  lessons: Lessons | null = null;
  private readonly tasks: readonly Task[];
  private readonly engine: EngineClient;
  private readonly placer: Placer;
  private readonly takers: Readonly<Record<string, Taker>>;
  private readonly wireListeners = new Set<(wire: WireShape | null) => void>();
  /** Of the run under way. */
  private forming: WireShape | null = null;
  private wire: WireShape | null = null;

  constructor({ tasks, before, newWorker }: Setup) {
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
    const taker = (task: string): Taker => this.takers[task]!;
    this.opener = new Opener(this.bench, tasks, this.options, taker);
    this.receiver = new Receiver(this.bench, tasks, this.opener, taker, (hash) => this.teach(hash));
    this.saver = new Saver(this.bench, tasks, taker);
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
    const lesson = namesLesson(hash);
    const opening = lesson ? false : this.opener.fragment(hash);
    const asked = hash.length > 1 && !lesson ? this.doc.task : null;
    this.runs.offer(await recalled);
    if (asked) this.opener.choose(asked);
    const taught = await this.teach(hash);
    if (!taught && !(await opening) && !namesBeside(hash)) await this.opener.example();
    await this.engine.call("settings", { tasks: this.tasks.map(({ name }) => name) }).then(
      (tables) => this.options.learn(tables),
      (error: unknown) => this.warn(explain(error, msg("The engine"))),
    );
    // With its settings, which are known only now.
    if (!taught) await this.receiver.beside(hash);
    this.lessons?.check();
  }

  /** Does what people can do, where it can be done now. */
  act<More extends readonly unknown[]>(action: Action<More>, ...more: More): void {
    if (this.can(action)) void action.act(this, ...more);
  }

  can({ id, part, can }: Pick<Action<never>, "id" | "part" | "can">): boolean {
    const state = this.store.get();
    return !isLocked(state, part ?? id) && (can?.(state) ?? true);
  }

  /** Whether files and links are taken from outside; says so where they are not. */
  takesFiles(): boolean {
    const state = this.store.get();
    const locked = isLocked(state, "files") || isLocked(state, "leave");
    if (locked) this.warn(msg("This page is locked for a lesson: files and links are not opened here."));
    return !locked;
  }

  /** Lessons and what a link asks for a class, which come when an address first names them; true where that is all it asks. */
  private async teach(hash: string): Promise<boolean> {
    if (!this.lessons && !namesClass(hash)) return false;
    const module = await import("./teaching/lessons").catch((error: unknown) => this.warn(explain(error, msg("The lesson"))));
    if (!module) return false;
    const { bench, tasks, opener, receiver, runs } = this;
    this.lessons ??= new module.Lessons({
      bench,
      tasks,
      opener,
      receiver,
      runs,
      notify: (words) => this.notify(words),
      address: (hash) => history.replaceState(null, "", hash || location.pathname + location.search),
    });
    return this.lessons.open(hash);
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

  /** The page may be about to go. */
  save(): void {
    this.project.save();
  }

  say(said: string): void {
    this.store.set({ said });
  }

  warn(problem: string): void {
    this.store.set({ problem });
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
      // A file that carries a wire would take its own job along.
      opens: async (file, name) => (isLocked(store.get(), "leave") ? false : this.opener.opens(file, name)),
      warn: (problem) => this.warn(problem),
    };
  }
}

const namesLesson = (hash: string): boolean => /[#&]lesson=/.test(hash);
/** Whether an address has anything to say to a class. */
const namesClass = (hash: string): boolean => /[#&](lesson|lock|hide|kiosk)=/.test(hash);
