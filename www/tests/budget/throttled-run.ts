/** A fast run on a processor four times slower, and how long the page ever fails to answer. */

import { existsSync, readFileSync } from "node:fs";
import { availableParallelism, loadavg } from "node:os";
import { join } from "node:path";
import { DIST, DRAWINGS, launch, serveDist, visit } from "../browser/browser";
import { throttle, watchLongTasks, type LongTask } from "../browser/throttle";
import type { Account, Row } from "./budget";
import { click, inPart, IN_APP, runToItsEnd, until } from "./quietly";

const SLOWER = 4;
const RUN_S = 15;
const SETTLED_MS = 1500;
const TASK_MS = 50;

/** Other work on the machine only ever makes things longer: the best of so many counts. */
const ROUNDS = 3;
const PREVIEWED = `!!${inPart("remedy-list", "section:not(.busy) .sum:not(.quiet)")}`;
/**
 * Pictures are put together in the process of the graphics card, as on every device that has one; here the processor
 * plays its part. By itself, Chromium without a card puts them together on the page's own thread.
 */
const COMPOSITED = ["--use-gl=angle", "--use-angle=swiftshader", "--ignore-gpu-blocklist", "--enable-gpu-rasterization"];

interface Measured {
  readonly seconds: number;
  readonly load: readonly LongTask[];
  readonly run: readonly LongTask[];
}

/** Chromium slows the page's thread but no worker, so what an unslowed processor needs, times four, counts too. */
export async function runThrottled(): Promise<Account> {
  const load = loadavg()[0]!;
  const full = await best(1, COMPOSITED);
  const slow = await best(SLOWER, COMPOSITED);
  const plain = await best(SLOWER, []);
  const estimate = SLOWER * full.seconds;
  return {
    rows: [
      { budget: `fast run, page ${SLOWER} times slower`, limit: `${RUN_S} s`, measured: `${slow.seconds.toFixed(1)} s`, ok: slow.seconds <= RUN_S },
      {
        budget: `fast run, everything ${SLOWER} times slower`,
        limit: `${RUN_S} s`,
        measured: `${estimate.toFixed(1)} s (${SLOWER} × ${full.seconds.toFixed(1)} s)`,
        ok: estimate <= RUN_S,
      },
      taskRow("loading", slow.load, plain.load, full.load),
      taskRow("a run", slow.run, plain.run, full.run),
    ],
    notes: [
      `Processors: ${availableParallelism()}; load average before: ${load.toFixed(1)} (other work makes these figures worse); best of ${ROUNDS}.`,
      `Chromium cannot slow workers down, hence four times the seconds. It ran with ${COMPOSITED.join(" ")}.`,
      ...list("while loading", slow.load),
      ...list("during a run", slow.run),
      ...list("while loading, put together on the page's thread", plain.load),
      ...list("during a run, put together on the page's thread", plain.run),
      "",
    ],
  };
}

async function best(slower: number, args: readonly string[]): Promise<Measured> {
  const rounds: Measured[] = [];
  for (let i = 0; i < ROUNDS; i++) rounds.push(await fastRun(slower, args));
  const least = (tasks: (round: Measured) => readonly LongTask[]): readonly LongTask[] =>
    rounds.map(tasks).sort((a, b) => (longestFirst(a)[0]?.ms ?? 0) - (longestFirst(b)[0]?.ms ?? 0))[0]!;
  return { seconds: Math.min(...rounds.map(({ seconds }) => seconds)), load: least(({ load }) => load), run: least(({ run }) => run) };
}

async function fastRun(slower: number, args: readonly string[]): Promise<Measured> {
  const site = await serveDist("/");
  const browser = await launch({ args });
  try {
    // Watched from before the page is there: on a blank page first.
    const { page } = await visit(browser, "about:blank");
    const longTasks = await watchLongTasks(page);
    await throttle(page, slower);
    await page.goto(site.url);
    await until(page, PREVIEWED);
    await page.waitForTimeout(SETTLED_MS);
    const load = await longTasks();
    // What it costs to fill in the drawings counts as part of the run.
    for (const [i, side] of ["front", "side", "top"].entries()) {
      const field = await page.evaluateHandle<HTMLInputElement>(`${IN_APP}.querySelectorAll("drawing-pad")[${i}].shadowRoot.querySelector("input")`);
      await field.asElement()!.setInputFiles(join(DRAWINGS, "t01-animals", `${side}.png`));
      await until(page, `!${inPart("drawing-pad", "section.busy")}`);
    }
    await page.waitForTimeout(SETTLED_MS);
    await until(page, PREVIEWED);
    await click(page, inPart("run-choices", "input[name=preset][value=fast]"));
    const seconds = await runToItsEnd(page);
    await page.waitForTimeout(SETTLED_MS);
    return { seconds, load, run: (await longTasks()).slice(load.length) };
  } finally {
    await browser.close();
    site.server.close();
  }
}

function taskRow(when: string, tasks: readonly LongTask[], plain: readonly LongTask[], unslowed: readonly LongTask[]): Row {
  const longest = longestFirst(tasks)[0];
  const others = `unslowed ${told(longestFirst(unslowed)[0])}; put together on the page's thread ${told(longestFirst(plain)[0])}`;
  const measured = `${told(longest)}; ${others}`;
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
