import { expect, it } from "vitest";
import { codeFrom, linkTo } from "./link";

it("round-trips a code through an address, whatever fragment that had", () => {
  const link = linkTo("aZ0-_9", "https://example.org/some/path/?a=1#w=old");
  expect(link).toBe("https://example.org/some/path/?a=1#w=aZ0-_9");
  expect(codeFrom(new URL(link).hash)).toBe("aZ0-_9");
});

it("finds no code where there is none", () => {
  expect(codeFrom("")).toBeNull();
  expect(codeFrom("#v=1&x=2")).toBeNull();
});
