/** What a finished wire amounts to, in words. */

import type { Finished, ViewMeasures } from "../engine/protocol";
import { percent } from "../state/words";

const GOOD = 0.82;
const FAIR = 0.65;
/** Bending of less than this, in pixels of 256, nobody sees. */
const SEEN_PX = 0.3;

/** How well a view matches what the wire was asked for: the drawing as it was bent, or as given. */
export function match(view: ViewMeasures): number | null {
  return view.bent?.soft_iou ?? view.soft_iou;
}

export function verdict({ measures }: Finished): string {
  const pieces = measures.components === 1 ? "One piece of wire" : `${measures.components} pieces of wire`;
  const views = measures.views.flatMap((view) => {
    const value = match(view);
    return value === null ? [] : [{ ...view, value }];
  });
  if (views.length === 0) return `${pieces}, from a link.`;
  const worst = views.reduce((a, b) => (b.value < a.value ? b : a));
  const weak = views.filter((view) => view.value < GOOD).length;
  const bentPx = Math.max(...views.map((view) => view.bent?.mean_px ?? 0));
  const bent = bentPx > SEEN_PX ? ` To agree, the drawings were bent by ${bentPx.toFixed(1)} of 256 pixels.` : "";
  if (weak === 0) return `${pieces}, and every view matches well.${bent}`;
  const how = worst.value < FAIR ? "is hard to recognise" : "matches fairly well";
  const others = weak === 1 ? "The other views match well, but the" : weak < views.length ? "Another view matches well; the" : "The";
  return `${pieces}. ${others} ${worst.name} ${how} (${percent(worst.value)}).${bent}`;
}
