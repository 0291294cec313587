/** What a device or a person's choices may take from the page, taken before any of its scripts runs. */

import type { Page } from "playwright-core";

export interface Hardship {
  /** The whole page reads from right to left. */
  readonly rightToLeft?: boolean;
  /** Every way to keep something throws or fails with a SecurityError. */
  readonly storage?: "blocked";
  readonly webgl2?: false;
  /** There is no `Worker`. For wasm without SIMD see `launch`: it must hold in workers too. */
  readonly worker?: false;
  /** The engine's WebGPU is not there, finds no adapter, or refuses to look for one. */
  readonly webgpu?: keyof typeof WITHOUT_WEBGPU;
  /** A script for the engine's worker, before its own. */
  readonly inEngine?: string;
}

const WITHOUT_WEBGPU = {
  missing: `Reflect.deleteProperty(WorkerNavigator.prototype, "gpu");`,
  adapterless: `GPU.prototype.requestAdapter = async () => null;`,
  blocked: `GPU.prototype.requestAdapter = async () => { throw new DOMException("WebGPU is blocked.", "OperationError"); };`,
};

export async function suffer(page: Page, { rightToLeft, storage, webgl2, worker, webgpu, inEngine = "" }: Hardship): Promise<void> {
  if (rightToLeft) await page.addInitScript(readFromRight);
  if (storage === "blocked") await page.addInitScript(blockStorage);
  if (webgl2 === false) await page.addInitScript(takeWebgl2);
  if (worker === false) await page.addInitScript(() => Reflect.deleteProperty(window, "Worker"));
  const first = (webgpu ? WITHOUT_WEBGPU[webgpu] : "") + inEngine;
  if (first) {
    await page.route(/\/worker-[^/]*\.js$/, async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, body: `{${first}}\n${await response.text()}` });
    });
  }
}

function readFromRight(): void {
  const turn = () => document.documentElement?.setAttribute("dir", "rtl");
  turn();
  new MutationObserver((_, observer) => {
    if (document.documentElement) observer.disconnect();
    turn();
  }).observe(document, { childList: true });
}

function blockStorage(): void {
  const refuse = (): never => {
    throw new DOMException("Access is denied for this document.", "SecurityError");
  };
  for (const name of ["localStorage", "sessionStorage"]) Object.defineProperty(window, name, { get: refuse });
  IDBFactory.prototype.open = refuse;
  IDBFactory.prototype.deleteDatabase = refuse;
  IDBFactory.prototype.databases = async () => refuse();
  StorageManager.prototype.getDirectory = async () => refuse();
  StorageManager.prototype.persist = async () => false;
}

function takeWebgl2(): void {
  // Or it would be there in workers.
  Reflect.deleteProperty(HTMLCanvasElement.prototype, "transferControlToOffscreen");
  for (const { prototype } of [HTMLCanvasElement, OffscreenCanvas]) {
    const getContext = prototype.getContext as (...rest: unknown[]) => unknown;
    prototype.getContext = function (this: unknown, kind: string, ...rest: unknown[]) {
      return kind === "webgl2" ? null : getContext.call(this, kind, ...rest);
    } as never;
  }
}
