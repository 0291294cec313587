/** What a person typed for a setting: whether it is possible, and if not, what would be. */

import { msg, str } from "@lit/localize";
import type { SettingRow } from "../../engine/protocol";
import { count } from "../../words/numbers";

/** Empty where the value is possible. */
export function refusal(row: SettingRow, text: string): string {
  if (row.kind !== "integer" && row.kind !== "number") return "";
  const number = Number(text);
  const [min, max] = [row.min ?? -Infinity, row.max ?? Infinity];
  const whole = row.kind === "integer";
  const possible = text.trim() !== "" && Number.isFinite(number) && number >= min && number <= max && (!whole || Number.isInteger(number));
  if (possible) return "";
  return whole ? msg(str`Give a whole number from ${count(min)} to ${count(max)}.`) : msg(str`Give a number from ${count(min)} to ${count(max)}.`);
}

/** Whether it is a yes or no: a switch, or a choice of on and off. */
export function isSwitch(row: SettingRow): boolean {
  return row.kind === "switch" || (row.kind === "choice" && row.choices?.length === 2 && row.choices.includes("on") && row.choices.includes("off"));
}

export const isOn = (value: string): boolean => value === "on" || value === "true";

/** The text the core takes for a yes or no. */
export function switched(row: SettingRow, on: boolean): string {
  if (row.kind === "choice") return on ? "on" : "off";
  return on ? "true" : "false";
}
