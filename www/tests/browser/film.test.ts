/** Pictures and films to post: made, played, cancelled, and made without the browser's encoder. */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Locator, Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { tagsFor } from "../../plugins/open-graph";
import { inspect } from "./a11y";
import { choose, DIST, idle, phase, runButton, visit } from "./browser";
import { downloaded } from "./gestures";
import { openSite } from "./site";

const { browser, site } = await openSite("/films/");

/** Opens the dialog over the wire that is there. */
async function open(page: Page): Promise<Locator> {
  await page.locator("save-panel").getByRole("button", { name: /^Pictures and films/ }).click();
  const dialog = page.locator("film-dialog");
  await dialog.getByRole("heading", { name: "Pictures and films" }).waitFor();
  return dialog;
}

const pick = (dialog: Locator, value: string): Promise<void> => dialog.locator(`input[value=${value}]`).check({ force: true });

async function size(dialog: Locator, width: number, height: number): Promise<void> {
  await pick(dialog, "custom");
  for (const [name, px] of [["Width", width], ["Height", height]] as const) {
    await dialog.getByLabel(`${name} in pixels`).fill(String(px));
    await dialog.getByLabel(`${name} in pixels`).press("Tab");
  }
}

const words = (dialog: Locator) => expect.poll(() => dialog.getByRole("status").textContent());

/** How far a film is. */
const course = async (dialog: Locator): Promise<string> => (await dialog.locator("#course").allTextContents()).join();

/** A film of few frames, by the dialog's own filmer: base64. */
function short(dialog: Locator, film: "turntable" | "found", format: "best" | "gif", frames: number): Promise<string> {
  return dialog.evaluate(
    async (element, [film, format, frames]) => {
      const { filmer, best } = element as unknown as { filmer: { film(order: object, progress: () => void): Promise<Blob> }; best: object };
      const choice = format === "gif" ? { format, codec: "" } : best;
      const blob = await filmer.film({ film, size: { width: 160, height: 90 }, choice, frames }, () => undefined);
      let text = "";
      for (const byte of new Uint8Array(await blob.arrayBuffer())) text += String.fromCharCode(byte);
      return btoa(text);
    },
    [film, format, frames] as const,
  );
}

/** What a browser sees of a GIF: its size, how many frames it has, and how many of the pixels differ between first and last. */
function decoded(page: Page, gif: string) {
  return page.evaluate(async (gif) => {
    const decoder = new ImageDecoder({ data: Uint8Array.from(atob(gif), (letter) => letter.charCodeAt(0)), type: "image/gif" });
    await Promise.all([decoder.completed, decoder.tracks.ready]);
    const { frameCount, repetitionCount } = decoder.tracks.selectedTrack!;
    const pixels = async (frameIndex: number): Promise<Uint8ClampedArray> => {
      const { image } = await decoder.decode({ frameIndex });
      const context = new OffscreenCanvas(image.displayWidth, image.displayHeight).getContext("2d")!;
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, image.displayWidth, image.displayHeight).data;
    };
    const { image } = await decoder.decode({ frameIndex: 0 });
    const [first, last] = [await pixels(0), await pixels(frameCount - 1)];
    let differ = 0;
    for (let at = 0; at < first.length; at += 4) differ += Math.abs(first[at]! - last[at]!) > 40 ? 1 : 0;
    return { size: [image.displayWidth, image.displayHeight], seconds: image.duration! / 1e6, frameCount, forEver: repetitionCount === Infinity, differ };
  }, gif);
}

