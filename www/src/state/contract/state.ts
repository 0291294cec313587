/** Everything the page shows, in one value. */

import type { WireShape } from "#sculpture/scene/shape";
import type { Backend, Place, SettingsTable, SettingsTables, Target, View } from "../../engine/protocol";
import { NO_LOCKS, type Locks } from "../common/locks";
import { remembered } from "../common/remember";
import type { Store } from "../common/store";
import { deskOf, type Made } from "../keeping/document";
import type { ProjectState } from "../keeping/project";
import { variantOf, type Track, type Variant } from "../keeping/track";
import type { LessonState } from "../lesson/lesson";

/** What of a task the state follows from. */
export interface TaskState<Given = unknown, Passing extends object = object> {
  /** The core's word for it. */
  readonly name: string;
  /** What is given where nothing is. */
  readonly blank: Given;
  /** What is passing about it where nothing is. */
  readonly quiet: Passing;
  /** Whether the wire that is there no longer is what would be made: it would go another way, or look otherwise. */
  stale?(passing: Passing): "way" | "look" | null;
  /** What the stage shows where `made` is the wire that is there. */
  wire?(passing: Passing, made: WireShape | null): WireShape | null;
}

/** What is passing about something that people give. */
export interface PadState {
  readonly busy: boolean;
  /** What was done to the last picture, or empty. */
  readonly note: string;
  /** What was wrong with the last picture that was given; the one before is kept. */
  readonly problem: string;
}

export const QUIET: PadState = { busy: false, note: "", problem: "" };

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

/** What there is to see beside the wire: of a run, or of a wire that was made. */
export interface Seen {
  /** The run under way, or the one that the wire on the stage came from. */
  readonly track: Track | null;
  /** The snapshot that is looked at, by its index; null is the newest wire. */
  readonly looking: number | null;
  readonly views: readonly View[];
  readonly targets: readonly Target[];
  /** What a person should know about what was given to this run. */
  readonly notes: readonly string[];
}

export const NOTHING_TO_SEE: Seen = { track: null, looking: null, views: [], targets: [], notes: [] };

/** A run under way, or the last one. */
export interface RunState extends Seen {
  readonly phase: Phase;
  readonly progress: Progress;
}

export const NO_RUN: RunState = { ...NOTHING_TO_SEE, phase: "idle", progress: READY };

/** Where runs are computed. */
export interface Whereabouts {
  readonly asked: Backend;
  /** Whether it is the address that asks, and not the setting. */
  readonly byAddress: boolean;
  /** Of the run under way, or of the next one. Null until the core has said. */
  readonly place: Place | null;
  /** Why the graphics card that was asked for is not to be had; runs then take the processor. Empty if it is. */
  readonly refusal: string;
}

export const ANYWHERE: Whereabouts = { asked: "auto", byAddress: false, place: null, refusal: "" };

/** What a run does while its tab is hidden. */
export const WHEN_HIDDEN = ["go", "pause"] as const;
export type WhenHidden = (typeof WHEN_HIDDEN)[number];

/** What may lie open beside the stage: the optimiser as it works, and the wire to be taken in hand. */
export const TOOLS = ["glass", "hands"] as const;
export type Tool = (typeof TOOLS)[number];

/** A wire that the stage shows ahead of the document. */
export interface Ahead {
  readonly task: string;
  /** Null until it has been read. */
  readonly wire: WireShape | null;
  readonly views: readonly View[];
  /** Whether it is on its way into the document; where the engine cannot open it, it is shown all the same. */
  readonly coming: boolean;
}

/** What the parts of the page set. */
export interface BaseState extends ProjectState {
  readonly run: RunState;
  /** What is passing about what is given, by task. */
  readonly passing: Readonly<Record<string, object>>;
  /** A finished run that is looked back at, as long as its wire is the one that is there. */
  readonly lookingBack: { readonly made: Made; readonly index: number } | null;
  /** A wire of a link or an example that is not in the document. */
  readonly ahead: Ahead | null;
  /** What the examples came with: while it is there as it came, a wire that is an example is of it. */
  readonly examples: Readonly<Record<string, unknown>>;
  /** The core's settings; null until it has told them. */
  readonly tables: SettingsTables | null;
  /** A run that a reload or a crash cut off and that can go on. */
  readonly unfinished: { readonly task: string; readonly iteration: number; readonly iterations: number } | null;
  readonly where: Whereabouts;
  readonly whenHidden: WhenHidden;
  /** Null while none is open. */
  readonly tool: Tool | null;
  /** Null outside of lessons. */
  readonly lesson: LessonState | null;
  /** What the lesson, or a link for a class, keeps from being used. */
  readonly locks: Locks;
  readonly problem: string;
  /** What a person should know though nothing is wrong, until they close it. */
  readonly notices: readonly string[];
  /** Shows the new version of the page that is ready; null where none is. */
  readonly loadNew: (() => void) | null;
  /** A short word about what was just done, such as "Link copied". */
  readonly said: string;
}

