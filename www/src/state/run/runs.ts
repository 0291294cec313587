/** Runs from their beginning to the wire they come to. */

import { msg, str } from "@lit/localize";
import type { WireShape } from "#sculpture/scene/shape";
import type { Backend, Finished } from "../../engine/protocol";
import { explain } from "../../words/sentences";
import type { Bench } from "../contract/bench";
import { whenIdle } from "../contract/state";
import type { Task } from "../contract/task";
import { deskOf, withDesk, withGiven, type Made } from "../keeping/document";
import { freshTrack, upTo, variantOf, type Track } from "../keeping/track";
import type { Placer } from "./placer";
import { Runner } from "./runner";
import { LOOSE, type Change } from "./variants";

export class Runs {
  private readonly runner: Runner;
  /** The run behind `unfinished`. */
  private cutOff: Track | null = null;

  constructor(
    private readonly bench: Bench,
    private readonly tasks: readonly Task[],
    private readonly placer: Placer,
    /** The run's wire, whichever task is looked at; null before there is one. It changes too often for the store. */
    private readonly form: (wire: WireShape | null) => void,
  ) {
    const { engine, store, project } = bench;
    this.runner = new Runner(engine, {
      get: () => store.get().run,
      set: (change) => store.set({ run: { ...store.get().run, ...change } }),
      wire: form,
      snapshot: (snapshot) => project.addSnapshot(snapshot),
      place: (place) => this.placer.hear(place),
      notice: (words) => store.set({ notices: [...store.get().notices, words] }),
    });
    engine.listen((news) => this.runner.hear(news));
  }

  async run(): Promise<void> {
    const { bench } = this;
    const { doc, busy } = bench;
    if (busy) return;
    const task = this.task(doc.task);
    const given = doc.given[task.name];
    const { settings, guide } = deskOf(doc);
    if (task.suffices(given, guide, true)) await this.fit(freshTrack(task.name, given, settings, guide));
    else bench.warn(`${task.words.needs} ${task.words.remedy}`);
  }

  /** The wire on the stage once more but for one thing, to be laid beside it; the wire first, where there is none of a run. */
  async compare({ variant, settings, given: instead }: Change = LOOSE): Promise<void> {
    if (this.bench.busy) return;
    const { task } = this.bench.doc;
    const made = (): Made | null => deskOf(this.bench.doc, task).made;
    const known = made()?.source === "run";
    if (!known) await this.run();
    const track = made()?.track;
    // One that was stopped on the way was not to be compared after all.
    const given = track && (known || !made()!.stopped);
    if (!given || this.bench.busy || this.bench.doc.task !== task) return;
    await this.fit({ ...freshTrack(task, instead ?? track.given, { ...track.settings, ...settings }, track.guide), loose: true, variant });
  }

  /** Pauses, or goes on. */
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
  cancel(): void {
    this.runner.cancel();
  }

  /** Shows an earlier wire of the run that is looked at; null is the newest. */
  lookAt(index: number | null): void {
    const { store, doc } = this.bench;
    if (store.get().running === doc.task) {
      this.runner.lookAt(index);
      return;
    }
    const { made } = deskOf(doc);
    const known = index !== null && made?.track?.snapshots[index];
    store.set({ lookingBack: known ? { made, index } : null });
  }

  /** Goes on from a snapshot, with the settings as they are now; what came after it is dropped. */
  async continueFrom(index: number): Promise<void> {
    const { store, doc, busy } = this.bench;
    const { track, running } = store.get();
    const snapshot = track?.snapshots[index];
    if (!track || !snapshot || (busy && running !== doc.task)) return;
    this.runner.cancel();
    await whenIdle(store);
    // Unless somebody was quicker.
    if (!this.bench.busy) await this.resume(upTo(track, snapshot));
  }

  async continueUnfinished(): Promise<void> {
    if (this.cutOff && !this.bench.busy) await this.resume(this.cutOff);
  }

  /** A run that was cut off may go on; null where there is none. */
  offer(track: Track | null): void {
    // A lesson's runs are not kept: what is offered stays the project's.
    if (this.bench.store.get().lesson) return;
    this.cutOff = track;
    const { iteration = 0, iterations = 0 } = track?.snapshots.at(-1) ?? {};
    this.bench.store.set({ unfinished: track && { task: track.task, iteration, iterations } });
  }

  dropUnfinished(): void {
    this.offer(null);
    this.bench.project.endRun();
  }

  private task(name: string): Task {
    return this.tasks.find((task) => task.name === name)!;
  }

  private async resume(track: Track): Promise<void> {
    const { bench } = this;
    const { task, given } = track;
    if (bench.doc.task !== task) bench.project.replace({ task });
    // What lies beside a wire may be of something else than that.
    if (!track.loose && bench.doc.given[task] !== given) bench.edit(msg(str`Bring back the ${this.task(task).words.given} of the run`), withGiven(bench.doc, task, given));
    // What it is compared with decides about what lies beside it.
    await this.fit(track.loose ? track : { ...track, settings: deskOf(bench.doc, task).settings, guide: deskOf(bench.doc, task).guide });
  }

  private async fit(track: Track): Promise<void> {
    const { project, store, settings } = this.bench;
    this.offer(null);
    store.set({ problem: "", notices: [], said: "" });
    project.beginRun(track);
    this.form(track.snapshots.at(-1)?.wire ?? null);
    const startMs = performance.now();
    let failed = false;
    try {
      const backend = this.placer.begin((settings.value("backend") || "auto") as Backend);
      const finished = await this.runner.run(this.task(track.task), track, backend);
      // In one: nobody is to see the wire before in between.
      store.batch(() => {
        this.runner.rest();
        if (!store.get().ahead?.coming) store.set({ ahead: null });
        if (finished) this.finish(finished, (performance.now() - startMs) / 1000);
      });
    } catch (error) {
      failed = true;
      this.runner.rest();
      this.bench.warn(explain(error, msg("The run")));
      const went = store.get().run.track;
      if (went && went.snapshots.length > 0) return this.offer(went);
    } finally {
      this.placer.end(failed);
    }
    project.endRun();
  }

  private finish(finished: Finished, seconds: number): void {
    const { track } = this.bench.store.get().run;
    if (!track) return;
    const stopped = !track.events.some(({ kind }) => kind === "done");
    const made: Made = { finished, source: "run", track, stopped, seconds };
    const { doc } = this.bench;
    if (track.loose) this.bench.edit(variantOf(track) === "loose" ? msg("Compare with loose strokes") : msg("Lay another wire beside it"), withDesk(doc, track.task, { loose: made }));
    else this.bench.edit(msg("Make the wire"), withDesk(doc, track.task, { made, loose: null }));
  }
}
