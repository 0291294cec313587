import { describe, expect, it } from "vitest";
import { inWorker, type Order, type Report } from "./backstage";
import type { Look } from "./looks";

/** A worker that hears orders and answers when it is told to. */
class Silent {
  orders: Order[] = [];
  ended = false;
  onmessage: ((event: { data: Report }) => void) | null = null;
  onerror: (() => void) | null = null;
  postMessage(order: Order): void {
    this.orders.push(order);
  }
  terminate(): void {
    this.ended = true;
  }
}

function stage() {
  const worker = new Silent();
  const canvas = { transferControlToOffscreen: () => ({}) } as unknown as HTMLCanvasElement;
  let lost = 0;
  const backstage = inWorker(worker as unknown as Worker, canvas, {} as Look, { view: () => {}, lost: () => {}, camera: () => {}, drawn: () => {} }, () => lost++);
  return { worker, backstage, lost: () => lost };
}

describe("pictures of a stage in a worker", () => {
  it("come, or say that they cannot be drawn", async () => {
    const { worker, backstage } = stage();
    const [first, second] = [backstage.picture(9, 9), backstage.picture(9, 9)];
    expect(worker.orders.slice(1)).toEqual([{ picture: 1, of: [9, 9] }, { picture: 2, of: [9, 9] }]);
    const blob = new Blob(["x"]);
    worker.onmessage!({ data: { picture: 2, blob } });
    worker.onmessage!({ data: { picture: 1, blob: null } });
    await expect(second).resolves.toBe(blob);
    await expect(first).rejects.toThrow("could not be drawn");
    // A second answer does no harm.
    worker.onmessage!({ data: { picture: 2, blob: null } });
  });

  it("do not wait for a scene that there is not, nor for a worker that failed or was ended", async () => {
    for (const end of [(s: ReturnType<typeof stage>) => s.worker.onmessage!({ data: { unavailable: true } }), (s: ReturnType<typeof stage>) => s.worker.onerror!(), (s: ReturnType<typeof stage>) => s.backstage.dispose()]) {
      const made = stage();
      const picture = made.backstage.picture(9, 9);
      end(made);
      await expect(picture).rejects.toThrow("could not be drawn");
      expect(made.lost() === 1 || made.worker.ended).toBe(true);
    }
  });
});
