/** Runs from their beginning to the wire they come to, and what of them is on the page meanwhile. */

import type { WireShape } from "../../embed/shape";
import type { Backend, Finished, Job, News } from "../../engine/protocol";
import { deskOf, SLOTS, withDesk, type Doc, type Made } from "../keeping/document";
import { whenIdle, type Bench } from "../contract/state";
import { explain } from "../common/words";
import type { Placer } from "./placer";
import { sheetsOf } from "../../tasks/multiview/previewer";
import { NOTHING_TO_SEE, READY, Runner, type RunState, type Scene } from "./runner";
import { freshTrack, jobOf, upTo, type Given, type Track } from "../keeping/track";

export class Runs {
  /** Of the run under way, whichever job is looked at. */
  private state: RunState = { ...NOTHING_TO_SEE, phase: "idle", progress: READY };
  private wire: WireShape | null = null;
  private readonly runner: Runner;
  /** The run behind `unfinished`. */
  private cutOff: Track | null = null;

  constructor(
    private readonly bench: Bench,
    private readonly placer: Placer,
    private readonly backend: () => Backend,
    /** A wire for the stage. */
    private readonly showWire: (wire: WireShape | null) => void,
    /** What stands for the finished wire while nothing runs. */
    private readonly standIn: (made: WireShape | null) => WireShape | null = (made) => made,
  ) {
    this.runner = new Runner(bench.engine, {
      get: () => this.state,
      set: (change) => this.set(change),
      wire: (wire) => {
        this.wire = wire;
        if (this.here) this.showWire(wire);
      },
      snapshot: (snapshot) => this.bench.project.addSnapshot(snapshot),
      place: (place) => this.placer.hear(place),
    });
  }

  hear(news: News): void {
    this.runner.hear(news);
  }

  async run(): Promise<void> {
    if (this.bench.busy) return;
    const given = this.given();
    if (given) await this.fit(freshTrack(given, deskOf(this.bench.doc).settings));
  }

