/** What a person waits for at the example: the stage's first picture, the first wire under way, and each kind of wire. */

import { availableParallelism, loadavg } from "node:os";
import type { Browser, Page } from "playwright-core";
import { choose, launch, phase, runButton, serveDist, settled, visit } from "../browser/browser";
import { watchLongTasks } from "../browser/throttle";
import type { Account, Row } from "./budget";

const VIEWPORT = { viewport: { width: 1440, height: 900 } };
/** Medians of so many. */
const ROUNDS = Number(process.env["ROUNDS"] ?? 5);
const TASK_MS = 50;

interface Wire {
  readonly words: string;
  readonly limitS: number;
  /** Makes everything ready for the click. */
  readonly ready: (page: Page) => Promise<void>;
}

const WIRES: readonly Wire[] = [
  { words: "quick sketch of the example", limitS: 2.5, ready: (page) => choose(page, "preset", "fast") },
  { words: "the example at its best", limitS: 12, ready: (page) => choose(page, "preset", "best") },
  { words: "one picture, the example", limitS: 8, ready: (page) => toTask(page, "One picture") },
  { words: "the creature in petals", limitS: 10, ready: (page) => toTask(page, "A shape") },
];

async function toTask(page: Page, name: string): Promise<void> {
  await page.getByRole("tab", { name, exact: true }).click();
  await runButton(page).waitFor();
  await page.waitForTimeout(4000);
}

const median = (numbers: readonly number[]): number => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)]!;

interface Loaded {
  readonly firstPictureS: number;
  readonly longestMs: number;
}

/** From navigation to the stage's first picture. */
async function load(browser: Browser, url: string): Promise<Loaded> {
  const { page } = await visit(browser, "about:blank", VIEWPORT);
  const longTasks = await watchLongTasks(page);
  await page.goto(url);
  const ms = await page.evaluate(
    () =>
      new Promise<number>((seen) => {
        const look = (): void => {
          const at = performance.getEntriesByName("wire-sculpture drawn")[0]?.startTime;
          if (at === undefined) setTimeout(look, 20);
          else seen(at);
        };
        look();
      }),
  );
  await page.waitForTimeout(1500);
  const longestMs = Math.max(0, ...(await longTasks()).map(({ ms }) => ms));
  await page.context().close();
  return { firstPictureS: ms / 1000, longestMs };
}

interface Made {
  /** From the click to the first iteration, and to the finished wire. */
  readonly underWayS: number;
  readonly doneS: number;
  readonly longestMs: number;
  readonly match: string;
}

async function make(browser: Browser, url: string, { ready }: Wire): Promise<Made> {
  const { page } = await visit(browser, "about:blank", VIEWPORT);
  const longTasks = await watchLongTasks(page);
  await page.goto(url);
  await settled(page);
  await ready(page);
  await page.waitForTimeout(1500);
  const before = (await longTasks()).length;
  const button = page.getByRole("button", { name: /^\s*(Run|Make it again|Cover it)\s*$/ });
  await button.evaluate((element) => {
    const marks = { clicked: 0, running: 0, done: 0 };
    Object.assign(window, { marks });
    const root = element.getRootNode() as ShadowRoot;
    element.addEventListener("click", () => (marks.clicked = performance.now()), { capture: true });
    new MutationObserver(() => {
      const phase = root.querySelector("[data-phase]")!.getAttribute("data-phase");
      if (phase === "running" && !marks.running) marks.running = performance.now();
      if (phase === "idle" && marks.running && !marks.done) marks.done = performance.now();
    }).observe(root, { subtree: true, attributes: true, attributeFilter: ["data-phase"] });
  });
  await button.click();
  await phase(page, "running");
  while (!(await page.evaluate(() => (window as unknown as { marks: { done: number } }).marks.done))) await page.waitForTimeout(200);
  const { clicked, running, done } = await page.evaluate(() => (window as unknown as { marks: { clicked: number; running: number; done: number } }).marks);
  const longestMs = Math.max(0, ...(await longTasks()).slice(before).map(({ ms }) => ms));
  await page.locator("result-panel .verdict").waitFor();
  const match = ((await page.locator("result-panel .verdict").textContent()) ?? "").trim().replace(/\s+/g, " ").slice(0, 60);
  await page.context().close();
  return { underWayS: (running - clicked) / 1000, doneS: (done - clicked) / 1000, longestMs, match };
}

export async function runWaits(): Promise<Account> {
  const busy = loadavg()[0]!;
  const site = await serveDist("/");
  const browser = await launch();
  try {
    const rows: Row[] = [];
    const notes = [`Waits: ${availableParallelism()} processors, no graphics card, load average before: ${busy.toFixed(1)}; medians of ${ROUNDS} at ${VIEWPORT.viewport.width} x ${VIEWPORT.viewport.height}.`];
    const row = (budget: string, limit: number, values: readonly number[], unit: "s" | "ms"): void => {
      const value = median(values);
      const told = (value: number): string => (unit === "s" ? value.toFixed(2) : String(Math.round(value)));
      rows.push({ budget, limit: `${limit} ${unit}`, measured: `${told(value)} ${unit} (${told(Math.min(...values))} to ${told(Math.max(...values))})`, ok: value <= limit });
    };
    const asked = process.env["WIRES"]?.split(",").map(Number);
    const loads: Loaded[] = [];
    for (let i = 0; i < ROUNDS; i++) loads.push(await load(browser, site.url));
    row("stage's first picture after navigation", 1.5, loads.map(({ firstPictureS }) => firstPictureS), "s");
    row("longest task while loading", TASK_MS, loads.map(({ longestMs }) => longestMs), "ms");
    for (const [index, wire] of WIRES.entries()) {
      if (asked && !asked.includes(index)) continue;
      const made: Made[] = [];
      for (let i = 0; i < ROUNDS; i++) made.push(await make(browser, site.url, wire));
      row(`${wire.words}: the wire under way after the click`, 1, made.map(({ underWayS }) => underWayS), "s");
      row(`${wire.words}: done`, wire.limitS, made.map(({ doneS }) => doneS), "s");
      row(`${wire.words}: longest task`, TASK_MS, made.map(({ longestMs }) => longestMs), "ms");
      notes.push(`- ${wire.words}: ${made[0]!.match}`);
    }
    return { rows, notes: [...notes, ""] };
  } finally {
    await browser.close();
    site.server.close();
  }
}
