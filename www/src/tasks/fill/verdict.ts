/** What a wire that covers a shape amounts to, in words: how evenly it lies, and what to try. */

import type { Made } from "../../state/keeping/document";
import type { Cover } from "./given";
import { percent } from "../../state/common/words";

/** Off the surface by more than this, and what is in front and what is behind begins to blur, world units. */
const SEEN_WORLD = 0.05;
/** A line nearer than half of their distance to its neighbour, for more than this share of the wire. */
const CROWDED = 0.03;

/** In hundredths of the shape's size, which is two units. */
export const worldLength = (world: number): string => `${(50 * world).toFixed(1)}%`;

const styled = ({ track }: Made): boolean => track !== null && (track.given as Cover).style !== null;

export function verdict(made: Made): string {
  const { measures } = made.finished;
  const { surface } = measures;
  const apart = measures.components > 1 ? `The wire is in ${measures.components} pieces.` : "";
  const why = made.carried ? "It is measured when it is made again." : "Its shape is not with it, so there is nothing to measure it by.";
  if (!surface) return apart || `One closed wire. ${why}`;
  const worst = worldLength(surface.worst * surface.spacing);
  const sentences = [
    `${apart || "The wire is one closed loop."} No spot is farther from it than ${worst} of the shape’s size.`,
    surface.drift_max > SEEN_WORLD ? `It leaves the surface by up to ${worldLength(surface.drift_max)}: less style, or a stronger pull to the surface, keeps it there.` : "",
    surface.crowded > CROWDED ? `Along ${percent(surface.crowded)} of it, ${styled(made) ? "the style draws lines close together" : "lines come close to each other"}.` : "",
    made.stopped ? "It was stopped early: going on may still help." : "",
  ];
  return sentences.filter(Boolean).join(" ");
}
