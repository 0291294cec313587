import { expect, it } from "vitest";
import { altOf, titleOf } from "./wire-words";

it("calls a wire after its drawings", () => {
  expect(titleOf(["Cat", "bird.png", "My fish.webp"])).toBe("Cat, bird, and My fish");
  expect(titleOf([])).toBe("A wire");
  expect(altOf(["Cat", "Bird"])).toBe("One continuous wire that shows: Cat and Bird");
});
