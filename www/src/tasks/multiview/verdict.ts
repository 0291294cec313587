/** What a finished wire amounts to, in words: what is good, what is not, and what to try. */

import { msg, str } from "@lit/localize";
import type { ViewMeasures } from "../../engine/protocol";
import type { Made } from "../../state/keeping/document";
import { comparedViews, flawOf, isGood, nothingToCompare, SEEN, verdictOf, worst, type Flaw } from "../../view/likeness";
import { viewWords } from "../../view/heading";
import { localeTag } from "../../words/language";
import { counted, listed } from "../../words/numbers";
import { sheetsOf, type Papers } from "./given";

export function verdict(made: Made): string {
  const views = comparedViews(made);
  if (views.length === 0) return isByWords(made) ? msg("Words alone pulled it, so there is no drawing to compare with. Another seed or word makes another wire.") : nothingToCompare(made);
  const worstView = worst(views);
  const subject = subjectOf(made, worstView.name);
  const flaw = flawOf(
    worstView,
    subject,
    (share) => msg(str`${share} of ${subject}’s ink is missing`),
    (share) => msg(str`${share} of what ${subject} shows are links that join its parts`),
  );
  return verdictOf(made, views, praise(views.filter(isGood).map(({ name }) => name), views.length), flaw, advice(made, flaw.kind, worstView));
}

/** Nothing was drawn of it. */
const isByWords = ({ track }: Made): boolean => track !== null && track.guide != null && sheetsOf(track.given as Papers).length === 0;

function praise(good: readonly string[], all: number): string {
  if (good.length === all) return all === 2 ? msg("Both views match well") : msg("Every view matches well");
  if (good.length === 0) return msg("No view matches well yet");
  const names = listed(good.map(viewWords));
  const first = names.charAt(0).toLocaleUpperCase(localeTag()) + names.slice(1);
  return counted(good.length, msg(str`${first} matches well`), msg(str`${first} match well`));
}

/** "the star" where the drawing has a name of its own, else "the front drawing". */
function subjectOf({ finished, track }: Made, viewName: string): string {
  const target = finished.targets.find(({ view }) => view.name === viewName);
  const sheets = track ? sheetsOf(track.given as Papers) : [];
  const label = target && sheets[target.source ?? -1]?.paper.label.replace(/\.\w{1,5}$/, "").trim();
  const ownName = label && label.length <= 24 && !/^(drawing|picture|image|photo|front|side|top|untitled|\d+)$/i.test(label);
  return ownName ? msg(str`the ${uncapitalised(label)}`) : msg(str`the ${viewWords(viewName)} drawing`);
}

/** "fish" out of "Fish", but "DNA" stays. */
function uncapitalised(label: string): string {
  return /^\p{Lu}\p{Ll}/u.test(label) ? label.charAt(0).toLowerCase() + label.slice(1) : label;
}

function advice(made: Made, flaw: Flaw["kind"], worst: ViewMeasures): string {
  const settings = made.track?.settings ?? {};
  const preset = settings["preset"] ?? "best";
  if (made.stopped && flaw !== "none") return msg("It was stopped early: going on may still help.");
  if (made.finished.measures.components > 1 && preset === "paper") return msg("Best wire keeps it in one piece.");
  if (flaw === "none") return "";
  if (preset === "fast") return msg("Best wire takes a little longer and matches better.");
  const bend = settings["bend"] ?? (preset === "paper" ? "none" : "little");
  const impossible = (worst.target_coverable ?? 1) < 1 - SEEN;
  if (impossible && bend !== "free") return msg(str`Let the drawings bend freely, or mirror the ${viewWords(worst.name)}.`);
  if (impossible) return msg(str`Try another drawing for the ${viewWords(worst.name)}, or mirror it.`);
  if (flaw === "stray") return msg("Drawings whose parts touch need fewer links.");
  return msg("More steps, or another seed, may help.");
}
