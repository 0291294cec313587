/** Nothing but the core, in a browser whose graphics card is a program, so that every machine has one. */

import { join } from "node:path";
import type { Browser, Page } from "playwright-core";
import { ROOT } from "./browser";
import { openSite } from "./site";

const PAGE = `<!doctype html><title>core</title><link rel="icon" href="data:,">
<script type="module">
  import init, * as core from "./wire4d.js";
  await init({ module_or_path: "./wire4d_bg.wasm" });
  window.core = core;
</script>`;

export type Core = typeof import("../../src/engine/wasm/wire4d");

/** A page whose `core` is the module. */
export async function openCore(): Promise<{ readonly browser: Browser; readonly page: Page }> {
  const args = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"];
  const { browser, site } = await openSite("/", { args }, join(ROOT, "www/src/engine/wasm"));
  const page = await browser.newPage();
  await page.route("**/core.html", (route) => route.fulfill({ contentType: "text/html", body: PAGE }));
  await page.goto(`${site.url}core.html`);
  await page.waitForFunction(() => "core" in window);
  return { browser, page };
}
