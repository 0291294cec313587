/** A wire for others: the dialog, its QR code, one HTML file from a disk, a frame on a stranger's page, the documentation. */

import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { createServer, type Server } from "node:http";
import { createRequire } from "node:module";
import type { AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import type { Frame, Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { codeIn } from "#sculpture/share/code";
import { axeFaults, COLOURS, fits, inspect } from "./a11y";
import { openPart, requestsElsewhere, ROOT, shoot, visit, type Visit, type VisitOptions } from "./browser";
import { downloaded } from "./gestures";
import { padsReady } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite("/wire/");
const WIDTHS = [
  { width: 360, height: 760 },
  { width: 820, height: 1100 },
  { width: 1440, height: 900 },
] as const;
const CLIPBOARD: VisitOptions = { permissions: ["clipboard-read", "clipboard-write"] };
const exampleCode = (await readFile(join(ROOT, "www/src/tasks/multiview/example/wire.code"), "utf8")).trim();

/** Opens the dialog of the wire on the stage. */
async function share(page: Page): Promise<void> {
  const more = page.locator("save-panel .more");
  await more.waitFor({ state: "attached" });
  await openPart(page, "Share");
  await more.click();
  await page.getByRole("dialog").waitFor();
}

const clipboard = (page: Page): Promise<string> => page.evaluate(() => navigator.clipboard.readText());
const linkField = (page: Page) => page.getByRole("dialog").getByLabel("The link", { exact: true });

describe("the dialog", () => {
  it.each(WIDTHS)("is at home in $width px, and axe finds nothing", async (viewport) => {
    for (const colorScheme of COLOURS) {
      const { page, faults } = await visit(browser, site.url, { viewport, colorScheme });
      await share(page);
      await inspect(page, `share-${viewport.width}-${colorScheme}`);
      await page.getByRole("tab", { name: "Embed" }).click();
      await expect.poll(() => shownWires(page)).toBe(1);
      await inspect(page, `embed-${viewport.width}-${colorScheme}`);
      expect(faults).toEqual([]);
      await page.context().close();
    }
  });

  it("copies the link, which carries the wire, by mouse and by keys alone", async () => {
    const { page, faults } = await visit(browser, site.url, CLIPBOARD);
    await padsReady(page);
    await page.locator("save-panel .more:enabled").waitFor();
    await page.keyboard.press("s");
    await page.getByRole("dialog").waitFor();
    // What most people want has the focus.
    await page.keyboard.press("Enter");
    await expect.poll(() => page.getByRole("dialog").getByRole("button", { name: "Copied" }).count()).toBe(1);
    const link = await clipboard(page);
    expect(link).toBe(await linkField(page).inputValue());
    expect(codeIn(link)!.whole).toBe(true);
    expect(new URL(link).hash).toBe(await page.evaluate(() => location.hash));
    await page.keyboard.press("Escape");
    await expect.poll(() => page.getByRole("dialog").count()).toBe(0);
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("marks the link where the clipboard is not to be had", async () => {
    const { page } = await visit(browser, site.url);
    await page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: { writeText: () => Promise.reject(new Error("no")) } }));
    await share(page);
    await page.getByRole("button", { name: "Copy link" }).last().click();
    await expect.poll(() => linkField(page).evaluate((field) => (field as HTMLInputElement).selectionEnd)).toBeGreaterThan(1000);
    await expect.poll(() => page.getByRole("status").filter({ hasText: /Ctrl/ }).count()).toBe(1);
    await page.context().close();
  });

  it("hands it to the system where that takes links", async () => {
    const { page } = await visit(browser, site.url);
    await page.evaluate(() => Object.assign(navigator, { share: async (what: ShareData) => void Object.assign(window, { sent: what }) }));
    await share(page);
    await page.getByRole("button", { name: "Send it with…" }).click();
    await expect.poll(() => page.evaluate(() => (window as unknown as { sent?: ShareData }).sent?.url)).toBe(await linkField(page).inputValue());
    await page.context().close();
  });

  it("has a QR code that another's reader reads, as it is shown and as a picture", async () => {
    const { page } = await visit(browser, site.url, { colorScheme: "dark", deviceScaleFactor: 2 });
    await share(page);
    const link = await linkField(page).inputValue();
    const code = page.getByRole("img", { name: "QR code of the link" });
    expect(await readQr(page, await code.screenshot())).toBe(link);
    const png = await downloaded(page, () => page.getByRole("button", { name: "PNG" }).last().click());
    expect(png.name).toMatch(/-qr\.png$/);
    expect(await readQr(page, png.bytes)).toBe(link);
    const svg = await downloaded(page, () => page.getByRole("button", { name: "SVG" }).last().click());
    expect(svg.bytes.toString()).toMatch(/^<svg /);
    // The reader can fail.
    expect(await readQr(page, await page.getByRole("heading", { name: "QR code" }).screenshot())).toBeNull();
    await page.context().close();
  });

  it("says so where a link is too long for a code, and offers files", async () => {
    const { page } = await visit(browser, `${site.url}#job=fill`);
    await share(page);
    const { length } = await linkField(page).inputValue();
    expect(length).toBeGreaterThan(2_953);
    await expect.poll(() => page.getByText(/A code holds 2,953 characters at most, and this link has/).count()).toBe(1);
    expect(await page.getByRole("img", { name: "QR code of the link" }).count()).toBe(0);
    expect(await page.getByText(/programs cut/).count()).toBe(length > 8_000 ? 1 : 0);
    await inspect(page, "share-too-long");
    await page.context().close();
  });
});

describe("embedding", () => {
  let visited: Visit;
  beforeAll(async () => {
    visited = await visit(browser, site.url, CLIPBOARD);
    await share(visited.page);
    await visited.page.getByRole("tab", { name: "Embed" }).click();
    await visited.page.locator("embed-panel wire-sculpture").waitFor();
  });

  const chosen = (name: string) => visited.page.locator("embed-panel").getByLabel(name, { exact: true });
  async function snippet(kind: string): Promise<string> {
    await chosen(kind).check({ force: true });
    await visited.page.locator("embed-panel .primary").click();
    await expect.poll(() => visited.page.locator("embed-panel").getByRole("button", { name: "Copied" }).count()).toBe(1);
    return clipboard(visited.page);
  }

  it("shows and writes what was chosen", async () => {
    await chosen("Steel").check({ force: true });
    await chosen("Turns by itself").check();
    await expect.poll(() => visited.page.locator("embed-panel wire-sculpture").getAttribute("look")).toBe("steel");
    const text = await snippet("Element");
    expect(text).toContain(`src="${site.url}wire-sculpture.js"`);
    for (const attribute of [/ code="[\w-]{500,}"/, / look="steel"/, / auto-rotate/, / shadow/, / alt="[^"]+"/]) expect(text).toMatch(attribute);
  });

  it("writes snippets that show the wire on a page that knows nothing of this one", async () => {
    const stranger = await serveText(`<!doctype html><title>Mine</title>${await snippet("Element")}\n${await snippet("Iframe")}`);
    const { page, faults } = await visit(browser, stranger.url);
    // The server of this test allows no other origin to read its modules: a frame needs nobody's leave.
    const frame = await frameOf(page, "embed.html");
    await expect.poll(() => shownWires(frame)).toBe(1);
    expect(faults.filter((fault) => !/CORS|ERR_FAILED/.test(fault))).toEqual([]);
    await shoot(page, "snippets-elsewhere");
    await page.context().close();
  });

  it("links to the documentation and leaves nothing behind", async () => {
    expect(await visited.page.getByRole("link", { name: "All that it can do" }).getAttribute("href")).toBe("./docs.html");
    expect(visited.faults).toEqual([]);
    expect(requestsElsewhere(visited)).toEqual([]);
    await visited.page.context().close();
  });
});

describe("one HTML file", () => {
  it("shows the wire from a disk and asks nobody for anything", async () => {
    const folder = await mkdtemp(join(tmpdir(), "wire4d-"));
    try {
      const { page } = await visit(browser, site.url);
      await share(page);
      const { name, bytes } = await downloaded(page, () => page.getByRole("dialog").getByRole("button", { name: /^\s*Web page/ }).click());
      await page.context().close();
      expect(name).toMatch(/\.html$/);
      expect(bytes.length).toBeLessThanOrEqual(300_000);
      const file = join(folder, "wire.html");
      await writeFile(file, bytes);
      const visited = await visit(browser, pathToFileURL(file).href);
      await expect.poll(() => shownWires(visited.page)).toBe(1);
      await inspect(visited.page, "one-file");
      expect(visited.requests.filter((asked) => !/^(blob|data):/.test(asked))).toEqual([visited.url]);
      expect(visited.faults).toEqual([]);
      await visited.page.context().close();
      // A picture of it without any script.
      const still = await visit(browser, pathToFileURL(file).href, { javaScriptEnabled: false });
      expect((await still.page.locator("noscript img, img").first().boundingBox())!.height).toBeGreaterThan(100);
      await still.page.context().close();
    } finally {
      await rm(folder, { recursive: true });
    }
  });
});

describe("a frame", () => {
  it("answers the page that its address names, from another origin", async () => {
    const { page, faults, close } = await framed({ named: true });
    expect(await heard(page, "load")).toBe(true);
    expect(await ask(page, { call: "flyTo", view: "side" })).toEqual({ answer: null });
    await expect.poll(async () => ((await ask(page, { call: "getState" })) as { answer: { view: string } }).answer.view).toBe("side");
    await expect.poll(() => heard(page, "view-change")).toBe(true);
    expect(await heard(page, "camera-change")).toBe(true);
    const { answer } = (await ask(page, { call: "getState" })) as { answer: object };
    expect(await ask(page, { call: "setState", state: { ...answer, look: "steel" } })).toEqual({ answer: null });
    await expect.poll(async () => ((await ask(page, { call: "getState" })) as { answer: { look: string } }).answer.look).toBe("steel");
    const picture = await page.evaluate(async () => {
      const { answer } = (await window.ask({ call: "toBlob", width: 320, height: 240, mimeType: "image/jpeg" })) as { answer: Blob };
      const { width, height } = await createImageBitmap(answer);
      return { type: answer.type, width, height };
    });
    expect(picture).toEqual({ type: "image/jpeg", width: 320, height: 240 });
    expect(await ask(page, { call: "play" })).toHaveProperty("answer");
    expect(faults).toEqual([]);
    await close();
  });

  it("ignores messages that are none", async () => {
    const { page, frame, faults, close } = await framed({ named: true });
    expect(await heard(page, "load")).toBe(true);
    const before = await ask(page, { call: "getState" });
    const count = () => page.evaluate(() => window.messages.length);
    const heardBefore = await count();
    await page.evaluate(() => {
      const to = "wire-sculpture";
      const hostile: unknown[] = [
        null, 1, "x", [], {}, new Map(), new Date(), new ArrayBuffer(8), { to }, { to, call: "remove", id: 1 }, { to, call: "constructor", id: 1 }, { to, call: "innerHTML", id: 1 },
        { to, call: "flyTo", view: { toString: 1 }, id: 1 }, { to, call: "toBlob", width: 1e9, height: 1e9, id: 1 }, { to, call: "toBlob", mimeType: "text/html", id: 1 },
        { to, call: "setState", state: "x", id: 1 }, { to, call: "setState", state: { big: "x".repeat(1e6) }, id: 1 }, { to, call: "getState", id: {} },
      ];
      for (const message of hostile) frames[0]!.postMessage(message, "*");
      // Of the right shape, with nonsense in it.
      frames[0]!.postMessage({ to, call: "setState", state: { camera: { azimuth: "<b>", reach: -1, target: [NaN] }, look: "gold", view: {}, color: "url(x)", widthScale: "1e99" } }, "*");
      frames[0]!.postMessage({ to, call: "flyTo", view: "nowhere" }, "*");
    });
    expect(await ask(page, { call: "getState" })).toMatchObject({ answer: { look: (before as { answer: { look: string } }).answer.look } });
    // Nothing but that answer, and what the camera did.
    const extra = await page.evaluate((from) => window.messages.slice(from).filter(({ event }) => event === undefined).length, heardBefore);
    expect(extra).toBe(1);
    expect(await shownWires(frame)).toBe(1);
    expect(faults).toEqual([]);
    await close();
  });

  it("is silent to a page that its address does not name", async () => {
    for (const options of [{ named: false }, { named: "https://elsewhere.example" }]) {
      const { page, frame, faults, close } = await framed(options);
      await expect.poll(() => shownWires(frame)).toBe(1);
      await page.evaluate(() => frames[0]!.postMessage({ to: "wire-sculpture", call: "getState", id: 1 }, "*"));
      await page.waitForTimeout(500);
      expect(await page.evaluate(() => window.messages)).toEqual([]);
      expect(faults.filter((fault) => !/target origin provided/.test(fault))).toEqual([]);
      await close();
    }
  });

  it("needs no storage, no workers and no origin of its own", async () => {
    const { page, frame, faults, close } = await framed({ named: true, sandbox: "allow-scripts" });
    await expect.poll(() => shownWires(frame)).toBe(1);
    expect(await frame.evaluate(() => { try { return localStorage.length; } catch { return "blocked"; } })).toBe("blocked");
    expect(await ask(page, { call: "flyTo", view: "top" })).toEqual({ answer: null });
    expect(faults).toEqual([]);
    await close();
  });

  it("shows a sentence, and runs nothing, whatever its fragment is", async () => {
    const mark = encodeURIComponent(`"><img src=x onerror=alert(1)><script>alert(1)</script>`);
    const hostile = [
      "", "#", "#w=", "#w=nonsense", `#w=${"A".repeat(70_000)}`, `#w=${mark}&alt=${mark}&look=${mark}&color=${mark}&views=${mark}&labels=${mark}&camera-orbit=${mark}`,
      `#src=${encodeURIComponent("javascript:alert(1)")}`, "#src=nothing.glb", "#src=docs.html", "#src=https://127.0.0.1:1/wire.glb", `#w=${exampleCode.slice(0, -3)}`, "#%E0%A4%A", `#labels=${encodeURIComponent('{"front":{}}')}`,
    ];
    for (const hash of hostile) {
      const { page, faults } = await visit(browser, `${site.url}embed.html${hash}`);
      let asked = "";
      page.on("dialog", (dialog) => void ((asked = dialog.message()), dialog.dismiss()));
      await page.waitForTimeout(300);
      expect(await page.evaluate(() => document.querySelectorAll("script").length), hash.slice(0, 60)).toBe(1);
      expect(await page.locator("img[src=x]").count()).toBe(0);
      expect(await shownWires(page)).toBe(0);
      expect(asked).toBe("");
      expect(faults.filter((fault) => !/Failed to load resource/.test(fault)), hash.slice(0, 60)).toEqual([]);
      await page.context().close();
    }
  });

  it("is clean to axe", async () => {
    const { page } = await visit(browser, `${site.url}embed.html#w=${exampleCode}&shadow&views&alt=A%20cat`);
    await expect.poll(() => shownWires(page)).toBe(1);
    await inspect(page, "embed-page");
    await page.context().close();
  });
});

describe("the documentation", () => {
  it.each(WIDTHS)("is at home in $width px, and axe finds nothing", async (viewport) => {
    const visited = await visit(browser, `${site.url}docs.html`, { viewport });
    const { page, faults } = visited;
    await expect.poll(() => shownWires(page)).toBeGreaterThan(0);
    for (const colorScheme of COLOURS) {
      await page.emulateMedia({ colorScheme });
      // The element draws beside the page.
      await page.waitForTimeout(500);
      await shoot(page, `docs-${viewport.width}-${colorScheme}`);
      await fits(page);
      expect(await axeFaults(page)).toEqual([]);
    }
    expect(requestsElsewhere(visited)).toEqual([]);
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("shows wires wherever there is an example", async () => {
    const { page } = await visit(browser, `${site.url}docs.html`);
    for (const sculpture of await page.locator("wire-sculpture").all()) {
      await sculpture.scrollIntoViewIfNeeded();
      await expect.poll(() => sculpture.evaluate((element) => (element as HTMLElement & { wire: unknown }).wire !== null)).toBe(true);
    }
    await page.locator("iframe").scrollIntoViewIfNeeded();
    const frame = await frameOf(page, "embed.html");
    await expect.poll(() => shownWires(frame)).toBe(1);
    await page.context().close();
  });

  it("copies each snippet as its file is", async () => {
    const { page } = await visit(browser, `${site.url}docs.html`, CLIPBOARD);
    const copied: string[] = [];
    // The buttons themselves: each has another name for a while after it was pressed.
    for (const button of await page.getByRole("button", { name: "Copy", exact: true }).elementHandles()) {
      await page.evaluate(() => navigator.clipboard.writeText(""));
      await button.click();
      await expect.poll(() => button.textContent()).toMatch(/Copied/);
      await expect.poll(() => clipboard(page)).not.toBe("");
      copied.push(await clipboard(page));
    }
    expect(copied.length).toBeGreaterThan(9);
    for (const name of ["Sculpture.tsx", "Sculpture.vue", "Sculpture.svelte", "element.html"]) {
      expect(copied).toContain((await readFile(join(ROOT, "www/packages/wire-sculpture/examples", name), "utf8")).trimEnd());
    }
    await page.context().close();
  });
});

/** How many elements show a wire: copper, steel or coloured pixels in a picture of what they show. */
function shownWires(page: Page | Frame): Promise<number> {
  return page.evaluate(async () => {
    type Sculpture = HTMLElement & { wire: unknown; toBlob(options: object): Promise<Blob> };
    const all: Sculpture[] = [];
    const look = (root: ParentNode): void => {
      for (const element of root.querySelectorAll("*")) {
        if (element.localName === "wire-sculpture") all.push(element as Sculpture);
        else if (element.shadowRoot) look(element.shadowRoot);
      }
    };
    look(document);
    let shown = 0;
    for (const sculpture of all) {
      if (!sculpture.wire) continue;
      const blob = await sculpture.toBlob({ width: 160, height: 120, transparent: true }).catch(() => null);
      if (!blob) continue;
      const picture = await createImageBitmap(blob);
      const context = new OffscreenCanvas(160, 120).getContext("2d")!;
      context.drawImage(picture, 0, 0);
      const { data } = context.getImageData(0, 0, 160, 120);
      const colours = new Set<number>();
      for (let at = 0; at < data.length; at += 4) if (data[at + 3]! > 100) colours.add((data[at]! >> 4) * 256 + (data[at + 1]! >> 4) * 16 + (data[at + 2]! >> 4));
      if (colours.size > 8) shown++;
    }
    return shown;
  });
}

/** What an independent reader reads in a picture; null for nothing. */
async function readQr(page: Page, picture: Buffer): Promise<string | null> {
  await page.evaluate(await readFile(createRequire(import.meta.url).resolve("jsqr"), "utf8"));
  return page.evaluate(async (base64) => {
    const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(base64), (character) => character.charCodeAt(0))]));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d")!;
    context.drawImage(bitmap, 0, 0);
    const { jsQR } = window as unknown as { jsQR: (data: Uint8ClampedArray, width: number, height: number) => { data: string } | null };
    return jsQR(context.getImageData(0, 0, bitmap.width, bitmap.height).data, bitmap.width, bitmap.height)?.data ?? null;
  }, picture.toString("base64"));
}

