/** What was saved opens again, whatever kind of file it is: with its wire, its settings and what it was made of. */

import { join } from "node:path";
import type { Page } from "playwright-core";
import { beforeAll, describe, expect, it } from "vitest";
import { choose, DRAWINGS, give, idle, pad, phase, picture, ROOT, runButton, shoot, visit, type Visit } from "./browser";
import { downloaded, dropFiles, pasteFile } from "./gestures";
import { validateGlb } from "./glb";
import { inkOn, padsReady, previewed } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite("/wire/");
/** What would be markup, if anybody took it for that. */
const HOSTILE = "<img src=x onerror=document.title=1>.png";
const KINDS = { png: /^PNG/, svg: /^SVG/, "lines.svg": /^Centre lines/, glb: /^GLB/, "wire.json": /^wire\.json/ } as const;
type Kind = keyof typeof KINDS;

let visited: Visit;
let code: string;
let ink: number[];
const files = {} as Record<Kind, Buffer>;

const stage = (page: Page) => page.locator("wire-stage");
const alert = (page: Page) => page.locator("notice-list").getByRole("alert");
const remix = (page: Page) => page.getByRole("button", { name: "Remix", exact: true });
const undo = (page: Page, label: RegExp) => page.getByRole("button", { name: label });
const inks = (page: Page) => Promise.all([0, 1, 2].map((i) => inkOn(page, i)));
const clear = async (page: Page, i: number): Promise<void> => {
  await pad(page, i).getByRole("button", { name: /^More/ }).click();
  await page.getByRole("menuitem", { name: "Clear" }).click();
};

/** The code of the wire that is there, by the link to it. */
async function codeOf(page: Page): Promise<string> {
  await page.evaluate(() => history.replaceState(null, "", "#"));
  await page.locator("save-panel").getByRole("button", { name: "Copy link" }).click();
  await page.waitForURL(/w=/);
  return new URLSearchParams(new URL(page.url()).hash.slice(1)).get("w")!;
}

async function quick(page: Page): Promise<void> {
  await choose(page, "preset", "fast");
  await choose(page, "size", "64");
  await choose(page, "iterations", "30");
  await choose(page, "seed", "7");
}

async function made(page: Page, button = runButton(page)): Promise<void> {
  await button.click();
  await phase(page, "running");
  await idle(page);
}

async function save(page: Page, kind: Kind): Promise<Buffer> {
  const button = page.locator("save-panel").getByRole("button", { name: KINDS[kind] });
  if (!(await button.isVisible())) await page.locator("save-panel summary").click();
  return (await downloaded(page, () => button.click())).bytes;
}

async function opens(page: Page, name: string, buffer: Buffer): Promise<void> {
  await dropFiles(page, stage(page), [{ name, buffer }]);
  await undo(page, new RegExp(`^Undo: Open ${name.replaceAll(".", "\\.")}`)).waitFor();
}

beforeAll(async () => {
  visited = await visit(browser, site.url);
  const { page } = visited;
  await padsReady(page);
  const front = await picture(page, 300, 300, "cross");
  await give(page, 0, { name: HOSTILE, mimeType: "image/png", buffer: front });
  await give(page, 1, join(DRAWINGS, "p02-garden", "side.png"));
  await clear(page, 2);
  await previewed(page);
  await quick(page);
  await made(page);
  code = await codeOf(page);
  ink = await inks(page);
  for (const kind of Object.keys(KINDS) as Kind[]) files[kind] = await save(page, kind);
}, 240_000);

describe("a file of every kind", () => {
  for (const kind of Object.keys(KINDS) as Kind[]) {
    it(`${kind} opens in a fresh browser as it was`, async () => {
      const { page, faults } = await visit(browser, site.url);
      await padsReady(page);
      const before = await inks(page);
      await opens(page, `it.${kind}`, files[kind]);
      await remix(page).waitFor();
      expect(await codeOf(page)).toBe(code);
      await previewed(page);
      const after = await inks(page);
      // The same drawings, but for being smaller in the file.
      after.forEach((share, i) => expect(Math.abs(share - ink[i]!)).toBeLessThan(0.02 * Math.max(share, ink[i]!) + 1e-3));
      await expect.poll(() => page.locator("input[name=preset][value=fast]").isChecked()).toBe(true);
      expect(await page.title()).not.toBe("1");
      // It is one step, and what was there is back.
      await undo(page, /^Undo: Open it/).click();
      await expect.poll(() => inks(page)).toEqual(before);
      expect(await runButton(page).isVisible()).toBe(true);
      expect(faults).toEqual([]);
      await page.context().close();
    });
  }

  it("is larger by at most 60 kB, and a model that others can read", async () => {
    const report = await validateGlb(files.glb);
    expect([report.messages, report.errors]).toEqual([[], 0]);
    const capsule = (JSON.parse(files["wire.json"].toString()) as { drawings: { png: string; label: string }[] }).drawings;
    expect(capsule).toHaveLength(2);
    expect(capsule[0]!.label).toContain("<img");
    const bytes = capsule.reduce((sum, { png }) => sum + png.length, 0);
    expect(bytes).toBeGreaterThan(500);
    expect(bytes).toBeLessThan(20_000);
    // Nothing in the drawing is markup but what draws.
    const elements = await visited.page.evaluate((text) => [...new DOMParser().parseFromString(text, "image/svg+xml").querySelectorAll("*")].map(({ localName }) => localName), files.svg.toString());
    expect([...new Set(elements)].sort()).toEqual(["metadata", "path", "svg"]);
  });
});

