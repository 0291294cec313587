import { expect, it } from "vitest";
import type { Finished } from "../engine/protocol";
import { verdict } from "./verdict";

const made = (matches: Record<string, number | null>, components = 1, mean_px: number | null = null): Finished => ({
  wire: { closed: false, knots: [], controlPoints: [] },
  views: [],
  targets: [],
  measures: {
    views: Object.entries(matches).map(([name, soft_iou]) => ({
      name,
      soft_iou,
      bent: mean_px === null || soft_iou === null ? null : { soft_iou: soft_iou + 0.05, mean_px },
    })),
    components,
    length: 20,
    control_points: 100,
  },
});

it("praises what is good and names what is weakest", () => {
  expect(verdict(made({ front: 0.9, side: 0.95 }))).toBe("One piece of wire, and every view matches well.");
  expect(verdict(made({ front: 0.9, side: 0.5, top: 0.9 }))).toContain("the side is hard to recognise (50%)");
  expect(verdict(made({ front: 0.8, side: 0.75, top: 0.9 }, 2))).toContain("2 pieces of wire. Another view matches well; the side matches fairly well (75%)");
});

it("counts the match with the bent drawings, and says that they were bent", () => {
  const words = verdict(made({ front: 0.8, side: 0.79 }, 1, 1.42));
  expect(words).toContain("every view matches well");
  expect(words).toContain("by 1.4 of 256 pixels");
  expect(verdict(made({ front: 0.8, side: 0.79 }, 1, 0.1))).not.toContain("bent");
});

it("has nothing to compare in a wire from a link", () => {
  expect(verdict(made({ front: null }))).toBe("One piece of wire, from a link.");
});
