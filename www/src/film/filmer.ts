/** Has pictures and films made in a worker, so that the page waits for none of them. */

import type { Subject } from "#sculpture/film/darkroom";
import type { FilmOrder, Order, Preview, Progress, StillOrder, Told } from "./orders";

/** Somebody gave it up. */
export class GivenUp extends Error {}

/** Distributes over the kinds of orders. */
type Ask = StillOrder | FilmOrder | Preview;

interface Waiting {
  resolve(made: Blob | ImageBitmap): void;
  reject(reason: Error): void;
  progress?(progress: Progress): void;
}

export class Filmer {
  private readonly waiting = new Map<number, Waiting>();
  private orders = 0;
  private worker: Worker | null = null;
  private subject: Subject | null = null;

  /** What pictures are of from now on. */
  show(subject: Subject): void {
    this.subject = subject;
    this.send({ subject });
  }

  /** @throws GivenUp after `giveUp`; else an error whose message says why it cannot be made. */
  still(order: Omit<StillOrder, "make">): Promise<Blob> {
    return this.ask({ make: "still", ...order }) as Promise<Blob>;
  }

  /** @throws as `still`. */
  film(order: Omit<FilmOrder, "make">, progress: (progress: Progress) => void): Promise<Blob> {
    return this.ask({ make: "film", ...order }, progress) as Promise<Blob>;
  }

  /** @throws as `still`. */
  preview(of: Preview["of"]): Promise<ImageBitmap> {
    return this.ask({ make: "preview", of }) as Promise<ImageBitmap>;
  }

  /** Ends at once whatever is being made; what is asked next begins anew. */
  giveUp(): void {
    this.worker?.terminate();
    this.worker = null;
    this.fail(new GivenUp("given up"));
  }

  private ask(order: Ask, progress?: Waiting["progress"]): Promise<Blob | ImageBitmap> {
    return new Promise((resolve, reject) => {
      const id = ++this.orders;
      this.waiting.set(id, { resolve, reject, ...(progress && { progress }) });
      if (!this.worker) {
        this.worker = this.open();
        if (this.subject) this.send({ subject: this.subject });
      }
      this.send({ id, ...order });
    });
  }

  private send(order: Order): void {
    this.worker?.postMessage(order);
  }

  private open(): Worker {
    const worker = new Worker(new URL("./film-worker.ts", import.meta.url), { type: "module", name: "film" });
    worker.onmessage = ({ data }: MessageEvent<Told>) => this.hear(data);
    worker.onerror = () => {
      this.worker = null;
      this.fail(new Error("the part of the page that draws did not come"));
    };
    return worker;
  }

  private hear(told: Told): void {
    const waiting = this.waiting.get(told.id);
    if (!waiting) return;
    if ("progress" in told) {
      waiting.progress?.(told.progress);
      return;
    }
    this.waiting.delete(told.id);
    if ("problem" in told) waiting.reject(new Error(told.problem));
    else waiting.resolve("blob" in told ? told.blob : told.bitmap);
  }

  private fail(reason: Error): void {
    for (const { reject } of this.waiting.values()) reject(reason);
    this.waiting.clear();
  }
}
