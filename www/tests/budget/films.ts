/** What a film costs: the time for one as it is posted, the share of drawing in that, and how long the page ever fails to answer. */

import { availableParallelism, loadavg } from "node:os";
import type { Page } from "playwright-core";
import { launch, serveDist, visit } from "../browser/browser";
import { watchLongTasks } from "../browser/throttle";
import type { Account } from "./budget";

const TASK_MS = 50;
/** What is made of each, and how many frames the whole would have. */
const FRAMES = 30;
const FILMS = [
  { words: "6 s of 1080p", width: 1920, height: 1080, gif: false, whole: 180 },
  { words: "6 s of GIF, 480 px", width: 480, height: 480, gif: true, whole: 120 },
] as const;

interface Made {
  readonly format: string;
  readonly ms: number;
  readonly drawMs: number;
  readonly encodeMs: number;
  readonly bytes: number;
}

export async function runFilms(): Promise<Account> {
  const load = loadavg()[0]!;
  const site = await serveDist("/");
  const browser = await launch();
  try {
    const { page } = await visit(browser, "about:blank");
    const longTasks = await watchLongTasks(page);
    await page.goto(site.url);
    await page.locator("save-panel").getByRole("button", { name: /^Pictures and films/ }).click();
    await page.locator("film-dialog").getByRole("heading").waitFor();
    await page.waitForTimeout(1500);
    const before = (await longTasks()).length;
    const notes: string[] = [`Films: ${availableParallelism()} processors, no graphics card, load average before: ${load.toFixed(1)} (other work makes these figures worse).`];
    for (const film of FILMS) {
      const { format, ms, drawMs, encodeMs, bytes } = await made(page, film);
      const times = film.whole / FRAMES;
      const share = Math.round((100 * drawMs) / (drawMs + encodeMs));
      const [all, encoding] = [ms, encodeMs].map((ms) => ((ms * times) / 1000).toFixed(1));
      notes.push(`- ${film.words} (${format}): ${all} s, ${share}% of it drawing; encoding alone ${encoding} s; ${((bytes * times) / 1e6).toFixed(1)} MB (${FRAMES} frames, times ${times})`);
    }
    const longest = Math.max(0, ...(await longTasks()).slice(before).map(({ ms }) => ms));
    return {
      rows: [{ budget: "longest task of the page while films are made", limit: `${TASK_MS} ms`, measured: longest ? `${Math.round(longest)} ms` : `none over ${TASK_MS} ms`, ok: longest <= TASK_MS }],
      notes: [...notes, ""],
    };
  } finally {
    await browser.close();
    site.server.close();
  }
}

/** By the dialog's own filmer. */
function made(page: Page, { width, height, gif }: (typeof FILMS)[number]): Promise<Made> {
  return page.locator("film-dialog").evaluate(
    async (element, [width, height, gif, frames]) => {
      type Progress = { readonly drawMs: number; readonly encodeMs: number };
      const dialog = element as unknown as { best: { format: string }; filmer: { film(order: object, progress: (progress: Progress) => void): Promise<Blob> } };
      const choice = gif ? { format: "gif", codec: "" } : dialog.best;
      let last: Progress = { drawMs: 0, encodeMs: 0 };
      const startMs = performance.now();
      const { size } = await dialog.filmer.film({ film: "turntable", size: { width, height }, choice, frames }, (progress) => (last = progress));
      return { format: choice.format, ms: performance.now() - startMs, drawMs: last.drawMs, encodeMs: last.encodeMs, bytes: size };
    },
    [width, height, gif, FRAMES] as const,
  );
}
