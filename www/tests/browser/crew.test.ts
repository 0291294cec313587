/** Views that workers compute beside the engine's: however many there are, and whatever becomes of them, the wire is the same. */

import { expect, it } from "vitest";
import { example, openEngine, type Made } from "./engine";

const { made } = await openEngine();
const cores = (count: number): string => `Object.defineProperty(navigator, "hardwareConcurrency", { value: ${count} });`;
/** Has something done to the first mate in place of its message of that number. */
const instead = (deed: string): string => `${cores(2)}
  let asked = 0;
  self.Worker = class extends Worker {
    postMessage(message, transfer) {
      if (++asked === 100) ${deed}
      else super.postMessage(message, transfer);
    }
  };`;
const run = (prelude: string): Promise<Made> => made(example("multiview", { preset: "fast", backend: "cpu" }), prelude);

const alone = await run(cores(1));

it("makes the same wire with one, two or three of them", async () => {
  expect(alone.workers).toEqual([1]);
  for (const count of [2, 3, 16]) {
    const together = await run(cores(count));
    expect(Math.max(...together.workers)).toBe(Math.min(3, count));
    expect(together.code).toBe(alone.code);
  }
});

it("goes on without one that comes to grief on the way", async () => {
  for (const deed of ["super.postMessage(new Uint8Array([9, 9, 9, 9]));", "super.terminate();"]) {
    const left = await run(instead(deed));
    expect(left.workers).toEqual([1, 2, 1]);
    expect(left.code).toBe(alone.code);
  }
});

it("does without where a worker may start none", async () => {
  for (const prelude of ["delete self.Worker;", `self.Worker = class extends Worker { constructor() { super("absent.js"); } };`]) {
    const left = await run(`${cores(2)} ${prelude}`);
    expect(left.workers).toEqual([1]);
    expect(left.code).toBe(alone.code);
  }
});
