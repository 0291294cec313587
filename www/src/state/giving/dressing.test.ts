import { beforeEach, expect, it } from "vitest";
import type { Bench, StudioState } from "../studio-state";
import { QUIET } from "../studio-state";
import { Dressing } from "./dressing";

let state: Pick<StudioState, "dressing">;
let taken: string[];
let answers: (() => void)[];
let busy: boolean;
let dressing: Dressing;

beforeEach(() => {
  state = { dressing: QUIET };
  taken = [];
  answers = [];
  busy = false;
  const bench = {
    engine: { call: () => new Promise<void>((resolve) => answers.push(resolve)) },
    store: { set: (change: Partial<StudioState>) => (state = { ...state, ...change }) },
    doc: { cover: null },
    get busy() {
      return busy;
    },
    edit: (label: string) => taken.push(label),
  };
  dressing = new Dressing(bench as unknown as Bench);
});

const mesh = new Blob(["v 0 0 0"]);
const later = () => new Promise((resolve) => setTimeout(resolve));

it("takes the newest of two meshes, whichever is read first", async () => {
  const both = [dressing.open(mesh, "large.obj"), dressing.open(mesh, "small.obj")];
  await later();
  answers[1]!();
  await later();
  answers[0]!();
  await Promise.all(both);
  expect(taken).toEqual(["Take the shape small.obj"]);
  expect(state.dressing).toEqual(QUIET);
});

it("does not let a mesh that was read late take the place of a shape that was chosen", async () => {
  const opening = dressing.open(mesh, "large.obj");
  await later();
  expect(state.dressing.busy).toBe(true);
  dressing.shape("knot");
  answers[0]!();
  await opening;
  expect(taken).toEqual(["Take the shape Knot"]);
});

it("says why a mesh that came during a run is not there, and that a style needs a shape", async () => {
  const opening = dressing.open(mesh, "box.obj");
  await later();
  busy = true;
  answers[0]!();
  await opening;
  expect(taken).toEqual([]);
  expect(state.dressing.problem).toMatch(/run is under way/);
  await dressing.picture(new Blob(["x"]), "cross.png");
  expect(state.dressing.problem).toMatch(/A style needs a shape.*cross.png/);
});
