/** One picture: how people give it, see its object, choose another and correct it with a brush. The elements alone. */

import { join } from "node:path";
import type { Page } from "playwright-core";
import { build } from "vite";
import { afterEach, beforeAll, describe, expect, it } from "vitest";
import { inspect } from "./a11y";
import { picture, ROOT, visit, type VisitOptions } from "./browser";
import { drawStroke, dropFiles, pasteFile } from "./gestures";
import { openSite } from "./site";

const PLACE = join(ROOT, "www/tests/browser/subject");
const BUILT = join(ROOT, "target/subject-place");
const DESK = { viewport: { width: 1440, height: 900 } } as const;
const PHONE = { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 } as const;

const { browser, site } = await openSite("/", { args: ["--use-fake-device-for-media-stream=device-count=2"] }, BUILT);
let page: Page;
let faults: string[];

beforeAll(async () => {
  await build({ root: PLACE, base: "./", logLevel: "error", publicDir: false, build: { outDir: BUILT, emptyOutDir: true, target: "es2022", assetsInlineLimit: 0 } });
});
afterEach(async () => {
  expect(faults).toEqual([]);
  await page.context().close();
});

async function open(options: VisitOptions = DESK): Promise<void> {
  ({ page, faults } = await visit(browser, site.url, options));
  await page.locator("subject-pad .shelf canvas.painted").first().waitFor();
}

const button = (name: string | RegExp) => page.getByRole("button", { name });
const pad = () => page.locator("subject-pad");
const shown = () => pad().locator("subject-canvas .frame");
const editor = () => page.locator("mask-editor");
const large = () => editor().locator("subject-canvas .frame");
/** Opens the editor with the brush in hand. */
async function takeBrush(): Promise<void> {
  await button(/^Mark$/).click();
  await editor().locator("input[value=fine]").check({ force: true });
}
const kinds = () => page.evaluate(() => (window as unknown as Place).place.events.map(({ kind }) => kind));
const strokes = () => page.evaluate(() => (window as unknown as Place).place.subject?.strokes.length ?? -1);

interface Place {
  readonly place: {
    locked: boolean;
    busy: boolean;
    draw(): void;
    readonly subject: { readonly object: number; readonly box?: readonly number[] | null; readonly strokes: readonly { adds: boolean; width: number; points: readonly number[] }[]; readonly picture: { name: string; width: number }; readonly depth: { name: string } | null } | null;
    readonly events: readonly { kind: string; detail: unknown }[];
  };
}
const subject = () => page.evaluate(() => (window as unknown as Place).place.subject);

/** Share of the picture that is veiled, more than half. */
function veiled(where = shown()): Promise<number> {
  return where.locator("canvas#over").evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    if (!canvas.width || !canvas.height) return -1;
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    let veiled = 0;
    for (let i = 3; i < data.length; i += 4) veiled += data[i]! > 127 ? 1 : 0;
    return veiled / (data.length / 4);
  });
}

/** Three discs of different sizes on white. */
async function things(width = 640, height = 480): Promise<Buffer> {
  const base64 = await page.evaluate(
    async ([width, height]) => {
      const canvas = new OffscreenCanvas(width, height);
      const context = canvas.getContext("2d")!;
      context.fillStyle = "#fff";
      context.fillRect(0, 0, width, height);
      for (const [x, y, radius, colour] of [[0.3, 0.5, 0.3, "#46637f"], [0.72, 0.32, 0.18, "#a2542e"], [0.74, 0.76, 0.12, "#3d6b3f"]] as const) {
        context.fillStyle = colour;
        context.beginPath();
        context.arc(x * width, y * height, radius * height, 0, 7);
        context.fill();
      }
      const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer());
      return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
    },
    [width, height] as const,
  );
  return Buffer.from(base64, "base64");
}

async function giveThings(name = "things.png"): Promise<void> {
  await pad().locator("#file").setInputFiles({ name, mimeType: "image/png", buffer: await things() });
  await expect.poll(() => veiled(), { timeout: 20_000 }).toBeGreaterThan(0.3);
}

