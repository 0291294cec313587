import { expect, it } from "vitest";
import { docOf, partsOf } from "../state/keeping/keep";
import { before, runBefore } from "./kept-before";
import { fill } from "./fill/task";
import { multiview } from "./multiview/task";
import { stroke } from "./stroke/task";

const FORMS = { multiview: multiview.form, stroke: stroke.form, fill: fill.form };
const finished = { code: "AB" };
const run = { settings: { seed: "5" }, iterations: 600, losses: [[0, 1]], events: [{ iteration: 600, kind: "done", count: 0 }] };
const snapshots = [{ iteration: 600, iterations: 600, loss: 0.1, wire: {}, checkpoint: new Blob() }];
const cat = { label: "Cat", layers: [] };
const subject = { picture: { name: "mug.png", width: 2, height: 2, rgba: new Blob() }, object: 1, strokes: [], found: null, depth: null };
const mesh = { key: "k1", name: "bunny.obj", file: new Blob(), up: "z" };

const made = (given: object) => ({ finished, source: "run", track: { given, ...run, snapshots }, stopped: false, seconds: 9 });

/** As the last page before wrote it. */
const PARTS = {
  front: cat,
  side: null,
  top: null,
  job: "fill",
  subject,
  solid: mesh,
  style: "waves",
  settings: { preset: "fast" },
  made: made({ job: "multiview", sheets: [{ slot: "side", paper: cat }] }),
  loose: null,
  stroke: { settings: { control_points: "80" }, made: made({ job: "stroke", subject }), loose: null },
  fill: { settings: {}, made: made({ job: "fill", cover: { solid: mesh, style: null } }), loose: null },
};

it("reads what was kept before", () => {
  const track = { ...run, snapshots };
  expect(docOf(before(PARTS), FORMS)).toEqual({
    task: "fill",
    given: { multiview: { front: cat, side: null, top: null }, stroke: subject, fill: { mesh, style: "waves" } },
    desks: {
      multiview: { settings: { preset: "fast" }, guide: null, made: { ...PARTS.made, track: { ...track, task: "multiview", given: { front: null, side: cat, top: null } } }, loose: null },
      stroke: { settings: { control_points: "80" }, guide: null, made: { ...PARTS.stroke.made, track: { ...track, task: "stroke", given: subject } }, loose: null },
      fill: { settings: {}, guide: null, made: { ...PARTS.fill.made, track: { ...track, task: "fill", given: { mesh, style: null } } }, loose: null },
    },
  });
});

it("reads what was kept before there was a second task", () => {
  expect(docOf(before({ front: cat, side: cat, top: null, settings: { seed: "5" }, made: null }), FORMS)).toEqual({
    task: "multiview",
    given: { multiview: { front: cat, side: cat, top: null }, stroke: null, fill: null },
    desks: { multiview: { settings: { seed: "5" }, guide: null, made: null, loose: null } },
  });
  expect(docOf(before({}), FORMS)).toBeNull();
});

it("reads runs under way of every age", () => {
  const sheets = [{ slot: "front", paper: cat }];
  const papers = { front: cat, side: null, top: null };
  expect(runBefore({ ...run, sheets })).toEqual({ ...run, task: "multiview", given: papers });
  expect(runBefore({ ...run, given: { job: "multiview", sheets } })).toEqual({ ...run, task: "multiview", given: papers });
  expect(runBefore({ ...run, given: { job: "stroke", subject }, loose: true })).toEqual({ ...run, loose: true, task: "stroke", given: subject });
  expect(runBefore({ ...run, given: { job: "fill", cover: { solid: mesh, style: "waves" } } })).toEqual({ ...run, task: "fill", given: { mesh, style: "waves" } });
});

it("keeps documents in parts, and puts them together again", () => {
  const doc = docOf(before(PARTS), FORMS)!;
  const parts = partsOf(doc, FORMS);
  expect(docOf(parts, FORMS)).toEqual(doc);
  // What did not change is the same, and is not written again.
  const turned = partsOf({ ...doc, given: { ...doc.given, fill: { mesh, style: null } } }, FORMS);
  expect(Object.keys(turned).filter((name) => turned[name] !== parts[name])).toEqual(["given/fill/style"]);
  // What is taken back is written over.
  const none = partsOf({ task: "fill", given: { multiview: multiview.blank, stroke: null, fill: null }, desks: {} }, FORMS);
  expect(Object.keys(none)).toEqual(Object.keys(parts));
});
