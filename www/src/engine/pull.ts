/** Pulls a run in short slices, so that words from the page get through, and tells the page how it goes. */

import type { CoreRun, OwnShape } from "./core";
import type { Ask, Crew } from "./crew";
import type { Control, Insight, News, Place } from "./protocol";
import { SliceLength } from "./slice-length";

/** The least time between two frames. */
const FRAME_MS = 1000 / 30;
/** Over how much running time speed is measured. */
const SPEED_MS = 1000;
/** Snapshots in a whole run, and the share of the running time that they may take. */
const SNAPSHOTS = 40;
const SNAPSHOT_SHARE = 0.05;

type Wanted = "run" | "pause" | "step" | "stop";

export class Pull {
  private wanted: Wanted = "run";
  /** Whether the page has seen the last frame: a slow page is not flooded. */
  private seen = true;
  private wake: () => void = () => undefined;
  private length = new SliceLength();
  private place: Place | null = null;
  private runningMs = 0;
  /** Running time and iteration after each slice of the last second or so. */
  private pace: [number, number][] = [];
  private framed = { at: -Infinity, iteration: -1 };
  private snapped = { iteration: -1, ms: 0 };
  private readonly hired = new Set<Ask>();
  /** Who waits for a look into the run. */
  private curious: ((insight: Insight | null) => void)[] = [];

  constructor(
    private readonly tell: (news: News, transfer?: Transferable[]) => void,
    private readonly crew: Pick<Crew, "ready"> = { ready: [] },
  ) {}

  hear(control: Control["control"]): void {
    if (control === "seen") this.seen = true;
    else if (this.wanted !== "stop") this.wanted = control === "resume" ? "run" : control;
    this.wake();
  }

  /** The run taken apart, between two slices; null where it is over before. */
  insight(): Promise<Insight | null> {
    return new Promise((resolve) => {
      this.curious.push(resolve);
      this.wake();
    });
  }

  /** What waits hears that there is no run any more. */
  end(): void {
    for (const tell of this.curious.splice(0)) tell(null);
  }

  /** Resolves when the run is over or was stopped. `resumed`: the page has the state it begins with. */
  async toTheEnd(run: CoreRun, resumed: boolean): Promise<void> {
    this.lookWhere(run);
    this.pace.push([0, run.iteration]);
    if (resumed) this.snapped.iteration = run.iteration;
    this.snapshot(run);
    // The first one pays for all that is done for the first time.
    this.snapped.ms = 0;
    while (run.iteration < run.iterations && this.wanted !== "stop") {
      this.answer(run);
      if (this.wanted === "pause") {
        await this.rest(run);
      } else {
        await this.slice(run);
        await listen();
      }
    }
    // The page may not have asked for it, but no other frame follows.
    this.frame(run);
    this.snapshot(run);
  }

  /** Waits for a word from the page. Nothing is lost if none ever comes. */
  private async rest(run: CoreRun): Promise<void> {
    this.snapshot(run);
    if (this.seen) this.frame(run);
    if (this.curious.length > 0) return;
    await new Promise<void>((resolve) => (this.wake = resolve));
  }

  private async slice(run: CoreRun): Promise<void> {
    const single = this.wanted === "step";
    if (single) this.wanted = "pause";
    const apart = Math.ceil(run.iterations / SNAPSHOTS);
    const first = run.iteration;
    // A slice ends where a snapshot is due, if there is time for one.
    const most = this.maySnapshot() ? apart - (first % apart) : Infinity;
    this.hire(run);
    const before = performance.now();
    const events = await run.step(single ? 1 : Math.min(this.length.next, most));
    for (const event of events) this.tell({ news: "event", event });
    const now = performance.now();
    const took = Math.max(0.1, now - before);
    this.runningMs += took;
    // Where a device was lost, the run has gone back to what was kept of it.
    if (run.iteration < first) this.pace = [];
    else if (!single) this.length.learn(run.iteration - first, took);
    this.lookWhere(run);
    this.pace.push([this.runningMs, run.iteration]);
    while (this.pace.length > 2 && this.runningMs - this.pace[1]![0] > SPEED_MS) this.pace.shift();
    if (this.seen && now - this.framed.at >= FRAME_MS) this.frame(run);
    if (Math.floor(run.iteration / apart) > Math.floor(this.snapped.iteration / apart) && this.maySnapshot()) this.snapshot(run);
  }

  private answer(run: CoreRun): void {
    if (this.curious.length === 0) return;
    const insight = run.insight();
    for (const tell of this.curious.splice(0)) tell(insight);
  }

  /** Whoever got ready meanwhile joins in. */
  private hire(run: CoreRun): void {
    for (const ask of this.crew.ready) {
      if (this.hired.has(ask)) continue;
      this.hired.add(ask);
      run.hire(ask);
    }
  }

  /** Tells where it is computed, if the page does not know. Elsewhere it goes at another pace. */
  private lookWhere(run: CoreRun): void {
    const place = run.place();
    const { place: told } = this;
    if (told && (["backend", "device", "why", "workers"] as const).every((what) => told[what] === place[what])) return;
    if (told) this.length = new SliceLength();
    this.place = place;
    this.tell({ news: "place", place });
  }

  private maySnapshot(): boolean {
    return this.snapped.ms <= SNAPSHOT_SHARE * this.runningMs;
  }

  private frame(run: CoreRun): void {
    if (run.iteration === this.framed.iteration) return;
    const [fromMs, from] = this.pace[0]!;
    const iterationsPerSecond = this.runningMs > fromMs ? (1000 * (run.iteration - from)) / (this.runningMs - fromMs) : 0;
    const frame = { ...run.frame(), iterationsPerSecond };
    this.framed = { at: performance.now(), iteration: run.iteration };
    this.seen = false;
    this.tell({ news: "frame", frame }, buffers(frame.wire));
  }

  private snapshot(run: CoreRun): void {
    if (run.iteration === this.snapped.iteration) return;
    const before = performance.now();
    const snapshot = run.snapshot();
    this.tell({ news: "snapshot", snapshot }, buffers(snapshot.wire));
    this.snapped = { iteration: run.iteration, ms: this.snapped.ms + performance.now() - before };
  }
}

/** To be given to the page instead of copied. */
function buffers(wire: OwnShape): ArrayBuffer[] {
  return [wire.knots.buffer, wire.controlPoints.buffer];
}

const { port1, port2 } = new MessageChannel();
let heard: () => void = () => undefined;
port1.onmessage = () => heard();
/** Lets waiting messages in; a timer would be slowed down by the browser where the page is not looked at. */
function listen(): Promise<void> {
  return new Promise((resolve) => {
    heard = resolve;
    port2.postMessage(null);
  });
}
