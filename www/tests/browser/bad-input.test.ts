/** Whatever is put on the page that is no drawing gets a sentence, and what was there stays. */

import { mkdtemp, open } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import { inspect } from "./a11y";
import { DRAWINGS, give, pad, picture, runButton, visit } from "./browser";
import { dropFiles } from "./gestures";
import { padsReady } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite();
let page: Page;
let faults: string[];

beforeAll(async () => {
  ({ page, faults } = await visit(browser, site.url));
  await padsReady(page);
});

const shown = (index: number) => pad(page, index).locator("canvas#ink").evaluate((canvas) => (canvas as HTMLCanvasElement).toDataURL());

/** What the front pad says about a file, and that its drawing is still there. */
async function complaint(file: Parameters<typeof give>[2], named: string): Promise<string> {
  const before = await shown(0);
  await give(page, 0, file);
  const message = pad(page, 0).getByRole("alert");
  await message.filter({ hasText: named }).waitFor();
  await expect.poll(() => shown(0)).toBe(before);
  const words = (await message.textContent())!;
  await message.getByRole("button", { name: "Close this message" }).click();
  return words;
}

const bytes = (name: string, mimeType: string, buffer: Buffer) => complaint({ name, mimeType, buffer }, name);

it("a file that is no picture", async () => {
  expect(await bytes("notes.txt", "text/plain", Buffer.from("hello"))).toContain("not a picture");
  expect(await bytes("nothing.png", "image/png", Buffer.alloc(0))).toContain("empty");
  expect(await bytes("<img src=x onerror=alert(1)>.png", "image/png", Buffer.from("x"))).toContain("<img src=x");
});

it("a picture cut off in the middle", async () => {
  const whole = await picture(page, 300, 300, "cross", "image/png");
  expect(await bytes("cut.png", "image/png", whole.subarray(0, 60))).toContain("not a picture");
});

it("a blank picture and a fully inked one", async () => {
  expect(await bytes("blank.png", "image/png", await picture(page, 64, 64, "blank"))).toMatch(/blank|no ink|empty/);
  expect(await bytes("black.png", "image/png", await picture(page, 64, 64, "full"))).toMatch(/ink|blank/);
});

it("a picture of 20,000 x 20,000 pixels, before it is decoded", async () => {
  const head = Buffer.from(await picture(page, 8, 8, "cross"));
  head.writeUInt32BE(20_000, 16);
  head.writeUInt32BE(20_000, 20);
  expect(await bytes("huge.png", "image/png", head)).toContain("20,000 × 20,000");
});

it("a file of 200 MB, before it is read", async () => {
  const path = join(await mkdtemp(join(tmpdir(), "wire4d-")), "enormous.png");
  const file = await open(path, "w");
  await file.truncate(200_000_000);
  await file.close();
  expect(await complaint(path, "enormous.png")).toContain("200 MB");
  await inspect(page, "bad-input");
});

it("a film, a folder and fifty files, dropped on the page", async () => {
  const stage = page.locator("wire-stage");
  const alert = page.locator("notice-list").getByRole("alert");
  const before = await Promise.all([0, 1, 2].map(shown));
  await dropFiles(page, stage, [{ name: "cat.mp4", buffer: Buffer.from("x") }]);
  await alert.filter({ hasText: "cat.mp4 is a film" }).waitFor();
  await dropFiles(page, stage, [join(DRAWINGS, "t01-animals")]);
  await alert.filter({ hasText: /t01-animals is a folder/ }).waitFor();
  await inspect(page, "dropped-folder");
  expect(await Promise.all([0, 1, 2].map(shown))).toEqual(before);
  const cross = await picture(page, 100, 100, "cross");
  await dropFiles(page, stage, Array.from({ length: 50 }, (_, i) => ({ name: `picture-${i}.png`, buffer: cross })));
  await alert.filter({ hasText: "the first three of 50 files were taken" }).waitFor();
  await page.getByRole("button", { name: /^Undo: Put picture-2\.png/ }).waitFor();
});

it("a wire.json that is none", async () => {
  const alert = page.locator("notice-list").getByRole("alert");
  for (const [name, text] of [["broken.json", "{"], ["other.json", `{"format":"gltf"}`], ["nan.wire.json", `{"format":"wire4d","version":1,"closed":false,"knots":[0],"control_points":[[0,0,0,"x"]],"views":[]}`]] as const) {
    await dropFiles(page, page.locator("wire-stage"), [{ name, buffer: Buffer.from(text) }]);
    await alert.filter({ hasText: name }).waitFor();
  }
});

it("a large picture is scaled down, saying so", async () => {
  await give(page, 0, { name: "large.jpg", mimeType: "image/jpeg", buffer: await picture(page, 3000, 2000, "cross", "image/jpeg") });
  await pad(page, 0).getByText("Scaled down from 3000 × 2000 pixels.").waitFor({ state: "attached" });
});

it("fewer than two pictures", async () => {
  for (const i of [1, 2]) {
    await pad(page, i).getByRole("button", { name: /^More/ }).click();
    await page.getByRole("menuitem", { name: "Clear" }).click();
  }
  await runButton(page).click();
  await page.getByRole("alert").filter({ hasText: "at least two drawings" }).waitFor();
  await expect.poll(() => page.locator("p[data-phase]").getAttribute("data-phase")).toBe("idle");
});

it("took all of this without a fault", () => {
  expect(faults).toEqual([]);
});
