import { beforeEach, expect, it, vi } from "vitest";
import { NO_RUN, type RunState, type WhenHidden } from "../contract/state";
import type { Task } from "../contract/task";
import { freshTrack, type Track } from "../keeping/track";
import { HiddenTab } from "./hidden-tab";
import { Runner } from "./runner";

const fresh: Track = freshTrack("knit", null, {});
const task = { words: { looking: "" }, work: async () => null } as unknown as Task;

let state: RunState;
let controls: string[];
let choice: WhenHidden;
let runner: Runner;
let finish: () => void;
let show: (hidden: boolean) => void;

beforeEach(() => {
  state = NO_RUN;
  controls = [];
  choice = "pause";
  const page = { hidden: false, addEventListener: (_: string, listener: () => void) => void (changed = listener) };
  let changed = (): void => undefined;
  show = (hidden) => {
    page.hidden = hidden;
    changed();
  };
  const engine = {
    callEndable: () => new Promise((resolve) => (finish = () => resolve({}))),
    control: (control: string) => void controls.push(control),
    cancel: () => undefined,
  };
  let tab: HiddenTab | null = null;
  runner = new Runner(engine as never, {
    get: () => state,
    set: (change) => {
      state = { ...state, ...change };
      tab?.look();
    },
    wire: () => undefined,
    snapshot: () => undefined,
    place: () => undefined, notice: () => undefined,
  });
  tab = new HiddenTab(() => choice, { phase: () => state.phase, pauseOrGoOn: () => runner.pause() }, page as never);
});

const begin = (): void => {
  void runner.run(task, fresh, Promise.resolve("auto")).finally(() => runner.rest());
  runner.hear({ news: "targets", targets: [] });
};

it("rests while the tab is hidden, and goes on by itself", () => {
  begin();
  show(true);
  expect(state.phase).toBe("paused");
  show(false);
  expect(state.phase).toBe("running");
  expect(controls).toEqual(["pause", "resume"]);
});

it("keeps going where that was chosen", () => {
  choice = "go";
  begin();
  show(true);
  show(false);
  expect(controls).toEqual([]);
});

it("leaves a run alone that the person paused", () => {
  begin();
  runner.pause();
  show(true);
  show(false);
  expect(state.phase).toBe("paused");
  expect(controls).toEqual(["pause"]);
});

it("rests also when the run begins in a hidden tab", () => {
  void runner.run(task, fresh, Promise.resolve("auto")).finally(() => runner.rest());
  show(true);
  expect(controls).toEqual([]);
  runner.hear({ news: "targets", targets: [] });
  expect([state.phase, controls]).toEqual(["paused", ["pause"]]);
  show(false);
  expect(state.phase).toBe("running");
});

it("has nothing to go on with when the run has ended meanwhile", async () => {
  begin();
  await vi.waitFor(() => expect(finish).toBeDefined());
  show(true);
  finish();
  await vi.waitFor(() => expect(state.phase).toBe("idle"));
  begin();
  expect(state.phase).toBe("paused");
  show(false);
  runner.pause();
  show(true);
  show(false);
  expect(state.phase).toBe("paused");
});