async function trySample(name: string): Promise<void> {
  await button(`Try the ${name}`).click();
  await expect.poll(() => veiled(), { timeout: 20_000 }).toBeGreaterThan(0.3);
}

describe("giving a picture", () => {
  it("takes a file, a drop, a paste and a picture of the shelf", async () => {
    await open();
    await giveThings("chosen.png");
    await expect.poll(async () => (await subject())?.picture).toMatchObject({ name: "chosen.png", width: 640 });
    await dropFiles(page, shown(), [{ name: "dropped.png", buffer: await things(300, 400) }]);
    await expect.poll(async () => (await subject())?.picture.name).toBe("dropped.png");
    await button("Clear").click();
    await expect.poll(subject).toBeNull();
    await button("Choose picture").focus();
    await pasteFile(page, "pasted.png", "image/png", await things(200, 200));
    await expect.poll(async () => (await subject())?.picture.name).toBe("pasted.png");
    await button("Clear").click();
    await trySample("pear");
    await expect.poll(async () => (await subject())?.picture.name).toBe("Pear");
    await expect.poll(() => kinds()).toEqual(["give", "give", "clear-subject", "give", "clear-subject", "give"]);
  });

  it("says what is wrong with a picture, and keeps the one before", async () => {
    await open();
    await trySample("mug");
    await pad().locator("#file").setInputFiles({ name: "broken.png", mimeType: "image/png", buffer: Buffer.from("no picture") });
    await page.getByRole("alert").filter({ hasText: "broken.png" }).waitFor();
    await expect.poll(async () => (await subject())?.picture.name).toBe("Mug");
    await inspect(page, "subject-problem");
    await button("Close this message").click();
    await expect.poll(() => page.getByRole("alert").count()).toBe(0);
  });

  it("takes a depth picture, and lets it go", async () => {
    await open();
    await trySample("ball");
    await pad().locator("summary").click();
    await pad().getByText("512 × 512").waitFor();
    await pad().locator("#depth-file").setInputFiles({ name: "depth.png", mimeType: "image/png", buffer: await things(512, 512) });
    await expect.poll(async () => (await subject())?.depth?.name).toBe("depth.png");
    await inspect(page, "subject-depth");
    await button("Take it away").click();
    await expect.poll(async () => (await subject())?.depth).toBeNull();
  });

  it("does nothing while a run goes on", async () => {
    await open();
    await trySample("cat");
    await page.evaluate(() => {
      const { place } = window as unknown as Place;
      place.locked = true;
      place.draw();
    });
    const before = await kinds();
    await expect.poll(() => button(/^Mark$/).isDisabled()).toBe(true);
    await shown().click();
    await dropFiles(page, shown(), [{ name: "late.png", buffer: await things() }]);
    await page.waitForTimeout(300);
    await expect.poll(() => kinds()).toEqual(before);
  });
});

