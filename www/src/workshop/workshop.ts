/** Has plans and files made in a worker, so that the page never waits for one. */

import type { Kind, Order, Plan, Told, Wishes } from "./orders";

interface Waiting {
  resolve(answer: Plan | Uint8Array<ArrayBuffer>): void;
  reject(reason: Error): void;
}

/** Of one wire. */
export class Workshop {
  private worker: Worker | null = null;
  private orders = 0;
  private readonly waiting = new Map<number, Waiting>();

  /** `file` is a wire.json. */
  constructor(private readonly file: Order["file"]) {}

  /** @throws an error whose message says what is wrong. */
  plan(wishes: Wishes): Promise<Plan> {
    return this.ask(wishes, null) as Promise<Plan>;
  }

  /** @throws as `plan`. */
  made(wishes: Wishes, kind: Kind): Promise<Uint8Array<ArrayBuffer>> {
    return this.ask(wishes, kind) as Promise<Uint8Array<ArrayBuffer>>;
  }

  close(): void {
    this.worker?.terminate();
    this.fail("closed");
  }

  private ask(wishes: Wishes, kind: Kind | null): Promise<Plan | Uint8Array<ArrayBuffer>> {
    return new Promise((resolve, reject) => {
      const id = ++this.orders;
      this.waiting.set(id, { resolve, reject });
      this.worker ??= this.open();
      this.worker.postMessage({ id, file: this.file, wishes, kind } satisfies Order);
    });
  }

  private open(): Worker {
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: "workshop" });
    worker.onmessage = ({ data }: MessageEvent<Told>) => {
      const waiting = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if ("problem" in data) waiting?.reject(new Error(data.problem));
      else waiting?.resolve("plan" in data ? data.plan : data.made);
    };
    worker.onerror = () => this.fail("the part of the page that plans did not come");
    return worker;
  }

  private fail(why: string): void {
    this.worker = null;
    for (const { reject } of this.waiting.values()) reject(new Error(why));
    this.waiting.clear();
  }
}
