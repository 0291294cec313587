import { expect, it } from "vitest";
import type { Made } from "../../state/studio";
import { description } from "./description";

const view = (name: string, recall: number | null, bent: number | null = null) => ({ name, recall_2px: recall, bent: bent === null ? null : { recall_2px: bent } });
const made = (components: number, views: readonly unknown[], targets: readonly unknown[]): Made => ({ finished: { measures: { components, views }, targets } }) as unknown as Made;

it("tells what each view shows, by the name of what was given there, and how much of it", () => {
  const targets = [{ view: { name: "front" }, source: 1 }, { view: { name: "side" }, source: 0 }, { view: { name: "top" }, source: null }];
  const wire = made(1, [view("front", 0.5, 0.873), view("side", 0.97), view("top", 0.4)], targets);
  expect(description(wire, ["Bird.png", "cat"])).toBe("The wire in 3D: one piece of wire; front: cat, 87% of it shows; side: Bird, 97% of it shows; top: its picture, 40% of it shows.");
});

it("tells of a wire without its pictures, and of none", () => {
  expect(description(made(3, [view("front", null)], []), [])).toBe("The wire in 3D: 3 pieces of wire.");
  expect(description(null, ["cat"])).toBeNull();
});
