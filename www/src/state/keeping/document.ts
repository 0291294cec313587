/** What a person makes on the page: everything that undo goes over and that is kept. */

import { JOBS, type Finished, type Job, type SettingValues } from "../../engine/protocol";
import type { Paper } from "../../tasks/multiview/drawing/paper";
import type { Track } from "./track";
import type { Subject } from "../../tasks/stroke/given";
import type { Cover } from "../../tasks/fill/given";

export { JOBS, type Job } from "../../engine/protocol";

export const SLOTS = ["front", "side", "top"] as const;
export type Slot = (typeof SLOTS)[number];

export interface Doc {
  /** The one that is looked at. */
  readonly job: Job;
  /** Given for the first job. */
  readonly papers: Readonly<Record<Slot, Paper | null>>;
  /** Given for the second. */
  readonly subject: Subject | null;
  /** Given for the third. */
  readonly cover: Cover | null;
  readonly desks: Readonly<Record<Job, Desk>>;
}

/** What belongs to each job besides what is given. */
export interface Desk {
  /** What differs from the preset, and the preset itself if it is not `best`. */
  readonly settings: SettingValues;
  /** The wire on the stage while nothing runs. */
  readonly made: Made | null;
  /** The same run with loose strokes, to compare `made` with. */
  readonly loose: Made | null;
}

/** A wire with where it is from. */
export interface Made {
  readonly finished: Finished;
  readonly source: "example" | "link" | "file" | "run";
  /** The run it came from; null for a wire from elsewhere. */
  readonly track: Track | null;
  /** Whether the run was stopped before its end. */
  readonly stopped: boolean;
  /** Seconds the run took; 0 for a wire from elsewhere. */
  readonly seconds: number;
}

export const EMPTY_DESK: Desk = { settings: {}, made: null, loose: null };

export const BLANK: Doc = {
  job: "multiview",
  papers: { front: null, side: null, top: null },
  subject: null,
  cover: null,
  desks: { multiview: EMPTY_DESK, stroke: EMPTY_DESK, fill: EMPTY_DESK },
};

/** What is given for the job that is looked at. */
export function givenOf({ job, papers, subject, cover }: Doc): unknown {
  return { multiview: papers, stroke: subject, fill: cover }[job];
}

/** Of the job that is looked at. */
export const deskOf = (doc: Doc): Desk => doc.desks[doc.job];

export function withDesk(doc: Doc, job: Job, change: Partial<Desk>): Pick<Doc, "desks"> {
  return { desks: { ...doc.desks, [job]: { ...doc.desks[job], ...change } } };
}

/** Whether nothing was ever given or made for a job. */
export function untouched({ papers, subject, cover, desks }: Doc, job: Job): boolean {
  const given = { multiview: SLOTS.some((slot) => papers[slot] !== null), stroke: subject !== null, fill: cover !== null };
  return !given[job] && desks[job].made === null;
}

/** The job in which two documents differ; null where neither or both do. */
export function differingJob(a: Doc, b: Doc): Job | null {
  const given = { multiview: a.papers !== b.papers, stroke: a.subject !== b.subject, fill: a.cover !== b.cover };
  const differing = JOBS.filter((job) => given[job] || a.desks[job] !== b.desks[job]);
  return differing.length === 1 ? differing[0]! : null;
}
