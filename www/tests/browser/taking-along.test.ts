/** A wire is taken along: as files of every kind, and as a link that needs nothing but the page. */

import { mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { beforeAll, describe, expect, it } from "vitest";
import { inspect } from "./a11y";
import { choose, DRAWINGS, give, idle, phase, requestsElsewhere, runButton, SHOTS, visit, type Visit } from "./browser";
import { downloaded, dropFiles } from "./gestures";
import { validateGlb } from "./glb";
import { solidOfGlb, solidOfStl } from "./three";
import { padsReady, previewed } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite("/wire/");
let visited: Visit;
let page: Page;
let link: string;

beforeAll(async () => {
  visited = await visit(browser, site.url);
  ({ page } = visited);
  await padsReady(page);
  for (const [i, side] of ["front", "side"].entries()) await give(page, i, join(DRAWINGS, "p02-garden", `${side}.png`));
  await page.locator("drawing-pad").nth(2).getByRole("button", { name: /^More/ }).click();
  await page.getByRole("menuitem", { name: "Clear" }).click();
  await previewed(page);
  await choose(page, "preset", "fast");
  await runButton(page).click();
  await phase(page, "running");
  await idle(page);
  await page.locator("save-panel summary").click();
});

const save = (name: RegExp) => downloaded(page, () => page.locator("save-panel").getByRole("button", { name }).click());

describe("as a file", () => {
  it("GLB, which the Khronos validator accepts", async () => {
    const { name, bytes } = await save(/^GLB/);
    expect(name).toMatch(/\.glb$/);
    const report = await validateGlb(bytes);
    expect(report.messages).toEqual([]);
    expect(report.triangles).toBeGreaterThan(1000);
    // The check can fail: the same file with a broken index.
    const broken = Buffer.from(bytes);
    broken.writeUInt32LE(0xffff_fff0, broken.length - 8);
    expect((await validateGlb(broken)).errors).toBeGreaterThan(0);
  });

  it("STL, whole and ten centimetres long", async () => {
    const { bytes } = await save(/^STL/);
    const triangles = bytes.readUInt32LE(80);
    expect(bytes.length).toBe(84 + 50 * triangles);
    const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
    for (let triangle = 0; triangle < triangles; triangle++) {
      for (let k = 3; k < 12; k++) {
        const x = bytes.readFloatLE(84 + 50 * triangle + 4 * k);
        low[k % 3] = Math.min(low[k % 3]!, x);
        high[k % 3] = Math.max(high[k % 3]!, x);
      }
    }
    expect(Math.max(...high.map((x, c) => x - low[c]!))).toBeCloseTo(100, 0);
  });

  it("GLB and STL, which three.js reads as one solid, upright in each format's own way", async () => {
    const glb = await solidOfGlb((await save(/^GLB/)).bytes);
    const stl = solidOfStl((await save(/^STL/)).bytes);
    expect(glb.triangles).toBeGreaterThan(1000);
    expect(stl.triangles).toBeGreaterThan(1000);
    const mm = 100 / Math.max(...glb.extents);
    // Up is along y in GLB and along z in STL.
    const [across, up, deep] = glb.extents.map((extent) => extent * mm);
    for (const [c, extent] of [across!, deep!, up!].entries()) expect(Math.abs(stl.extents[c]! - extent)).toBeLessThan(2.5);
    expect(Math.abs(up! - deep!)).toBeGreaterThan(5);
  });

  it("OBJ, a solid of vertices and faces", async () => {
    const text = (await save(/^OBJ/)).bytes.toString();
    const vertices = text.match(/^v /gm)!.length;
    const faces = [...text.matchAll(/^f (.*)$/gm)];
    expect(faces.length).toBeGreaterThan(1000);
    const largest = faces.flatMap(([, face]) => face!.split(" ").map((corner) => parseInt(corner))).reduce((a, b) => Math.max(a, b), 0);
    expect(largest).toBe(vertices);
  });

  it("SVG of the view that was chosen", async () => {
    const views = page.getByLabel("View of the SVG");
    const seen = [];
    for (const view of ["front", "side"]) {
      await views.selectOption(view);
      const { name, bytes } = await save(/^SVG/);
      expect(name).toMatch(new RegExp(`-${view}\\.svg$`));
      const paths = await page.evaluate((text) => {
        const parsed = new DOMParser().parseFromString(text, "image/svg+xml");
        return parsed.querySelector("parsererror") ? -1 : parsed.querySelectorAll("path").length;
      }, bytes.toString());
      expect(paths).toBeGreaterThan(0);
      seen.push(bytes.toString());
    }
    expect(seen[0]).not.toBe(seen[1]);
  });

  it("centre lines of that view, one path in real size", async () => {
    await page.getByLabel("View of the SVG").selectOption("side");
    const { name, bytes } = await save(/^Centre lines/);
    expect(name).toMatch(/-side-lines\.svg$/);
    const drawn = await page.evaluate((text) => {
      const svg = new DOMParser().parseFromString(text, "image/svg+xml").documentElement as unknown as SVGSVGElement;
      document.body.append(svg);
      const paths = [...svg.querySelectorAll("path")];
      const { width, height } = svg.viewBox.baseVal;
      const answer = { paths: paths.length, lengthPx: paths[0]!.getTotalLength(), sides: [svg.getAttribute("width"), svg.getAttribute("height")], box: [width, height] };
      svg.remove();
      return answer;
    }, bytes.toString());
    expect(drawn.paths).toBe(1);
    const sides = drawn.sides.map((side) => Number(/^([\d.]+)mm$/.exec(side!)![1]));
    expect(Math.max(...sides)).toBeCloseTo(100, 1);
    expect(sides[0]! / sides[1]!).toBeCloseTo(drawn.box[0]! / drawn.box[1]!, 2);
    // The wire goes over a picture of 256 px several times.
    expect(drawn.lengthPx).toBeGreaterThan(800);
  });

  it("PNG of the stage, large and not blank", async () => {
    const { name, bytes } = await save(/^PNG/);
    await mkdir(SHOTS, { recursive: true });
    await writeFile(join(SHOTS, "saved-picture.png"), bytes);
    expect(name).toMatch(/\.png$/);
    expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([2400, 1800]);
    expect(bytes.length).toBeGreaterThan(50_000);
  });

  it("a bend list, in millimetres", async () => {
    const lines = (await save(/^Bend list/)).bytes.toString().trim().split("\n");
    expect(lines[0]).toMatch(/mm/);
    expect(lines.length).toBeGreaterThan(20);
  });

  it("wire.json, which opens here again with every control point", async () => {
    const { bytes } = await save(/^wire\.json/);
    const wire = JSON.parse(bytes.toString()) as { format: string; version: number; knots: number[]; control_points: number[][]; views: { name: string }[] };
    expect([wire.format, wire.version]).toEqual(["wire4d", 1]);
    // Closed: the first three control points follow again.
    expect(wire.knots.length).toBe(wire.control_points.length + 7);
    expect(wire.views.map(({ name }) => name)).toEqual(["front", "side"]);
    const other = await visit(browser, site.url);
    await padsReady(other.page);
    await dropFiles(other.page, other.page.locator("wire-stage"), [{ name: "mine.wire.json", buffer: bytes }]);
    await other.page.getByRole("button", { name: /^Undo: Open mine\.wire\.json/ }).waitFor();
    await other.page.locator("save-panel summary").click();
    const again = await downloaded(other.page, () => other.page.locator("save-panel").getByRole("button", { name: /^wire\.json/ }).click());
    expect(JSON.parse(again.bytes.toString()).control_points).toEqual(wire.control_points);
    await other.page.context().close();
  });
});

describe("as a link", () => {
  it("carries the wire and the settings, and opens in a fresh browser at once, without the engine", async () => {
    await page.locator("save-panel").getByRole("button", { name: "Copy link" }).click();
    await page.waitForURL(/#v=1&w=/);
    link = page.url();
    expect(link).toContain("&preset=fast");
    const other = await visit(browser, link, { worker: false });
    // Without a worker there is the wire all the same: the stage is not empty and its views are named.
    await expect.poll(() => other.page.locator("[data-view]").allTextContents()).toHaveLength(2);
    await expect.poll(() => inked(other.page)).toBeGreaterThan(0.005);
    await inspect(other.page, "link-without-worker");
    await other.page.context().close();
    const fresh = await visit(browser, link);
    await fresh.page.getByRole("button", { name: /^Undo: Open the link/ }).waitFor();
    await expect.poll(() => fresh.page.locator("input[name=preset][value=fast]").isChecked()).toBe(true);
    await inspect(fresh.page, "from-link");
    expect(requestsElsewhere(fresh)).toEqual([]);
    expect(fresh.faults).toEqual([]);
    await fresh.page.context().close();
  });

  it("takes settings and seed, and ignores what it does not know", async () => {
    const { page, faults } = await visit(browser, `${site.url}#v=1&preset=fast&seed=7&colour=red&iterations=-5&__proto__=x`);
    await padsReady(page);
    await expect.poll(() => page.locator("input[name=preset][value=fast]").isChecked()).toBe(true);
    await page.locator("settings-panel summary").first().click();
    await expect.poll(() => page.locator("[data-setting=seed] #control").inputValue()).toBe("7");
    await expect.poll(() => page.locator("[data-setting=iterations] #control").inputValue()).toBe("200");
    // What a person changes shows in the address.
    await choose(page, "bend", "free");
    await expect.poll(() => page.evaluate(() => location.hash)).toBe("#v=1&preset=fast&seed=7&bend=free");
    expect(faults).toEqual([]);
    await page.context().close();
  });

  it("says so when it is damaged, empty or of a newer page, and everything else works", async () => {
    const middle = Math.floor((link.indexOf("&w=") + link.indexOf("&preset")) / 2);
    const damaged = link.slice(0, middle) + (link[middle] === "A" ? "B" : "A") + link.slice(middle + 1);
    const cases: [string, RegExp][] = [
      [damaged, /damaged|incomplete/],
      [link.slice(0, middle), /damaged|incomplete/],
      [`${site.url}#w=`, /empty|incomplete/],
      [`${site.url}#w=${"%00<b>x".repeat(50)}`, /[Ll]ink|[Cc]ode/],
      [link.replace("v=1", "v=2"), /newer Wire4D/],
    ];
    for (const [bad, words] of cases) {
      const { page, faults } = await visit(browser, bad);
      const message = page.getByRole("alert").filter({ hasText: words });
      await message.waitFor();
      await expect.poll(() => page.locator("b", { hasText: /^x$/ }).count()).toBe(0);
      await expect.poll(() => runButton(page).isEnabled()).toBe(true);
      expect(faults).toEqual([]);
      await page.context().close();
    }
  });

  it("is opened when it is pasted, and other text is told where to go", async () => {
    const { page } = await visit(browser, site.url);
    await padsReady(page);
    const paste = (text: string) =>
      page.evaluate((text) => {
        const clipboardData = new DataTransfer();
        clipboardData.setData("text/plain", text);
        document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true, composed: true }));
      }, text);
    await paste("hello <b>you</b>");
    await page.getByRole("alert").filter({ hasText: "That was text" }).waitFor();
    await paste(`Look: ${link}`);
    await page.getByRole("button", { name: /^Undo: Open the link/ }).waitFor();
    await page.context().close();
  });
});

it("asked nobody else for anything, and nothing went wrong", async () => {
  expect(requestsElsewhere(visited)).toEqual([]);
  expect(visited.faults).toEqual([]);
  expect(await readFile(join(SHOTS, "saved-picture.png"))).toBeTruthy();
});

/** Share of the match panels that is inked. */
function inked(page: Page): Promise<number> {
  return page.locator("match-panels canvas").first().evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    let ink = 0;
    for (let i = 3; i < data.length; i += 4) ink += data[i]! > 100 ? 1 : 0;
    return ink / (data.length / 4);
  });
}
