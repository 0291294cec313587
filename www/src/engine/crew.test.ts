import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Crew } from "./crew";

/** A worker that answers each message by itself, once it is told to. */
class FakeWorker {
  onmessage: (event: { data: unknown }) => void = () => undefined;
  onerror: (event: { preventDefault(): void }) => void = () => undefined;
  readonly got: unknown[] = [];
  ended = false;
  postMessage(message: unknown): void {
    this.got.push(message);
  }
  terminate(): void {
    this.ended = true;
  }
  ready(): void {
    this.onmessage({ data: null });
  }
  fail(): void {
    this.onerror({ preventDefault: () => undefined });
  }
}

const MODULE = {} as WebAssembly.Module;
const bytes = (...values: number[]) => Uint8Array.from(values);

let workers: FakeWorker[];
let crew: Crew;
beforeEach(() => {
  vi.useFakeTimers();
  workers = [];
  crew = new Crew(() => {
    const worker = new FakeWorker();
    workers.push(worker);
    return worker as unknown as Worker;
  });
});
afterEach(() => void vi.useRealTimers());

describe("a crew", () => {
  it("has a mate for each core beside the engine's, of three at most", () => {
    for (const [cores, mates] of [[1, 0], [2, 1], [3, 2], [16, 3]] as const) {
      crew.call(MODULE, cores);
      expect(workers.length).toBe(mates);
    }
    expect(workers.every(({ got }) => got[0] === MODULE)).toBe(true);
  });

  it("has nobody who is not ready, and keeps who is", () => {
    crew.call(MODULE, 3);
    expect(crew.ready).toEqual([]);
    workers[1]!.ready();
    expect(crew.ready.length).toBe(1);
    crew.call(MODULE, 3);
    expect(workers.length).toBe(2);
    const [ask] = crew.ready;
    expect(crew.ready[0]).toBe(ask);
  });

  it("hands over answers in the order of the messages", async () => {
    crew.call(MODULE, 2);
    workers[0]!.ready();
    const ask = crew.ready[0]!;
    const answers = [ask(bytes(1)), ask(bytes(2))];
    workers[0]!.onmessage({ data: bytes(3) });
    workers[0]!.onmessage({ data: bytes(4) });
    expect(await Promise.all(answers)).toEqual([bytes(3), bytes(4)]);
    // Patience is over only for who still waits.
    vi.advanceTimersByTime(60_000);
    expect(crew.ready.length).toBe(1);
  });

  it("gives up who fails or is silent, and tells all that wait for it", async () => {
    crew.call(MODULE, 3);
    workers.forEach((worker) => worker.ready());
    const [first, second] = crew.ready;
    const waiting = [first!(bytes(1)), first!(bytes(2)), second!(bytes(3))];
    workers[0]!.fail();
    await expect(waiting[0]).rejects.toThrow();
    await expect(waiting[1]).rejects.toThrow();
    expect(crew.ready).toEqual([second]);
    vi.advanceTimersByTime(60_000);
    await expect(waiting[2]).rejects.toThrow();
    expect(workers.every(({ ended }) => ended)).toBe(true);
    await expect(second!(bytes(4))).rejects.toThrow();
    // The next run has others.
    crew.call(MODULE, 3);
    expect(workers.length).toBe(4);
    crew.dismiss();
    expect(workers.every(({ ended }) => ended)).toBe(true);
  });

  it("does without where none can be started", () => {
    crew.call(MODULE, 2);
    workers[0]!.fail();
    crew.call(MODULE, 4);
    expect(workers.length).toBe(1);
    const none = new Crew(() => {
      throw new ReferenceError("Worker is not defined");
    });
    none.call(MODULE, 4);
    expect(none.ready).toEqual([]);
  });
});