describe("the camera", () => {
  it("takes one photo and is let go", async () => {
    await open({ ...DESK, permissions: ["camera"] });
    await page.evaluate(() => {
      const media = navigator.mediaDevices;
      const ask = media.getUserMedia.bind(media);
      const given: MediaStream[] = [];
      Object.assign(window, { given });
      media.getUserMedia = async (wanted) => {
        const stream = await ask(wanted);
        given.push(stream);
        return stream;
      };
    });
    const live = () => page.evaluate(() => (window as unknown as { given: MediaStream[] }).given.flatMap((stream) => stream.getTracks().map(({ readyState }) => readyState)));
    await expect.poll(() => live()).toEqual([]);
    await button("Camera").click();
    await expect.poll(() => button("Take").isEnabled()).toBe(true);
    await expect.poll(() => live()).toEqual(["live"]);
    await page.waitForTimeout(500);
    await inspect(page, "camera");
    await button("Other camera").click();
    await expect.poll(live).toEqual(["ended", "live"]);
    expect(new Set(await page.evaluate(() => (window as unknown as { given: MediaStream[] }).given.map((stream) => stream.getVideoTracks()[0]!.label))).size).toBe(2);
    await button("Cancel").click();
    await expect.poll(live).toEqual(["ended", "ended"]);
    await expect.poll(() => kinds()).toEqual([]);
    expect(await page.evaluate(() => (document.querySelector("subject-pad")!.shadowRoot!.activeElement as HTMLElement).id)).toBe("camera");
    await button("Camera").click();
    await expect.poll(() => button("Take").isEnabled()).toBe(true);
    await button("Take").click();
    await expect.poll(async () => (await subject())?.picture.name).toBe("Photo");
    await expect.poll(async () => (await subject())?.picture.width).toBeGreaterThan(200);
    await expect.poll(live).toEqual(["ended", "ended", "ended"]);
  });

  it("says so if it is refused", async () => {
    await open();
    await page.evaluate(() => {
      navigator.mediaDevices.getUserMedia = () => Promise.reject(new DOMException("No.", "NotAllowedError"));
    });
    await button("Camera").click();
    await page.getByRole("alert").filter({ hasText: "may not use the camera" }).waitFor();
    await inspect(page, "camera-refused");
    await page.keyboard.press("Escape");
    await expect.poll(() => page.locator("camera-dialog").count()).toBe(0);
  });

  it("is not offered where there is none to ask", async () => {
    ({ page, faults } = await visit(browser, "about:blank", DESK));
    await page.addInitScript(() => Reflect.deleteProperty(Navigator.prototype, "mediaDevices"));
    await page.goto(site.url);
    await button("Choose picture").waitFor();
    await expect.poll(() => button("Camera").count()).toBe(0);
  });
});

describe("several things in one picture", () => {
  it("are chosen by tapping or with keys, and strokes stay", async () => {
    await open();
    await giveThings();
    await page.getByText("3 things found").waitFor();
    await inspect(page, "subject-things");
    const box = (await shown().boundingBox())!;
    await page.mouse.click(box.x + 0.72 * box.width, box.y + 0.32 * box.height);
    await expect.poll(async () => (await subject())?.object).toBe(2);
    // A near miss counts, a far one does not.
    await page.mouse.click(box.x + 0.74 * box.width, box.y + 0.9 * box.height);
    await expect.poll(async () => (await subject())?.object).toBe(3);
    await pad().locator("input[name=object][value='3']").focus();
    await page.keyboard.press("ArrowLeft");
    await expect.poll(async () => (await subject())?.object).toBe(2);
    await expect.poll(() => kinds()).toEqual(["give", "choose-object", "choose-object", "choose-object"]);
    await page.mouse.click(box.x + 0.95 * box.width, box.y + 0.55 * box.height);
    await editor().waitFor();
  });
});

describe("a box", () => {
  it("is dragged round what is meant, either way, and a short drag is a tap", async () => {
    await open();
    await giveThings();
    await page.getByText("3 things found").waitFor();
    const frame = (await shown().boundingBox())!;
    const at = ([x, y]: readonly [number, number]) => [frame.x + x * frame.width, frame.y + y * frame.height] as const;
    const drag = async (from: readonly [number, number], to: readonly [number, number]): Promise<void> => {
      await page.mouse.move(...at(from));
      await page.mouse.down();
      await page.mouse.move(...at([0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])]));
      await page.mouse.move(...at(to));
    };
    await drag([0.9, 0.8], [0.3, 0.2]);
    const line = (await pad().locator("subject-canvas .box").boundingBox())!;
    expect(line.width).toBeCloseTo(0.6 * frame.width, -1);
    await page.mouse.up();
    await expect.poll(async () => (await subject())?.box?.map((share) => Math.round(10 * share))).toEqual([3, 2, 9, 8]);
    // It stays to be seen, and goes by a button, too.
    await expect.poll(() => pad().locator("subject-canvas .box:not(.under-way)").count()).toBe(1);
    await inspect(page, "subject-box");
    await button("Remove the box").click();
    await expect.poll(() => pad().locator("subject-canvas .box").count()).toBe(0);
    await expect.poll(async () => (await subject())?.box).toBeNull();
    await drag([0.72, 0.32], [0.73, 0.32]);
    await page.mouse.up();
    await expect.poll(kinds).toEqual(["give", "give-box", "give-box", "choose-object"]);
  });

  it("is asked for where it is not clear what is meant", async () => {
    await open(PHONE);
    await giveThings();
    await page.getByText("3 things found").waitFor();
    expect(await shown().evaluate((frame) => getComputedStyle(frame).touchAction)).not.toBe("none");
    await page.evaluate(() => {
      const { place } = window as unknown as { place: { subject: { found: object }; draw(): void } };
      place.subject = { ...place.subject, found: { ...place.subject.found, isSure: false } };
      place.draw();
    });
    await page.getByText("Which thing is it? Drag a box round it").waitFor();
    expect(await shown().evaluate((frame) => getComputedStyle(frame).touchAction)).toBe("none");
  });
});

