/** Numbers about a wire, in words. */

import type { Made } from "../../state/studio";
import { count } from "../../state/common/count";
import { percent } from "../../state/common/words";
import type { Figure } from "../shared/page-task";

/** What nobody knows yet. */
export const DASH = "–";

/** Of every wire; of one that forms, only its points are known. */
export function figuresOf(made: Made | null, forming: number): readonly Figure[] {
  const measures = made?.finished.measures;
  const points = measures?.control_points ?? forming;
  return [
    ["Pieces", measures ? count(measures.components) : DASH],
    ["Length", measures ? measures.length.toFixed(1) : DASH],
    ["Control points", points ? count(points) : DASH],
    ["Over its lines", known(measures?.length_over_lines, (ratio) => `${ratio.toFixed(2)} ×`)],
    ["Turning", known(measures?.turning_per_unit, (turning) => turning.toFixed(1))],
    ["Kinks", known(measures?.kinks, count)],
    ["Bent tightly", known(measures?.tight_share, percent)],
    ["Touching", known(measures?.touching_share, percent)],
    ["Within itself", known(measures?.penetrating_share, percent)],
    ["Time", made?.seconds ? `${made.seconds.toFixed(1)} s` : DASH],
  ];
}

function known(value: number | null | undefined, words: (value: number) => string): string {
  return value == null ? DASH : words(value);
}
