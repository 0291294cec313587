import { expect, it } from "vitest";
import { arrangement } from "./arrangement";

it("says where a drawing went only if it was moved", () => {
  const target = (name: string, mirrored: boolean, quarterTurns: number): Parameters<typeof arrangement>[1] => ({
    view: { name } as Parameters<typeof arrangement>[1]["view"], mirrored, quarterTurns,
  });
  expect(arrangement("front", target("front", false, 0))).toBe("");
  expect(arrangement("front", target("top", true, 2))).toBe("Seen from the top, mirrored, upside down.");
});
