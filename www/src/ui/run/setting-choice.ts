/** A setting of few words, as a row of them. */

import { nothing } from "lit";
import { isHidden, isSettingLocked } from "../../state/common/locks";
import type { Studio, StudioState } from "../../state/studio";
import { WORDS } from "../settings/setting-words";
import { segmented } from "../shared/segmented";

/** `usual` is shown until the core has told its settings. */
export function settingChoice(studio: Studio, state: StudioState, name: string, usual: string) {
  if (isHidden(state, name)) return nothing;
  const { label, choices = {} } = WORDS[name]!;
  return segmented({
    legend: label,
    name,
    options: Object.entries(choices).map(([value, words]) => ({ value, words })),
    value: studio.options.value(name) || usual,
    locked: state.phase !== "idle" || isSettingLocked(state, name),
    choose: (value) => studio.options.set(name, value),
  });
}
