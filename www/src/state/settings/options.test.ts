import { beforeEach, expect, it } from "vitest";
import type { SettingRow, SettingsTable, SettingsTables } from "../../engine/protocol";
import type { Doc } from "../keeping/document";
import { Store } from "../common/store";
import type { Bench } from "../contract/bench";
import type { StudioState } from "../contract/state";
import { Options } from "./options";

const row = (name: string, group: SettingRow["group"], more: Partial<SettingRow> = {}): SettingRow => ({
  name, group, unit: "", help: "", kind: "number", min: 0, max: 1000, affects: ["course"], ...more,
});
const presets = { best: { preset: "best", seed: "0", control_points: "0", min_width: "1", max_width: "20", spacing: "4", roundness: "0.9" } };
const rows = [
  row("preset", "run", { kind: "choice", choices: ["best", "fast"] }),
  ...["seed"].map((name) => row(name, "run")),
  ...["control_points", "min_width", "max_width", "spacing"].map((name) => row(name, "wire")),
];
const table = (more: readonly SettingRow[]): SettingsTable => ({ rows: [...rows, ...more], presets: { ...presets, fast: { ...presets.best, preset: "fast", spacing: "6" } } });
const tables: SettingsTables = { multiview: table([]), stroke: table([row("roundness", "stroke")]), fill: table([row("density", "surface")]) };

const TASKS = [
  { name: "multiview", keeps: { settings: [], groups: [] }, compared: ["front", "side"] },
  { name: "stroke", keeps: { settings: ["control_points", "min_width", "max_width"], groups: ["stroke"] }, compared: ["front"] },
];

let doc: Doc;
let labels: string[];
let options: Options;

beforeEach(() => {
  doc = { task: "multiview", given: {}, desks: {} };
  labels = [];
  const store = new Store<StudioState>({ doc, tables: null, locks: { lock: [], hide: [] } } as unknown as StudioState);
  const change = (changed: Partial<Doc>): void => {
    doc = { ...doc, ...changed };
    store.set({ doc });
  };
  const bench = {
    store,
    project: { get doc() { return doc; }, replace: change },
    get doc() { return doc; },
    edit: (label: string, changed: Partial<Doc>) => {
      labels.push(label);
      change(changed);
    },
  } as unknown as Bench;
  options = new Options(bench, TASKS);
  look = (task) => change({ task });
});
let look: (task: string) => void;

it("keeps the settings of each task apart", () => {
  options.learn(tables);
  options.set("seed", "3");
  look("stroke");
  expect([options.value("seed"), options.value("spacing")]).toEqual(["0", "4"]);
  options.setAll({ min_width: "3", max_width: "3" }, "Set the width");
  look("multiview");
  expect(options.all).toEqual({ seed: "3" });
  look("stroke");
  expect(options.all).toEqual({ min_width: "3", max_width: "3" });
  expect(labels).toEqual(["Set seed", "Set the width"]);
});

it("takes none of several settings where one is impossible", () => {
  options.learn(tables);
  options.setAll({ min_width: "3", max_width: "9999" }, "Set the width");
  expect([options.all, labels]).toEqual([{}, []]);
});

it("leaves what is made of one picture alone when a preset changes, and nothing else", () => {
  options.learn(tables);
  const chosen = { seed: "3", control_points: "80", max_width: "5", spacing: "9" };
  for (const task of ["multiview", "stroke"]) {
    look(task);
    options.setAll(task === "stroke" ? { ...chosen, roundness: "0.5" } : chosen, "Set several");
    options.set("preset", "fast");
  }
  expect(options.all).toEqual({ preset: "fast", seed: "3", control_points: "80", max_width: "5", roundness: "0.5" });
  look("multiview");
  expect(options.all).toEqual({ preset: "fast", seed: "3" });
});

it("gives what an address asks for to the task it names, once it is known what there is", () => {
  look("stroke");
  options.ask("stroke", { control_points: "60", colour: "red" });
  expect(options.all).toEqual({});
  options.learn(tables);
  expect(options.all).toEqual({ control_points: "60" });
  look("multiview");
  expect(options.all).toEqual({});
});

it("takes from an address what is to guide, of the views that the task has", () => {
  options.askGuide("stroke", { "guide-front": "cat", "guide-side": "dog", "guide-weight": "1", "guide-by": "0a1b" });
  expect(doc.desks["stroke"]!.guide).toEqual({ words: { front: "cat" }, weight: 1, by: "icons" });
  options.askGuide("multiview", { "guide-top": "x", "guide-weight": "NaN" });
  expect(doc.desks["multiview"]?.guide ?? null).toBeNull();
  options.askGuide("multiview", { "guide-side": "x".repeat(99), "guide-weight": "NaN", "guide-by": "denoiser" });
  expect(doc.desks["multiview"]!.guide).toEqual({ words: { side: "x".repeat(60) }, weight: 0.3, by: "denoiser" });
});

it("keeps what guides each task, and nothing where nothing was said", () => {
  options.say("front", "umbrella");
  options.guideBy({ weight: 1 });
  look("stroke");
  options.say("front", "");
  expect(doc.desks["stroke"]?.guide).toBeNull();
  options.say("front", "cat");
  options.say("front", "");
  expect(doc.desks["stroke"]!.guide).toBeNull();
  expect(doc.desks["multiview"]!.guide).toEqual({ words: { front: "umbrella" }, weight: 1, by: "icons" });
  expect(labels).toEqual(["Guide by words", "Guide by words", "Guide by pictures alone", "Guide by words", "Guide by pictures alone"]);
});

it("leaves alone what a lesson locks, also where a preset or a reset would change it", () => {
  options.learn(tables);
  options.set("spacing", "7");
  options.set("control_points", "40");
  options["bench"].store.set({ locks: { lock: ["spacing"], hide: [] } });
  options.set("spacing", "9");
  options.setAll({ spacing: "9", control_points: "50" }, "Set two");
  expect([options.value("spacing"), options.value("control_points")]).toEqual(["7", "40"]);
  options.set("preset", "fast");
  expect(options.all).toEqual({ spacing: "7", preset: "fast" });
  options.set("control_points", "50");
  options.reset();
  expect(options.all).toEqual({ spacing: "7" });
  options["bench"].store.set({ locks: { lock: [], hide: ["settings"] } });
  options.set("control_points", "60");
  expect(options.all).toEqual({ spacing: "7" });
});
