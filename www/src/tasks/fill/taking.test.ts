import { beforeEach, expect, it } from "vitest";
import { givenFor, passingOf } from "../../state/contract/state";
import { testBench, type TestBench } from "../../state/contract/test-bench";
import { meshKey } from "./given";
import type { CoverTaker } from "./taking";
import { fill } from "./task";

let bench: TestBench;
let answers: ((found: { readonly up: "y" | "z" }) => void)[];
let taker: CoverTaker;

beforeEach(() => {
  answers = [];
  bench = testBench([fill], { call: () => new Promise((resolve) => answers.push(resolve)) });
  taker = fill.open(bench);
});

const mesh = () => givenFor(bench.store.get(), fill)!.mesh;
const pad = () => passingOf(bench.store.get(), fill);

const FOUND = { up: "z" } as const;
const file = new Blob(["v 0 0 0"]);
const later = () => new Promise((resolve) => setTimeout(resolve));

it("takes the newest of two meshes, whichever is read first", async () => {
  const both = [taker.open(file, "large.obj"), taker.open(file, "small.obj")];
  await later();
  answers[1]!(FOUND);
  await later();
  answers[0]!(FOUND);
  await Promise.all(both);
  expect(bench.labels).toEqual(["Take the shape small.obj"]);
  expect(pad()).toEqual(fill.quiet);
});

it("does not let a mesh that was read late take the place of a shape that was chosen", async () => {
  const opening = taker.open(file, "large.obj");
  await later();
  expect(pad().busy).toBe(true);
  taker.shape("knot");
  answers[0]!(FOUND);
  await opening;
  expect(bench.labels).toEqual(["Take the shape Knot"]);
});

it("says why a mesh that came during a run is not there, and that a style needs a shape", async () => {
  const opening = taker.open(file, "box.obj");
  await later();
  bench.run(true);
  answers[0]!(FOUND);
  await opening;
  expect(bench.labels).toEqual([]);
  expect(pad().problem).toMatch(/run is under way/);
  await taker.picture(new Blob(["x"]), "cross.png");
  expect(pad().problem).toMatch(/A style needs a shape.*cross.png/);
});

it("knows which way a mesh stands, and takes one that is turned for another", async () => {
  const opening = taker.open(file, "pawn.stl");
  await later();
  answers[0]!(FOUND);
  await opening;
  const before = mesh();
  expect(before).toMatchObject({ name: "pawn.stl", up: "z" });
  taker.turn("y");
  const after = mesh();
  expect(after).toMatchObject({ name: "pawn.stl", up: "y" });
  expect(meshKey(after)).not.toBe(meshKey(before));
  expect(bench.labels.at(-1)).toBe("Turn pawn.stl");
  taker.shape("vase");
  taker.turn("z");
  expect(mesh()).toEqual({ shape: "vase" });
});
