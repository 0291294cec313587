import { expect, it, vi } from "vitest";
import type { EngineClient } from "../../engine/client";
import { simplified } from "./simplified";

const engine = (call: () => Promise<unknown>) => ({ call: vi.fn(call) }) as unknown as EngineClient;
const FILE = new Uint8Array(3);

it("asks the engine for a code that fits", async () => {
  const answer = { code: "A".repeat(100), most_px: 2.5, mean_px: 0.4 };
  const asked = engine(async () => answer);
  expect(await simplified(asked, FILE, 100)).toBe(answer);
  expect(asked.call).toHaveBeenCalledWith("simplify", { file: FILE, characters: 100 });
});

it("offers none where none is like the wire, or made at all", async () => {
  vi.spyOn(console, "error").mockImplementation(() => undefined);
  expect(await simplified(engine(async () => null), FILE, 100)).toBeNull();
  expect(await simplified(engine(() => Promise.reject(new Error("not known"))), FILE, 100)).toBeNull();
});
