/** What the tab says: how far a run is, for those who look elsewhere meanwhile. */

import { msg } from "@lit/localize";
import type { Phase } from "../../state/studio";
import { percent } from "../../words/numbers";

export const PLAIN_TITLE = msg("Wire4D: pictures into one wire");

/** `unseen` is whether a run has ended since somebody last looked at the page. */
export function pageTitle(phase: Phase, share: number, unseen: boolean): string {
  if (phase === "paused") return msg("Paused · Wire4D");
  if (phase !== "idle") return `${percent(share)} · Wire4D`;
  return unseen ? msg("Done · Wire4D") : PLAIN_TITLE;
}
