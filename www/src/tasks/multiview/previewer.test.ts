import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Problem } from "../../engine/client";
import type { Preview } from "../../engine/protocol";
import type { Paper } from "./paper";
import { NO_PAPERS, type Slot } from "./given";
import { NO_PREVIEW, Previewer, type PreviewState, type Wanted } from "./previewer";
import type { Drawing } from "./protocol";

const dot = (x: number): Paper => ({
  label: "dot",
  layers: [{ kind: "stroke", erase: false, widthPx: 40, points: Float32Array.of(x, 100, x + 50, 100) }],
});
const docOf = (papers: Partial<Record<Slot, Paper>>, settings = {}): Wanted => ({ papers: { ...NO_PAPERS, ...papers }, settings });
const preview = (coverable: number, remedies: Preview["remedies"] = []): Preview => ({
  drawings: [0, 1].map((source) => ({ source }) as Preview["drawings"][number]),
  coverable,
  asGiven: coverable,
  remedies,
  bends: [],
  notes: [],
});

let asked: { drawings: readonly Drawing[]; answer(preview: Preview): void; fail(error: Error): void }[];
let state: PreviewState;
let previewer: Previewer;

beforeEach(() => {
  vi.useFakeTimers();
  asked = [];
  state = NO_PREVIEW;
  previewer = new Previewer(
    (drawings) => new Promise((answer, fail) => asked.push({ drawings, answer, fail })),
    (change) => (state = { ...state, ...change }),
    () => Promise.resolve(),
  );
});
afterEach(() => vi.useRealTimers());

const wait = (ms: number): Promise<unknown> => vi.advanceTimersByTimeAsync(ms);

it("asks for two drawings or more, and names them by their pads", async () => {
  previewer.follow(docOf({ front: dot(10) }));
  await wait(1000);
  expect(asked).toEqual([]);
  previewer.follow(docOf({ front: dot(10), top: dot(20) }));
  await wait(1000);
  expect(asked[0]!.drawings.map(({ name }) => name)).toEqual(["front", "top"]);
  asked[0]!.answer(preview(0.7, [{ kind: "swap", sources: [0, 1], quarterTurns: 0, coverable: 0.9 }]));
  await wait(0);
  expect(state.preview!.drawings.top!.source).toBe(1);
  expect(state.preview!.remedies[0]!.slots).toEqual(["front", "top"]);
  expect(state.previewBusy).toBe(false);
});

it("waits for a hand that draws, works one at a time, and shows only the newest", async () => {
  previewer.follow(docOf({ front: dot(1), side: dot(2) }));
  await wait(0);
  for (let x = 3; x < 9; x++) {
    previewer.follow(docOf({ front: dot(x), side: dot(2) }));
    await wait(100);
  }
  await wait(1000);
  expect(asked.length).toBe(1);
  asked[0]!.answer(preview(0.1));
  await wait(0);
  expect(state.preview).toBeNull();
  expect(asked.length).toBe(2);
  asked[1]!.answer(preview(0.2));
  await wait(0);
  expect(state.preview!.coverable).toBe(0.2);
});

it("takes what it knew of other sheets away at once", async () => {
  const side = dot(2);
  const first = docOf({ front: dot(1), side });
  previewer.follow(first);
  await wait(0);
  asked[0]!.answer(preview(0.5));
  await wait(0);
  previewer.follow({ ...first, settings: { bend: "free" } });
  expect(state.preview).not.toBeNull();
  previewer.follow(docOf({ front: dot(7), side }));
  expect(state.preview).toBeNull();
  expect(state.previewBusy).toBe(true);
});

it("says what is wrong with the drawings, and asks again when they change", async () => {
  previewer.follow(docOf({ front: dot(1), side: dot(2) }));
  await wait(0);
  asked[0]!.fail(new Problem("the drawings share no ink; use others"));
  await wait(0);
  expect(state.previewProblem).toBe("The drawings share no ink; use others.");
  previewer.follow(docOf({ front: dot(1), side: dot(3) }));
  await wait(1000);
  expect(asked.length).toBe(2);
  asked[1]!.answer(preview(0.4));
  await wait(0);
  expect([state.preview!.coverable, state.previewProblem]).toEqual([0.4, ""]);
});