/** And what follows from it. */
export interface StudioState extends BaseState, Seen {
  readonly phase: Phase;
  readonly progress: Progress;
  /** The task of the run under way, which need not be the one that is looked at. */
  readonly running: string | null;
  /** In what the run under way differs from that of the wire that it is laid beside; null where it is laid beside none. */
  readonly comparing: Variant | null;
  /** Whether the stage shows how a wire would run, and not the one that was made. */
  readonly planned: boolean;
  /** Whether a wire on the same way would now be bent or thickened in another manner. */
  readonly restyled: boolean;
}

export type StudioStore = Store<BaseState, StudioState>;

export function firstState(tasks: readonly TaskState[]): BaseState {
  return {
    doc: { task: tasks[0]!.name, given: by(tasks, ({ blank }) => blank), desks: {} },
    undo: null,
    redo: null,
    keeping: "here",
    run: NO_RUN,
    passing: by(tasks, ({ quiet }) => quiet),
    lookingBack: null,
    ahead: null,
    examples: {},
    tables: null,
    unfinished: null,
    where: ANYWHERE,
    whenHidden: WHEN_HIDDEN.find((choice) => choice === remembered("hidden")) ?? "go",
    tool: null,
    lesson: null,
    locks: NO_LOCKS,
    problem: "",
    notices: [],
    loadNew: null,
    said: "",
  };
}

export function by<Task extends Pick<TaskState, "name">, T>(tasks: readonly Task[], value: (task: Task) => T): Readonly<Record<string, T>> {
  return Object.fromEntries(tasks.map((task) => [task.name, value(task)]));
}

/** What follows from the state of the parts. */
export function stateOf(base: BaseState, tasks: readonly TaskState[]): StudioState {
  const { run, doc, passing, ahead, lookingBack } = base;
  const { phase, progress } = run;
  const running = phase === "idle" ? null : (run.track?.task ?? null);
  const { made } = deskOf(doc);
  const stale = tasks.find(({ name }) => name === doc.task)?.stale?.(passing[doc.task]!) ?? null;
  const follows = { phase, progress, running, comparing: running === null ? null : variantOf(run.track), planned: stale === "way", restyled: stale === "look" };
  let seen: Seen = NOTHING_TO_SEE;
  if (running === doc.task) {
    const { track, looking, views, targets, notes } = run;
    seen = { track, looking, views, targets, notes };
  } else if (ahead?.task === doc.task) {
    seen = { ...NOTHING_TO_SEE, views: ahead.views };
  } else if (made) {
    const { views, targets } = made.finished;
    seen = { ...NOTHING_TO_SEE, views, targets, track: made.track, looking: lookingBack?.made === made ? lookingBack.index : null };
  }
  return { ...base, ...follows, ...seen };
}

/** The wire for the stage, where `forming` is the run's; undefined while that is to be read: what is there stays. */
export function wireFor(state: StudioState, tasks: readonly TaskState[], forming: WireShape | null): WireShape | null | undefined {
  const { doc, running, ahead, looking, track, passing } = state;
  if (running === doc.task && forming) return forming;
  if (looking !== null && running !== doc.task) return track?.snapshots[looking]?.wire ?? null;
  const isAhead = ahead?.task === doc.task;
  if (isAhead && !ahead.wire) return undefined;
  const made = isAhead ? ahead.wire : (deskOf(doc).made?.finished.wire ?? null);
  const task = tasks.find(({ name }) => name === doc.task);
  return task?.wire ? task.wire(passing[doc.task]!, made) : made;
}

/** What is given for a task. */
export function givenFor<Given>({ doc }: Pick<BaseState, "doc">, { name }: Pick<TaskState<Given>, "name" | "blank">): Given {
  return doc.given[name] as Given;
}

/** What is passing about what is given for a task. */
export function passingOf<Passing extends object>({ passing }: Pick<BaseState, "passing">, { name }: Pick<TaskState<unknown, Passing>, "name" | "quiet">): Passing {
  return passing[name] as Passing;
}

/** Of the task that is looked at. */
export const tableOf = ({ tables, doc }: Pick<StudioState, "tables" | "doc">): SettingsTable | null => tables?.[doc.task] ?? null;

/** The wire on the stage is the example, and what it was made of is there as it came. */
export function showsExample({ doc, examples }: Pick<StudioState, "doc" | "examples">): boolean {
  return deskOf(doc).made?.source === "example" && examples[doc.task] === doc.given[doc.task];
}

/** Once no run is under way. */
export function whenIdle(store: StudioStore): Promise<void> {
  return new Promise((resolve) => {
    const stop = store.follow(({ phase }) => {
      if (phase !== "idle") return;
      setTimeout(() => {
        stop();
        resolve();
      });
    });
  });
}