describe("marks", () => {
  const marks = () => page.evaluate(() => ((window as unknown as Place).place.subject as { marks?: readonly { adds: boolean; points: readonly number[] }[] }).marks ?? []);

  it("are drawn on what is meant and on what is not, undone one by one and cleared", async () => {
    await open();
    await giveThings();
    await button(/^Mark$/).click();
    await drawStroke(page, large(), [[0.2, 0.5], [0.4, 0.5]]);
    await expect.poll(marks).toMatchObject([{ adds: true }]);
    await editor().getByText("by 1 mark").waitFor();
    await page.keyboard.press("x");
    await drawStroke(page, large(), [[0.3, 0.3], [0.3, 0.7]]);
    // The later one rubs the earlier one out where they cross.
    await expect.poll(async () => (await marks()).map(({ adds }) => adds)).toEqual([true, true, false]);
    await page.mouse.move(500, 700);
    await inspect(page, "subject-marks");
    await editor().getByRole("button", { name: /^Undo/ }).click();
    await expect.poll(async () => (await marks()).length).toBe(1);
    await editor().getByRole("button", { name: "Clear marks" }).click();
    await expect.poll(marks).toEqual([]);
    await expect.poll(() => kinds()).toEqual(["give", "open-brush", "mark", "mark", "undo", "clear-marks"]);
  });

  it("and a box are made with keys alone, and a box with numbers", async () => {
    await open();
    await giveThings();
    await button(/^Mark$/).focus();
    await page.keyboard.press("Enter");
    await large().waitFor();
    await large().focus();
    await page.keyboard.press("Space");
    await page.keyboard.press("Shift+ArrowLeft");
    await page.keyboard.press("Space");
    await expect.poll(marks).toMatchObject([{ adds: true, points: [0.5, 0.5, 0.4375, 0.5] }]);
    // Nothing can be drawn while the object is looked for.
    await editor().locator(".all:not(.busy)").waitFor();
    await editor().locator("input[value=box]").focus();
    await page.keyboard.press("Space");
    await large().focus();
    for (const key of ["Space", "Shift+ArrowRight", "Shift+ArrowRight", "Shift+ArrowDown", "Space"]) await page.keyboard.press(key);
    await expect.poll(async () => (await subject())?.box?.map((share) => Math.round(1000 * share))).toEqual([438, 500, 563, 583]);
    await inspect(page, "subject-box-keys");
    await editor().getByLabel("Left").fill("20");
    await page.keyboard.press("Tab");
    await expect.poll(async () => (await subject())?.box?.[0]).toBe(0.2);
    // No side passes the opposite one.
    await editor().getByLabel("Right").fill("5");
    await page.keyboard.press("Tab");
    await expect.poll(async () => (await subject())?.box?.[2]).toBeCloseTo(0.21);
    // Escape takes a box back that is not done, then closes.
    await large().focus();
    await page.keyboard.press("Space");
    await page.keyboard.press("Shift+ArrowUp");
    await page.keyboard.press("Escape");
    await expect.poll(() => editor().count()).toBe(1);
    await page.keyboard.press("Escape");
    await expect.poll(() => editor().count()).toBe(0);
  });

  it("are a finger's on a phone, with targets as large as one", async () => {
    await open(PHONE);
    await giveThings();
    await button(/^Mark$/).tap();
    await large().waitFor();
    for (const tool of ["box", "not-this", "this"]) {
      await editor().locator(`input[value=${tool}]`).check({ force: true });
      for (const control of await editor().locator("button:visible, .options:visible, input[type=number]:visible").all()) {
        expect((await control.boundingBox())!.height).toBeGreaterThanOrEqual(44);
      }
      await inspect(page, `subject-phone-${tool}`);
    }
    const sheet = (await large().boundingBox())!;
    await page.touchscreen.tap(sheet.x + 0.3 * sheet.width, sheet.y + 0.5 * sheet.height);
    await expect.poll(async () => (await marks()).map(({ points }) => points.length)).toEqual([2]);
    await inspect(page, "subject-phone-marked");
  });
});

