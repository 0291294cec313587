/** Answers the page's calls, one worker a page. It keeps the run under way, and the shape that was last looked at. */

import { openShareCode } from "../embed/share/code";
import { loaded, type CoreSurface } from "./core";
import { fitted } from "./fit";
import type { Answer, Calls, Control, Covered, Finished, FoundSurface, News, Request, Solid } from "./protocol";
import { Pull } from "./pull";
import { sheetOf } from "./sheet";

const CRASHED = "The engine stopped unexpectedly. What you gave it is still here; please try again.";

let pull: Pull | null = null;
let surface: { readonly key: string; readonly opened: Promise<Opened> } | null = null;

/** What is told of a shape is kept beside it, since nobody may look at it while a run holds it. */
interface Opened {
  readonly core: CoreSurface;
  readonly found: FoundSurface;
}

const handlers: { [K in keyof Calls]: (given: Calls[K]["arguments"]) => Promise<Calls[K]["answer"]> } = {
  settings: async () => (await loaded()).settings(),
  place: async ({ backend }) => (await loaded()).place(backend),
  read: async ({ picture, reading, sidePx }) => {
    const found = (await loaded()).read(picture, reading);
    return { ...found, width: sidePx, height: sidePx, ink: fitted(found, sidePx) };
  },
  find: async ({ picture, object }) => (await loaded()).find(picture, object),
  preview: async ({ drawings, settings }) => (await loaded()).preview(drawings, settings),
  surface: async ({ solid }) => (await surfaceOf(solid)).found,
  curve: async ({ covered, settings }) => (await dressed(covered)).curve(settings, (share) => tell({ news: "covering", share })),
  pattern: async ({ pattern, sidePx }) => (await loaded()).pattern(pattern, sidePx),
  run,
  sheet: ({ drawing }) => sheetOf(drawing),
  peek: async ({ code }) => openShareCode(code),
  open: async (given) => (await loaded()).open(given),
  export: async ({ file, format, view, covered }) => (covered ? (await surfaceOf(covered)).core : await loaded()).export(file, format, view),
};

async function run({ work, settings, from }: Calls["run"]["arguments"]): Promise<Finished> {
  if (pull) throw new Error("A run is under way already; stop it first.");
  // Made before the core is loaded: it hears a stop that comes meanwhile.
  const mine = (pull = new Pull(tell));
  try {
    const checkpoint = from && new Uint8Array(await from.arrayBuffer());
    const ears = {
      tell: (words: string, share: number) => tell({ news: "progress", words, share }),
      note: (words: string) => tell({ news: "note", words }),
    };
    const session =
      work.job === "fill"
        ? await (await dressed(work.covered)).start(settings, checkpoint, ears)
        : await (await loaded()).start(work, settings, checkpoint, ears);
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

/** Read once, however often it is asked for. */
function surfaceOf(solid: Solid): Promise<Opened> {
  const key = "shape" in solid ? solid.shape : solid.key;
  if (surface?.key !== key) {
    // Whoever waits for it still has it first.
    void surface?.opened.then(({ core }) => setTimeout(() => core.free()), () => undefined);
    const opened = open(solid);
    surface = { key, opened };
    opened.catch(() => {
      if (surface?.opened === opened) surface = null;
    });
  }
  return surface.opened;
}

async function open(solid: Solid): Promise<Opened> {
  const core = await loaded();
  const read = "shape" in solid ? core.shape(solid.shape) : await core.mesh(solid);
  return { core: read, found: read.found() };
}

async function dressed({ solid, style }: Covered): Promise<CoreSurface> {
  const { core } = await surfaceOf(solid);
  core.dress(style);
  return core;
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
