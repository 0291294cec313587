/** Somebody else's site: an origin of its own, with pages that know nothing of ours. */

import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import type { Page } from "playwright-core";
import { afterAll } from "vitest";
import { coloursIn } from "./colours";

export interface Answer {
  readonly body: string | Buffer;
  readonly status?: number;
  readonly headers?: Readonly<Record<string, string>>;
}

export interface Foreign {
  readonly url: string;
  /** What lies at a path. */
  put(path: string, answer: Answer | string): string;
}

/** To be awaited at the head of a file; pages are put there as tests need them. */
export async function openForeign(): Promise<Foreign> {
  const answers = new Map<string, Answer>();
  const server = createServer((request, response) => {
    const answer = answers.get(new URL(request.url ?? "/", "http://localhost").pathname);
    if (!answer) response.writeHead(404, { "content-type": "text/html" }).end("<h1>Not here</h1>");
    else response.writeHead(answer.status ?? 200, { "content-type": "text/html; charset=utf-8", ...answer.headers }).end(answer.body);
  });
  await new Promise<void>((ready) => server.listen(0, "127.0.0.1", ready));
  afterAll(() => void server.close());
  const url = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  const put = (path: string, answer: Answer | string): string => {
    answers.set(path, typeof answer === "string" ? { body: answer } : answer);
    return url + path;
  };
  return { url, put };
}

/** A page that says which events its sculptures have fired, in `events`. */
export function pageWith(body: string, script: string): string {
  return `<!doctype html><html lang="en"><meta charset="utf-8"><title>A portfolio</title>
<script>events = []; for (const name of ["load", "error", "camera-change", "view-change"]) addEventListener(name, ({ target, detail }) =>
  target.localName === "wire-sculpture" && events.push([target.id, name, detail]), true);</script>
<style>body { margin: 16px; font: 16px sans-serif } wire-sculpture { width: 320px; height: 320px }</style>
<script type="module" src="${script}"></script><main><h1>Works</h1>${body}</main></html>`;
}

/** Names of the events that a sculpture has fired, in their order. */
export function heard(page: Page, id: string): Promise<string[]> {
  return page.evaluate((id) => (globalThis as unknown as { events: [string, string][] }).events.filter(([at]) => at === id).map(([, name]) => name), id);
}

/** How much of what is seen there is copper. */
export async function copperAt(page: Page, selector: string): Promise<number> {
  return (await coloursIn(page, (await page.locator(selector).screenshot()).toString("base64"))).copper;
}
