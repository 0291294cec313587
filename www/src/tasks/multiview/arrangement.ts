/** Where arranging took a drawing, in words. */

import { msg, str } from "@lit/localize";
import { asSentence } from "../../words/sentences";
import type { DrawingPreview } from "../../engine/protocol";
import { viewWords } from "../../view/heading";
import type { Slot } from "./given";

/** Where a drawing went, as far as that is not simply where it was put. */
export function arrangement(slot: string, target: Pick<DrawingPreview, "view" | "mirrored" | "quarterTurns">): string {
  const turned = ["", msg("turned left"), msg("upside down"), msg("turned right")][target.quarterTurns % 4]!;
  const seen = target.view.name === slot ? "" : msg(str`seen from the ${viewWords(target.view.name)}`);
  const words = [seen, target.mirrored ? msg("mirrored") : "", turned].filter(Boolean).join(", ");
  return words && asSentence(words);
}

/** Where arranging took a drawing, as a short aside: "from the top, mirrored". */
export const movedBy = (slot: Slot, preview: DrawingPreview): string => arrangement(slot, preview).replace(/^Seen f/, "F").replace(/\.$/, "").toLowerCase();
