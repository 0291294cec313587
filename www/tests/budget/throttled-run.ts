/** A fast run on a processor four times slower, and how long the page ever fails to answer. */

import { existsSync, readFileSync } from "node:fs";
import { availableParallelism, loadavg } from "node:os";
import { join } from "node:path";
import { choose, DIST, DRAWINGS, give, idle, launch, run, serveDist, settled, visit } from "../browser/browser";
import { padsReady } from "../browser/pads";
import { throttle, watchLongTasks, type LongTask } from "../browser/throttle";
import type { Account, Row } from "./budget";

const SLOWER = 4;
const RUN_S = 15;
const TASK_MS = 50;

interface Measured {
  readonly seconds: number;
  readonly load: readonly LongTask[];
  readonly run: readonly LongTask[];
}

/** Chromium slows the page's thread but no worker, so the run counts by its seconds on an unslowed processor, times four. */
export async function runThrottled(): Promise<Account> {
  const load = loadavg()[0]!;
  const full = await fastRun(1);
  const slow = await fastRun(SLOWER);
  const flat = await fastRun(SLOWER, ["--disable-3d-apis"]);
  const estimate = SLOWER * full.seconds;
  const seconds = `${SLOWER} × ${full.seconds.toFixed(1)} s; ${slow.seconds.toFixed(1)} s with only the page's thread slowed, ${flat.seconds.toFixed(1)} s so without WebGL`;
  return {
    rows: [
      { budget: `fast run, ${SLOWER} times slower`, limit: `${RUN_S} s`, measured: `${estimate.toFixed(1)} s (${seconds})`, ok: Math.max(estimate, slow.seconds) <= RUN_S },
      taskRow("loading", slow.load, flat.load),
      taskRow("a run", slow.run, flat.run),
    ],
    notes: [
      `Processors: ${availableParallelism()}; load average before: ${load.toFixed(1)} (other work makes these figures worse).`,
      "Chromium cannot slow workers down, hence four times the seconds. Without a graphics card WebGL is drawn on the processor,",
      "in a process that is not slowed but shares the cores, and the page waits for it; so the same is measured without WebGL.",
      ...list("while loading", slow.load),
      ...list("during a run", slow.run),
      ...list("while loading, without WebGL", flat.load),
      ...list("during a run, without WebGL", flat.run),
      "",
    ],
  };
}

async function fastRun(slower: number, args: readonly string[] = []): Promise<Measured> {
  const site = await serveDist("/");
  const browser = await launch({ args });
  try {
    // Watched from before the page is there: on a blank page first.
    const { page } = await visit(browser, "about:blank");
    const longTasks = await watchLongTasks(page);
    await throttle(page, slower);
    await page.goto(site.url);
    await padsReady(page);
    await settled(page);
    const load = await longTasks();
    // What it costs to fill in the drawings counts as part of the run.
    for (const [i, side] of ["front", "side", "top"].entries()) await give(page, i, join(DRAWINGS, "t01-animals", `${side}.png`));
    await padsReady(page);
    await choose(page, "preset", "fast");
    const start = performance.now();
    await run(page);
    await idle(page);
    const seconds = (performance.now() - start) / 1000;
    return { seconds, load, run: (await longTasks()).slice(load.length) };
  } finally {
    await browser.close();
    site.server.close();
  }
}

function taskRow(when: string, tasks: readonly LongTask[], flat: readonly LongTask[]): Row {
  const longest = longestFirst(tasks)[0];
  const measured = `${told(longest)}; without WebGL ${told(longestFirst(flat)[0])}`;
  return { budget: `longest task during ${when}, ${SLOWER} times slower`, limit: `${TASK_MS} ms`, measured, ok: !longest || longest.ms <= TASK_MS };
}

function told(task: LongTask | undefined): string {
  return task ? `${Math.round(task.ms)} ms (scripts ${scriptMs(task)} ms)` : `none over ${TASK_MS} ms`;
}

function longestFirst(tasks: readonly LongTask[]): LongTask[] {
  return [...tasks].sort((a, b) => b.ms - a.ms);
}

function scriptMs({ scripts }: LongTask): number {
  return Math.round(scripts.reduce((sum, { ms }) => sum + ms, 0));
}

function list(when: string, tasks: readonly LongTask[]): string[] {
  const lines = longestFirst(tasks).slice(0, 6).map((task) => {
    const scripts = task.scripts.slice(0, 3).map(({ name, file, at, ms }) => `\n    ${Math.round(ms)} ms ${name}${codeAt(file, at)}`);
    return `- ${Math.round(task.ms)} ms at ${(task.start / 1000).toFixed(2)} s, scripts ${scriptMs(task)} ms${scripts.join("")}`;
  });
  return [`Long tasks ${when}: ${tasks.length}`, ...lines];
}

/** The beginning of the built code that a position means. */
function codeAt(file: string, at: number): string {
  const path = join(DIST, "assets", file);
  if (!file || at < 0 || !existsSync(path)) return "";
  return ` (${file}: ${readFileSync(path, "utf8").slice(at, at + 70).replace(/\s+/g, " ")})`;
}