describe("of the example", async () => {
  const { page, faults } = await visit(browser, site.url);
  const dialog = await open(page);

  it("a picture of any size, with nothing behind it", async () => {
    await inspect(page, "film-picture");
    await pick(dialog, "wire");
    await pick(dialog, "clear");
    await size(dialog, 300, 200);
    const { name, bytes } = await downloaded(page, () => dialog.getByRole("button", { name: "Save the picture" }).click());
    expect(name).toBe("cat-bird-fish.png");
    await words(dialog).toMatch(/^Saved cat-bird-fish\.png/);
    const seen = await page.evaluate(async (png) => {
      const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (letter) => letter.charCodeAt(0))]));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d")!;
      context.drawImage(bitmap, 0, 0);
      const { data, width, height } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      const corners = [0, width - 1, width * (height - 1), width * height - 1].map((pixel) => data[4 * pixel + 3]);
      let copper = 0;
      for (let at = 0; at < data.length; at += 4) copper += data[at + 3]! > 200 && data[at]! - data[at + 2]! > 50 ? 1 : 0;
      return { width, height, corners, copper };
    }, bytes.toString("base64"));
    expect(seen).toMatchObject({ width: 300, height: 200, corners: [0, 0, 0, 0] });
    expect(seen.copper).toBeGreaterThan(200);
  });

  it("a picture in pieces, which show no seam", async () => {
    await pick(dialog, "light");
    await pick(dialog, "room");
    await size(dialog, 2100, 300);
    const { bytes } = await downloaded(page, () => dialog.getByRole("button", { name: "Save the picture" }).click());
    const steps = await page.evaluate(async (png) => {
      const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (letter) => letter.charCodeAt(0))]));
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d")!;
      context.drawImage(bitmap, 0, 0);
      const { data, width, height } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      /** The mean difference between a column and the next. */
      const step = (x: number): number => {
        let sum = 0;
        for (let y = 0; y < height; y++) for (let c = 0; c < 3; c++) sum += Math.abs(data[4 * (y * width + x) + c]! - data[4 * (y * width + x + 1) + c]!);
        return sum / height;
      };
      const inside = Array.from({ length: 200 }, (_, i) => step(950 + i)).sort((a, b) => a - b);
      return { width, height, seam: step(1049), most: inside.at(-1)!, median: inside[100]! };
    }, bytes.toString("base64"));
    expect([steps.width, steps.height]).toEqual([2100, 300]);
    expect(steps.median).toBeGreaterThan(0);
    expect(steps.seam).toBeLessThanOrEqual(steps.most);
  });

  it("a video that a browser plays", async () => {
    await pick(dialog, "turntable");
    await inspect(page, "film-turntable");
    const best = () => dialog.evaluate((element) => (element as unknown as { best: { format: string } | null }).best);
    await expect.poll(best).toBeTruthy();
    const { format } = (await best())!;
    expect(["mp4", "webm"]).toContain(format);
    const film = await short(dialog, "turntable", "best", 12);
    const player = await page.context().newPage();
    const played = await player.evaluate(
      async ([film, type]) => {
        const video = document.createElement("video");
        video.muted = true;
        video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(film), (letter) => letter.charCodeAt(0))], { type }));
        await new Promise((loaded, failed) => {
          video.onloadeddata = loaded;
          video.onerror = () => failed(new Error(video.error!.message));
        });
        const { duration, videoWidth, videoHeight } = video;
        // What was loaded is drawn for sure only where somebody has gone, and only once its frame is on show.
        await new Promise((shown) => {
          video.requestVideoFrameCallback(shown);
          video.currentTime = 0.2;
        });
        const context = new OffscreenCanvas(videoWidth, videoHeight).getContext("2d")!;
        const wall = (): number[] => {
          context.drawImage(video, 0, 0);
          return [...context.getImageData(2, 2, 1, 1).data];
        };
        const asked = performance.now();
        // A busy decoder draws nothing at all at first.
        while (wall().every((level, c) => level === 0 || c === 3) && performance.now() - asked < 30_000) await new Promise((turn) => setTimeout(turn, 50));
        return { duration, size: [videoWidth, videoHeight], wall: wall().slice(0, 3) };
      },
      [film, `video/${format}`] as const,
    );
    expect(played.duration).toBeCloseTo(12 / 30, 1);
    expect(played.size).toEqual([160, 90]);
    // The light wall, as on the stage: no encoder's idea of colours is in between.
    for (const [c, level] of [0xf6, 0xf3, 0xee].entries()) expect(Math.abs(played.wall[c]! - level), String(played.wall)).toBeLessThan(10);
    await player.close();
  });

  it("a GIF of every frame, for ever", async () => {
    const seen = await decoded(page, await short(dialog, "turntable", "gif", 12));
    expect(seen).toMatchObject({ size: [160, 90], frameCount: 12, forEver: true });
    expect(seen.seconds).toBeCloseTo(0.05, 3);
  });

  it("none where somebody cancels, and another one then", async () => {
    await pick(dialog, "square");
    await dialog.getByRole("button", { name: "Make the film" }).click();
    await expect.poll(() => course(dialog)).toMatch(/^Frame \d+ of 180, about/);
    await inspect(page, "film-being-made");
    let saved = false;
    page.once("download", () => (saved = true));
    await dialog.getByRole("button", { name: "Cancel" }).click();
    await words(dialog).toBe("Cancelled. Nothing was saved.");
    expect(saved).toBe(false);
    expect(await dialog.evaluate((element) => element.shadowRoot!.activeElement?.id)).toBe("make");
    // Escape does the same, and closes only when nothing is being made.
    await page.keyboard.press("Enter");
    await expect.poll(() => course(dialog)).toMatch(/^Frame/);
    await page.keyboard.press("Escape");
    await words(dialog).toBe("Cancelled. Nothing was saved.");
    await page.keyboard.press("Escape");
    await expect.poll(() => page.locator("film-dialog").count()).toBe(0);
    expect(faults).toEqual([]);
    await page.context().close();
  });
});

