/** Whatever is put into a pad that is no drawing gets a sentence, and what was there stays. */

import type { Browser, Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { give, launch, pad, picture, serveDist, shoot, visit } from "./browser";
import { padsReady } from "./pads";

let browser: Browser;
let site: Awaited<ReturnType<typeof serveDist>>;
let page: Page;
let faults: string[];

beforeAll(async () => {
  browser = await launch();
  site = await serveDist("/");
  ({ page, faults } = await visit(browser, site.url));
  await padsReady(page);
});
afterAll(async () => {
  await browser.close();
  site.server.close();
});

/** What the front pad says about a file, and that its drawing is still there. */
async function complaint(name: string, mimeType: string, buffer: Buffer): Promise<string> {
  const before = await pad(page, 0).locator("canvas").evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  await give(page, 0, { name, mimeType, buffer });
  const message = pad(page, 0).getByRole("alert");
  await message.filter({ hasText: name }).waitFor();
  const after = await pad(page, 0).locator("canvas").evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());
  expect(after).toBe(before);
  return (await message.textContent())!;
}

it("a file that is no picture", async () => {
  expect(await complaint("notes.txt", "text/plain", Buffer.from("hello"))).toContain("not a picture");
  expect(await complaint("nothing.png", "image/png", Buffer.alloc(0))).toContain("empty");
  expect(await complaint("<img src=x onerror=alert(1)>.png", "image/png", Buffer.from("x"))).toContain("<img src=x");
});

it("a picture cut off in the middle", async () => {
  const whole = await picture(page, 300, 300, "cross", "image/png");
  expect(await complaint("cut.png", "image/png", whole.subarray(0, 60))).toContain("not a picture");
});

it("a blank picture and a fully inked one", async () => {
  expect(await complaint("blank.png", "image/png", await picture(page, 64, 64, "blank"))).toMatch(/blank|no ink|empty/);
  expect(await complaint("black.png", "image/png", await picture(page, 64, 64, "full"))).toMatch(/ink|blank/);
  await shoot(page, "bad-input");
});

it("a picture of 20,000 x 20,000 pixels, before it is decoded", async () => {
  const head = Buffer.from(await picture(page, 8, 8, "cross"));
  head.writeUInt32BE(20_000, 16);
  head.writeUInt32BE(20_000, 20);
  expect(await complaint("huge.png", "image/png", head)).toContain("20,000 × 20,000");
});

it("a large picture is scaled down, saying so", async () => {
  await give(page, 0, { name: "large.jpg", mimeType: "image/jpeg", buffer: await picture(page, 3000, 2000, "cross", "image/jpeg") });
  await pad(page, 0).getByText("Scaled down from 3000 × 2000 pixels.").waitFor();
  const size = await pad(page, 0).locator("canvas").evaluate((canvas) => [(canvas as HTMLCanvasElement).width, (canvas as HTMLCanvasElement).height]);
  expect(size).toEqual([1024, 683]);
});

it("fewer than two pictures", async () => {
  for (const i of [1, 2]) await pad(page, i).getByRole("button", { name: /Clear/ }).click();
  await page.getByRole("button", { name: "Run" }).click();
  await page.getByRole("alert").filter({ hasText: "at least two drawings" }).waitFor();
  expect(await page.locator("p[data-phase]").getAttribute("data-phase")).toBe("idle");
});

it("took all of this without a fault", () => {
  expect(faults).toEqual([]);
});
