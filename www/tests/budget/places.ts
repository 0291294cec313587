/** Where the processor's seconds go while a wire is made: who took how many, by the browser's own account. */

import { availableParallelism, loadavg } from "node:os";
import type { Browser, CDPSession } from "playwright-core";
import { choose, launch, serveDist, settled, visit } from "../browser/browser";
import type { Account } from "./budget";
import { runToItsEnd } from "./quietly";

/** As most people have it: the camera sways. */
const VISIT = { viewport: { width: 1440, height: 900 }, reducedMotion: "no-preference" } as const;
/** Of the run's time, what may go into drawing where there is no graphics card; and seconds of the page's own thread. */
const STAGE_SHARE = 0.1;
const PAGE_S = 1;
/** Tasks of threads with their processor's time, and of whom they are. */
const CATEGORIES = ["toplevel", "devtools.timeline", "disabled-by-default-devtools.timeline", "__metadata"];

/** An event of a trace; times in microseconds. `tdur` is of the thread's own processor time. */
interface Traced {
  readonly name: string;
  readonly ph: string;
  readonly pid: number;
  readonly tid: number;
  readonly ts: number;
  readonly dur?: number;
  readonly tdur?: number;
  readonly args?: { readonly name?: string; readonly data?: { readonly url?: string } };
}

type Seconds = Map<string, number>;

export async function runPlaces(): Promise<Account> {
  const load = loadavg()[0]!;
  const site = await serveDist("/");
  const browser = await launch();
  try {
    const { page } = await visit(browser, site.url, VISIT);
    await settled(page);
    await choose(page, "preset", "best");
    await page.waitForTimeout(1500);
    const session = await browser.newBrowserCDPSession();
    const before = await processSeconds(session);
    await browser.startTracing(undefined, { categories: CATEGORIES });
    const ranS = await runToItsEnd(page);
    const after = await processSeconds(session);
    const threads = threadSeconds(await traceOf(browser));
    const processes = new Map([...after].map(([type, seconds]) => [type, seconds - (before.get(type) ?? 0)]));
    const parts = partsOf(threads, processes);
    const pageS = parts.get(PAGE)!;
    const stageShare = (parts.get(STAGE)! + parts.get(GRAPHICS)!) / ranS;
    return {
      rows: [
        { budget: "the page's own thread while the example is made at its best", limit: `${PAGE_S} s`, measured: `${pageS.toFixed(2)} s`, ok: pageS <= PAGE_S },
        {
          budget: "share of a processor for stage and screen meanwhile, without a graphics card",
          limit: `${100 * STAGE_SHARE}%`,
          measured: `${Math.round(100 * stageShare)}%`,
          ok: stageShare <= STAGE_SHARE,
        },
      ],
      notes: [
        `Where the processor's seconds go: the example at its best, ${ranS.toFixed(1)} s, ${availableParallelism()} processors, no graphics card, load average before: ${load.toFixed(1)}.`,
        "",
        "| who | CPU s | of the run's time |",
        "|---|---|---|",
        ...[...parts].map(([who, seconds]) => `| ${who} | ${seconds.toFixed(2)} | ${Math.round((100 * seconds) / ranS)}% |`),
        "",
      ],
    };
  } finally {
    await browser.close();
    site.server.close();
  }
}

const ENGINE = "engine's worker";
const PAGE = "page's own thread";
const STAGE = "stage's worker";
const COMPOSITOR = "putting the page together (compositor, tiles)";
const GRAPHICS = "graphics process (WebGL in software, the screen)";
const REST = "the rest of the browser";

/** By whom; what a process used besides the threads that are told apart is the rest. */
function partsOf(threads: Seconds, processes: Seconds): Seconds {
  const sum = (wanted: RegExp): number => [...threads].reduce((sum, [name, seconds]) => sum + (wanted.test(name) ? seconds : 0), 0);
  const graphics = processes.get("GPU") ?? 0;
  const parts: Seconds = new Map([
    [ENGINE, sum(/^worker .*\/worker-/)],
    [PAGE, sum(/^CrRendererMain$/)],
    [STAGE, sum(/^worker .*\/backstage-worker-/)],
    [COMPOSITOR, sum(/^Compositor/)],
    [GRAPHICS, graphics],
  ]);
  const all = [...processes.values()].reduce((sum, seconds) => sum + seconds, 0);
  return parts.set(REST, all - [...parts.values()].reduce((sum, seconds) => sum + seconds, 0));
}

/** What each kind of process has used so far. */
async function processSeconds(session: CDPSession): Promise<Seconds> {
  const seconds: Seconds = new Map();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  for (const { type, cpuTime } of processInfo) seconds.set(type, (seconds.get(type) ?? 0) + cpuTime);
  return seconds;
}

async function traceOf(browser: Browser): Promise<readonly Traced[]> {
  return (JSON.parse((await browser.stopTracing()).toString()) as { traceEvents: Traced[] }).traceEvents;
}

/** What the tasks of each thread took, by the thread's name; of workers by `worker` and their script. */
function threadSeconds(events: readonly Traced[]): Seconds {
  const names = new Map<string, string>();
  const key = ({ pid, tid }: Traced): string => `${pid} ${tid}`;
  for (const event of events) if (event.ph === "M" && event.name === "thread_name") names.set(key(event), event.args!.name!);
  for (const event of events) {
    const url = event.args?.data?.url;
    if (url && names.get(key(event)) === "DedicatedWorker thread") names.set(key(event), `worker ${url}`);
  }
  const seconds: Seconds = new Map();
  /** Tasks lie within each other: the outermost count. Until when the last one of each thread went on. */
  const until = new Map<string, number>();
  const tasks = events.filter(({ ph, tdur }) => ph === "X" && tdur !== undefined).sort((a, b) => a.ts - b.ts || b.dur! - a.dur!);
  for (const task of tasks) {
    const thread = key(task);
    if (task.ts < (until.get(thread) ?? -Infinity)) continue;
    until.set(thread, task.ts + task.dur!);
    const name = names.get(thread) ?? "unnamed";
    seconds.set(name, (seconds.get(name) ?? 0) + task.tdur! / 1e6);
  }
  return seconds;
}
