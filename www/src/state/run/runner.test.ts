import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Cancelled, Problem } from "../../engine/client";
import type { WireShape } from "#sculpture/scene/shape";
import type { Finished, Frame, News, SettingValues, Snapshot } from "../../engine/protocol";
import { NO_RUN, type RunState } from "../contract/state";
import type { Task } from "../contract/task";
import { Runner } from "./runner";
import { freshTrack, upTo, type Track } from "../keeping/track";

const wire = (x: number): WireShape => ({ closed: false, knots: [0, 0, 0, 0, 1, 1, 1, 1], controlPoints: Array<number>(16).fill(x) });
const snapshot = (iteration: number): Snapshot => ({ iteration, iterations: 100, loss: 1 / iteration, wire: wire(-iteration), checkpoint: new Blob([String(iteration)]) });
const frame = (iteration: number): Frame => ({ wire: wire(iteration), iteration, iterations: 100, loss: 1 / iteration, iterationsPerSecond: 20 });
const fresh: Track = freshTrack("knit", "wool", {});

let state: RunState;
let controls: string[];
let shown: number;
let from: Uint8Array | null;
let end: { finish(finished: Finished): void; fail(error: Error): void };
let runner: Runner;
let where: string;
let settings: SettingValues;
let work: unknown;
const task: Pick<Task, "words" | "work"> = {
  words: { given: "", looking: "Looking at the wool", needs: "", remedy: "", text: "" },
  work: async (given) => ({ given }),
};

beforeEach(() => {
  vi.stubGlobal("document", { hidden: true });
  vi.useFakeTimers({ toFake: ["performance"] });
  state = NO_RUN;
  controls = [];
  where = "";
  shown = NaN;
  const engine = {
    callEndable: (_call: string, given: { work: unknown; from: Uint8Array | null; settings: SettingValues }) => {
      ({ work, from, settings } = given);
      return new Promise((finish, fail) => (end = { finish, fail }));
    },
    control: (control: string) => void controls.push(control),
    cancel: () => end?.fail(new Cancelled("cancelled")),
  };
  runner = new Runner(engine as never, {
    get: () => state,
    set: (change) => (state = { ...state, ...change }),
    wire: (wire) => (shown = wire.controlPoints[0]!),
    snapshot: () => undefined,
      notice: () => undefined,
    place: (place) => (where = place.device),
  });
});

afterEach(() => vi.useRealTimers());

const hear = (...news: News[]): void => news.forEach((one) => runner.hear(one));
const begun = (track = fresh): Promise<Finished | null> => {
  const run = runner.run(task, track, Promise.resolve("auto")).finally(() => runner.rest());
  hear({ news: "targets", targets: [] });
  return run;
};

/** Once the engine has been asked. */
const asked = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

it("follows a run from what is given to the wire", async () => {
  const run = begun({ ...fresh, settings: { seed: "3" } });
  expect(state.phase).toBe("running");
  hear({ news: "frame", frame: frame(10) }, { news: "snapshot", snapshot: snapshot(10) }, { news: "event", event: { iteration: 10, kind: "refine", count: 3 } });
  hear({ news: "frame", frame: frame(15) });
  // The wire is shown, but numbers are not to flicker.
  expect([shown, state.progress.iteration]).toEqual([15, 10]);
  vi.advanceTimersByTime(200);
  hear({ news: "frame", frame: frame(20) });
  expect(state.progress).toMatchObject({ iteration: 20, share: 0.2, secondsLeft: 4 });
  expect(state.track).toMatchObject({ iterations: 100, losses: [[10, 0.1], [15, 1 / 15], [20, 0.05]], events: [{ kind: "refine" }], snapshots: [{ iteration: 10 }] });
  expect(controls).toEqual(["seen", "seen", "seen"]);
  await asked();
  expect([work, settings]).toEqual([{ given: "wool" }, { seed: "3", backend: "auto" }]);
  const finished = {} as Finished;
  end.finish(finished);
  expect(await run).toBe(finished);
  expect(state.phase).toBe("idle");
});

it("pauses to look back, keeps looking while frames still come, and returns to the newest", () => {
  void begun();
  hear({ news: "snapshot", snapshot: snapshot(10) }, { news: "frame", frame: frame(30) });
  runner.lookAt(0);
  expect([state.phase, shown, state.looking]).toEqual(["paused", -10, 0]);
  hear({ news: "frame", frame: frame(31) });
  expect(shown).toBe(-10);
  runner.pause();
  expect([state.phase, shown, state.looking]).toEqual(["running", 31, null]);
  expect(controls.filter((control) => control !== "seen")).toEqual(["pause", "resume"]);
});

it("goes on from a snapshot: what came later is gone", async () => {
  void begun();
  hear(...[10, 20, 30].map((at) => ({ news: "snapshot", snapshot: snapshot(at) }) as const), { news: "frame", frame: frame(15) });
  vi.advanceTimersByTime(200);
  hear({ news: "frame", frame: frame(35) });
  const track = upTo(state.track!, state.track!.snapshots[1]!);
  expect(track.snapshots.map(({ iteration }) => iteration)).toEqual([10, 20]);
  expect(track.losses.map(([iteration]) => iteration)).toEqual([15]);
  void begun(track);
  await asked();
  expect(from).toBe(track.snapshots.at(-1)!.checkpoint);
});

it("comes to nothing when it is called off, and says what went wrong otherwise", async () => {
  const called = begun();
  await asked();
  runner.cancel();
  expect(await called).toBeNull();
  const failed = runner.run(task, fresh, Promise.resolve("cpu")).finally(() => runner.rest());
  await asked();
  runner.stop();
  expect(await failed).toBeNull();
  const crashed = begun();
  await asked();
  hear({ news: "snapshot", snapshot: snapshot(10) });
  end.fail(new Problem("the engine stopped"));
  await expect(crashed).rejects.toThrow("the engine stopped");
  expect([state.phase, state.track!.snapshots.length]).toEqual(["idle", 1]);
  hear({ news: "frame", frame: frame(99) });
  expect(shown).not.toBe(99);
});

it("ends at once while it is still unknown where it can be computed, and the engine never hears of it", async () => {
  end = undefined as never;
  const run = runner.run(task, fresh, new Promise(() => undefined)).finally(() => runner.rest());
  runner.stop();
  expect(await run).toBeNull();
  expect([state.phase, end]).toEqual(["idle", undefined]);
  const soon = runner.run(task, fresh, Promise.resolve("gpu"));
  runner.stop();
  expect([await soon, end]).toEqual([null, undefined]);
});

it("passes on where it is computed, while it runs", () => {
  hear({ news: "place", place: { backend: "gpu", device: "Card", why: "" } });
  expect(where).toBe("");
  void begun();
  hear({ news: "place", place: { backend: "gpu", device: "Card", why: "" } });
  expect(where).toBe("Card");
});

it("stops with the best so far, once", () => {
  void begun();
  runner.step();
  runner.stop();
  runner.stop();
  runner.step();
  expect(controls).toEqual(["step", "stop"]);
  expect(state.phase).toBe("finishing");
});
