/** One thing that people can do: what it is called, by which keys, when it can be done, and what it does. */

import type { Bench } from "../contract/bench";
import type { StudioState } from "../contract/state";
import type { Project } from "../keeping/project";
import type { Opener } from "../opening/opener";
import type { Runs } from "../run/runs";

/** What actions work with. */
export interface Parts {
  readonly bench: Bench;
  readonly project: Project;
  readonly runs: Runs;
  readonly opener: Opener;
}

/** `More` is what it needs to be told besides; `On`, what it works with. */
export interface Action<More extends readonly unknown[] = [], On = Parts> {
  readonly id: string;
  /** On its button, or for those who cannot see the icon; it may say more of what it would do now. */
  readonly label: string;
  readonly says?: (state: StudioState) => string;
  /** As help shows them: a letter, or with Ctrl (or Command), or with Shift before it. */
  readonly keys?: readonly string[];
  /** In the list of keys; without it another action with the same key speaks for it. */
  readonly help?: string;
  /** What it is locked by, besides its own `id`. */
  readonly part?: string;
  /** Whether its keys also count where something has keys of its own. */
  readonly everywhere?: boolean;
  /** Always, where nothing is said. */
  readonly can?: (state: StudioState) => boolean;
  readonly act: (on: On, ...more: More) => unknown;
}
