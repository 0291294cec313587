/** Values of settings: which a table allows, and which it takes where nobody has chosen. */

import { msg, str } from "@lit/localize";
import type { SettingsTable, SettingValues } from "../../engine/protocol";

/** The settings that the table knows with values it allows, less those that are as their preset has them. */
export function known(settings: SettingValues, table: SettingsTable): SettingValues {
  const valid = Object.entries(settings).filter(([name, value]) => problemWith(name, value, table) === null);
  const preset = presetOf(Object.fromEntries(valid), table);
  const usual: SettingValues = { ...preset, preset: DEFAULT_PRESET, smooth: table.presets[preset["preset"] ?? DEFAULT_PRESET]?.["smooth"] ?? "" };
  return Object.fromEntries(valid.filter(([name, value]) => !isSame(value, usual[name])));
}

/** Programs write one number in several ways. */
function isSame(value: string, other = ""): boolean {
  return value === other || (value !== "" && other !== "" && Number(value) === Number(other));
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
  if (!row) return msg("there is no such setting");
  switch (row.kind) {
    case "choice":
      return row.choices!.includes(value) ? null : msg(str`choose ${row.choices!.join(", ")}`);
    case "switch":
      return value === "true" || value === "false" ? null : msg("choose on or off");
    default: {
      const number = value.trim() === "" ? NaN : Number(value);
      const whole = row.kind === "integer";
      const fits = number >= row.min! && number <= row.max! && (!whole || Number.isInteger(number));
      return fits ? null : whole ? msg(str`give a whole number from ${row.min} to ${row.max}`) : msg(str`give a number from ${row.min} to ${row.max}`);
    }
  }
}