describe("the brush", () => {
  it("adds and takes away, is undone, and gives up for what was found", async () => {
    await open();
    await trySample("ball");
    const found = await veiled();
    await takeBrush();
    await drawStroke(page, large(), [[0.1, 0.06], [0.9, 0.06]]);
    await expect.poll(strokes).toBe(1);
    await expect.poll(() => veiled()).toBeLessThan(found - 0.02);
    const added = await veiled();
    await editor().locator("input[value=remove]").check({ force: true });
    await editor().locator("input[type=number]").fill("20");
    await editor().locator("input[type=number]").press("Tab");
    await drawStroke(page, large(), [[0.5, 0.3], [0.5, 0.7]]);
    await expect.poll(strokes).toBe(2);
    await expect.poll(() => veiled()).toBeGreaterThan(added + 0.05);
    await expect.poll(async () => (await subject())?.strokes.map(({ adds, width }) => [adds, width])).toEqual([[true, 0.06], [false, 0.2]]);
    await page.mouse.move(500, 600);
    await inspect(page, "subject-brush");
    await button(/^Undo/).click();
    await expect.poll(() => veiled()).toBeCloseTo(added, 3);
    await button(/^Redo/).click();
    await button("Use what was found").click();
    await expect.poll(strokes).toBe(0);
    await expect.poll(() => veiled()).toBeCloseTo(found, 3);
    await button("Done").click();
    await expect.poll(() => editor().count()).toBe(0);
  });

  it("paints where nothing was found, and nothing is veiled before", async () => {
    await open();
    const blank = await picture(page, 400, 300, "blank");
    await pad().locator("#file").setInputFiles({ name: "fog.png", mimeType: "image/png", buffer: blank });
    await page.getByText("Nothing found").waitFor();
    await takeBrush();
    await expect.poll(() => veiled()).toBe(0);
    await drawStroke(page, large(), [[0.3, 0.5], [0.7, 0.5]]);
    await expect.poll(() => veiled()).toBeGreaterThan(0.8);
    await expect.poll(async () => (await subject())?.strokes[0]!.points.map((value) => Math.round(50 * value) / 50)).toEqual([0.3, 0.5, 0.7, 0.5]);
    await inspect(page, "subject-nothing-found");
  });

  it("works with keys alone", async () => {
    await open();
    await trySample("ball");
    await button(/^Mark$/).focus();
    await page.keyboard.press("Enter");
    await large().waitFor();
    for (let i = 0; i < 2; i++) await page.keyboard.press("ArrowRight");
    await large().focus();
    await page.keyboard.press("x");
    for (let i = 0; i < 4; i++) await page.keyboard.press("]");
    for (let i = 0; i < 2; i++) await page.keyboard.press("Shift+ArrowLeft");
    await page.keyboard.press("Space");
    for (let i = 0; i < 4; i++) await page.keyboard.press("Shift+ArrowRight");
    // Nothing is told before the stroke is done; Escape would take it back, and not close the sheet.
    await expect.poll(() => strokes()).toBe(0);
    await page.keyboard.press("Space");
    await expect.poll(strokes).toBe(1);
    const [stroke] = (await subject())!.strokes;
    expect(stroke).toEqual({ adds: false, width: 0.1, points: [0.375, 0.5, 0.625, 0.5] });
    await page.keyboard.press("Space");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Escape");
    await expect.poll(() => strokes()).toBe(1);
    await inspect(page, "subject-brush-keys");
    await page.keyboard.press("Escape");
    await expect.poll(() => editor().count()).toBe(0);
    await expect.poll(() => strokes()).toBe(1);
  });

  it("is a finger on a phone", async () => {
    await open(PHONE);
    await inspect(page, "subject-phone-empty");
    await giveThings();
    await inspect(page, "subject-phone");
    const box = (await shown().boundingBox())!;
    await page.touchscreen.tap(box.x + 0.3 * box.width, box.y + 0.5 * box.height);
    await large().waitFor();
    await page.waitForTimeout(200);
    await editor().locator("input[value=fine]").check({ force: true });
    const sheet = (await large().boundingBox())!;
    const session = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", x: number, y: number) =>
      session.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x: sheet.x + x * sheet.width, y: sheet.y + y * sheet.height }] });
    await touch("touchStart", 0.1, 0.1);
    await touch("touchMove", 0.3, 0.12);
    await touch("touchMove", 0.5, 0.1);
    await touch("touchEnd", 0, 0);
    await expect.poll(strokes).toBe(1);
    await inspect(page, "subject-phone-brush");
    for (const control of await editor().locator("button:visible, .options:visible, input[type=range]:visible").all()) {
      const { height } = (await control.boundingBox())!;
      expect(height).toBeGreaterThanOrEqual(44);
    }
  });
});

