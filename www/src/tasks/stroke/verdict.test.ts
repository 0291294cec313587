import { describe, expect, it } from "vitest";
import type { Finished, ViewMeasures } from "../../engine/protocol";
import { freshTrack } from "../../state/keeping/track";
import { verdict } from "./verdict";

type Numbers = readonly [softIou: number, precision?: number, recall?: number];

const view = (name: string, [soft_iou, precision_2px = 1, recall_2px = 1]: Numbers): ViewMeasures => ({
  name, soft_iou, precision_2px, recall_2px, target_coverable: 1, bent: null,
});

function one(numbers: Numbers, { components = 1, settings = {}, stopped = false } = {}): string {
  const measures = { views: [view("front", numbers), view("33,6", [0.2, 0.5, 0.5])], components };
  return verdict({ finished: { measures } as unknown as Finished, source: "run", track: freshTrack("stroke", null, settings), stopped, seconds: 1 });
}

describe("a verdict on one picture", () => {
  it("is about the picture, and not about the sides that nobody gave", () => {
    expect(one([0.95])).toBe("The front matches well, in one piece of wire.");
    expect(one([0.95], { components: 3 })).toBe("The front matches well. The wire is in 3 pieces.");
  });

  it("says what is wrong and what to try", () => {
    expect(one([0.7, 1, 0.9], { settings: { control_points: "60" } })).toBe(
      "The front does not match well yet; 10% of the picture’s lines are missing. More control points draw it more closely.",
    );
    expect(one([0.75, 0.9, 1], { stopped: true })).toMatch(/10% of what it shows is wire between the lines\. It was stopped early/);
    expect(one([0.95], { components: 9, settings: { form: "bag" } })).toMatch(/One smooth wire keeps it together\.$/);
  });
});
