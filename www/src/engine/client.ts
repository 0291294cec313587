/** The page's end of the worker: calls as promises, news as callbacks, and a fresh worker after a crash or a cancel. */

import type { Answer, CallName, Calls, Control, News, Request } from "./protocol";

/** A sentence for people: what happened and what to do. */
export class Problem extends Error {}
/** The call was given up because the person asked for it. */
export class Cancelled extends Error {}

interface Waiting {
  readonly call: CallName;
  readonly given: object;
  readonly endable: boolean;
  resolve(answer: unknown): void;
  reject(reason: Error): void;
}

const CRASHED = "The engine stopped unexpectedly. What you gave it is still here; please try again.";
const ABSENT = "The engine could not be started. Reload the page; if that does not help, use another browser or a normal window.";

export class EngineClient {
  private worker: Worker | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private readonly listeners: ((news: News) => void)[] = [];
  private nextId = 1;

  /** `newWorker` throws where the browser allows none. */
  constructor(private readonly newWorker: () => Worker) {
    this.start();
  }

  call<K extends CallName>(call: K, given: Calls[K]["arguments"]): Promise<Calls[K]["answer"]> {
    return this.promise(call, given, false);
  }

  /** For what takes long: `cancel` ends it before its time. */
  callEndable<K extends CallName>(call: K, given: Calls[K]["arguments"]): Promise<Calls[K]["answer"]> {
    return this.promise(call, given, true);
  }

  /** Whoever wants to hear what the worker tells unasked. */
  listen(listener: (news: News) => void): void {
    this.listeners.push(listener);
  }

  control(control: Control["control"]): void {
    this.worker?.postMessage({ control } satisfies Control);
  }

  /** Ends what takes long, even where it does not listen; what else was asked, a fresh worker is asked. */
  cancel(): void {
    if (![...this.waiting.values()].some(({ endable }) => endable)) return;
    for (const waiting of this.leave()) {
      if (waiting.endable) waiting.reject(new Cancelled("cancelled"));
      else this.ask(waiting);
    }
    if (!this.worker) this.start();
  }

  private promise<K extends CallName>(call: K, given: object, endable: boolean): Promise<Calls[K]["answer"]> {
    return new Promise((resolve, reject) => this.ask({ call, given, endable, resolve: resolve as (answer: unknown) => void, reject }));
  }

  private ask(waiting: Waiting): void {
    const worker = this.worker ?? this.start();
    if (!worker) {
      waiting.reject(new Problem(ABSENT));
      return;
    }
    const id = this.nextId++;
    worker.postMessage({ id, call: waiting.call, ...waiting.given } as unknown as Request);
    this.waiting.set(id, waiting);
  }

  /** A worker where the browser allows one. One that turns out not to load is dropped; the next call tries again. */
  private start(): Worker | null {
    let worker: Worker;
    try {
      worker = this.newWorker();
    } catch (error) {
      console.error(error);
      return null;
    }
    let heard = false;
    worker.onmessage = ({ data }: MessageEvent<Answer | News>) => {
      heard = true;
      if ("news" in data) {
        this.tell(data);
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
    for (const waiting of this.leave()) waiting.reject(reason);
  }

  /** Ends the worker; what it still owes. */
  private leave(): Waiting[] {
    this.worker?.terminate();
    this.worker = null;
    const owed = [...this.waiting.values()];
    this.waiting.clear();
    this.tell({ news: "fresh" });
    return owed;
  }

  private tell(news: News): void {
    for (const listener of this.listeners) listener(news);
  }
}
