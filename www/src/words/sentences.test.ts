import { expect, it, vi } from "vitest";
import { Problem } from "../engine/client";
import { asSentence, explain, timeLeft } from "./sentences";

it("makes sentences of what the core says", () => {
  expect(asSentence("front.png: is blank; draw something in it")).toBe("front.png: is blank; draw something in it.");
  expect(asSentence("share code: it is damaged; copy the link again")).toBe("Share code: it is damaged; copy the link again.");
  expect(asSentence(" Done! ")).toBe("Done!");
});

it("keeps what was not meant for people to the console", () => {
  const log = vi.spyOn(console, "error").mockImplementation(() => undefined);
  expect(explain(new TypeError("x is undefined"), "The file")).toBe("The file did not work out. Nothing is lost; please try again.");
  expect(log).toHaveBeenCalledOnce();
  expect(explain(new Problem("too large"), "The file")).toBe("Too large.");
  log.mockRestore();
});

it("counts seconds, then minutes", () => {
  expect(timeLeft(59)).toBe("about 59 s left");
  expect(timeLeft(61)).toBe("about 2 min left");
});
