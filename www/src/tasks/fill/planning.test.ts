import { beforeEach, expect, it } from "vitest";
import type { SettingRow, SettingsTable } from "../../engine/protocol";
import { passingOf } from "../../state/contract/state";
import { testBench, type TestBench } from "../../state/contract/test-bench";
import { deskOf, withDesk, withGiven, type Made } from "../../state/keeping/document";
import type { Cover } from "./given";
import { Planning } from "./planning";
import { fill } from "./task";

const of = (shape: "vase" | "knot"): Cover => ({ mesh: { shape }, style: null });
const row: SettingRow = { name: "curve_spacing", group: "surface", unit: "", help: "", kind: "number", min: 0, max: 1, affects: ["course", "curve"] };
const table: SettingsTable = { rows: [row], presets: { best: { curve_spacing: "0.06" } } };
const madeOf = (cover: Cover | null): Made => ({ finished: {}, track: cover && { task: "fill", given: cover, settings: {} } }) as Made;

let bench: TestBench;
let planning: Planning;

const change = (next: Parameters<TestBench["change"]>[0]): void => {
  bench.change(next);
  planning.follow();
};
const make = (made: Made | null): void => change(withDesk(bench.doc, "fill", { made }));
const give = (cover: Cover): void => change(withGiven(bench.doc, "fill", cover));
const ahead = (coming: boolean): void => bench.store.set({ ahead: coming ? { task: "fill", wire: null, views: [], coming } : null });
const planned = (): boolean => passingOf(bench.store.get(), fill).stale === "way";

beforeEach(() => {
  bench = testBench([fill], {}, (name) => deskOf(bench.doc).settings[name] ?? table.presets["best"]![name] ?? "");
  bench.store.set({ tables: { fill: table } });
  planning = new Planning(bench, fill, { follow: () => undefined, forget: () => undefined });
  give(of("vase"));
});

it("plans where there is no wire, and where the one that was made runs another way", () => {
  planning.follow();
  expect(planned()).toBe(true);
  make(madeOf(of("vase")));
  expect(planned()).toBe(false);
  change(withDesk(bench.doc, "fill", { settings: { curve_spacing: "0.1" } }));
  expect(planned()).toBe(true);
});

it("takes a wire from elsewhere for one of what was there when it was asked for", () => {
  ahead(true);
  planning.awaits();
  planning.follow();
  expect(planned()).toBe(false);
  give(of("knot"));
  expect(planned()).toBe(true);
  ahead(false);
  const link = madeOf(null);
  make(link);
  expect(planned()).toBe(true);
  expect(planning.coverOf(link)).toBe(null);
  give(of("vase"));
  expect(planned()).toBe(false);
  expect(planning.coverOf(link)).toEqual(of("vase"));
});

it("takes it with the settings that came with it, which are known later", () => {
  ahead(true);
  bench.store.set({ tables: null });
  planning.awaits();
  planning.follow();
  bench.change(withDesk(bench.doc, "fill", { settings: { curve_spacing: "0.1" } }));
  bench.store.set({ tables: { fill: table } });
  planning.follow();
  ahead(false);
  make(madeOf(null));
  expect(planned()).toBe(false);
});

it("knows what a wire of a run covers, whatever is there now", () => {
  const made = madeOf(of("vase"));
  make(made);
  give(of("knot"));
  expect(planning.coverOf(made)).toEqual(of("vase"));
});
