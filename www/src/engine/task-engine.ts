/** A task's end of the worker: what it begins runs of, and what else the page may ask of it. */

import type { CoreRun } from "./core";
import type { CallName, Calls, News, SettingValues } from "./protocol";

/** What a run says while it starts: how far it is, and what a person should know about what was given. */
export interface Ears {
  tell(words: string, share: number): void;
  note(words: string): void;
}

export type Handlers = { readonly [K in CallName]?: (given: Calls[K]["arguments"], tell: (news: News) => void) => Promise<Calls[K]["answer"]> };

/** `Work` is what the page's end of the task makes of what is given. */
export interface TaskEngine<Work = unknown> {
  readonly task: string;
  /** Answers to the task's own calls. */
  readonly handlers: Handlers;
  /** Starts a run, or resumes it from a checkpoint. */
  start(work: Work, settings: SettingValues, from: Uint8Array<ArrayBuffer> | null, ears: Ears): Promise<CoreRun>;
}
