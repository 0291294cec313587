/** One run at a time: what the worker tells of it becomes a track, progress, and wires to look at. */

import { Cancelled, type EngineClient } from "../../engine/client";
import type { WireShape } from "../../embed/shape";
import type { Backend, Drawing, Finished, Frame, Job, News, Place, Snapshot, Target, View, Work } from "../../engine/protocol";
import { drawingOf } from "../../tasks/multiview/drawing/paper";
import { pixelsOf } from "../picture/picture";
import { nextTask } from "../common/next-turn";
import { maskOf } from "../../tasks/stroke/given";
import { coveredOf } from "../../tasks/fill/given";
import { withEvent, withFrame, withSnapshot, type Given, type Track } from "../keeping/track";
import { asSentence } from "../common/words";

export type Phase = "idle" | "preparing" | "running" | "paused" | "finishing";

export interface Progress {
  readonly words: string;
  /** 0 to 1. */
  readonly share: number;
  readonly secondsLeft: number | null;
  readonly iteration: number;
  readonly iterations: number;
  readonly iterationsPerSecond: number;
}

export const READY: Progress = { words: "", share: 0, secondsLeft: null, iteration: 0, iterations: 0, iterationsPerSecond: 0 };

/** What there is to see of a run, or of a wire that was made. */
export interface Scene {
  /** The run under way, or the one that the wire on the stage came from. */
  readonly track: Track | null;
  /** The snapshot that is looked at, by its index; null is the newest wire. */
  readonly looking: number | null;
  readonly views: readonly View[];
  readonly targets: readonly Target[];
  /** What a person should know about the drawings of this run. */
  readonly notes: readonly string[];
}

export interface RunState extends Scene {
  readonly phase: Phase;
  readonly progress: Progress;
}

export const NOTHING_TO_SEE: Scene = { track: null, looking: null, views: [], targets: [], notes: [] };

export interface RunHooks {
  get(): RunState;
  set(change: Partial<RunState>): void;
  /** A wire to show while it forms. */
  wire(wire: WireShape): void;
  snapshot(snapshot: Snapshot): void;
  place(place: Place): void;
}

const LOOKING: Readonly<Record<Job, string>> = {
  multiview: "Looking at the drawings",
  stroke: "Looking at the picture",
  fill: "Looking at the shape",
};

/** Numbers that change more often than this cannot be read, and cost a slow page its breath. */
const NUMBERS_MS = 100;

export class Runner {
  private newest: WireShape | null = null;
  /** Frames whose numbers have not been told yet, and when that was last done. */
  private untold: Frame[] = [];
  private toldMs = -Infinity;
  /** Ends a run that the engine has not heard of yet. */
  private callOff: () => void = () => undefined;

  constructor(
    private readonly engine: Pick<EngineClient, "call" | "control" | "cancel">,
    private readonly hooks: RunHooks,
  ) {}

  /**
   * Runs the track's work from its last snapshot on, or from the start, where `backend` says. Null if it was called off.
   * @throws what the engine says; the track so far stays in the state.
   */
  async run(track: Track, backend: Promise<Backend>): Promise<Finished | null> {
    const from = track.snapshots.at(-1)?.checkpoint ?? null;
    const words = from ? "Picking up the wire" : LOOKING[track.given.job];
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
      const work = await workOf(track.given);
      const decided = await Promise.race([calledOff, backend]);
      if (off || !decided) return null;
      return await this.engine.call("run", { work, settings: { ...track.settings, backend: decided }, from });
    } catch (error) {
      if (error instanceof Cancelled) return null;
      throw error;
    } finally {
      this.hooks.set({ phase: "idle", progress: READY });
    }
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
        this.hooks.set({ progress: { ...progress, words: news.words, share: news.share, secondsLeft: null } });
        break;
      case "note":
        this.hooks.set({ notes: [...notes, asSentence(news.words)] });
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
        // After the browser has drawn what came of it (or at once in a hidden tab, where it draws nothing).
        afterDrawing(() => this.engine.control("seen"));
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
        words: "Bending the wire into shape",
        share: iteration / Math.max(1, iterations),
        secondsLeft: iterationsPerSecond > 0 ? Math.ceil((iterations - iteration) / iterationsPerSecond) : null,
        iteration,
        iterations,
        iterationsPerSecond,
      },
    });
  }
}

/** What was given, as the engine wants it, a task for each part of it. */
async function workOf(given: Given): Promise<Work> {
  if (given.job === "stroke") {
    const { picture, depth } = given.subject;
    const mask = maskOf(given.subject);
    return { job: "stroke", subject: { picture: await pixelsOf(picture), mask, depth: depth && (await pixelsOf(depth)) } };
  }
  if (given.job === "fill") return { job: "fill", covered: await coveredOf(given.cover) };
  const drawings: Drawing[] = [];
  for (const { slot, paper } of given.sheets) {
    await nextTask();
    drawings.push(drawingOf(paper, slot));
  }
  return { job: "multiview", drawings };
}

/** Where drawing takes long, as long again is left for everything else. */
function afterDrawing(action: () => void): void {
  if (document.hidden) {
    action();
    return;
  }
  const askedMs = performance.now();
  requestAnimationFrame(() =>
    setTimeout(() => {
      const tookMs = performance.now() - askedMs;
      if (tookMs > 50) setTimeout(action, Math.min(1000, tookMs));
      else action();
    }),
  );
}