it.each([["narrow", { viewport: { width: 1024, height: 700 } }], ["small", { ...PHONE, viewport: { width: 320, height: 480 } }]] as const)("nothing sticks out of a %s window", async (name, window) => {
  await open(window);
  const sticksOut = (): Promise<string[]> =>
    pad().evaluate((element) => {
      const { left, right } = element.getBoundingClientRect();
      return [...element.shadowRoot!.querySelectorAll("button, p, canvas, subject-canvas, .invitation, h2")]
        .filter((inner) => {
          const box = inner.getBoundingClientRect();
          const sheet = inner.closest(".sheet")?.getBoundingClientRect();
          return box.left < left - 0.5 || box.right > right + 0.5 || (sheet && (box.bottom > sheet.bottom || box.top < sheet.top));
        })
        .map((inner) => inner.textContent!.trim() || inner.tagName);
    });
  await expect.poll(() => sticksOut()).toEqual([]);
  await inspect(page, `subject-${name}-empty`);
  await giveThings();
  await expect.poll(() => sticksOut()).toEqual([]);
  await inspect(page, `subject-${name}`);
  await takeBrush();
  await large().waitFor();
  await page.waitForTimeout(300);
  await inspect(page, `subject-${name}-brush`);
});

describe.each([
  ["dark", { colorScheme: "dark" }],
  ["forced", { forcedColors: "active" }],
  ["rtl", { rightToLeft: true }],
] as const)("%s", (name, options) => {
  it.each([["desk", DESK], ["phone", PHONE]] as const)("looks right on a %s", async (size, window) => {
    await open({ ...window, ...options });
    await inspect(page, `subject-${name}-${size}-empty`);
    await giveThings();
    await inspect(page, `subject-${name}-${size}`);
    await takeBrush();
    await drawStroke(page, large(), [[0.05, 0.08], [0.9, 0.08]]);
    await page.waitForTimeout(200);
    await inspect(page, `subject-${name}-${size}-brush`);
  });
});
