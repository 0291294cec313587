/** The page without a network, and the page when a new version of it comes. */

import { cp, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { BrowserContext, Page } from "playwright-core";
import { afterAll, expect, it } from "vitest";
import { choose, contextWithProfile, DIST, idle, phase, requestsElsewhere, run, serveDist, visit } from "./browser";
import { openSite } from "./site";

const PREFIX = "/school/wire4d/";
const { browser, site } = await openSite(PREFIX);
const folders: string[] = [];
afterAll(() => Promise.all(folders.map((folder) => rm(folder, { recursive: true }))));

const profile = (): Promise<BrowserContext> => contextWithProfile(browser, { serviceWorkers: "allow" });

/** Everything is kept, and the page is answered from there. */
async function kept(page: Page): Promise<void> {
  await page.waitForFunction(() => navigator.serviceWorker.controller?.state === "activated", null, { timeout: 120_000 });
}

const pageCaches = (page: Page): Promise<string[]> => page.evaluate(async () => (await caches.keys()).filter((name) => name.startsWith("wire4d-page-")));

/** Another build of the page: the same with a word in its title. */
async function another(word: string): Promise<string> {
  const folder = await mkdtemp(join(tmpdir(), "wire4d-"));
  folders.push(folder);
  await cp(DIST, folder, { recursive: true });
  const [page, worker] = [join(folder, "index.html"), join(folder, "offline.js")];
  const html = await readFile(page, "utf8");
  const script = /src="\.\/(assets\/index-[^"]+\.js)"/.exec(html)![1]!;
  const renamed = script.replace(/\.js$/, `-${word}.js`);
  await cp(join(folder, script), join(folder, renamed));
  await rm(join(folder, script));
  await writeFile(page, html.replaceAll(script, renamed).replace("<title>", `<title>${word} `));
  const text = await readFile(worker, "utf8");
  await writeFile(worker, text.replaceAll(script, renamed).replace(/(`wire4d-page-`[^`]*`)[0-9a-f]{8}/, `$1${word}`));
  return folder;
}

it("works where the network was cut after the first visit, in a folder of its host", async () => {
  const context = await profile();
  const first = await visit(context, site.url);
  await kept(first.page);
  await context.setOffline(true);
  await first.page.close();
  const { page, faults } = await visit(context, `${site.url}?renderer=cpu#v=1&preset=fast`);
  await run(page);
  await idle(page);
  await page.locator("result-panel .verdict").waitFor();
  for (const name of ["gallery.html", "docs.html"]) {
    const other = await visit(context, site.url + name);
    await other.page.locator("h1").first().waitFor();
    await other.page.close();
  }
  expect(faults).toEqual([]);
  await context.close();
});

it("asks nobody but its host for anything in a whole visit, and keeps nothing that only some want", async () => {
  const context = await profile();
  const asked: string[] = [];
  context.on("request", (request) => asked.push(request.url()));
  const seen = await visit(context, site.url);
  await kept(seen.page);
  expect(asked.length).toBeGreaterThan(50);
  expect(requestsElsewhere({ ...seen, requests: asked })).toEqual([]);
  expect(asked.filter((url) => /\.onnx|\/ort[.-]|gallery\//.test(url))).toEqual([]);
  await context.close();
});

it("goes on with its version while a new one waits, and shows that when it is asked to", async () => {
  const folder = await another("newer");
  const host = await serveDist("/", DIST);
  const context = await profile();
  const { page } = await visit(context, host.url);
  await kept(page);
  const address = new URL(host.url);
  await new Promise((closed) => {
    host.server.close(closed);
    host.server.closeAllConnections();
  });
  const next = await serveDist("/", folder, Number(address.port));
  const second = await visit(context, host.url);
  await second.page.getByText("A new version of this page is ready.").waitFor({ timeout: 60_000 });
  expect(await second.page.title()).not.toMatch(/^newer/);
  // A run is not interrupted.
  await choose(second.page, "preset", "fast");
  await run(second.page);
  await phase(second.page, "running");
  expect(await second.page.getByText("A new version of this page is ready.").count()).toBe(0);
  await second.page.getByRole("button", { name: /^\s*Stop\s*$/ }).click();
  await idle(second.page);
  await second.page.getByRole("button", { name: "Load it" }).click();
  await expect.poll(() => second.page.title().catch(() => ""), { timeout: 60_000 }).toMatch(/^newer/);
  // The tab of the version before has all its files still.
  expect(await page.title()).not.toMatch(/^newer/);
  expect(await pageCaches(page)).toHaveLength(2);
  await page.getByRole("tab", { name: "A shape", exact: true }).click();
  await page.getByText("Petals").first().waitFor();
  await page.close();
  // Looked at with every visit.
  const again = async (): Promise<readonly string[]> => {
    await second.page.reload();
    await second.page.waitForTimeout(500);
    return pageCaches(second.page);
  };
  await expect.poll(again).toHaveLength(1);
  await context.close();
  next.server.close();
});

it("says that it cannot be kept where there is no room, and works", async () => {
  const context = await profile();
  const { page } = await visit(context, "about:blank");
  const tools = await context.newCDPSession(page);
  await tools.send("Storage.overrideQuotaForOrigin", { origin: new URL(site.url).origin, quotaSize: 100_000 });
  await page.goto(site.url);
  await page.getByText("no room to keep the page").waitFor({ timeout: 60_000 });
  await choose(page, "preset", "fast");
  await run(page);
  await idle(page);
  await page.locator("result-panel .verdict").waitFor();
  await context.close();
});

it("can be installed", async () => {
  const context = await profile();
  const { page } = await visit(context, site.url);
  const tools = await context.newCDPSession(page);
  const { errors, url } = await tools.send("Page.getAppManifest");
  expect([url, errors]).toEqual([`${site.url}manifest.webmanifest`, []]);
  const icons = await page.evaluate(async () => ((await (await fetch("./manifest.webmanifest")).json()) as { icons: { src: string }[] }).icons.map(({ src }) => src));
  for (const icon of icons) expect((await context.request.get(site.url + icon)).ok(), icon).toBe(true);
  await kept(page);
  expect((await tools.send("Page.getInstallabilityErrors")).installabilityErrors.filter(({ errorId }) => errorId !== "in-incognito")).toEqual([]);
  await context.close();
});
