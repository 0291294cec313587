/**
 * The address's fragment, which no server ever sees: `#v=1&job=stroke&w=CODE&preset=fast&seed=3`. `w` carries a whole
 * wire, `job` names the task (the first, where there is none), the keys that a task's `address` knows name what is given,
 * every other key is a setting of the core's table; unknown ones are ignored. Links before `v` held `w` alone.
 */

import type { SettingValues } from "../../engine/protocol";
import type { Task } from "../contract/task";

export const FRAGMENT_VERSION = 1;

type Pairs = Readonly<Record<string, string>>;

export interface Fragment {
  /** Null where the fragment says nothing at all. */
  readonly task: string | null;
  readonly code: string | null;
  /** What names what is given for the task. */
  readonly given: Pairs;
  /** As written; see [`known`]. */
  readonly settings: SettingValues;
  /** Whether a newer page wrote it. */
  readonly newer: boolean;
}

/** What is read here of tasks. */
export type Named = Pick<Task, "name" | "address">;

export function readFragment(hash: string, tasks: readonly Named[]): Fragment {
  const pairs = new URLSearchParams(hash.replace(/^#/, ""));
  const version = Number(pairs.get("v") ?? FRAGMENT_VERSION);
  const task = tasks.find(({ name }) => name === pairs.get("job")) ?? (pairs.size > 0 ? tasks[0]! : null);
  const ofTasks = tasks.flatMap(({ address }) => address?.keys ?? []);
  const [given, settings]: Record<string, string>[] = [{}, {}];
  for (const [name, value] of pairs) {
    if (task?.address?.keys.includes(name)) given![name] = value;
    else if (!["v", "w", "job", ...ofTasks].includes(name)) settings![name] = value;
  }
  return { task: task?.name ?? null, code: pairs.get("w"), given: given!, settings: settings!, newer: !(version <= FRAGMENT_VERSION) };
}

/** Empty where there is nothing to say. `given` names what is given for the task. */
export function writeFragment(task: string, code: string | null, settings: SettingValues, given: Pairs, tasks: readonly Named[]): string {
  const first = `${task === tasks[0]!.name ? "" : `&job=${task}`}${written(given)}`;
  if (!first && code === null && Object.keys(settings).length === 0) return "";
  return `#v=${FRAGMENT_VERSION}${first}${code === null ? "" : `&w=${code}`}${written(settings)}`;
}

function written(pairs: Pairs): string {
  return Object.entries(pairs)
    .map(([name, value]) => `&${encodeURIComponent(name)}=${encodeURIComponent(value)}`)
    .join("");
}
