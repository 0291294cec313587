/** The page's end of the worker: calls as promises, news as callbacks, and a fresh worker after a crash or a cancel. */

import type { Answer, CallName, Calls, Control, News, Request } from "./protocol";

/** A sentence for people: what happened and what to do. */
export class Problem extends Error {}
/** The call was given up because the person asked for it. */
export class Cancelled extends Error {}

interface Waiting {
  resolve(answer: unknown): void;
  reject(reason: Error): void;
}

const CRASHED = "The engine stopped unexpectedly. Your pictures are still here; please try again.";
const ABSENT = "The engine could not be started. Reload the page; if that does not help, use another browser or a normal window.";

export class EngineClient {
  private worker: Worker | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private nextId = 1;

  constructor(private readonly onNews: (news: News) => void) {
    this.start();
  }

  call<K extends CallName>(call: K, given: Calls[K]["arguments"], transfer: Transferable[] = []): Promise<Calls[K]["answer"]> {
    const worker = this.worker ?? this.start();
    if (!worker) return Promise.reject(new Problem(ABSENT));
    const id = this.nextId++;
    return new Promise((resolve, reject) => {
      worker.postMessage({ id, call, ...given } as unknown as Request, transfer);
      this.waiting.set(id, { resolve: resolve as (answer: unknown) => void, reject });
    });
  }

  control(control: Control["control"]): void {
    this.worker?.postMessage({ control } satisfies Control);
  }

  /** Ends whatever runs, even where it does not listen, and starts afresh. */
  cancel(): void {
    this.drop(new Cancelled("cancelled"));
    this.start();
  }

  /** The same, unless others would lose their answers, too. */
  cancelIfAlone(): void {
    if (this.waiting.size === 1) this.cancel();
  }

  /** A worker where the browser allows one. One that turns out not to load is dropped; the next call tries again. */
  private start(): Worker | null {
    let worker: Worker;
    try {
      worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: "wire4d" });
    } catch (error) {
      console.error(error);
      return null;
    }
    let heard = false;
    worker.onmessage = ({ data }: MessageEvent<Answer | News>) => {
      heard = true;
      if ("news" in data) {
        this.onNews(data);
        return;
      }
      const call = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if ("problem" in data) call?.reject(new Problem(data.problem));
      else call?.resolve(data.answer);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      console.error(event.message);
      if (this.worker === worker) this.drop(new Problem(heard ? CRASHED : ABSENT));
    };
    this.worker = worker;
    return worker;
  }

  private drop(reason: Error): void {
    this.worker?.terminate();
    this.worker = null;
    const given = [...this.waiting.values()];
    this.waiting.clear();
    for (const call of given) call.reject(reason);
  }
}