const servers: Server[] = [];
afterAll(() => servers.forEach((server) => server.close()));

/** A page of another origin. */
async function serveText(html: string): Promise<{ readonly url: string }> {
  const server = createServer((_, response) => response.writeHead(200, { "content-type": "text/html" }).end(html));
  servers.push(server);
  await new Promise<void>((ready) => server.listen(0, "127.0.0.1", ready));
  return { url: `http://127.0.0.1:${(server.address() as AddressInfo).port}/` };
}

interface Framed extends Visit {
  readonly frame: Frame;
  close(): Promise<void>;
}

/** A stranger's page with `embed.html` in it, whose address names that page, or another one, or none. */
async function framed({ named, sandbox }: { readonly named: boolean | string; readonly sandbox?: string }): Promise<Framed> {
  const html = `<!doctype html><title>A stranger's page</title><script>
    const messages = window.messages = [];
    const waiting = new Map();
    addEventListener("message", ({ data }) => { messages.push(data); waiting.get(data.id)?.(data); });
    let last = 0;
    window.ask = (message) => new Promise((answer) => {
      const id = ++last;
      waiting.set(id, ({ from, id, ...rest }) => answer(rest));
      frames[0].postMessage({ to: "wire-sculpture", id, ...message }, "*");
    });
    const origin = ${JSON.stringify(named)};
    const search = origin === false ? "" : "?origin=" + (origin === true ? location.origin : origin);
    addEventListener("DOMContentLoaded", () => {
      const frame = document.createElement("iframe");
      ${sandbox === undefined ? "" : `frame.sandbox = ${JSON.stringify(sandbox)};`}
      frame.title = "A wire";
      frame.width = 640; frame.height = 480;
      frame.src = ${JSON.stringify(`${site.url}embed.html`)} + search + ${JSON.stringify(`#w=${exampleCode}&shadow`)};
      document.body.append(frame);
    });
  </script>`;
  const { url } = await serveText(html);
  const visited = await visit(browser, url);
  return { ...visited, frame: await frameOf(visited.page, "embed.html"), close: () => visited.page.context().close() };
}

/** The frame with that page, once it is there. */
async function frameOf(page: Page, name: string): Promise<Frame> {
  const found = () => page.frames().find((frame) => frame.url().includes(name));
  await expect.poll(() => found() !== undefined).toBe(true);
  await found()!.waitForLoadState();
  return found()!;
}

interface Heard {
  readonly event?: string;
}

declare global {
  interface Window {
    messages: Heard[];
    ask(message: object): Promise<unknown>;
  }
}

const ask = (page: Page, message: object): Promise<unknown> => page.evaluate((message) => window.ask(message), message);

/** Whether that event has come, or comes soon. */
async function heard(page: Page, event: string): Promise<boolean> {
  await page.waitForFunction((event) => window.messages.some((message) => message.event === event), event);
  return true;
}