it("is a GIF where the browser makes no video", async () => {
  const { page, faults } = await visit(browser, "about:blank");
  await page.addInitScript(() => Reflect.deleteProperty(window, "VideoEncoder"));
  await page.goto(site.url);
  const dialog = await open(page);
  await pick(dialog, "turntable");
  await words(dialog).toMatch(/GIF: this browser makes no video/);
  expect(await dialog.locator("input[value=mp4], input[value=webm]").count()).toBe(0);
  await size(dialog, 64, 64);
  const { name, bytes } = await downloaded(page, () => dialog.getByRole("button", { name: "Make the film" }).click());
  expect(name).toBe("cat-bird-fish-turning.gif");
  expect(await decoded(page, bytes.toString("base64"))).toMatchObject({ size: [64, 64], frameCount: 120, forEver: true });
  expect(faults).toEqual([]);
  await page.context().close();
});

it("says so where nothing can be drawn", async () => {
  const { page } = await visit(browser, "about:blank");
  await page.route(/film-worker/, async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `OffscreenCanvas.prototype.getContext = () => null;\n${await response.text()}` });
  });
  await page.goto(site.url);
  const dialog = await open(page);
  await dialog.getByRole("button", { name: "Save the picture" }).click();
  await words(dialog).toMatch(/^It could not be made: this browser cannot draw in 3D here.*Nothing is lost/);
  await page.context().close();
});

it("shows how a wire was found, once one has been", async () => {
  const { page, faults } = await visit(browser, site.url, { viewport: { width: 360, height: 740 } });
  const part = (name: string) => page.getByRole("tab", { name, exact: true }).click();
  await part("Run");
  await choose(page, "preset", "fast");
  await runButton(page).click();
  await phase(page, "running");
  await idle(page);
  await part("Share");
  const dialog = await open(page);
  await pick(dialog, "found");
  await inspect(page, "film-found-360");
  const seen = await decoded(page, await short(dialog, "found", "gif", 8));
  expect(seen.frameCount).toBe(8);
  // It was another wire at first.
  expect(seen.differ).toBeGreaterThan(100);
  expect(faults).toEqual([]);
  await page.context().close();
});

describe("the page where its address is posted", () => {
  const html = readFileSync(join(DIST, "index.html"), "utf8");
  const content = (name: string): string | undefined => new RegExp(`<meta (?:property|name)="${name}" content="([^"]*)"`).exec(html)?.[1];

  it("has a title, words and a picture that is there", () => {
    expect(content("og:title")).toMatch(/Wire4D/);
    expect(content("og:description")?.length).toBeGreaterThan(50);
    expect(content("twitter:card")).toBe("summary_large_image");
    const picture = readFileSync(join(DIST, content("og:image")!.replace(/^.*\//, "")));
    expect(picture.subarray(0, 3)).toEqual(Buffer.from([0xff, 0xd8, 0xff]));
    expect(picture.length).toBeLessThanOrEqual(120_000);
  });

  it("has whole addresses where the build is told where it will lie", () => {
    const tags = (home: string) => new Map(tagsFor(html, home).map(({ attrs }) => [attrs!["property"] ?? attrs!["name"], attrs!["content"]]));
    expect(tags("https://example.org/wire").get("og:image")).toBe("https://example.org/wire/og.jpg");
    expect(tags("https://example.org/wire/?x#y").get("og:url")).toBe("https://example.org/wire/");
    expect(tags("").get("og:image")).toBe("./og.jpg");
    expect(tags("").has("og:url")).toBe(false);
    for (const wrong of ["example.org", "ftp://example.org/", "javascript:alert(1)"]) expect(() => tags(wrong)).toThrow("WIRE4D_URL");
  });
});
