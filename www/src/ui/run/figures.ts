/** Numbers about a wire, in words. */

import { msg } from "@lit/localize";
import type { Made } from "../../state/studio";
import { count, decimal, percent } from "../../words/numbers";
import type { Figure } from "../shared/page-task";

/** What nobody knows yet. */
export const DASH = "–";

/** Of every wire; of one that forms, only its points are known. */
export function figuresOf(made: Made | null, forming: number): readonly Figure[] {
  const measures = made?.finished.measures;
  const points = measures?.control_points ?? forming;
  return [
    [msg("Pieces"), measures ? count(measures.components) : DASH],
    [msg("Length"), measures ? decimal(measures.length, 1) : DASH],
    [msg("Control points"), points ? count(points) : DASH],
    [msg("Over its lines"), known(measures?.length_over_lines, (ratio) => `${decimal(ratio, 2)} ×`)],
    [msg("Turning"), known(measures?.turning_per_unit, (turning) => decimal(turning, 1))],
    [msg("Kinks"), known(measures?.kinks, count)],
    [msg("Bent tightly"), known(measures?.tight_share, percent)],
    [msg("Touching"), known(measures?.touching_share, percent)],
    [msg("Within itself"), known(measures?.penetrating_share, percent)],
    [msg("Time"), made?.seconds ? `${decimal(made.seconds, 1)} s` : DASH],
  ];
}

function known(value: number | null | undefined, words: (value: number) => string): string {
  return value == null ? DASH : words(value);
}
