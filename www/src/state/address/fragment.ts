/**
 * The address's fragment, which no server ever sees: `#v=1&job=stroke&w=CODE&preset=fast&seed=3`. `w` carries a whole
 * wire, `job` says what it is for (several drawings, where there is none), `shape` and `style` name a shape by formula
 * and a style by formula, every other key is a setting of the core's table; unknown ones are ignored. Links before `v`
 * held `w` alone.
 */

import { isPattern, isShape, type CoverWords } from "../../tasks/fill/given";
import { JOBS, type Job, type SettingsTable, type SettingValues } from "../../engine/protocol";

export const FRAGMENT_VERSION = 1;

export interface Fragment {
  /** Null where the fragment says nothing at all. */
  readonly job: Job | null;
  readonly code: string | null;
  readonly cover: CoverWords;
  /** As written; see [`known`]. */
  readonly settings: SettingValues;
  /** Whether a newer page wrote it. */
  readonly newer: boolean;
}

export function readFragment(hash: string): Fragment {
  const pairs = new URLSearchParams(hash.replace(/^#/, ""));
  const version = Number(pairs.get("v") ?? FRAGMENT_VERSION);
  const settings: Record<string, string> = {};
  for (const [name, value] of pairs) {
    if (!["v", "w", "job", "shape", "style"].includes(name)) settings[name] = value;
  }
  const job = JOBS.find((job) => job === pairs.get("job")) ?? (pairs.size > 0 ? "multiview" : null);
  const [shape, style] = [pairs.get("shape"), pairs.get("style")];
  const cover = { shape: isShape(shape) ? shape : null, style: isPattern(style) ? style : null };
  return { job, code: pairs.get("w"), cover, settings, newer: !(version <= FRAGMENT_VERSION) };
}

const NOTHING: CoverWords = { shape: null, style: null };

/** Empty where there is nothing to say. */
export function writeFragment(job: Job, code: string | null, settings: SettingValues, { shape, style }: CoverWords = NOTHING): string {
  const covered = `${shape ? `&shape=${shape}` : ""}${shape && style ? `&style=${style}` : ""}`;
  const first = job === "multiview" ? "" : `&job=${job}${job === "fill" ? covered : ""}`;
  const pairs = Object.entries(settings).map(([name, value]) => `&${encodeURIComponent(name)}=${encodeURIComponent(value)}`);
  if (!first && code === null && pairs.length === 0) return "";
  return `#v=${FRAGMENT_VERSION}${first}${code === null ? "" : `&w=${code}`}${pairs.join("")}`;
}

/** The settings that the table knows with values it allows, less those that are as their preset has them. */
export function known(settings: SettingValues, table: SettingsTable): SettingValues {
  const valid = Object.entries(settings).filter(([name, value]) => problemWith(name, value, table) === null);
  const preset = presetOf(Object.fromEntries(valid), table);
  const usual: SettingValues = { ...preset, preset: DEFAULT_PRESET, smooth: table.presets[preset["preset"] ?? DEFAULT_PRESET]?.["smooth"] ?? "" };
  return Object.fromEntries(valid.filter(([name, value]) => value !== usual[name]));
}

export const DEFAULT_PRESET = "best";

/** Every value of the preset that these settings start from; whether the wire is kept smooth chooses among them, too. */
export function presetOf(settings: SettingValues, table: SettingsTable): SettingValues {
  const preset = settings["preset"] ?? DEFAULT_PRESET;
  return table.presets[`${preset}/${settings["smooth"]}`] ?? table.presets[preset] ?? {};
}

/** Why a setting cannot have a value, in words for people; null if it can. */
export function problemWith(name: string, value: string, table: SettingsTable): string | null {
  const row = table.rows.find((row) => row.name === name);
  if (!row) return "there is no such setting";
  switch (row.kind) {
    case "choice":
      return row.choices!.includes(value) ? null : `choose ${row.choices!.join(", ")}`;
    case "switch":
      return value === "true" || value === "false" ? null : "choose on or off";
    default: {
      const number = value.trim() === "" ? NaN : Number(value);
      const whole = row.kind === "integer";
      const fits = number >= row.min! && number <= row.max! && (!whole || Number.isInteger(number));
      return fits ? null : `give a ${whole ? "whole " : ""}number from ${row.min} to ${row.max}`;
    }
  }
}
