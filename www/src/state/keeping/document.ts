/** What a person makes on the page: everything that undo goes over and that is kept. */

import type { Finished, Guide, SettingValues } from "../../engine/protocol";
import type { Track } from "./track";

export interface Doc {
  /** The one that is looked at, by its name. */
  readonly task: string;
  /** What was given, by task; only the task knows what it is. */
  readonly given: Readonly<Record<string, unknown>>;
  /** By task; where there is none, it is empty. */
  readonly desks: Readonly<Record<string, Desk>>;
}

/** What belongs to each task besides what is given. */
export interface Desk {
  /** What differs from the preset, and the preset itself if it is not `best`. */
  readonly settings: SettingValues;
  /** Words that guide its runs beside the pictures; null where none do. */
  readonly guide: Guide | null;
  /** The wire on the stage while nothing runs. */
  readonly made: Made | null;
  /** The same run but for one thing, loose strokes to begin with, to compare `made` with. */
  readonly loose: Made | null;
}

/** A wire with where it is from. */
export interface Made {
  readonly finished: Finished;
  readonly source: "example" | "link" | "file" | "run" | "hand";
  /** Whether the file that it came from brought what it was made of. */
  readonly carried?: boolean;
  /** The run it came from; null for a wire from elsewhere. */
  readonly track: Track | null;
  /** Whether the run was stopped before its end. */
  readonly stopped: boolean;
  /** Seconds the run took; 0 for a wire from elsewhere. */
  readonly seconds: number;
}

export const EMPTY_DESK: Desk = { settings: {}, guide: null, made: null, loose: null };

/** Of the task that is looked at, or of another. */
export const deskOf = (doc: Doc, task = doc.task): Desk => doc.desks[task] ?? EMPTY_DESK;

/** The change of a document that changes a task's desk. */
export function withDesk(doc: Doc, task: string, change: Partial<Desk>): Pick<Doc, "desks"> {
  return { desks: { ...doc.desks, [task]: { ...deskOf(doc, task), ...change } } };
}

/** The change of a document that gives a task something else. */
export function withGiven(doc: Doc, task: string, given: unknown): Pick<Doc, "given"> {
  return { given: { ...doc.given, [task]: given } };
}

/** The task in which two documents differ; null where none or several do. */
export function differingTask(a: Doc, b: Doc): string | null {
  const tasks = new Set([a, b].flatMap(({ given, desks }) => [...Object.keys(given), ...Object.keys(desks)]));
  const differing = [...tasks].filter((task) => a.given[task] !== b.given[task] || deskOf(a, task) !== deskOf(b, task));
  return differing.length === 1 ? differing[0]! : null;
}
