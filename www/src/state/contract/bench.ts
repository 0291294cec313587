/** What each part of the studio works with. */

import type { EngineClient } from "../../engine/client";
import type { Doc } from "../keeping/document";
import type { Project } from "../keeping/project";
import type { StudioStore, TaskState } from "./state";

/** The settings of the task that is looked at. */
export interface Settings {
  /** The value a run would take. */
  value(name: string): string;
  set(name: string, value: string): void;
}

export interface Bench {
  readonly engine: EngineClient;
  readonly store: StudioStore;
  readonly project: Project;
  readonly settings: Settings;
  readonly doc: Doc;
  /** Whether a run is under way. */
  readonly busy: boolean;
  /** A step that undo takes back; waits for no run, but is left out during one. */
  edit(label: string, change: Partial<Doc>, kind?: string): void;
  /** A task's passing state changes. */
  pass<Passing extends object>(task: Pick<TaskState<unknown, Passing>, "name" | "quiet">, change: Partial<Passing>): void;
  /** Opens a file that carries a wire; false if it is any other file. */
  opens(file: Blob, name: string): Promise<boolean>;
  warn(problem: string): void;
}

