/** What a wire that covers a shape amounts to, in words: how evenly it lies, and what to try. */

import { msg, str } from "@lit/localize";
import type { Made } from "../../state/keeping/document";
import type { Cover } from "./given";
import { decimal, percent } from "../../words/numbers";

/** Off the surface by more than this, and what is in front and what is behind begins to blur, world units. */
const SEEN_WORLD = 0.05;
/** A line nearer than half of their distance to its neighbour, for more than this share of the wire. */
const CROWDED = 0.03;

/** In hundredths of the shape's size, which is two units. */
export const worldLength = (world: number): string => `${decimal(50 * world, 1)}%`;

const styled = ({ track }: Made): boolean => track !== null && (track.given as Cover).style !== null;

export function verdict(made: Made): string {
  const { measures } = made.finished;
  const { surface } = measures;
  const apart = measures.components > 1 ? msg(str`The wire is in ${measures.components} pieces.`) : "";
  const why = made.carried ? msg("It is measured when it is made again.") : msg("Its shape is not with it, so there is nothing to measure it by.");
  if (!surface) return apart || msg(str`One closed wire. ${why}`);
  const worst = worldLength(surface.worst * surface.spacing);
  const sentences = [
    msg(str`${apart || msg("The wire is one closed loop.")} No spot is farther from it than ${worst} of the shape’s size.`),
    surface.drift_max > SEEN_WORLD ? msg(str`It leaves the surface by up to ${worldLength(surface.drift_max)}: less style, or a stronger pull to the surface, keeps it there.`) : "",
    surface.crowded > CROWDED ? msg(str`Along ${percent(surface.crowded)} of it, ${styled(made) ? msg("the style draws lines close together") : msg("lines come close to each other")}.`) : "",
    made.stopped ? msg("It was stopped early: going on may still help.") : "",
  ];
  return sentences.filter(Boolean).join(" ");
}
