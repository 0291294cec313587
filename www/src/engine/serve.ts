/** Answers the page's calls, one worker a page. It keeps the run under way. */

import type { WireShape } from "#sculpture/scene/shape";
import { openShareCode } from "#sculpture/share/code";
import { loaded, type CoreRun } from "./core";
import { Crew } from "./crew";
import type { Answer, Calls, Control, Finished, Guide, News, Request } from "./protocol";
import { Pull } from "./pull";
import { sheetOf } from "./sheet";
import type { Ears, Handlers, TaskEngine } from "./task-engine";

const CRASHED = "The engine stopped unexpectedly. What you gave it is still here; please try again.";

let pull: Pull | null = null;
const crew = new Crew();
let engines: readonly TaskEngine[] = [];

const handlers: Handlers = {
  settings: async ({ tasks }) => (await loaded()).settings(tasks),
  place: async ({ backend }) => (await loaded()).place(backend),
  run,
  insight: async () => pull?.insight() ?? null,
  sheet: ({ drawing }) => sheetOf(drawing),
  peek: async ({ code }) => openShareCode(code),
  open: async (given) => (await loaded()).open(given),
  export: async (given) => (await files()).exported(given),
  carry: async ({ picture, file }) => (await files()).withWire(picture, file),
  simplify: async (given) => (await files()).simplified(given),
  edit: async ({ file, edit }) => (await loaded()).edited(file, edit),
  lookAtGuidance: async ({ from }) => (await guidance()).look(from),
  openGuidance: async ({ from, prefer, keep }, tell) => (await guidance()).open(from, prefer, keep, (words, share) => tell({ news: "guidance", words, share })),
  askGuidance: async ({ question }) => (await guidance()).ask(question),
  closeGuidance: async () => (await guidance()).closeAll(),
  guidanceShelf: async ({ drop }) => (await guidance()).kept(drop),
};

const notice = (words: string): void => tell({ news: "notice", words });

/** Whatever is wrong with what was to guide it: the run goes on without, if anything is drawn at all. */
async function guideBy(run: CoreRun, guide: Guide, first: WireShape | null, told: Ears["tell"]): Promise<void> {
  try {
    const { guideByWords } = await import("./guiding");
    await guideByWords({ run, guide, first, tell: told, notice, service: guidance });
  } catch (error) {
    console.error(error);
    if (run.targets().every(({ source }) => source === null)) throw error;
    notice(`${error instanceof Error ? error.message : "What was to guide it could not be loaded."} The wire goes on without it.`);
  }
}

/** Comes when somebody saves or shares. */
const files = (): Promise<typeof import("./files")> => import("./files");

/** Comes when somebody asks for it. */
async function guidance(): Promise<typeof import("../guidance/service")> {
  try {
    const service = await import("../guidance/service");
    // Without the core there is no card of its own.
    const core = await loaded().catch(() => null);
    service.lend(() => core?.card() ?? null);
    return service;
  } catch (error) {
    console.error(error);
    throw new Error("The part of the engine that opens models could not be loaded. Check the connection and try again.");
  }
}

async function run({ task, work, settings, from, first, guide }: Calls["run"]["arguments"]): Promise<Finished> {
  if (pull) throw new Error("A run is under way already; stop it first.");
  // Made before the core is loaded: it hears a stop that comes meanwhile.
  const mine = (pull = new Pull(tell, crew));
  try {
    const checkpoint = from && new Uint8Array(await from.arrayBuffer());
    const ears = {
      tell: (words: string, share: number) => tell({ news: "progress", words, share }),
      note: (words: string) => tell({ news: "note", words }),
    };
    const engine = engines.find((engine) => engine.task === task)!;
    const core = await loaded();
    // They get ready while the first wire is laid; a graphics card has no use for them.
    if (core.card() && settings["backend"] !== "cpu") crew.dismiss();
    else crew.call(core.module());
    const session = await engine.start(work, settings, checkpoint, ears);
    try {
      tell({ news: "targets", targets: session.targets() });
      if (guide) await guideBy(session, guide, first, ears.tell);
      await mine.toTheEnd(session, from !== null);
      session.troubles().forEach(notice);
      tell({ news: "progress", words: "Measuring the wire…", share: 1 });
      return session.finish();
    } finally {
      session.free();
    }
  } finally {
    mine.end();
    pull = null;
  }
}

function tell(message: News | Answer, transfer: Transferable[] = []): void {
  postMessage(message, { transfer });
}

function answer(request: Request): Promise<unknown> {
  const all = [handlers, ...engines.map((engine) => engine.handlers)];
  const handler = all.map((some) => some[request.call]).find(Boolean) as (given: Request, tell: (news: News) => void) => Promise<unknown>;
  return handler(request, tell);
}

async function hear({ data }: MessageEvent<Request | Control>): Promise<void> {
  if ("control" in data) {
    pull?.hear(data.control);
    return;
  }
  try {
    tell({ id: data.id, answer: await answer(data) });
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
}

/** From here on the page is answered, also what these have to answer. */
export function serve(tasks: readonly TaskEngine[]): void {
  engines = tasks;
  onmessage = hear;
  // Loaded before the first call needs it; what goes wrong is told to each call.
  loaded().catch(() => undefined);
}
