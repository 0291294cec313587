/** A bench for tests: the real state of some tasks, nothing kept, and an engine of the test's own. */

import { Store } from "../common/store";
import type { Doc } from "../keeping/document";
import type { Bench } from "./bench";
import { firstState, NO_RUN, stateOf, type BaseState, type StudioState, type TaskState } from "./state";

export interface TestBench extends Bench {
  /** Of the edits, in order. */
  readonly labels: string[];
  /** Whether a run is under way, of a task that nobody looks at. */
  run(under: boolean): void;
  change(change: Partial<Doc>): void;
}

export function testBench(tasks: readonly TaskState[], engine: object, value: (name: string) => string = () => ""): TestBench {
  const store = new Store<BaseState, StudioState>(firstState(tasks), (base) => stateOf(base, tasks));
  const labels: string[] = [];
  const change = (changed: Partial<Doc>): void => store.set({ doc: { ...store.get().doc, ...changed } });
  const busy = (): boolean => store.get().phase !== "idle";
  return {
    store,
    labels,
    change,
    engine: { listen: () => undefined, cancel: () => undefined, ...engine } as unknown as Bench["engine"],
    project: { replace: change, amend: (how: (doc: Doc) => Doc) => change(how(store.get().doc)), ...KEEPS_NOTHING } as unknown as Bench["project"],
    settings: { value, set: () => undefined },
    get doc() {
      return store.get().doc;
    },
    get busy() {
      return busy();
    },
    edit(label, changed) {
      if (busy()) return;
      labels.push(label);
      change(changed);
    },
    pass({ name }, changed) {
      const { passing } = store.get();
      store.set({ passing: { ...passing, [name]: { ...passing[name], ...changed } } });
    },
    run: (under) => store.set({ run: { ...NO_RUN, phase: under ? "running" : "idle" } }),
    opens: async () => false,
    warn: (problem) => store.set({ problem }),
  };
}

const KEEPS_NOTHING = { beginRun: () => undefined, addSnapshot: () => undefined, endRun: () => undefined };
