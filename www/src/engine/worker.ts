/** Answers the page's calls, one worker a page. It keeps nothing but the run under way. */

import { openShareCode } from "../embed/share/code";
import { loaded } from "./core";
import { fitted } from "./fit";
import type { Answer, Calls, Control, Finished, News, Request } from "./protocol";
import { Pull } from "./pull";
import { sheetOf } from "./sheet";

const CRASHED = "The engine stopped unexpectedly. Your pictures are still here; please try again.";

let pull: Pull | null = null;

const handlers: { [K in keyof Calls]: (given: Calls[K]["arguments"]) => Promise<Calls[K]["answer"]> } = {
  settings: async () => (await loaded()).settings(),
  place: async ({ backend }) => (await loaded()).place(backend),
  read: async ({ picture, reading, sidePx }) => {
    const found = (await loaded()).read(picture, reading);
    return { ...found, width: sidePx, height: sidePx, ink: fitted(found, sidePx) };
  },
  find: async ({ picture, object }) => (await loaded()).find(picture, object),
  preview: async ({ drawings, settings }) => (await loaded()).preview(drawings, settings),
  run,
  sheet: ({ drawing }) => sheetOf(drawing),
  peek: async ({ code }) => openShareCode(code),
  open: async (given) => (await loaded()).open(given),
  export: async ({ file, format, view }) => (await loaded()).export(file, format, view),
};

async function run({ work, settings, from }: Calls["run"]["arguments"]): Promise<Finished> {
  if (pull) throw new Error("A run is under way already; stop it first.");
  // Made before the core is loaded: it hears a stop that comes meanwhile.
  const mine = (pull = new Pull(tell));
  try {
    const checkpoint = from && new Uint8Array(await from.arrayBuffer());
    const session = await (await loaded()).start(work, settings, checkpoint, {
      tell: (words, share) => tell({ news: "progress", words, share }),
      note: (words) => tell({ news: "note", words }),
    });
    try {
      tell({ news: "targets", targets: session.targets() });
      await mine.toTheEnd(session, from !== null);
      tell({ news: "progress", words: "Measuring the wire…", share: 1 });
      return session.finish();
    } finally {
      session.free();
    }
  } finally {
    pull = null;
  }
}

function tell(message: News | Answer, transfer: Transferable[] = []): void {
  postMessage(message, { transfer });
}

onmessage = async ({ data }: MessageEvent<Request | Control>) => {
  if ("control" in data) {
    pull?.hear(data.control);
    return;
  }
  try {
    const handler = handlers[data.call] as (given: Request) => Promise<unknown>;
    tell({ id: data.id, answer: await handler(data) });
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) {
      // The core stopped midway and is of no use any more: to the page, this worker is gone.
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

// Loaded before the first call needs it; what goes wrong is told to each call.
loaded().catch(() => undefined);
