/** What of a run can be another way, to lay what comes of it beside the wire: the same pictures, settings and seed but for one thing. */

import type { SettingsTable, SettingValues } from "../../engine/protocol";
import type { Made } from "../keeping/document";
import type { Variant } from "../keeping/track";
import { presetOf, problemWith } from "../settings/values";

/** A variant as a run of it would be. */
export interface Change {
  readonly variant: Variant;
  readonly settings: SettingValues;
  /** What is given, where that is something else. */
  readonly given?: unknown;
  /** Whether something is left out, or else added. */
  readonly without: boolean;
}

/** First wires that lie only near their places: others are laid at even steps from the start. */
const ROUGH: readonly string[] = ["circuit", "tree", "hull", "ball"];

/** Where loose strokes are laid instead of one wire. */
export const LOOSE: Change = { variant: "loose", settings: { form: "bag" }, without: false };

/** What can be another way in a run with these settings; `made` is the wire that came of it, `fewer` the same without a picture. */
export function changesOf(settings: SettingValues, table: SettingsTable | null, made: Made | null, fewer: unknown = null): readonly Change[] {
  if (!table) return [];
  const value = (name: string): string => settings[name] ?? presetOf(settings, table)[name] ?? "";
  const isSmooth = value("smooth") === "on";
  const change = (variant: Variant, settings: SettingValues, without = true): Change => ({ variant, settings, without });
  const switched = (name: "reinit" | "refine"): Change => change(name, { [name]: String(value(name) !== "true") }, value(name) === "true");
  /** A weight that is taken away. */
  const weightless = (name: "smoothness" | "tightness" | "clearance" | "level_weight"): Change | null => (Number(value(name)) > 0 ? change(name, { [name]: "0" }) : null);
  const points = made?.finished.measures.control_points;
  const respaces = isSmooth && value("control_points") === "0" && ROUGH.includes(value("start")) && points;
  const changes: readonly (Change | null)[] = [
    LOOSE,
    switched("reinit"),
    switched("refine"),
    respaces ? change("respace", { control_points: String(points) }) : null,
    weightless("smoothness"),
    isSmooth ? weightless("tightness") : null,
    isSmooth ? weightless("clearance") : null,
    weightless("level_weight"),
    value("bend") === "none" ? null : change("bend", { bend: "none" }),
    fewer === null ? null : { ...change("picture", {}), given: fewer },
    value("start") === "ball" ? null : change("start", { start: "ball" }),
  ];
  // Not every task has all of them.
  const isOffered = ({ settings }: Change): boolean => Object.entries(settings).every(([name, value]) => problemWith(name, value, table) === null);
  return changes.filter((found): found is Change => found !== null && isOffered(found));
}
