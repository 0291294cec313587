/** The built page and a browser to visit it, for all tests of a file. */

import type { Browser } from "playwright-core";
import { afterAll } from "vitest";
import { launch, serveDist, type LaunchOptions, type Site } from "./browser";

/** To be awaited at the head of the file; what is opened here is closed after its last test. */
export async function openSite(prefix = "/", options: LaunchOptions = {}, folder?: string): Promise<{ readonly browser: Browser; readonly site: Site }> {
  const browser = await launch(options);
  const site = await serveDist(prefix, folder);
  afterAll(async () => {
    await browser.close();
    site.server.close();
  });
  return { browser, site };
}
