import { beforeEach, expect, it } from "vitest";
import type { WireShape } from "#sculpture/scene/shape";
import { Store } from "../common/store";
import type { Made } from "../keeping/document";
import { freshTrack } from "../keeping/track";
import { firstState, NO_RUN, stateOf, wireFor, type BaseState, type StudioState, type TaskState } from "./state";

const wire = (name: string): WireShape => ({ name, closed: false, knots: [], controlPoints: [] }) as WireShape;
const [MADE, OLD, FORMING, LINKED, PLANNED] = ["made", "old", "forming", "linked", "planned"].map(wire) as [WireShape, WireShape, WireShape, WireShape, WireShape];

/** The second shows a plan instead of a wire that no longer is what would be made. */
const TASKS: readonly TaskState[] = [
  { name: "knit", blank: null, quiet: {} },
  {
    name: "sew",
    blank: null,
    quiet: { stale: null },
    stale: (passing) => (passing as { stale: "way" | "look" | null }).stale,
    wire: (passing, made) => ((passing as { stale: string | null }).stale === "way" ? PLANNED : made),
  },
];
const track = { ...freshTrack("knit", "wool", {}), snapshots: [{ wire: OLD }] as never };
const made = { finished: { wire: MADE, views: ["front"], targets: ["cat"] }, track, source: "run" } as unknown as Made;

let store: Store<BaseState, StudioState>;
const shown = (forming: WireShape | null = null): WireShape | null | undefined => wireFor(store.get(), TASKS, forming);
const look = (task: string): void => store.set({ doc: { ...store.get().doc, task } });

beforeEach(() => {
  store = new Store<BaseState, StudioState>(firstState(TASKS), (base) => stateOf(base, TASKS));
  store.set({ doc: { ...store.get().doc, desks: { knit: { settings: {}, guide: null, made, loose: null } } } });
});

it("shows the wire that was made, and what belongs to it", () => {
  expect(store.get()).toMatchObject({ phase: "idle", running: null, views: ["front"], targets: ["cat"], track, looking: null });
  expect(shown()).toBe(MADE);
  look("sew");
  expect(store.get()).toMatchObject({ views: [], targets: [], track: null });
  expect(shown()).toBeNull();
});

it("looks back at a finished run as long as its wire is there", () => {
  store.set({ lookingBack: { made, index: 0 } });
  expect([store.get().looking, shown()]).toEqual([0, OLD]);
  const other = { ...made };
  store.set({ doc: { ...store.get().doc, desks: { knit: { settings: {}, guide: null, made: other, loose: null } } } });
  expect([store.get().looking, shown()]).toEqual([null, MADE]);
});

it("shows a run where its task is looked at, from its first wire on, and no other task's", () => {
  store.set({ run: { ...NO_RUN, phase: "running", track, notes: ["thin"] } });
  expect(store.get()).toMatchObject({ phase: "running", running: "knit", notes: ["thin"], views: [] });
  expect([shown(), shown(FORMING)]).toEqual([MADE, FORMING]);
  look("sew");
  expect(store.get()).toMatchObject({ running: "knit", notes: [], track: null });
  expect(shown(FORMING)).toBeNull();
});

it("shows what a link carries ahead of the document, and leaves what is there until that has been read", () => {
  store.set({ ahead: { task: "knit", wire: null, views: [], coming: true } });
  expect(shown()).toBeUndefined();
  store.set({ ahead: { task: "knit", wire: LINKED, views: ["side"] as never, coming: true } });
  expect([shown(), store.get().views, store.get().targets]).toEqual([LINKED, ["side"], []]);
  look("sew");
  expect(shown()).toBeNull();
});

it("lets a task show a plan in place of its wire", () => {
  look("sew");
  store.set({ passing: { ...store.get().passing, sew: { stale: "way" } } });
  expect([store.get().planned, store.get().restyled, shown()]).toEqual([true, false, PLANNED]);
  store.set({ passing: { ...store.get().passing, sew: { stale: "look" } } });
  expect([store.get().planned, store.get().restyled, shown()]).toEqual([false, true, null]);
  // What another task's wire has come to is nobody's business here.
  look("knit");
  expect(store.get().restyled).toBe(false);
});

it("tells what changed together as one change, and watchers only of what they watch", () => {
  const told: string[] = [];
  store.watch(({ problem }) => [problem], ({ problem, said }) => told.push(`${problem} ${said}`));
  store.set({ said: "hello" });
  expect(told).toEqual([]);
  store.batch(() => {
    store.set({ problem: "broken" });
    store.set({ said: "mended" });
    expect(store.get().problem).toBe("broken");
  });
  expect(told).toEqual(["broken mended"]);
});
