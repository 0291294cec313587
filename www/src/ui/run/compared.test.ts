import { expect, it } from "vitest";
import type { Finished } from "../../engine/protocol";
import type { Made } from "../../state/keeping/document";
import { freshTrack } from "../../state/keeping/track";
import { compared, gapOf, meanMatch, weighed } from "./compared";

type Numbers = readonly [front: number, side: number, pieces: number, gap: number];

function made([front, side, components, connectivity_cost]: Numbers, { stopped = false } = {}): Made {
  const view = (name: string, soft_iou: number) => ({ name, soft_iou, precision_2px: 1, recall_2px: 1, target_coverable: null, bent: null });
  const measures = { views: [view("front", front), view("33,6", side)], components, connectivity_cost, length: 10, control_points: 40, min_width: 0.01, max_width: 0.02 };
  return { finished: { measures } as unknown as Finished, source: "run", track: freshTrack("knit", null, {}), stopped, seconds: 1 };
}

it("says in what they differ: match, pieces and what it would take to join them", () => {
  const wire = made([0.95, 0.2, 1, 0]);
  expect(compared(wire, made([0.94, 0.9, 212, 2.5]), 1)).toBe(
    "Both match about as well. Loose strokes fall into 212 pieces, the wire is one. To join them would take 25% more wire.",
  );
  expect(compared(wire, made([0.99, 0.2, 1, 0]), 1)).toBe("Loose strokes match better. Both are in one piece.");
  expect(compared(wire, made([0.8, 0.2, 3, 0], { stopped: true }), 1)).toMatch(/^The wire matches better\..*stopped early\.$/);
});

it("weighs a wire that was made another way: match, length, tight bends, passing through itself", () => {
  const than = (made: Made, more: object): Made => ({ ...made, finished: { ...made.finished, measures: { ...made.finished.measures, ...more } } });
  const wire = than(made([0.9, 0.2, 1, 0]), { tight_share: 0.05, penetrating_share: 0.1 });
  expect(weighed(wire, wire, 1)).toBe("Both match about as well.");
  expect(weighed(wire, than(wire, { length: 12, tight_share: 0.02, penetrating_share: 0.3 }), 1)).toBe(
    "Both match about as well. It is 20% longer. It bends tightly less often. It passes through itself more often.",
  );
  expect(weighed(wire, than(made([0.8, 0.2, 1, 0], { stopped: true }), { length: 9, tight_share: 0.2, penetrating_share: 0.1 }), 1)).toBe(
    "The other wire matches worse: 80%, not 90%. It is 10% shorter. It bends tightly more often. It was stopped early.",
  );
});

it("counts the views that a picture was given for", () => {
  expect(meanMatch(made([0.9, 0.5, 1, 0]), 1)).toBe(0.9);
  expect(meanMatch(made([0.9, 0.5, 1, 0]), 3)).toBeCloseTo(0.7);
});

it("has no gap in one piece", () => {
  expect([gapOf(made([1, 1, 1, 0])), gapOf(made([1, 1, 2, 5]))]).toEqual([0, 0.5]);
});
