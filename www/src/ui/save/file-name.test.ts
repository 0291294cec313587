import { expect, it } from "vitest";
import { fileStem } from "./file-name";

it("makes a name of the drawings' names", () => {
  expect(fileStem(["Bird.png", "star", "My bike!"])).toBe("bird-star-my-bike");
  expect(fileStem(["", "…", "🦊"])).toBe("wire");
  expect(fileStem([])).toBe("wire");
});

it("lets nothing through that a file system minds", () => {
  expect(fileStem(["../../etc/passwd", "C:\\con<>|?*.png", "龍"])).toBe("etc-passwd-c-con-龍");
  expect(fileStem(["a".repeat(300)])).toHaveLength(24);
});