describe("Remix", () => {
  it("goes on from a file: the same drawings, settings and seed make the same wire", async () => {
    const { page } = await visit(browser, site.url);
    await padsReady(page);
    await opens(page, "it.png", files.png);
    await shoot(page, "reopened");
    await previewed(page);
    await made(page, remix(page));
    await undo(page, /^Undo: Make the wire/).waitFor();
    expect(await runButton(page).isVisible()).toBe(true);
    // What was saved again carries it again.
    const again = JSON.parse((await save(page, "wire.json")).toString()) as { made_with: { seed: number; settings: { iterations: number } }; drawings: { label: string }[] };
    expect([again.made_with.seed, again.made_with.settings.iterations]).toEqual([7, 30]);
    expect(again.drawings.map(({ label }) => label)).toEqual(["<img src=x onerror=document.title=1>", "side"]);
    await page.context().close();
  });

  it("turns to the task that a file is of: one picture, and a shape", async () => {
    const { page, faults } = await visit(browser, site.url);
    await padsReady(page);
    await page.getByRole("tab", { name: "One picture" }).click();
    await page.locator("subject-pad").getByRole("button", { name: "Mark", exact: true }).waitFor();
    await quick(page);
    await made(page);
    const stroke = await save(page, "png");
    await page.getByRole("tab", { name: "A shape" }).click();
    await page.locator("shape-pad input[value=sphere]").check({ force: true });
    await page.getByText(/triangles\./).waitFor({ timeout: 60_000 });
    await choose(page, "preset", "fast");
    await choose(page, "size", "64");
    await choose(page, "iterations", "10");
    await page.locator("fill-choices #curve_spacing").fill("0.16");
    await page.waitForTimeout(400);
    await page.locator("fill-choices .laying:not(.busy)").waitFor({ state: "attached", timeout: 60_000 });
    await made(page, page.getByRole("button", { name: "Cover it", exact: true }));
    const [cover, fillCode] = [await save(page, "glb"), await codeOf(page)];
    expect(faults).toEqual([]);
    await page.context().close();

    const fresh = await visit(browser, site.url);
    await padsReady(fresh.page);
    await opens(fresh.page, "one.png", stroke);
    await expect.poll(() => fresh.page.getByRole("tab", { name: "One picture" }).getAttribute("aria-selected")).toBe("true");
    await fresh.page.locator("subject-pad subject-canvas[name*='its object in colour']").waitFor();
    await made(fresh.page, remix(fresh.page));
    await opens(fresh.page, "cover.glb", cover);
    await expect.poll(() => fresh.page.getByRole("tab", { name: "A shape" }).getAttribute("aria-selected")).toBe("true");
    await expect.poll(() => fresh.page.locator("shape-pad input[value=sphere]").isChecked()).toBe(true);
    expect(await codeOf(fresh.page)).toBe(fillCode);
    await made(fresh.page, remix(fresh.page));
    expect(fresh.faults).toEqual([]);
    await fresh.page.context().close();
  }, 240_000);
});

describe("anywhere", () => {
  it("pasted, and put into a pad, it opens; a picture of somebody else is a drawing", async () => {
    const { page } = await visit(browser, site.url);
    await padsReady(page);
    await pasteFile(page, "pasted.png", "image/png", files.png);
    await undo(page, /^Undo: Open pasted\.png/).waitFor();
    await give(page, 2, { name: "given.svg", mimeType: "image/svg+xml", buffer: files.svg });
    await undo(page, /^Undo: Open given\.svg/).waitFor();
    expect(await codeOf(page)).toBe(code);
    await dropFiles(page, stage(page), [{ name: "theirs.png", buffer: await picture(page, 80, 80, "cross") }]);
    await undo(page, /^Undo: Put theirs\.png on the top pad/).waitFor();
    await dropFiles(page, stage(page), [join(ROOT, "tests/drawings/p02-garden/front.png")]);
    await undo(page, /^Undo: Put front\.png/).waitFor();
    await page.context().close();
  });
});

describe("a damaged file", () => {
  it("says so in a sentence that names it, and nothing is lost", async () => {
    const { page, faults } = await visit(browser, site.url);
    await padsReady(page);
    await opens(page, "it.png", files.png);
    await previewed(page);
    const before = await inks(page);
    for (const [kind, mark] of [["png", '"code":"'], ["svg", '"code":"'], ["glb", '"code":"'], ["wire.json", '"knots":[']] as const) {
      const at = files[kind].indexOf(mark) + mark.length;
      const flipped = Buffer.from(files[kind]);
      flipped[at + 5]! ^= 4;
      if (kind === "wire.json") flipped[at - 1] = 0x7b;
      const newer = Buffer.from(files[kind].toString("latin1").replace('"version":1', '"version":2'), "latin1");
      const cases: [string, Buffer, RegExp][] = [[`flipped.${kind}`, flipped, /damaged|JSON/]];
      // A picture's text has a checksum, which is wrong now.
      cases.push([`newer.${kind}`, newer, kind === "png" ? /damaged/ : /update Wire4D|newer/]);
      if (kind !== "png") cases.push([`cut.${kind}`, files[kind].subarray(0, at + 40), /damaged|JSON/]);
      for (const [name, buffer, words] of cases) {
        await dropFiles(page, stage(page), [{ name, buffer }]);
        await alert(page).filter({ hasText: name }).filter({ hasText: words }).waitFor();
      }
    }
    await expect.poll(() => inks(page)).toEqual(before);
    expect(await codeOf(page)).toBe(code);
    expect(faults).toEqual([]);
    await page.context().close();
  });
});

it("went without a fault where it was made", () => {
  expect(visited.faults).toEqual([]);
});
