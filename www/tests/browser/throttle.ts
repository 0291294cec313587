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

/** What a script did in a frame. */
export interface ScriptShare {
  readonly name: string;
  /** Its file's name and the place in it, in characters; the name is empty if the browser does not tell. */
  readonly file: string;
  readonly at: number;
  readonly ms: number;
}

/** A task of more than 50 ms, in the page's own time; what its scripts did not take went into style, layout and drawing. */
export interface LongTask {
  readonly start: number;
  readonly ms: number;
  /** Longest first. */
  readonly scripts: readonly ScriptShare[];
}

interface Kept {
  tasks: { start: number; ms: number }[];
  scripts: (ScriptShare & { start: number })[];
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
    return tasks.map(({ start, ms }) => {
      const within = scripts.filter((script) => script.start < start + ms && script.start + script.ms > start);
      return { start, ms, scripts: within.sort((a, b) => b.ms - a.ms) };
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
    for (const { startTime: start, duration: ms } of list.getEntries()) kept.tasks.push({ start, ms });
  }).observe({ type: "longtask", buffered: true });
  new PerformanceObserver((list) => {
    for (const frame of list.getEntries() as (PerformanceEntry & { scripts?: Script[] })[]) {
      for (const script of frame.scripts ?? []) {
        const name = script.sourceFunctionName || script.invoker;
        const file = script.sourceURL.replace(/.*\//, "");
        kept.scripts.push({ start: script.startTime, ms: script.duration, name, file, at: script.sourceCharPosition });
      }
    }
  }).observe({ type: "long-animation-frame", buffered: true });
}
