/** The page at the widths and in the colours people have; the pictures are kept to be looked at. */

import type { Browser } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { launch, padsReady, serveDist, shoot, visit } from "./browser";

let browser: Browser;
let site: Awaited<ReturnType<typeof serveDist>>;

beforeAll(async () => {
  browser = await launch();
  site = await serveDist("/");
});
afterAll(async () => {
  await browser.close();
  site.server.close();
});

for (const [width, height] of [[1440, 900], [820, 1180], [360, 740]] as const) {
  for (const colorScheme of ["light", "dark"] as const) {
    it(`fits ${width} px, ${colorScheme}`, async () => {
      const { page, faults } = await visit(browser, site.url, { viewport: { width, height }, colorScheme, hasTouch: width < 900 });
      await padsReady(page);
      await page.evaluate(() => document.fonts.ready);
      await shoot(page, `${width}-${colorScheme}`);
      const wide = await page.evaluate(() => document.documentElement.scrollWidth);
      expect(wide).toBeLessThanOrEqual(width);
      const run = (await page.getByRole("button", { name: "Run" }).boundingBox())!;
      expect(run.width).toBeGreaterThan(200);
      expect(run.height).toBeGreaterThanOrEqual(44);
      // On a phone the stage, the pads and the button are all within the first screen.
      expect(run.y + run.height).toBeLessThanOrEqual(height);
      const background = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
      expect(background).toBe(colorScheme === "dark" ? "rgb(22, 21, 19)" : "rgb(246, 243, 238)");
      expect(faults).toEqual([]);
      await page.context().close();
    });
  }
}

it("says so where there is no WebGL 2, and everything else works", async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.addInitScript(() => {
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind === "webgl2" ? null : (getContext as (...a: unknown[]) => RenderingContext | null).call(this, kind, ...rest);
    } as typeof getContext;
  });
  await page.goto(site.url);
  await page.getByText("cannot draw in 3D here").waitFor();
  await padsReady(page);
  await context.close();
});
