/** Where arranging took a drawing, in words. */

import { asSentence } from "../../state/common/words";
import type { DrawingPreview } from "../../engine/protocol";
import type { Slot } from "./given";

/** Where a drawing went, as far as that is not simply where it was put. */
export function arrangement(slot: string, target: Pick<DrawingPreview, "view" | "mirrored" | "quarterTurns">): string {
  const turned = ["", "turned left", "upside down", "turned right"][target.quarterTurns % 4]!;
  const seen = target.view.name === slot ? "" : `seen from the ${target.view.name}`;
  const words = [seen, target.mirrored ? "mirrored" : "", turned].filter(Boolean).join(", ");
  return words && asSentence(words);
}

/** Where arranging took a drawing, as a short aside: "from the top, mirrored". */
export const movedBy = (slot: Slot, preview: DrawingPreview): string => arrangement(slot, preview).replace(/^Seen f/, "F").replace(/\.$/, "").toLowerCase();
