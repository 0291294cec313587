import { describe, expect, it } from "vitest";
import type { Finished, Target, ViewMeasures } from "../../engine/protocol";
import type { Made } from "../../state/keeping/document";
import { freshTrack } from "../../state/keeping/track";
import { PAPER_PX, type Paper } from "./paper";
import { NO_PAPERS, type Papers } from "./given";
import { verdict } from "./verdict";

const FULL = new Uint8Array(PAPER_PX * PAPER_PX).fill(255);

type Numbers = readonly [softIou: number | null, precision?: number, recall?: number];

const view = (name: string, [soft_iou, precision_2px = 1, recall_2px = 1]: Numbers, more: Partial<ViewMeasures> = {}): ViewMeasures => ({
  name, soft_iou, precision_2px, recall_2px, target_coverable: 1, bent: null, ...more,
});

function made(views: readonly ViewMeasures[], more: { components?: number; settings?: Record<string, string>; stopped?: boolean; labels?: readonly string[] } = {}): Made {
  const target = (name: string, source: number): Target => ({ view: { name } as Target["view"], source, mirrored: false, quarterTurns: 0, coverable: 1, width: 0, height: 0, ink: new Uint8Array() });
  const finished: Finished = {
    wire: { closed: false, knots: [], controlPoints: [] },
    views: [],
    targets: views.map(({ name }, source) => target(name, source)),
    shown: [],
    measures: { views, components: more.components ?? 1, connectivity_cost: 0, length: 20, control_points: 100, min_width: 0.01, max_width: 0.1 },
    file: new Uint8Array(),
    code: "",
  };
  const paper = (label: string): Paper => ({ layers: [{ kind: "stamp", label, ink: FULL }], label });
  const papers: Papers = { ...NO_PAPERS, ...Object.fromEntries(views.map(({ name }, i) => [name, paper(more.labels?.[i] ?? "Drawing")])) };
  return { finished, source: "run", track: freshTrack("multiview", papers, more.settings ?? {}), stopped: more.stopped ?? false, seconds: 1 };
}

describe("a verdict", () => {
  it("praises what is good, and leaves it at that", () => {
    expect(verdict(made([view("front", [0.9]), view("side", [0.95]), view("top", [0.9])]))).toBe("Every view matches well, in one piece of wire.");
    expect(verdict(made([view("front", [0.9]), view("side", [0.95])]))).toMatch(/^Both views match well,/);
  });

  it("takes thin lines that are off by their own width for a good match", () => {
    expect(verdict(made([view("front", [0.72, 0.96, 0.97]), view("side", [0.9])]))).toMatch(/^Both views match well; 4%/);
    expect(verdict(made([view("front", [0.72, 0.98, 0.94])]))).toContain("No view matches well yet; 6%");
    expect(verdict(made([view("front", [0.6, 0.98, 0.98])]))).toContain("hard to recognise");
  });

  it("names missing ink by the drawing's own name, and what to try", () => {
    const views = [view("front", [0.9]), view("side", [0.92]), view("top", [0.7, 0.99, 0.94], { target_coverable: 0.9 })];
    expect(verdict(made(views, { labels: ["bird.png", "bike.png", "Star.png"] }))).toBe(
      "Front and side match well; 6% of the star’s ink is missing. Let the drawings bend freely, or mirror the top.",
    );
    expect(verdict(made(views, { settings: { bend: "free" } }))).toContain("Try another drawing for the top");
    expect(verdict(made(views))).toContain("6% of the top drawing’s ink");
  });

  it("names links that show", () => {
    expect(verdict(made([view("front", [0.7, 0.9, 1]), view("side", [0.9])]))).toBe(
      "Side matches well; 10% of what the front drawing shows are links that join its parts. Drawings whose parts touch need fewer links.",
    );
  });

  it("says when nothing matches, counts pieces, and knows the preset", () => {
    const words = verdict(made([view("front", [0.4, 0.99, 0.99]), view("side", [0.5])], { components: 34, settings: { preset: "paper" } }));
    expect(words).toBe("No view matches well yet; the front drawing is hard to recognise (40%). The wire is in 34 pieces. Best wire keeps it in one piece.");
    expect(verdict(made([view("front", [0.6])], { settings: { preset: "fast" } }))).toContain("Best wire takes a little longer");
    expect(verdict(made([view("front", [0.6])], { stopped: true }))).toContain("stopped early");
  });

  it("counts the match with the bent drawings, and says that they were bent", () => {
    const bent = (mean_px: number) => ({ bent: { soft_iou: 0.9, precision_2px: 1, recall_2px: 1, mean_px } });
    expect(verdict(made([view("front", [0.7, 0.8, 0.8], bent(5.52))]))).toBe(
      "Every view matches well, in one piece of wire. To agree, lines moved by 5.5 of 256 pixels.",
    );
    expect(verdict(made([view("front", [0.7, 0.8, 0.8], bent(1.3))]))).not.toContain("moved");
  });

  it("has nothing to compare in a wire from a link", () => {
    expect(verdict(made([view("front", [null])]))).toBe("One piece of wire. Its drawings are not with it, so there is nothing to compare.");
    expect(verdict({ ...made([view("front", [null])]), carried: true })).toBe("One piece of wire. It is compared with its drawings when it is made again.");
  });
});
