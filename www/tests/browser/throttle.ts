/** A slower processor, and the tasks that keep a page from answering. */

import type { Page } from "playwright-core";

/**
 * Slows the page's own thread down. Chromium refuses to slow workers ("only supported for pages, not workers"), so what
 * they do takes as long as before.
 */
export async function throttle(page: Page, times: number): Promise<void> {
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setCPUThrottlingRate", { rate: times });
}

/** A task of more than 50 ms, in the page's own time. */
export interface LongTask {
  readonly start: number;
  readonly ms: number;
  /** The scripts that took most of the frame it was in, or what else the browser says of it. */
  readonly where: string;
}

interface Kept {
  tasks: { start: number; ms: number; name: string }[];
  scripts: { start: number; ms: number; what: string }[];
}

declare global {
  interface Window {
    keptLongTasks?: Kept;
  }
}

/** Writes down long tasks from the next load on; afterwards says which there were. */
export async function watchLongTasks(page: Page): Promise<() => Promise<LongTask[]>> {
  await page.addInitScript(keepLongTasks);
  return async () => {
    // Entries arrive in a task of their own.
    await page.waitForTimeout(300);
    const { tasks, scripts } = await page.evaluate(() => window.keptLongTasks!);
    return tasks.map(({ start, ms, name }) => {
      const within = scripts.filter((script) => script.start < start + ms && script.start + script.ms > start);
      const most = within.sort((a, b) => b.ms - a.ms).slice(0, 2);
      return { start, ms, where: most.map(({ what, ms }) => `${what} ${Math.round(ms)} ms`).join(" + ") || `no script (${name})` };
    });
  };
}

function keepLongTasks(): void {
  interface Script extends PerformanceEntry {
    readonly invoker: string;
    readonly sourceURL: string;
    readonly sourceFunctionName: string;
    readonly sourceCharPosition: number;
  }
  const kept: Kept = { tasks: [], scripts: [] };
  window.keptLongTasks = kept;
  new PerformanceObserver((list) => {
    for (const { startTime: start, duration: ms, name } of list.getEntries()) kept.tasks.push({ start, ms, name });
  }).observe({ type: "longtask", buffered: true });
  new PerformanceObserver((list) => {
    for (const frame of list.getEntries() as (PerformanceEntry & { scripts?: Script[] })[]) {
      for (const script of frame.scripts ?? []) {
        const file = script.sourceURL.replace(/.*\//, "");
        const what = `${script.sourceFunctionName || script.invoker} (${file}:${script.sourceCharPosition})`;
        kept.scripts.push({ start: script.startTime, ms: script.duration, what });
      }
    }
  }).observe({ type: "long-animation-frame", buffered: true });
}
