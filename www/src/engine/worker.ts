/** The only place that knows the wasm module. A run is pulled in short slices, so that stop and pause get through. */

import { core, type CoreRun, type CoreSculpture } from "./core";
import type { Answer, Calls, Control, Finished, News, Request } from "./protocol";

/** How long the run works before it listens again, and the least time between two pictures of it. */
const SLICE_MS = 30;
const FRAME_MS = 1000 / 30;
const CRASHED = "The engine stopped unexpectedly. Your pictures are still here; please try again.";

type Wanted = "run" | "pause" | "stop";
let wanted: Wanted = "run";
/** Whether the page has seen the last frame: a slow page is not flooded. */
let seen = true;
let wake: () => void = () => undefined;
let sculpture: CoreSculpture | null = null;

const handlers: { [K in keyof Calls]: (given: Calls[K]["arguments"]) => Promise<Calls[K]["answer"]> | Calls[K]["answer"] } = {
  settings: () => core.settings(),
  read: ({ picture, settings }) => core.read(picture, settings),
  run: ({ pictures, settings }) =>
    run(
      core.start(
        pictures,
        settings,
        (words, share) => tell({ news: "progress", words, share }),
        (words) => tell({ news: "note", words }),
      ),
    ),
  open: ({ code }) => finished(core.open(code)),
  export: ({ format }) => made().export(format),
  share: () => made().share(),
};

async function run(session: CoreRun): Promise<Finished> {
  wanted = "run" as Wanted;
  seen = true;
  let told = -Infinity;
  let steps = 1;
  tell({ news: "targets", targets: session.targets() });
  try {
    for (;;) {
      while (wanted === "pause") await new Promise<void>((resolve) => (wake = resolve));
      if (wanted === "stop") break;
      const before = performance.now();
      const frame = session.step(steps);
      const now = performance.now();
      // As many steps as fill a slice, found as the run goes.
      steps = Math.max(1, Math.min(64, Math.round((steps * SLICE_MS) / Math.max(1, now - before))));
      const over = frame.iteration >= frame.iterations;
      if (over || (seen && now - told >= FRAME_MS)) {
        told = now;
        seen = false;
        tell({ news: "frame", frame: session.frame() });
      }
      if (over) break;
      await listen();
    }
    tell({ news: "progress", words: "Measuring the wire", share: 1 });
    return finished(session.finish());
  } finally {
    session.free();
  }
}

function finished(made: CoreSculpture): Finished {
  sculpture?.free();
  sculpture = made;
  return made.show();
}

function made(): CoreSculpture {
  if (!sculpture) throw new Error("There is no wire yet; press Run first.");
  return sculpture;
}

const { port1, port2 } = new MessageChannel();
let heard: () => void = () => undefined;
port1.onmessage = () => heard();
/** Lets waiting messages in; a timer would be slowed down by the browser. */
function listen(): Promise<void> {
  return new Promise((resolve) => {
    heard = resolve;
    port2.postMessage(null);
  });
}

function tell(message: News | Answer): void {
  postMessage(message);
}

onmessage = async ({ data }: MessageEvent<Request | Control>) => {
  if ("control" in data) {
    if (data.control === "seen") {
      seen = true;
    } else {
      wanted = data.control === "resume" ? "run" : data.control;
      wake();
    }
    return;
  }
  try {
    await core.ready;
    const handler = handlers[data.call] as (given: Request) => unknown;
    tell({ id: data.id, answer: await handler(data) });
  } catch (error) {
    // Sentences come as errors; a trap in the module leaves it unusable, so the page starts a new worker.
    if (error instanceof WebAssembly.RuntimeError) {
      console.error(error);
      tell({ id: data.id, problem: CRASHED });
      setTimeout(() => {
        throw error;
      });
    } else {
      tell({ id: data.id, problem: error instanceof Error ? error.message : String(error) });
    }
  }
};

// A module that does not load is a crash like any other: the page hears it as the worker's error.
core.ready.catch((error: unknown) =>
  setTimeout(() => {
    throw error;
  }),
);
