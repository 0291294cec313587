/** Wires from elsewhere: links, files, and the examples of a first visit. */

import { msg, str } from "@lit/localize";
import { openShareCode, ShareCodeError } from "#sculpture/share/code";
import { Problem } from "../../engine/client";
import type { ViewMeasures } from "../../engine/protocol";
import { readFragment } from "../address/fragment";
import { fragmentIn } from "../address/pasted";
import { asSentence, DURING_A_RUN, explain, named } from "../../words/sentences";
import type { Bench } from "../contract/bench";
import { whenIdle } from "../contract/state";
import type { Taker, Task } from "../contract/task";
import { deskOf, withDesk, withGiven, type Made } from "../keeping/document";
import type { Options } from "../settings/options";

/** Where a wire comes from: an example also tells how well it matches, since the core cannot measure without pictures. */
type From = { readonly source: "link" } | { readonly source: "example"; readonly measured: readonly ViewMeasures[] };

export class Opener {
  /** Once what was kept is back. */
  private recalled: Promise<unknown> = Promise.resolve();

  constructor(
    private readonly bench: Bench,
    private readonly tasks: readonly Task[],
    private readonly options: Options,
    private readonly taker: (task: string) => Taker,
  ) {}

  /** What was kept is on its way: what comes from elsewhere goes over it. */
  await(recalled: Promise<unknown>): void {
    this.recalled = recalled;
  }

  /** Whether the stage shows what a link or an example carries, ahead of the document. */
  get ahead(): boolean {
    const { ahead, doc } = this.bench.store.get();
    return ahead?.task === doc.task && ahead.coming;
  }

  /** Shows the wire and takes the settings that an address carries; false if it carries no wire. */
  async fragment(hash: string): Promise<boolean> {
    const { bench } = this;
    const { task, code, given, settings, newer } = readFragment(fragmentIn(hash) ?? hash, this.tasks);
    bench.warn("");
    if (newer) {
      bench.warn(msg("This link was made by a newer Wire4D. Reload the page to get it, then open the link again."));
      return false;
    }
    if (!task) return false;
    if (code !== null) this.go(task);
    this.choose(task);
    this.options.ask(task, settings);
    void this.recalled.then(() => this.options.askGuide(task, settings));
    if (this.task(task).address) void this.recalled.then(() => this.take(task, given, code));
    return code !== null && this.code(code, task, { source: "link" });
  }

  /** Turns to another task. What the one before has, given and made, stays with it; a run goes on. */
  turnTo(task: string): void {
    if (task === this.bench.doc.task) return;
    this.choose(task);
    void this.example();
  }

  /** The same without an example. */
  choose(task: string): void {
    const { doc, project, store } = this.bench;
    if (task === doc.task) return;
    store.set({ lookingBack: null });
    project.replace({ task });
  }

  /** What a link names: a wire without it is not shown over anything else. */
  private take(name: string, pairs: Readonly<Record<string, string>>, code: string | null): void {
    const { doc, busy, project } = this.bench;
    const address = this.task(name).address!;
    const given = address.read(pairs);
    const before = doc.given[name];
    if (busy || (code !== null && this.has(code, name))) return;
    if (given === null ? code === null : alike(address.write(given), address.write(before))) return;
    const change = withGiven(doc, name, given ?? this.task(name).blank);
    if (code !== null) this.bench.edit(msg("Open the link"), change, "open a link");
    else project.replace(change);
  }

  /** Whether the link is to the very wire that is there: a person comes back to their own, with all that it came from. */
  private has(code: string, task: string): boolean {
    return deskOf(this.bench.doc, task).made?.finished.code === code;
  }

  /** Opens a file if it carries a wire; false if it is any other. */
  async opens(file: Blob, name: string): Promise<boolean> {
    // What cannot be read, and a page that is not all there, are for others to speak of.
    const carries = await import("../carrying/recognised").then(({ carriesWire }) => carriesWire(file)).catch(() => false);
    if (!carries) return false;
    await this.file(new File([file], name));
    return true;
  }

