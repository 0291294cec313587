/** One run at a time: what the worker tells of it becomes a track, progress, and wires to look at. */

import { msg } from "@lit/localize";
import { Cancelled, type EngineClient } from "../../engine/client";
import type { WireShape } from "#sculpture/scene/shape";
import type { Backend, Finished, Frame, News, Place, Snapshot } from "../../engine/protocol";
import { asSentence } from "../../words/sentences";
import { told } from "../../words/told";
import { READY, type RunState } from "../contract/state";
import type { Task } from "../contract/task";
import { withEvent, withFrame, withSnapshot, type Track } from "../keeping/track";

export interface RunHooks {
  get(): RunState;
  set(change: Partial<RunState>): void;
  /** A wire to show while it forms. */
  wire(wire: WireShape): void;
  snapshot(snapshot: Snapshot): void;
  place(place: Place): void;
  /** What stays to be read when the run is over. */
  notice(words: string): void;
}

/** Numbers that change more often than this cannot be read, and cost a slow page its breath. */
const NUMBERS_MS = 200;

export class Runner {
  private newest: WireShape | null = null;
  /** Frames whose numbers have not been told yet, and when that was last done. */
  private untold: Frame[] = [];
  private toldMs = -Infinity;
  /** Ends a run that the engine has not heard of yet. */
  private callOff: () => void = () => undefined;

  constructor(
    private readonly engine: Pick<EngineClient, "callEndable" | "control" | "cancel">,
    private readonly hooks: RunHooks,
  ) {}

  /**
   * Runs the track's work from its last snapshot on, or from the start, where `backend` says. Null if it was called off.
   * The state stays that of a run until `rest`.
   * @throws what the engine says; the track so far stays in the state.
   */
  async run(task: Pick<Task, "words" | "work">, track: Track, backend: Promise<Backend>): Promise<Finished | null> {
    const from = track.snapshots.at(-1)?.checkpoint ?? null;
    const words = from ? msg("Picking up the wire") : task.words.looking;
    this.newest = null;
    this.untold = [];
    let off = false;
    const calledOff = new Promise<null>((resolve) => {
      this.callOff = () => {
        off = true;
        resolve(null);
      };
    });
    this.hooks.set({ phase: "preparing", progress: { ...READY, words }, track, looking: null, notes: [] });
    try {
      const work = await task.work(track.given, track.guide ?? null);
      const decided = await Promise.race([calledOff, backend]);
      if (off || !decided) return null;
      return await this.engine.callEndable("run", { task: track.task, work, settings: { ...track.settings, backend: decided }, from, first: track.snapshots[0]?.wire ?? null, guide: track.guide ?? null });
    } catch (error) {
      if (error instanceof Cancelled) return null;
      throw error;
    }
  }

  /** What came of the run has been seen to: there is none any more. */
  rest(): void {
    this.hooks.set({ phase: "idle", progress: READY });
  }

  /** Pauses, or goes on. */
  pause(): void {
    const { phase } = this.hooks.get();
    if (phase === "running") {
      this.hooks.set({ phase: "paused" });
      this.engine.control("pause");
    } else if (phase === "paused") {
      this.lookAt(null);
      this.hooks.set({ phase: "running" });
      this.engine.control("resume");
    }
  }

  /** One iteration, then a pause. */
  step(): void {
    const { phase } = this.hooks.get();
    if (phase !== "running" && phase !== "paused") return;
    this.lookAt(null);
    this.hooks.set({ phase: "paused" });
    this.engine.control("step");
  }

  /** Ends the run with the best wire so far; while there is none yet it simply ends. */
  stop(): void {
    const { phase } = this.hooks.get();
    if (phase === "preparing") {
      this.cancel();
    } else if (phase === "running" || phase === "paused") {
      this.hooks.set({ phase: "finishing" });
      this.engine.control("stop");
    }
  }

  /** Ends the run at once and without a wire. */
  cancel(): void {
    if (this.hooks.get().phase === "idle") return;
    this.callOff();
    this.engine.cancel();
  }

  /** Shows a snapshot of the run; a running one pauses for it. Null is the newest. */
  lookAt(index: number | null): void {
    const { phase, track, looking } = this.hooks.get();
    if (index === looking) return;
    if (phase === "running" && index !== null) this.pause();
    this.hooks.set({ looking: index });
    const wire = index === null ? this.newest : track?.snapshots[index]?.wire;
    if (wire) this.hooks.wire(wire);
  }

  hear(news: News): void {
    const { phase, track, notes, progress } = this.hooks.get();
    // The last words of a run that was called off.
    if (phase === "idle" || !track) return;
    switch (news.news) {
      case "progress":
        this.hooks.set({ progress: { ...progress, words: told(news.words), share: news.share, secondsLeft: null } });
        break;
      case "note":
        this.hooks.set({ notes: [...notes, asSentence(news.words)] });
        break;
      case "notice":
        this.hooks.notice(asSentence(news.words));
        break;
      case "place":
        this.hooks.place(news.place);
        break;
      case "targets":
        this.hooks.set({ targets: news.targets, views: news.targets.map(({ view }) => view), phase: "running" });
        break;
      case "event":
        this.hooks.set({ track: withEvent(track, news.event) });
        break;
      case "snapshot":
        this.hooks.set({ track: withSnapshot(track, news.snapshot) });
        this.hooks.snapshot(news.snapshot);
        break;
      case "frame":
        this.hearFrame(news.frame, track);
        // After what came of it (or at once in a hidden tab, where timers are slowed down).
        afterTurn(() => this.engine.control("seen"));
        break;
    }
  }

  private hearFrame(frame: Frame, track: Track): void {
    const { iteration, iterations, iterationsPerSecond } = frame;
    this.newest = frame.wire;
    const { looking, phase } = this.hooks.get();
    if (looking === null) this.hooks.wire(frame.wire);
    this.untold.push(frame);
    const now = performance.now();
    if (phase === "running" && iteration < iterations && now - this.toldMs < NUMBERS_MS) return;
    this.toldMs = now;
    const told = this.untold.splice(0);
    this.hooks.set({
      track: told.reduce(withFrame, track),
      progress: {
        words: msg("Bending the wire into shape"),
        share: iteration / Math.max(1, iterations),
        secondsLeft: iterationsPerSecond > 0 ? Math.ceil((iterations - iteration) / iterationsPerSecond) : null,
        iteration,
        iterations,
        iterationsPerSecond,
      },
    });
  }
}

/** Where that takes long, since the page has much to do, as long again is left for everything else. */
function afterTurn(action: () => void): void {
  if (document.hidden) {
    action();
    return;
  }
  const askedMs = performance.now();
  // Not with the next picture of the page: to ask for that makes the browser draw one.
  setTimeout(() => {
    const tookMs = performance.now() - askedMs;
    if (tookMs > 50) setTimeout(action, Math.min(1000, tookMs));
    else action();
  });
}
