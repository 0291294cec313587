/** What people do with a mouse, a clipboard and files. */

import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Locator, Page } from "playwright-core";

/** A place within an element: shares of its width and height. */
export type Share = readonly [x: number, y: number];

/** Presses the mouse at the first point, draws through the others and lets go. */
export async function drawStroke(page: Page, element: Locator, points: readonly Share[]): Promise<void> {
  const at = await placesIn(element);
  await page.mouse.move(...at(points[0]!));
  await page.mouse.down();
  for (const point of points.slice(1)) await page.mouse.move(...at(point), { steps: 8 });
  await page.mouse.up();
}

async function placesIn(element: Locator): Promise<(share: Share) => [number, number]> {
  await element.scrollIntoViewIfNeeded();
  const box = await element.boundingBox();
  if (!box) throw new Error(`${element} is not shown, so nothing can be drawn or dropped there`);
  return ([x, y]) => [box.x + x * box.width, box.y + y * box.height];
}

/** Pastes a file wherever the focus is. */
export async function pasteFile(page: Page, name: string, type: string, buffer: Buffer): Promise<void> {
  await page.evaluate(
    ([name, type, base64]) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const clipboardData = new DataTransfer();
      clipboardData.items.add(new File([bytes], name, { type }));
      let target: Element = document.activeElement ?? document.body;
      while (target.shadowRoot?.activeElement) target = target.shadowRoot.activeElement;
      target.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true, composed: true }));
    },
    [name, type, buffer.toString("base64")] as const,
  );
}

/** A file that exists, a folder that exists, or a file made of bytes. */
export type Dropped = string | { readonly name: string; readonly buffer: Buffer };

/** Drags files or folders from outside over an element; `drop: false` holds them there. */
export async function dropFiles(page: Page, element: Locator, dropped: readonly Dropped[], { drop = true } = {}): Promise<void> {
  const files = await Promise.all(dropped.map((one) => (typeof one === "string" ? one : written(one.name, one.buffer))));
  const [x, y] = (await placesIn(element))([0.5, 0.5]);
  const session = await page.context().newCDPSession(page);
  const data = { items: [], files, dragOperationsMask: 1 };
  for (const type of ["dragEnter", "dragOver", ...(drop ? ["drop" as const] : [])] as const) {
    await session.send("Input.dispatchDragEvent", { type, x, y, data });
  }
  await session.detach();
}

async function written(name: string, buffer: Buffer): Promise<string> {
  const file = join(await mkdtemp(join(tmpdir(), "wire4d-")), name);
  await writeFile(file, buffer);
  return file;
}

/** The file that an action makes the browser save. */
export async function downloaded(page: Page, action: () => Promise<unknown>): Promise<{ name: string; bytes: Buffer }> {
  const [download] = await Promise.all([page.waitForEvent("download"), action()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}
