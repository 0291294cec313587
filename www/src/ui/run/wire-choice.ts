/** How much of a wire the wire is: from one that follows every line of the pictures to a calm one. */

import { msg } from "@lit/localize";
import { nothing } from "lit";
import { isHidden, isSettingLocked } from "../../state/common/locks";
import type { Studio, StudioState } from "../../state/studio";
import { segmented } from "../shared/segmented";

/** What it sets. */
const SETTINGS = ["smooth", "smoothness"] as const;
const LINES = "lines";
/** Words and weight of bending, by choice. */
const CHOICES: Readonly<Record<string, readonly [words: string, smoothness: string]>> = {
  [LINES]: [msg("Every line"), "1"],
  close: [msg("Close"), "0.3"],
  even: [msg("Smooth"), "1"],
  calm: [msg("Calm"), "4"],
};

export function wireChoice(studio: Studio, state: StudioState) {
  if (SETTINGS.some((name) => isHidden(state, name))) return nothing;
  const { options } = studio;
  const smoothness = Number(options.value("smoothness") || 1);
  const nearest = Object.keys(CHOICES)
    .slice(1)
    .reduce((a, b) => (ratio(b, smoothness) < ratio(a, smoothness) ? b : a));
  return segmented({
    legend: msg("Wire"),
    name: "wire",
    options: Object.entries(CHOICES).map(([value, [words]]) => ({ value, words })),
    value: options.value("smooth") === "off" ? LINES : nearest,
    locked: state.phase !== "idle" || SETTINGS.some((name) => isSettingLocked(state, name)),
    choose: (value) => options.setAll({ smooth: value === LINES ? "off" : "on", smoothness: CHOICES[value]![1] }, msg("Set the wire"), "set wire"),
  });
}

/** How far a weight is from a choice's. */
function ratio(choice: string, smoothness: number): number {
  return Math.abs(Math.log(Number(CHOICES[choice]![1]) / Math.max(smoothness, 1e-3)));
}
