import { describe, expect, it } from "vitest";
import type { SettingRow, SettingsTable } from "../../engine/protocol";
import type { Made } from "../keeping/document";
import { changesOf } from "./variants";

const row = (name: string, kind: SettingRow["kind"], more: Partial<SettingRow> = {}): SettingRow => ({ name, group: "fit", unit: "", help: "", affects: [], kind, min: 0, max: 1000, ...more }) as SettingRow;
const usual = { preset: "best", smooth: "on", form: "wire", reinit: "false", refine: "false", control_points: "0", smoothness: "1", tightness: "1", clearance: "1", level_weight: "0.5", bend: "little", start: "circuit" };
const table: SettingsTable = {
  rows: [
    row("form", "choice", { choices: ["wire", "bag"] }),
    row("reinit", "switch"),
    row("refine", "switch"),
    row("bend", "choice", { choices: ["none", "little"] }),
    row("start", "choice", { choices: ["circuit", "ball"] }),
    row("control_points", "integer", { max: 20000 }),
    ...["smoothness", "tightness", "clearance", "level_weight"].map((name) => row(name, "number")),
  ],
  presets: { best: usual, "best/off": { ...usual, smooth: "off", start: "ball" } },
};
const made = { finished: { measures: { control_points: 321 } } } as unknown as Made;
const changed = (settings: Record<string, string>, of = table) => Object.fromEntries(changesOf(settings, of, made).map(({ variant, settings }) => [variant, settings]));

describe("what can be another way", () => {
  it("is one thing each", () => {
    expect(changed({})).toEqual({
      loose: { form: "bag" },
      reinit: { reinit: "true" },
      refine: { refine: "true" },
      respace: { control_points: "321" },
      smoothness: { smoothness: "0" },
      tightness: { tightness: "0" },
      clearance: { clearance: "0" },
      level_weight: { level_weight: "0" },
      bend: { bend: "none" },
      start: { start: "ball" },
    });
  });

  it("is the other way round where it is on, and not there where it is off already", () => {
    const changes = changesOf({ reinit: "true", clearance: "0", bend: "none" }, table, made);
    expect(changes.find(({ variant }) => variant === "reinit")).toEqual({ variant: "reinit", settings: { reinit: "false" }, without: true });
    expect(changes.map(({ variant }) => variant)).not.toContain("clearance");
    expect(changes.map(({ variant }) => variant)).not.toContain("bend");
  });

  it("leaves out what a wire that is not kept smooth has not, and what the task has not", () => {
    expect(Object.keys(changed({ smooth: "off" }))).toEqual(["loose", "reinit", "refine", "smoothness", "level_weight", "bend"]);
    const without = { ...table, rows: table.rows.map((each) => (each.name === "bend" ? { ...each, choices: ["little"] } : each)) };
    expect(Object.keys(changed({}, without))).not.toContain("bend");
    expect(changesOf({}, null, made)).toEqual([]);
  });

  it("is one picture fewer, where that is enough", () => {
    expect(changesOf({}, table, made, "two of them").find(({ variant }) => variant === "picture")).toEqual({ variant: "picture", settings: {}, given: "two of them", without: true });
    expect(changesOf({}, table, made, null).map(({ variant }) => variant)).not.toContain("picture");
  });

  it("knows no fixed number of points before there is a wire", () => {
    expect(changesOf({}, table, null).map(({ variant }) => variant)).not.toContain("respace");
  });
});
