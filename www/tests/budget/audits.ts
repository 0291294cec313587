/** Lighthouse, as on a desktop. */

import { readFileSync } from "node:fs";
import { createServer, type AddressInfo } from "node:net";
import { join } from "node:path";
import lighthouse, { desktopConfig } from "lighthouse";
import { launch, ROOT, serveDist } from "../browser/browser";
import type { Account } from "./budget";

const LEAST = 95;
const ROUNDS = 3;
const CATEGORIES = ["performance", "accessibility", "best-practices"] as const;

/** The app, and the pages beside it; those are also to be found. */
const PAGES: readonly { readonly name: string; readonly path: string; readonly categories: readonly string[] }[] = [
  { name: "app", path: "", categories: CATEGORIES },
  { name: "gallery.html", path: "gallery.html", categories: [...CATEGORIES, "seo"] },
  { name: "docs.html", path: "docs.html", categories: [...CATEGORIES, "seo"] },
  { name: "embed.html", path: `embed.html#w=${exampleCode()}&shadow&views`, categories: [...CATEGORIES, "seo"] },
];

/** The parts of a report that are read here. */
interface Report {
  readonly runtimeError?: { readonly message: string };
  readonly categories: Readonly<Record<string, { title: string; score: number | null; auditRefs: { id: string; weight: number }[] }>>;
  readonly audits: Readonly<Record<string, { title: string; score: number | null; displayValue?: string; scoreDisplayMode: string }>>;
}

export async function runAudits(): Promise<Account> {
  const site = await serveDist("/");
  try {
    const accounts: Account[] = [];
    for (const page of PAGES) accounts.push(await auditPage(page, site.url));
    return { rows: accounts.flatMap(({ rows }) => rows), notes: accounts.flatMap(({ notes }) => notes) };
  } finally {
    site.server.close();
  }
}

/** The median of three for performance; the other categories do not depend on the machine's mood. */
async function auditPage({ name, path, categories }: (typeof PAGES)[number], site: string): Promise<Account> {
  const url = site + path;
  const reports: Report[] = [];
  for (let i = 0; i < ROUNDS; i++) reports.push(await audit(url, categories));
  const flat = await audit(url, categories, ["--disable-3d-apis"]);
  const score = (report: Report) => report.categories["performance"]!.score ?? 0;
  const report = reports.sort((a, b) => score(a) - score(b))[Math.floor(ROUNDS / 2)]!;
  const rows = categories.map((category) => {
    const { title, score: share } = report.categories[category]!;
    const points = Math.round(100 * (share ?? 0));
    const all = category === "performance" ? ` (median of ${reports.map((report) => Math.round(100 * score(report))).join(", ")})` : "";
    return { budget: `Lighthouse: ${name}: ${title.toLowerCase()}`, limit: `at least ${LEAST}`, measured: `${points}${all}`, ok: points >= LEAST };
  });
  // Drawn by the processor, WebGL blocks the page; a graphics card would not.
  const without = `Lighthouse's performance of ${name} without WebGL: ${Math.round(100 * score(flat))}`;
  return { rows, notes: [without, "Lighthouse's findings (those with a weight cost points):", ...categories.flatMap((category) => findings(report, category)), ""] };
}

/** One audit in a browser of its own, so that no cache helps the next one. */
async function audit(url: string, categories: readonly string[], args: readonly string[] = []): Promise<Report> {
  const port = await freePort();
  const browser = await launch({ args: [`--remote-debugging-port=${port}`, ...args] });
  try {
    const result = await lighthouse(url, { port, logLevel: "error", onlyCategories: [...categories] }, desktopConfig);
    const report = result!.lhr as unknown as Report;
    if (report.runtimeError) throw new Error(`Lighthouse: ${report.runtimeError.message}`);
    return report;
  } finally {
    await browser.close();
  }
}

function exampleCode(): string {
  return readFileSync(join(ROOT, "www/src/tasks/multiview/example/wire.code"), "utf8").trim();
}

async function freePort(): Promise<number> {
  const server = createServer().listen(0, "127.0.0.1");
  await new Promise((ready) => server.once("listening", ready));
  const { port } = server.address() as AddressInfo;
  await new Promise((closed) => server.close(closed));
  return port;
}

function findings({ categories, audits }: Report, category: string): string[] {
  return categories[category]!.auditRefs
    .map(({ id, weight }) => ({ id, weight, ...audits[id]! }))
    .filter(({ score, scoreDisplayMode }) => score !== null && score < 0.9 && !["informative", "notApplicable", "manual"].includes(scoreDisplayMode))
    .sort((a, b) => b.weight - a.weight)
    .map(({ id, weight, title, displayValue }) => `- ${category}, weight ${weight}: ${id}: ${title}${displayValue ? ` (${displayValue})` : ""}`);
}
