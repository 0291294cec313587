import { beforeEach, expect, it } from "vitest";
import type { SettingRow, SettingsTable } from "../../engine/protocol";
import { BLANK, withDesk, type Doc, type Made } from "../../state/keeping/document";
import type { Options } from "../../state/settings/options";
import type { Bench, StudioState } from "../../state/contract/state";
import type { Cover } from "./given";
import { Planning } from "./planning";

const of = (shape: "vase" | "knot"): Cover => ({ solid: { shape }, style: null });
const row: SettingRow = { name: "curve_spacing", group: "surface", unit: "", help: "", kind: "number", min: 0, max: 1, affects: ["course", "curve"] };
const table: SettingsTable = { rows: [row], presets: { best: { curve_spacing: "0.06" } } };
const madeOf = (cover: Cover | null): Made => ({ track: cover && { given: { job: "fill", cover }, settings: {} } }) as Made;

let doc: Doc;
let state: Pick<StudioState, "planned" | "restyled">;
let planning: Planning;
let ahead: boolean;
let known: boolean;

const change = (next: Partial<Doc>): void => {
  doc = { ...doc, ...next };
  planning.follow(ahead);
};
const make = (made: Made | null): void => change(withDesk(doc, "fill", { made }));

beforeEach(() => {
  doc = { ...BLANK, job: "fill", cover: of("vase") };
  state = { planned: false, restyled: false };
  ahead = false;
  known = true;
  const bench = {
    get doc() {
      return doc;
    },
    busy: false,
    store: {
      get: () => ({ ...state, doc, tables: known ? { multiview: table, stroke: table, fill: table } : null }),
      set: (changed: object) => (state = { ...state, ...changed }),
    },
  };
  const value = (name: string): string => doc.desks.fill.settings[name] ?? table.presets["best"]![name] ?? "";
  planning = new Planning(bench as unknown as Bench, { value } as Options, { follow: () => undefined, forget: () => undefined });
});

it("plans where there is no wire, and where the one that was made runs another way", () => {
  planning.follow(false);
  expect(state.planned).toBe(true);
  make(madeOf(of("vase")));
  expect(state.planned).toBe(false);
  change(withDesk(doc, "fill", { settings: { curve_spacing: "0.1" } }));
  expect(state.planned).toBe(true);
});

it("takes a wire from elsewhere for one of what was there when it was asked for", () => {
  ahead = true;
  planning.awaits();
  planning.follow(true);
  expect(state.planned).toBe(false);
  change({ cover: of("knot") });
  expect(state.planned).toBe(true);
  ahead = false;
  const link = madeOf(null);
  make(link);
  expect(state.planned).toBe(true);
  expect(planning.coverOf(link)).toBe(null);
  change({ cover: of("vase") });
  expect(state.planned).toBe(false);
  expect(planning.coverOf(link)).toEqual(of("vase"));
});

it("takes it with the settings that came with it, which are known later", () => {
  [ahead, known] = [true, false];
  planning.awaits();
  planning.follow(true);
  doc = { ...doc, ...withDesk(doc, "fill", { settings: { curve_spacing: "0.1" } }) };
  known = true;
  planning.follow(true);
  ahead = false;
  make(madeOf(null));
  expect(state.planned).toBe(false);
});

it("knows what a wire of a run covers, whatever is there now", () => {
  const made = madeOf(of("vase"));
  make(made);
  change({ cover: of("knot") });
  expect(planning.coverOf(made)).toEqual(of("vase"));
});
