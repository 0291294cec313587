import { beforeEach, expect, it } from "vitest";
import type { Bench, StudioState } from "../../state/contract/state";
import { QUIET } from "../../state/contract/state";
import { solidKey, type Cover } from "./given";
import { Dressing } from "./taking";

let state: Pick<StudioState, "dressing">;
let taken: string[];
let cover: Cover | null;
let answers: ((found: { readonly up: "y" | "z" }) => void)[];
let busy: boolean;
let dressing: Dressing;

beforeEach(() => {
  state = { dressing: QUIET };
  taken = [];
  cover = null;
  answers = [];
  busy = false;
  const bench = {
    engine: { call: () => new Promise((resolve) => answers.push(resolve)) },
    store: { set: (change: Partial<StudioState>) => (state = { ...state, ...change }) },
    get doc() {
      return { cover };
    },
    get busy() {
      return busy;
    },
    edit: (label: string, change: { readonly cover: Cover | null }) => {
      taken.push(label);
      cover = change.cover;
    },
  };
  dressing = new Dressing(bench as unknown as Bench);
});

const FOUND = { up: "z" } as const;
const mesh = new Blob(["v 0 0 0"]);
const later = () => new Promise((resolve) => setTimeout(resolve));

it("takes the newest of two meshes, whichever is read first", async () => {
  const both = [dressing.open(mesh, "large.obj"), dressing.open(mesh, "small.obj")];
  await later();
  answers[1]!(FOUND);
  await later();
  answers[0]!(FOUND);
  await Promise.all(both);
  expect(taken).toEqual(["Take the shape small.obj"]);
  expect(state.dressing).toEqual(QUIET);
});

it("does not let a mesh that was read late take the place of a shape that was chosen", async () => {
  const opening = dressing.open(mesh, "large.obj");
  await later();
  expect(state.dressing.busy).toBe(true);
  dressing.shape("knot");
  answers[0]!(FOUND);
  await opening;
  expect(taken).toEqual(["Take the shape Knot"]);
});

it("says why a mesh that came during a run is not there, and that a style needs a shape", async () => {
  const opening = dressing.open(mesh, "box.obj");
  await later();
  busy = true;
  answers[0]!(FOUND);
  await opening;
  expect(taken).toEqual([]);
  expect(state.dressing.problem).toMatch(/run is under way/);
  await dressing.picture(new Blob(["x"]), "cross.png");
  expect(state.dressing.problem).toMatch(/A style needs a shape.*cross.png/);
});

it("knows which way a mesh stands, and takes one that is turned for another", async () => {
  const opening = dressing.open(mesh, "pawn.stl");
  await later();
  answers[0]!(FOUND);
  await opening;
  const before = cover!.solid;
  expect(before).toMatchObject({ name: "pawn.stl", up: "z" });
  dressing.turn("y");
  const after = cover!.solid;
  expect(after).toMatchObject({ name: "pawn.stl", up: "y" });
  expect(solidKey(after)).not.toBe(solidKey(before));
  expect(taken.at(-1)).toBe("Turn pawn.stl");
  dressing.shape("vase");
  dressing.turn("z");
  expect(cover!.solid).toEqual({ shape: "vase" });
});
