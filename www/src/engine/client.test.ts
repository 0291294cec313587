import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Cancelled, EngineClient, Problem } from "./client";

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
  vi.spyOn(console, "error").mockImplementation(() => undefined);
  client = new EngineClient(() => new FakeWorker() as unknown as Worker);
});
afterEach(() => {
  vi.restoreAllMocks();
});

it("ends a run, and asks a fresh worker what else was asked", async () => {
  const settings = client.call("settings", { tasks: [] });
  const run = client.callEndable("run", { task: "knit", work: null, settings: {}, from: null, first: null, guide: null });
  const open = client.call("open", { code: "AB" });
  const first = worker();
  const news: string[] = [];
  client.listen((told) => news.push(told.news));
  client.cancel();
  expect(news).toEqual(["fresh"]);
  await expect(run).rejects.toBeInstanceOf(Cancelled);
  expect(first.ended).toBe(true);
  expect(worker().asked.map(({ call }) => call)).toEqual(["settings", "open"]);
  worker().answer("settings", "table");
  worker().answer("open", "seen");
  // What the one that was ended still had to say is for nobody.
  first.answer("settings", "late");
  expect([await settings, await open]).toEqual(["table", "seen"]);
});

it("tells everybody who waits when the worker breaks, and starts another at the next call", async () => {
  const settings = client.call("settings", { tasks: [] });
  worker().onerror({ message: "broken", preventDefault: () => undefined });
  await expect(settings).rejects.toBeInstanceOf(Problem);
  const again = client.call("settings", { tasks: [] });
  expect(FakeWorker.all).toHaveLength(2);
  worker().answer("settings", "table");
  expect(await again).toBe("table");
});
