import { beforeEach, expect, it, vi } from "vitest";
import type { WireShape } from "#sculpture/scene/shape";
import type { Finished, Snapshot } from "../../engine/protocol";
import { testBench, type TestBench } from "../contract/test-bench";
import type { Task } from "../contract/task";
import { deskOf, withDesk, withGiven, type Made } from "../keeping/document";
import { variantOf } from "../keeping/track";
import type { Placer } from "./placer";
import { Runs } from "./runs";

const task = {
  name: "knit",
  blank: null,
  quiet: {},
  words: { given: "wool", looking: "Looking at the wool", needs: "A wire needs wool.", remedy: "Give some.", text: "" },
  suffices: (wool: unknown) => wool !== null,
  work: async (wool: unknown) => wool,
} as unknown as Task;

let bench: TestBench;
let runs: Runs;
let asked: { settings: Record<string, string>; from: Blob | null; work: unknown }[];
let finish: (finished: Finished) => void;
let forming: (WireShape | null)[];

beforeEach(() => {
  asked = [];
  forming = [];
  const engine = {
    callEndable: (_call: string, given: (typeof asked)[number]) => {
      asked.push(given);
      return new Promise((resolve) => (finish = resolve));
    },
    control: () => undefined,
  };
  bench = testBench([task], engine);
  const placer = { begin: async () => "cpu", end: () => undefined, hear: () => undefined } as unknown as Placer;
  runs = new Runs(bench, [task], placer, (wire) => forming.push(wire));
});

const give = (wool: string | null): void => bench.change(withGiven(bench.doc, "knit", wool));
const made = (): Made | null => deskOf(bench.doc).made;
const times = (count: number): Promise<void> => vi.waitFor(() => expect(asked.length).toBe(count));
async function done(count: number, running: Promise<void>): Promise<void> {
  await times(count);
  finish({ code: `wire ${count}` } as Finished);
  await running;
}

it("says what is missing, and begins nothing", async () => {
  await runs.run();
  expect(bench.store.get().problem).toBe("A wire needs wool. Give some.");
  expect(asked).toEqual([]);
});

it("brings the wire and the end of its run in one", async () => {
  give("red");
  const seen: unknown[] = [];
  bench.store.follow(({ phase }) => seen.push(phase === "idle" ? (made()?.finished.code ?? null) : phase));
  await done(1, runs.run());
  expect(seen.at(-1)).toBe("wire 1");
  expect(seen.slice(seen.indexOf("preparing")).slice(0, -1).every((phase) => phase === "preparing")).toBe(true);
  expect(made()).toMatchObject({ source: "run", stopped: true, track: { task: "knit", given: "red" } });
  expect([bench.labels, asked[0]!.work]).toEqual([["Make the wire"], "red"]);
});

it("lays loose strokes beside a wire of the same, after one of a run", async () => {
  give("red");
  await done(1, runs.run());
  await done(2, runs.compare());
  expect(deskOf(bench.doc)).toMatchObject({ made: { finished: { code: "wire 1" } }, loose: { finished: { code: "wire 2" } } });
  expect(asked[1]!.settings).toEqual({ form: "bag", backend: "cpu" });
});

it("lays a wire beside it that differs in one thing, of the same settings and seed", async () => {
  give("red");
  bench.change(withDesk(bench.doc, "knit", { settings: { seed: "7" } }));
  await done(1, runs.run());
  await done(2, runs.compare({ variant: "clearance", settings: { clearance: "0" }, without: true }));
  expect(asked[1]!.settings).toEqual({ seed: "7", clearance: "0", backend: "cpu" });
  const { loose } = deskOf(bench.doc);
  expect([loose?.finished.code, loose?.track?.variant, variantOf(loose?.track), variantOf(made()?.track)]).toEqual(["wire 2", "clearance", "clearance", null]);
  // Kept before there was anything but loose strokes.
  expect(variantOf({ ...loose!.track!, variant: undefined! })).toBe("loose");
});

it("lays a wire of something else beside it, and leaves what is given", async () => {
  give("red");
  await done(1, runs.run());
  await done(2, runs.compare({ variant: "picture", settings: {}, given: "half", without: true }));
  expect([asked[1]!.work, bench.doc.given["knit"]]).toEqual(["half", "red"]);
});

it("goes on from a wire that it went through, and brings back what that was of", async () => {
  give("red");
  const wire: WireShape = { closed: false, knots: [], controlPoints: [] };
  const snapshot: Snapshot = { iteration: 10, iterations: 20, loss: 1, wire, checkpoint: new Blob(["state"]) };
  const running = runs.run();
  await times(1);
  bench.store.set({ run: { ...bench.store.get().run, track: { ...bench.store.get().run.track!, snapshots: [snapshot] } } });
  finish({} as Finished);
  await running;
  give("blue");
  runs.lookAt(0);
  expect(bench.store.get().looking).toBe(0);
  await done(2, runs.continueFrom(0));
  expect(asked[1]).toMatchObject({ work: "red", from: snapshot.checkpoint });
  expect(forming.at(-1)).toBe(wire);
  expect(bench.labels).toEqual(["Make the wire", "Bring back the wool of the run", "Make the wire"]);
  expect(bench.doc.given["knit"]).toBe("red");
});
