import { afterEach, expect, it, vi } from "vitest";
import { engineProblem } from "./engine-check";

afterEach(() => void vi.unstubAllGlobals());

it("finds nothing wrong where workers and SIMD are", () => {
  vi.stubGlobal("Worker", class {});
  expect(engineProblem()).toBe("");
});

it("says what is missing", () => {
  vi.stubGlobal("Worker", undefined);
  expect(engineProblem()).toContain("no background workers");
  vi.stubGlobal("Worker", class {});
  vi.stubGlobal("WebAssembly", { validate: () => false });
  expect(engineProblem()).toContain("no fast WebAssembly");
});