  /** The wire on the stage once more with loose strokes, to be laid beside it; the wire first, where there is none of a run. */
  async compare(): Promise<void> {
    if (this.bench.busy) return;
    const { job } = this.bench.doc;
    const made = (): Made | null => this.bench.doc.desks[job].made;
    const known = made()?.source === "run";
    if (!known) await this.run();
    const track = made()?.track;
    // One that was stopped on the way was not to be compared after all.
    const given = track && (known || !made()!.stopped);
    if (!given || this.bench.busy || this.bench.doc.job !== job) return;
    await this.fit({ ...freshTrack(track.given, { ...track.settings, form: "bag" }), loose: true });
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
  cancel(): void {
    this.runner.cancel();
  }

  lookAt(index: number | null): void {
    if (this.here) {
      this.runner.lookAt(index);
      return;
    }
    const { store, doc } = this.bench;
    const snapshot = index === null ? null : store.get().track?.snapshots[index];
    store.set({ looking: snapshot ? index : null });
    this.showWire(snapshot?.wire ?? this.standIn(deskOf(doc).made?.finished.wire ?? null));
  }

  /** Goes on from a snapshot, with the settings as they are now; what came after it is dropped. */
  async continueFrom(index: number): Promise<void> {
    const { track } = this.bench.store.get();
    const snapshot = track?.snapshots[index];
    if (!track || !snapshot || (this.bench.busy && !this.here)) return;
    this.runner.cancel();
    await whenIdle(this.bench.store);
    // Unless somebody was quicker.
    if (!this.bench.busy) await this.resume(upTo(track, snapshot));
  }

  async continueUnfinished(): Promise<void> {
    if (this.cutOff && !this.bench.busy) await this.resume(this.cutOff);
  }

  offer(track: Track | null): void {
    this.cutOff = track;
    const { iteration = 0, iterations = 0 } = track?.snapshots.at(-1) ?? {};
    this.bench.store.set({ unfinished: track && { job: jobOf(track), iteration, iterations } });
  }

  dropUnfinished(): void {
    this.offer(null);
    this.bench.project.endRun();
  }

  /** Puts on the page what the job that is looked at has to show: its run, or its wire. */
  show(): void {
    const { store, doc } = this.bench;
    if (this.here) {
      store.set(sceneOf(this.state));
      this.showWire(this.wire);
      return;
    }
    const { made } = deskOf(doc);
    const { views = [], targets = [], wire = null } = made?.finished ?? {};
    store.set({ ...NOTHING_TO_SEE, views, targets, track: made?.track ?? null });
    this.showWire(this.standIn(wire));
  }

  private get running(): Job | null {
    return this.state.phase === "idle" || !this.state.track ? null : jobOf(this.state.track);
  }

  /** Whether the run under way is of the job that is looked at. */
  private get here(): boolean {
    return this.running === this.bench.doc.job;
  }

  private set(change: Partial<RunState>): void {
    this.state = { ...this.state, ...change };
    const { phase, progress, track } = this.state;
    const comparing = phase !== "idle" && track?.loose === true;
    this.bench.store.set({ phase, progress, running: this.running, comparing, ...(this.here ? sceneOf(this.state) : {}) });
  }

  private given(): Given | null {
    const { doc } = this.bench;
    if (doc.job === "stroke") {
      if (doc.subject) return { job: "stroke", subject: doc.subject };
      this.bench.warn("A wire needs a picture. Give one on the left, then press Run.");
      return null;
    }
    if (doc.job === "fill") {
      if (doc.cover) return { job: "fill", cover: doc.cover };
      this.bench.warn("A wire needs a shape to cover. Choose one on the left, then press Cover it.");
      return null;
    }
    const sheets = sheetsOf(doc);
    if (sheets.length >= 2) return { job: "multiview", sheets };
    this.bench.warn("A wire needs at least two drawings. Put one into another pad, then press Run.");
    return null;
  }

  private async resume(track: Track): Promise<void> {
    const { doc, project } = this.bench;
    const job = jobOf(track);
    if (doc.job !== job) project.replace({ job });
    const change = givenAgain(track.given, doc);
    if (change) this.bench.edit(`Bring back the ${GIVEN[job]} of the run`, change);
    // What it is compared with decides about loose strokes.
    await this.fit(track.loose ? track : { ...track, settings: doc.desks[job].settings });
  }

  private async fit(track: Track): Promise<void> {
    const { project, store } = this.bench;
    this.offer(null);
    store.set({ problem: "", notices: [], said: "" });
    project.beginRun(track);
    this.wire = null;
    const startMs = performance.now();
    let failed = false;
    try {
      const finished = await this.runner.run(track, this.placer.begin(this.backend()));
      if (finished) this.finish(finished, (performance.now() - startMs) / 1000);
      else this.show();
    } catch (error) {
      failed = true;
      this.bench.warn(explain(error, "The run"));
      const went = this.state.track;
      this.show();
      if (went && went.snapshots.length > 0) return this.offer(went);
    } finally {
      this.placer.end(failed);
    }
    project.endRun();
  }

  private finish(finished: Finished, seconds: number): void {
    const { track } = this.state;
    if (!track) return;
    const stopped = !track.events.some(({ kind }) => kind === "done");
    const made: Made = { finished, source: "run", track, stopped, seconds };
    const { doc } = this.bench;
    if (track.loose) this.bench.edit("Compare with loose strokes", withDesk(doc, jobOf(track), { loose: made }));
    else this.bench.edit("Make the wire", withDesk(doc, jobOf(track), { made, loose: null }));
    this.show();
  }
}

const GIVEN: Readonly<Record<Job, string>> = { multiview: "drawings", stroke: "picture", fill: "shape" };

function sceneOf({ track, looking, views, targets, notes }: RunState): Scene {
  return { track, looking, views, targets, notes };
}

/** The change that brings back what a run was given, if that is not what is there. */
function givenAgain(given: Given, doc: Doc): Partial<Doc> | null {
  if (given.job === "stroke") return given.subject === doc.subject ? null : { subject: given.subject };
  if (given.job === "fill") return given.cover === doc.cover ? null : { cover: given.cover };
  const papers = Object.fromEntries(SLOTS.map((slot) => [slot, given.sheets.find((sheet) => sheet.slot === slot)?.paper ?? null]));
  return SLOTS.every((slot) => papers[slot] === doc.papers[slot]) ? null : { papers: papers as Doc["papers"] };
}
