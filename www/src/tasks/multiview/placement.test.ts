import { expect, it } from "vitest";
import { placement } from "./placement";

it("says where a drawing went only if it was moved", () => {
  const target = (name: string, mirrored: boolean, quarterTurns: number): Parameters<typeof placement>[1] => ({
    view: { name } as Parameters<typeof placement>[1]["view"], mirrored, quarterTurns,
  });
  expect(placement("front", target("front", false, 0))).toBe("");
  expect(placement("front", target("top", true, 2))).toBe("Seen from the top, mirrored, upside down.");
});
