import { expect, it } from "vitest";
import { faultWords } from "./faults";

it("counts the places where a wire fails", () => {
  expect(faultWords("tight", 0)).toBe("nowhere tighter than a hand can bend");
  expect(faultWords("tight", 1)).toBe("tighter than a hand can bend in 1 place");
  expect(faultWords("tight", 1200)).toBe("tighter than a hand can bend in 1,200 places");
  expect(faultWords("penetrating", 0)).toBe("nowhere through itself");
  expect(faultWords("penetrating", 3)).toBe("passes through itself in 3 places");
});
