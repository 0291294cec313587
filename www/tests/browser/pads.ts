/** What the pads show. */

import type { Page } from "playwright-core";
import { pad } from "./browser";

/** Share of a pad's pixels that hold ink, weighted by how much. */
export function inkOn(page: Page, index: number): Promise<number> {
  return pad(page, index).locator("ink-canvas canvas#ink").evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    if (canvas.width === 0 || canvas.height === 0) return 0;
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    let ink = 0;
    for (let i = 3; i < data.length; i += 4) ink += data[i]!;
    return ink / 255 / (data.length / 4);
  });
}

/** Share of a pad's pixels that are hatched as ink that no wire can show. */
export function hatchedOn(page: Page, index: number): Promise<number> {
  return pad(page, index).locator("ink-canvas canvas#ink").evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    let hatched = 0;
    for (let i = 0; i < data.length; i += 4) hatched += data[i + 3]! > 100 && data[i]! - data[i + 2]! > 60 ? 1 : 0;
    return hatched / (data.length / 4);
  });
}

/** Waits until the page has said what the drawings come to. */
export async function previewed(page: Page): Promise<void> {
  // A change is looked at only after a moment.
  await page.waitForTimeout(400);
  await page.locator("remedy-list .sum").filter({ hasText: "shown" }).waitFor({ timeout: 60_000 });
  await page.locator("remedy-list section:not(.busy)").waitFor();
}

/** Waits until all three pads hold ink and the page knows what it comes to. */
export async function padsReady(page: Page): Promise<void> {
  await previewed(page);
}
