import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Cancelled, EngineClient, Problem } from "./client";
import type { Drawing } from "./protocol";

class FakeWorker {
  static readonly all: FakeWorker[] = [];
  readonly asked: { id: number; call: string }[] = [];
  onmessage: (event: { data: unknown }) => void = () => undefined;
  onerror: (event: { message: string; preventDefault(): void }) => void = () => undefined;
  ended = false;

  constructor() {
    FakeWorker.all.push(this);
  }

  postMessage(asked: { id: number; call: string }): void {
    this.asked.push(asked);
  }

  terminate(): void {
    this.ended = true;
  }

  answer(call: string, answer: unknown): void {
    this.onmessage({ data: { id: this.asked.find((asked) => asked.call === call)!.id, answer } });
  }
}

let client: EngineClient;
const worker = () => FakeWorker.all.at(-1)!;

beforeEach(() => {
  FakeWorker.all.length = 0;
  vi.stubGlobal("Worker", FakeWorker);
  vi.spyOn(console, "error").mockImplementation(() => undefined);
  client = new EngineClient(() => undefined);
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

it("ends a run, and asks a fresh worker what else was asked", async () => {
  const settings = client.call("settings", {});
  const run = client.call("run", { work: { job: "multiview", drawings: [] }, settings: {}, from: null });
  const preview = client.call("preview", { drawings: [] as Drawing[], settings: {} });
  const first = worker();
  client.cancel();
  await expect(run).rejects.toBeInstanceOf(Cancelled);
  expect(first.ended).toBe(true);
  expect(worker().asked.map(({ call }) => call)).toEqual(["settings", "preview"]);
  worker().answer("settings", "table");
  worker().answer("preview", "seen");
  // What the one that was ended still had to say is for nobody.
  first.answer("settings", "late");
  expect([await settings, await preview]).toEqual(["table", "seen"]);
});

it("tells everybody who waits when the worker breaks, and starts another at the next call", async () => {
  const settings = client.call("settings", {});
  worker().onerror({ message: "broken", preventDefault: () => undefined });
  await expect(settings).rejects.toBeInstanceOf(Problem);
  const again = client.call("settings", {});
  expect(FakeWorker.all).toHaveLength(2);
  worker().answer("settings", "table");
  expect(await again).toBe("table");
});
