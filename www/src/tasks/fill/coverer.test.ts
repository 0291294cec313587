import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Cancelled, Problem } from "../../engine/client";
import type { WireShape } from "#sculpture/scene/shape";
import type { Cover } from "./given";
import type { FoundSurface } from "./protocol";
import { Coverer, NO_COVER, type CoverState, type Wish } from "./coverer";

const cover = (shape: "vase" | "knot"): Cover => ({ mesh: { shape }, style: null });
const wish = (curve: string | null, shape: "vase" | "knot" = "vase", running = false): Wish => ({ cover: cover(shape), settings: {}, curve, running });

let state: CoverState;
let asked: string[];
let answers: { resolve(curve: WireShape): void; reject(reason: Error): void }[];
let coverer: Coverer;

beforeEach(() => {
  vi.useFakeTimers();
  state = NO_COVER;
  asked = [];
  answers = [];
  coverer = new Coverer(
    {
      surface: (mesh) => {
        asked.push("shape" in mesh ? mesh.shape : mesh.name);
        return Promise.resolve({ triangles: 4 } as FoundSurface);
      },
      curve: () => {
        asked.push("curve");
        return new Promise((resolve, reject) => answers.push({ resolve, reject }));
      },
      cancel: () => answers.at(-1)!.reject(new Cancelled()),
    },
    (change) => (state = { ...state, ...change }),
  );
});
afterEach(() => {
  vi.useRealTimers();
});

const later = () => vi.advanceTimersByTimeAsync(1000);

it("shows the shape, then how a wire would run over it, and how far that is", async () => {
  coverer.follow(wish("a"));
  await later();
  expect(asked).toEqual(["vase", "curve"]);
  expect(state).toMatchObject({ surface: { triangles: 4 }, covering: 0, curve: null });
  coverer.hear(0.5);
  expect(state.covering).toBe(0.5);
  const curve = {} as WireShape;
  answers[0]!.resolve(curve);
  await later();
  expect(state).toMatchObject({ curve, covering: null, coverProblem: "" });
  coverer.follow(wish("a"));
  await later();
  expect(asked).toHaveLength(2);
});

it("ends a curve that nobody wants any more, and makes only the newest", async () => {
  coverer.follow(wish("a"));
  await later();
  coverer.follow(wish("b"));
  coverer.follow(wish("c"));
  await later();
  expect(asked).toEqual(["vase", "curve", "curve"]);
  answers[1]!.resolve({ closed: true } as WireShape);
  await later();
  expect(state.curve).toEqual({ closed: true });
});

it("shows nothing of one shape over another", async () => {
  coverer.follow(wish("a"));
  await later();
  answers[0]!.resolve({} as WireShape);
  await later();
  coverer.follow(wish("b", "knot"));
  expect(state).toEqual(NO_COVER);
  await later();
  expect(asked).toEqual(["vase", "curve", "knot", "curve"]);
});

it("asks for no curve where a finished wire is shown", async () => {
  coverer.follow(wish(null));
  await later();
  expect(asked).toEqual(["vase"]);
});

it("says once why there is none, and tries again when something changes", async () => {
  coverer.follow(wish("a"));
  await later();
  answers[0]!.reject(new Problem("the spacing is too fine"));
  await later();
  expect(state).toMatchObject({ coverProblem: "The spacing is too fine.", covering: null });
  coverer.follow(wish("a"));
  await later();
  expect(asked).toHaveLength(2);
  coverer.follow(wish("b"));
  await later();
  expect(asked).toHaveLength(3);
});

it("leaves the engine to a run, and asks it for no more than the shape", async () => {
  coverer.follow(wish("a"));
  await later();
  coverer.follow(wish("b", "vase", true));
  await later();
  expect(asked).toEqual(["vase", "curve"]);
  answers[0]!.resolve({} as WireShape);
  coverer.follow(wish("c", "knot", true));
  await later();
  expect(asked).toEqual(["vase", "curve", "knot"]);
  expect(state).toMatchObject({ surface: { triangles: 4 }, curve: null, covering: null });
  coverer.follow(wish("c", "knot"));
  await later();
  expect(asked).toEqual(["vase", "curve", "knot", "curve"]);
});
