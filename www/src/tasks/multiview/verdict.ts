/** What a finished wire amounts to, in words: what is good, what is not, and what to try. */

import type { ViewMeasures } from "../../engine/protocol";
import type { Made } from "../../state/keeping/document";
import { covered } from "../fill/verdict";
import { percent } from "../../state/common/words";

const GOOD = 0.82;
const FAIR = 0.65;
/** A thin line that is off by its own width reads the same: it is enough if so much of wire and drawing is within two pixels. */
const NEAR = 0.95;
/** Ink missing, or wire beside the drawing, of less than this share nobody sees. */
const SEEN = 0.03;
/** Bending of less than this, in pixels of 256, changes no drawing's look. */
const SEEN_PX = 2;

/** How well a view matches what the wire was asked for: the drawing as it was bent, or as given. */
export function match(view: ViewMeasures): number | null {
  return view.bent?.soft_iou ?? view.soft_iou;
}

export function verdict(made: Made): string {
  if (made.track?.given.job === "fill") return covered(made);
  const { measures } = made.finished;
  const views = measures.views.flatMap((view) => {
    const value = match(view);
    return value === null ? [] : [{ ...view, value, ...(view.bent ?? {}) }];
  });
  if (views.length === 0) return `${pieces(measures.components)}. Its drawings are not with it, so there is nothing to compare.`;
  // Sides that nobody gave have no picture to be like.
  const ofOne = made.track?.given.job === "stroke";
  const given = ofOne ? views.slice(0, 1) : views;
  const worst = given.reduce((a, b) => (b.value < a.value ? b : a));
  const flaw = flawOf(worst, ofOne ? "the picture" : subject(made, worst.name), ofOne);
  const good = praise(given.filter(isGood).map(({ name }) => name), given.length, ofOne);
  const apart = measures.components > 1;
  const sentences = [
    `${good}${flaw.words ? `; ${flaw.words}` : apart ? "" : ", in one piece of wire"}.`,
    apart ? `The wire is in ${measures.components} pieces.` : "",
    bending(given),
    ofOne ? adviceForOne(made, flaw.kind) : advice(made, flaw.kind, worst),
  ];
  return sentences.filter(Boolean).join(" ");
}

type Compared = { value: number; precision_2px: number | null; recall_2px: number | null };

function isGood({ value, precision_2px, recall_2px }: Compared): boolean {
  return value >= GOOD || (value >= FAIR && Math.min(precision_2px ?? 0, recall_2px ?? 0) >= NEAR);
}

function pieces(count: number): string {
  return count === 1 ? "One piece of wire" : `${count} pieces of wire`;
}

function praise(good: readonly string[], all: number, ofOne: boolean): string {
  if (ofOne) return good.length ? "The front matches well" : "The front does not match well yet";
  if (good.length === all) return all === 2 ? "Both views match well" : "Every view matches well";
  if (good.length === 0) return "No view matches well yet";
  const names = good.length === 1 ? good[0]! : `${good.slice(0, -1).join(", ")} and ${good.at(-1)!}`;
  return `${names.charAt(0).toUpperCase()}${names.slice(1)} ${good.length === 1 ? "matches" : "match"} well`;
}

type Flaw = "none" | "missing" | "stray" | "unclear";

function flawOf(view: Compared, subject: string, ofOne: boolean): { kind: Flaw; words: string } {
  const missing = 1 - (view.recall_2px ?? 1);
  const stray = 1 - (view.precision_2px ?? 1);
  if (missing >= SEEN && missing >= stray) return { kind: "missing", words: `${percent(missing)} of ${subject}’s ${ofOne ? "lines are" : "ink is"} missing` };
  if (stray >= SEEN && ofOne) return { kind: "stray", words: `${percent(stray)} of what it shows is wire between the lines` };
  if (stray >= SEEN) return { kind: "stray", words: `${percent(stray)} of what ${subject} shows are links that join its parts` };
  if (view.value < FAIR) return { kind: "unclear", words: `${subject} is hard to recognise (${percent(view.value)})` };
  if (!isGood(view)) return { kind: "unclear", words: `${subject} matches fairly well (${percent(view.value)})` };
  return { kind: "none", words: "" };
}

/** "the star" where the drawing has a name of its own, else "the front drawing". */
function subject(made: Made, viewName: string): string {
  const target = made.finished.targets.find(({ view }) => view.name === viewName);
  const sheets = made.track?.given.job === "multiview" ? made.track.given.sheets : [];
  const label = target && sheets[target.source ?? -1]?.paper.label.replace(/\.\w{1,5}$/, "").trim();
  const ownName = label && label.length <= 24 && !/^(drawing|picture|image|photo|front|side|top|untitled|\d+)$/i.test(label);
  return ownName ? `the ${uncapitalised(label)}` : `the ${viewName} drawing`;
}

/** "fish" out of "Fish", but "DNA" stays. */
function uncapitalised(label: string): string {
  return /^\p{Lu}\p{Ll}/u.test(label) ? label.charAt(0).toLowerCase() + label.slice(1) : label;
}

function bending(views: readonly ViewMeasures[]): string {
  const mostPx = Math.max(...views.map(({ bent }) => bent?.mean_px ?? 0));
  return mostPx > SEEN_PX ? `To agree, lines moved by ${mostPx.toFixed(1)} of 256 pixels.` : "";
}

function advice(made: Made, flaw: Flaw, worst: ViewMeasures): string {
  const settings = made.track?.settings ?? {};
  const preset = settings["preset"] ?? "best";
  if (made.stopped && flaw !== "none") return "It was stopped early: going on may still help.";
  if (made.finished.measures.components > 1 && preset === "paper") return "Best wire keeps it in one piece.";
  if (flaw === "none") return "";
  if (preset === "fast") return "Best wire takes a little longer and matches better.";
  const bend = settings["bend"] ?? (preset === "paper" ? "none" : "little");
  const impossible = (worst.target_coverable ?? 1) < 1 - SEEN;
  if (impossible && bend !== "free") return `Let the drawings bend freely, or mirror the ${worst.name}.`;
  if (impossible) return `Try another drawing for the ${worst.name}, or mirror it.`;
  if (flaw === "stray") return "Drawings whose parts touch need fewer links.";
  return "More steps, or another seed, may help.";
}

function adviceForOne(made: Made, flaw: Flaw): string {
  const settings = made.track?.settings ?? {};
  if (made.stopped && flaw !== "none") return "It was stopped early: going on may still help.";
  if (made.finished.measures.components > 1 && (settings["form"] ?? "wire") !== "wire") return "One smooth wire keeps it together.";
  if (flaw === "none") return "";
  if (settings["preset"] === "paper" || settings["preset"] === "fast") return "Best wire takes a little longer and matches better.";
  if (Number(settings["control_points"] ?? 0) > 0) return "More control points draw it more closely.";
  return "More steps, or another seed, may help.";
}
