/** What a finished wire amounts to, in words: what is good, what is not, and what to try. */

import { msg, str } from "@lit/localize";
import type { Made } from "../../state/keeping/document";
import { comparedViews, flawOf, isGood, nothingToCompare, verdictOf, type Flaw } from "../../view/likeness";

export function verdict(made: Made): string {
  // Sides that nobody gave have no picture to be like.
  const [front] = comparedViews(made);
  if (!front) return nothingToCompare(made);
  const flaw = flawOf(
    front,
    msg("the picture"),
    (share) => msg(str`${share} of the picture’s lines are missing`),
    (share) => msg(str`${share} of what it shows is wire between the lines`),
  );
  return verdictOf(made, [front], isGood(front) ? msg("The front matches well") : msg("The front does not match well yet"), flaw, advice(made, flaw.kind));
}

function advice(made: Made, flaw: Flaw["kind"]): string {
  const settings = made.track?.settings ?? {};
  if (made.stopped && flaw !== "none") return msg("It was stopped early: going on may still help.");
  if (made.finished.measures.components > 1 && (settings["form"] ?? "wire") !== "wire") return msg("One smooth wire keeps it together.");
  if (flaw === "none") return "";
  if (settings["preset"] === "paper" || settings["preset"] === "fast") return msg("Best wire takes a little longer and matches better.");
  if (Number(settings["control_points"] ?? 0) > 0) return msg("More control points draw it more closely.");
  return msg("More steps, or another seed, may help.");
}
