/**
 * Workers that compute views of a run beside the engine's: portfolio frames and schools give a page no shared memory, so messages
 * go to and fro. Nobody ever waits for one to start, and a run does without one that fails.
 */

/** Brings a mate a message, and its answer later. */
export type Ask = (message: Uint8Array<ArrayBuffer>) => Promise<Uint8Array>;

/** More of them than this are more trouble than help: runs have few views. */
const MOST = 3;
/** Who is silent for so long has come to grief. */
const PATIENCE_MS = 5000;

interface Waiting {
  resolve(answer: Uint8Array): void;
  reject(error: Error): void;
}

interface Mate {
  readonly worker: Worker;
  readonly ask: Ask;
  readonly waiting: Waiting[];
  isReady: boolean;
}

const newMate = (): Worker => new Worker(new URL("./mate.ts", import.meta.url), { type: "module", name: "wire4d mate" });

export class Crew {
  private mates: Mate[] = [];
  /** Whether none can be had here. */
  private isHopeless = false;

  constructor(private readonly newWorker = newMate) {}

  /** Has as many get ready as `cores` allow beside the engine's own; those that are stay so. */
  call(module: WebAssembly.Module, cores = navigator.hardwareConcurrency): void {
    const wanted = Math.min(MOST, (cores || 1) - 1);
    while (!this.isHopeless && this.mates.length < wanted) this.start(module);
  }

  /** Lets all go. */
  dismiss(): void {
    [...this.mates].forEach((mate) => this.lose(mate));
  }

  /** One for each who is ready. */
  get ready(): readonly Ask[] {
    return this.mates.filter(({ isReady }) => isReady).map(({ ask }) => ask);
  }

  private start(module: WebAssembly.Module): void {
    try {
      const worker = this.newWorker();
      const mate: Mate = { worker, ask: (message) => this.ask(mate, message), waiting: [], isReady: false };
      worker.onmessage = ({ data }: MessageEvent<Uint8Array | null>) => {
        if (data) mate.waiting.shift()?.resolve(data);
        else mate.isReady = true;
      };
      worker.onerror = (event) => {
        event.preventDefault();
        // One that could not even start is not tried again.
        this.isHopeless ||= !mate.isReady;
        this.lose(mate);
      };
      worker.postMessage(module);
      this.mates.push(mate);
    } catch {
      // No workers in workers, or no modules sent to them.
      this.isHopeless = true;
    }
  }

  private ask(mate: Mate, message: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
    return new Promise((resolve, reject) => {
      if (!this.mates.includes(mate)) {
        reject(new Error("It is gone."));
        return;
      }
      const patience = setTimeout(() => this.lose(mate), PATIENCE_MS);
      const over = <T>(tell: (outcome: T) => void) => (outcome: T): void => {
        clearTimeout(patience);
        tell(outcome);
      };
      mate.waiting.push({ resolve: over(resolve), reject: over(reject) });
      mate.worker.postMessage(message, [message.buffer]);
    });
  }

  private lose(mate: Mate): void {
    mate.worker.terminate();
    this.mates = this.mates.filter((other) => other !== mate);
    mate.waiting.splice(0).forEach(({ reject }) => reject(new Error("It is gone.")));
  }
}
