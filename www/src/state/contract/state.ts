/** Everything the page shows, in one value; and what the studio's parts share. */

import type { EngineClient } from "../../engine/client";
import type { Job, SettingsTable, SettingsTables } from "../../engine/protocol";
import { givenOf, type Doc, type Slot } from "../keeping/document";
import { NO_PROJECT, type Project, type ProjectState } from "../keeping/project";
import { remembered } from "../common/remember";
import { WHEN_HIDDEN, type WhenHidden } from "../run/hidden-tab";
import { ANYWHERE, type Whereabouts } from "../run/placer";
import { NO_COVER, type CoverState } from "../../tasks/fill/coverer";
import { NO_PREVIEW, type PreviewState } from "../../tasks/multiview/previewer";
import { NOTHING_TO_SEE, READY, type RunState } from "../run/runner";
import type { Store } from "../common/store";

/** What is passing about a pad, about the picture of a stroke, or about a shape. */
export interface PadState {
  readonly busy: boolean;
  /** What was done to the last picture, or empty. */
  readonly note: string;
  /** What was wrong with the last picture that was given; the one before is kept. */
  readonly problem: string;
}

export const QUIET: PadState = { busy: false, note: "", problem: "" };

export interface StudioState extends ProjectState, RunState, PreviewState, CoverState {
  readonly pads: Readonly<Record<Slot, PadState>>;
  readonly sitting: PadState;
  readonly dressing: PadState;
  /** Whether the stage shows how a wire would run, and not the one that was made. */
  readonly planned: boolean;
  /** Whether a wire on the same way would now be bent or thickened in another manner. */
  readonly restyled: boolean;
  /** What the examples came with: while it is there as it came, a wire that is an example is of it. */
  readonly examples: Readonly<Record<Job, unknown>>;
  /** The core's settings; null until it has told them. */
  readonly tables: SettingsTables | null;
  /** The job of the run under way, which need not be the one that is looked at. */
  readonly running: Job | null;
  /** Whether loose strokes are being laid, to compare. */
  readonly comparing: boolean;
  /** A run that a reload or a crash cut off and that can go on. */
  readonly unfinished: { readonly job: Job; readonly iteration: number; readonly iterations: number } | null;
  readonly where: Whereabouts;
  readonly whenHidden: WhenHidden;
  readonly problem: string;
  /** What a person should know though nothing is wrong, until they close it. */
  readonly notices: readonly string[];
  /** A short word about what was just done, such as "Link copied". */
  readonly said: string;
}

export const AT_FIRST: StudioState = {
  ...NO_PROJECT,
  ...NO_PREVIEW,
  ...NO_COVER,
  ...NOTHING_TO_SEE,
  pads: { front: QUIET, side: QUIET, top: QUIET },
  sitting: QUIET,
  dressing: QUIET,
  planned: false,
  restyled: false,
  examples: { multiview: null, stroke: null, fill: null },
  phase: "idle",
  progress: READY,
  tables: null,
  running: null,
  comparing: false,
  unfinished: null,
  where: ANYWHERE,
  whenHidden: WHEN_HIDDEN.find((choice) => choice === remembered("hidden")) ?? "go",
  problem: "",
  notices: [],
  said: "",
};

/** Of the job that is looked at. */
export const tableOf = ({ tables, doc }: Pick<StudioState, "tables" | "doc">): SettingsTable | null => tables?.[doc.job] ?? null;

/** The wire on the stage is the example, and what it was made of is there as it came. */
export function showsExample({ doc, examples }: Pick<StudioState, "doc" | "examples">): boolean {
  return doc.desks[doc.job].made?.source === "example" && examples[doc.job] === givenOf(doc);
}

/** Once no run is under way. */
export function whenIdle(store: Store<StudioState>): Promise<void> {
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

/** What each part of the studio works with. */
export interface Bench {
  readonly engine: EngineClient;
  readonly store: Store<StudioState>;
  readonly project: Project;
  readonly doc: Doc;
  /** Whether a run is under way. */
  readonly busy: boolean;
  /** A step that undo takes back; waits for no run, but is left out during one. */
  edit(label: string, change: Partial<Doc>, kind?: string): void;
  warn(problem: string): void;
}
