/** What a finished wire amounts to, in words: what is good, what is not, and what to try. */

import type { Made } from "../../state/keeping/document";
import { comparedViews, flawOf, isGood, nothingToCompare, verdictOf, type Flaw } from "../../view/likeness";

export function verdict(made: Made): string {
  // Sides that nobody gave have no picture to be like.
  const [front] = comparedViews(made);
  if (!front) return nothingToCompare(made);
  const flaw = flawOf(
    front,
    "the picture",
    (share) => `${share} of the picture’s lines are missing`,
    (share) => `${share} of what it shows is wire between the lines`,
  );
  return verdictOf(made, [front], isGood(front) ? "The front matches well" : "The front does not match well yet", flaw, advice(made, flaw.kind));
}

function advice(made: Made, flaw: Flaw["kind"]): string {
  const settings = made.track?.settings ?? {};
  if (made.stopped && flaw !== "none") return "It was stopped early: going on may still help.";
  if (made.finished.measures.components > 1 && (settings["form"] ?? "wire") !== "wire") return "One smooth wire keeps it together.";
  if (flaw === "none") return "";
  if (settings["preset"] === "paper" || settings["preset"] === "fast") return "Best wire takes a little longer and matches better.";
  if (Number(settings["control_points"] ?? 0) > 0) return "More control points draw it more closely.";
  return "More steps, or another seed, may help.";
}
