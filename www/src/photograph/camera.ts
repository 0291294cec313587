/** Has photographs taken in a worker, so that the page never waits for one. */

import type { Order, Pixels, Rest, Told, Wishes } from "./orders";

export interface Ear {
  /** A picture of it so far; `passes` is 0 for a small one. */
  picture(pixels: Pixels, passes: number): void;
  progress(passes: number): void;
}

/** Something else was wanted meanwhile, or nothing any more. */
export class GivenUp extends Error {}

interface Waiting extends Ear {
  readonly id: number;
  resolve(pixels: Pixels): void;
  reject(reason: Error): void;
}

export class Camera {
  private worker: Worker | null = null;
  private orders = 0;
  private waiting: Waiting | null = null;

  /** Shows what it would be, small; an older picture that is still being taken is given up. */
  look(file: Order["file"], wishes: Wishes, ear: Ear): void {
    this.take(file, wishes, 0, ear).catch((error: unknown) => {
      if (!(error instanceof GivenUp)) console.warn(error);
    });
  }

  /** @throws GivenUp after `giveUp`, or when something else is wanted; else an error whose message says why it cannot be taken. */
  take(file: Order["file"], wishes: Wishes, passes: number, ear: Ear): Promise<Pixels> {
    this.waiting?.reject(new GivenUp("given up"));
    const id = ++this.orders;
    return new Promise((resolve, reject) => {
      this.waiting = { id, resolve, reject, picture: (pixels, passes) => ear.picture(pixels, passes), progress: (passes) => ear.progress(passes) };
      this.worker ??= this.open();
      this.rest();
      this.worker.postMessage({ id, file, wishes, passes } satisfies Order);
    });
  }

  /** Ends at once. */
  giveUp(): void {
    document.removeEventListener("visibilitychange", this.rest);
    this.worker?.terminate();
    this.worker = null;
    this.waiting?.reject(new GivenUp("given up"));
    this.waiting = null;
  }

  private readonly rest = (): void => this.worker?.postMessage({ rests: document.hidden } satisfies Rest);

  private open(): Worker {
    document.addEventListener("visibilitychange", this.rest);
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: "photograph" });
    worker.onmessage = ({ data }: MessageEvent<Told>) => this.hear(data);
    worker.onerror = () => {
      this.worker = null;
      this.waiting?.reject(new Error("the part of the page that takes photographs did not come"));
      this.waiting = null;
    };
    return worker;
  }

  private hear(told: Told): void {
    const { waiting } = this;
    if (waiting?.id !== told.id) return;
    if ("problem" in told) waiting.reject(new Error(told.problem));
    else if ("done" in told) waiting.resolve(told.done);
    else if ("pixels" in told) waiting.picture(told.pixels, told.passes);
    else waiting.progress(told.passes);
  }
}