  /** The wire of a file, with its settings and what it was made of: all that it takes to go on from it. */
  async file(file: File): Promise<void> {
    const { bench } = this;
    try {
      const bytes = new Uint8Array(await file.arrayBuffer());
      const finished = await bench.engine.call("open", { file: bytes, name: file.name });
      const { carriedIn } = await import("../carrying/wire-file");
      const { task: of, settings, packed } = await carriedIn(finished.file);
      const task = this.tasks.find(({ name }) => name === of) ?? this.task(bench.doc.task);
      const given = packed && (await (await task.packing()).unpack(packed));
      if (bench.busy) return bench.warn(DURING_A_RUN);
      const [label, kind] = [msg(str`Open ${file.name}`), `open ${performance.now()}`];
      bench.store.batch(() => {
        this.choose(task.name);
        bench.store.set({ ahead: null });
        const desk = { ...(settings && { settings: this.options.fitting(task.name, settings) }), ...(given !== null && { guide: null }) };
        bench.edit(label, { ...withDesk(bench.doc, task.name, desk), ...(given !== null && withGiven(bench.doc, task.name, given)) }, kind);
        this.taker(task.name).awaits?.();
        const made: Made = { finished, source: "file", carried: given !== null, track: null, stopped: false, seconds: 0 };
        bench.edit(label, withDesk(bench.doc, task.name, { made, loose: null }), kind);
      });
      if (given !== null) this.taker(task.name).complete?.(given);
      if (finished.notes?.length) bench.warn(finished.notes.map(asSentence).join(" "));
    } catch (error) {
      bench.warn(explain(error, named(file.name)));
    }
  }

  /** What the task that is looked at shows to those who have given it nothing yet. */
  async example(): Promise<void> {
    const { engine, project, store, doc } = this.bench;
    const task = this.task(doc.task);
    const { name } = task;
    if (!task.example || !this.untouched(name)) return;
    try {
      const { code, given, measured } = await task.example(engine);
      // Unless the person was quicker.
      if (this.bench.busy || !this.untouched(name)) return;
      // First, so that nothing is sought for what is about to have a wire.
      const showing = this.code(code, name, { source: "example", measured });
      project.amend((doc) => (task.isBlank(doc.given[name]) ? { ...doc, ...withGiven(doc, name, given) } : doc));
      store.set({ examples: { ...store.get().examples, [name]: given } });
      this.taker(name).complete?.(given);
      await showing;
    } catch (error) {
      this.bench.warn(explain(error, msg("The example")));
    }
  }

  private task(name: string): Task {
    return this.tasks.find((task) => task.name === name)!;
  }

  /** Whether nothing was ever given, said or made for a task. */
  private untouched(name: string): boolean {
    const { doc } = this.bench;
    const { made, guide } = deskOf(doc, name);
    return this.task(name).isBlank(doc.given[name]) && !made && !guide;
  }

  private go(task: string): void {
    this.bench.store.set({ ahead: { task, wire: null, views: [], coming: true } });
  }

  private arrive(): void {
    this.bench.store.set({ ahead: null });
  }

  /** Shows the wire at once; the worker measures it when it comes to that. */
  private async code(code: string, task: string, from: From): Promise<boolean> {
    this.go(task);
    try {
      // Read aside, to keep nobody waiting; here where there is no worker, or to hear what is wrong.
      const { wire, views } = await this.bench.engine.call("peek", { code }).catch(() => openShareCode(code));
      const { store } = this.bench;
      if (store.get().ahead?.task === task) store.set({ ahead: { task, wire, views, coming: true } });
    } catch (error) {
      this.arrive();
      if (!(error instanceof ShareCodeError)) throw error;
      this.bench.warn(asSentence(error.message));
      return false;
    }
    void this.adopt(code, task, from);
    return true;
  }

  private async adopt(code: string, task: string, from: From): Promise<void> {
    try {
      await this.recalled;
      this.taker(task).awaits?.();
      const before = deskOf(this.bench.doc, task).made;
      const finished = this.has(code, task) ? null : await this.bench.engine.call("open", { code });
      await whenIdle(this.bench.store);
      this.bench.store.batch(() => {
        this.arrive();
        // A wire that was made meanwhile is newer.
        if (!finished || deskOf(this.bench.doc, task).made !== before) return;
        const measures = from.source === "example" ? { ...finished.measures, views: from.measured } : finished.measures;
        // The code as it came: the same link again.
        const made: Made = { finished: { ...finished, code, measures }, source: from.source, track: null, stopped: false, seconds: 0 };
        this.opened(made, task, msg("Open the link"));
      });
    } catch (error) {
      // It is on the stage all the same, until there is another.
      const { store } = this.bench;
      const { ahead } = store.get();
      if (ahead?.task === task) store.set({ ahead: { ...ahead, coming: false } });
      if (!(error instanceof Problem)) console.error(error);
    }
  }

  private opened(made: Made, task: string, label: string): void {
    const { busy, doc, project } = this.bench;
    if (busy) {
      this.bench.warn(DURING_A_RUN);
      return;
    }
    // With what the link names, if it names anything, as one step.
    const kind = this.task(task).address && made.source === "link" ? "open a link" : "";
    if (made.source !== "example") this.bench.edit(label, withDesk(doc, task, { made, loose: null }), kind);
    else project.amend((doc) => (deskOf(doc, task).made ? doc : { ...doc, ...withDesk(doc, task, { made }) }));
  }
}

function alike(a: Readonly<Record<string, string>>, b: Readonly<Record<string, string>>): boolean {
  return JSON.stringify(a) === JSON.stringify(b);
}
