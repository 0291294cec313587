/** What the tab says: how far a run is, for those who look elsewhere meanwhile. */

import type { Phase } from "../../state/studio";
import { percent } from "../../state/common/words";

export const PLAIN_TITLE = "Wire4D: pictures into one wire";

/** `unseen` is whether a run has ended since somebody last looked at the page. */
export function pageTitle(phase: Phase, share: number, unseen: boolean): string {
  if (phase === "paused") return "Paused · Wire4D";
  if (phase !== "idle") return `${percent(share)} · Wire4D`;
  return unseen ? "Done · Wire4D" : PLAIN_TITLE;
}
