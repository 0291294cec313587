/** Lessons as people go through them: by mouse, by keys alone, on a phone; locked ones; the wall of a class. */

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readLesson, type Lesson } from "../../src/state/lesson/lesson";
import { inspect } from "./a11y";
import { choose, idle, phase, picture, requestsElsewhere, ROOT, runButton, settled, shoot, visit, type Visit, type VisitOptions } from "./browser";
import { qrOf, qrSvg } from "../../src/ui/save/qr";
import { inkOn } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite();

const FOLDER = join(ROOT, "www/lessons");
const IDS = readdirSync(FOLDER).filter((name) => !name.includes("."));
const lessonOf = (id: string): Lesson => readLesson(JSON.parse(readFileSync(join(FOLDER, id, "lesson.json"), "utf8")));
const textsOf = (id: string): Readonly<Record<string, string>> => JSON.parse(readFileSync(join(FOLDER, id, "texts.en.json"), "utf8")) as Readonly<Record<string, string>>;
const codeOf = (job: string): string => readFileSync(join(ROOT, "www/src/tasks", job, "example/wire.code"), "utf8").trim();

const panel = (page: Page) => page.locator("lesson-panel");
const heading = (page: Page) => panel(page).getByRole("heading", { level: 3 });

async function open(hash: string, options: VisitOptions = {}): Promise<Visit> {
  const visited = await visit(browser, `${site.url}${hash}`, options);
  await heading(visited.page).waitFor();
  return visited;
}

async function close({ page, faults, ...visited }: Visit): Promise<void> {
  expect(faults).toEqual([]);
  expect(requestsElsewhere({ page, faults, ...visited })).toEqual([]);
  await page.context().close();
}

/** How somebody presses what is before them. */
interface Hand {
  press(page: Page, name: string | RegExp): Promise<void>;
  pick(page: Page, choice: string): Promise<void>;
}

const mouse: Hand = {
  press: (page, name) => panel(page).getByRole("button", { name, exact: typeof name === "string" }).click(),
  pick: (page, choice) => panel(page).locator(`input[value="${choice}"]`).click(),
};

const finger: Hand = {
  press: (page, name) => panel(page).getByRole("button", { name, exact: typeof name === "string" }).tap(),
  pick: (page, choice) => panel(page).locator(`label:has(input[value="${choice}"])`).tap(),
};

/** Tab from where the step has put the focus; space and arrows from there. */
const keys: Hand = {
  async press(page, name) {
    const pattern = typeof name === "string" ? new RegExp(`^${name}$`) : name;
    for (let i = 0; i < 40; i++) {
      if (pattern.test(await focused(page))) return page.keyboard.press("Enter");
      await page.keyboard.press("Tab");
    }
    throw new Error(`Tab never comes to ${name}`);
  },
  async pick(page, choice) {
    for (let i = 0; i < 40 && !(await focused(page)).startsWith("radio "); i++) await page.keyboard.press("Tab");
    // The first arrow chooses, too: space first, for the one that has the focus.
    await page.keyboard.press("Space");
    for (let i = 0; i < 10 && (await focused(page)) !== `radio ${choice}`; i++) await page.keyboard.press("ArrowDown");
    expect(await focused(page)).toBe(`radio ${choice}`);
  },
};

function focused(page: Page): Promise<string> {
  return page.evaluate(() => {
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
    if (element instanceof HTMLInputElement && element.type === "radio") return `radio ${element.value}`;
    return element?.getAttribute("aria-label") ?? element?.textContent?.trim() ?? "";
  });
}

/** From the first step to the last: reads, guesses, and begins every run, to stop it as soon as it can be. */
async function walk(page: Page, id: string, hand: Hand, seen: (step: number) => Promise<void> = async () => undefined): Promise<void> {
  const lesson = lessonOf(id);
  const texts = textsOf(id);
  for (const [i, step] of lesson.steps.entries()) {
    await expect.poll(() => heading(page).textContent()).toBe(texts[`${step.id}.title`]);
    await panel(page).getByText(`Step ${i + 1} of ${lesson.steps.length}`, { exact: true }).waitFor();
    expect(await page.evaluate(() => location.hash)).toContain(`lesson=${id}&step=${i + 1}`);
    if (step.question) {
      await hand.pick(page, step.question.right);
      await expect.poll(() => panel(page).locator(".says").textContent()).toContain(texts[`${step.id}.says.${step.question.right}`]);
      await expect.poll(() => panel(page).locator(".says").textContent()).toContain("Yes.");
    }
    if (step.kind === "run") {
      // Its drawings have come.
      await expect.poll(() => page.evaluate(() => document.querySelector("wire-app")!.shadowRoot!.querySelector("run-panel")!.shadowRoot!.textContent)).toMatch(/Ready|Remix|Opened|example/);
      await hand.press(page, "Run");
      await phase(page, "running");
      await hand.press(page, "Stop");
      await idle(page);
      await expect.poll(() => panel(page).getByRole("button", { name: "Run", exact: true }).count()).toBe(1);
    }
    await seen(i);
    if (i + 1 < lesson.steps.length) await hand.press(page, "Next");
  }
  await hand.press(page, "Finish");
  await expect.poll(() => panel(page).count()).toBe(0);
}

it.each(IDS)("%s goes from first to last step by mouse, and leaves nothing behind", async (id) => {
  const visited = await open(`#lesson=${id}`);
  const { page } = visited;
  await walk(page, id, mouse, async (step) => {
    if (step === 1) await inspect(page, `lesson-${id}`);
  });
  expect(await page.evaluate(() => location.hash)).not.toContain("lesson");
  await close(visited);
});

it.each(IDS)("%s goes from first to last step by keys alone", async (id) => {
  const visited = await open(`#lesson=${id}`);
  await walk(visited.page, id, keys);
  await close(visited);
});

it.each(IDS)("%s goes from first to last step on a phone", async (id) => {
  const visited = await open(`#lesson=${id}`, { viewport: { width: 360, height: 740 }, hasTouch: true });
  const { page } = visited;
  await walk(page, id, finger, async (step) => {
    // Nothing hangs out at the side, and whatever is to be touched is large enough.
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(360);
    const low = await panel(page).locator("button, label").evaluateAll((elements) => elements.filter((element) => element.checkVisibility() && element.getBoundingClientRect().height < 44).map((element) => element.textContent!.trim()));
    expect(low).toEqual([]);
    if (step === 1) await inspect(page, `lesson-${id}-phone`);
  });
  await close(visited);
});

it("keeps the visitor's own project aside, and brings it back with its undo", async () => {
  const visited = await visit(browser, site.url);
  const { page } = visited;
  await settled(page);
  await choose(page, "preset", "fast");
  await page.getByRole("button", { name: /^Undo: Set preset/ }).waitFor();
  await page.evaluate(() => (location.hash = "#lesson=impossible"));
  await heading(page).waitFor();
  await expect.poll(() => page.getByRole("button", { name: "Undo", exact: true }).isDisabled()).toBe(true);
  await expect.poll(() => inkOn(page, 1)).toBeGreaterThan(0.005);
  await panel(page).getByRole("button", { name: "Leave the lesson" }).click();
  await page.getByRole("button", { name: /^Undo: Set preset/ }).waitFor();
  await expect.poll(() => inkOn(page, 2)).toBeGreaterThan(0.005);
  // Nor does a lesson that is closed with its tab stand in the project's way.
  await page.evaluate(() => (location.hash = "#lesson=impossible"));
  await heading(page).waitFor();
  await page.goto("about:blank");
  await page.goto(site.url);
  await settled(page);
  expect(await panel(page).count()).toBe(0);
  expect(await page.locator("input[name=preset][value=fast]").isChecked()).toBe(true);
  await close(visited);
});

it("goes on where this browser left a lesson, with its answers, and keeps what was made in each step", async () => {
  const visited = await open("#lesson=impossible&step=2");
  const { page } = visited;
  await mouse.pick(page, "no");
  await page.goto("about:blank");
  await page.goto(`${site.url}#lesson=impossible`);
  await expect.poll(() => panel(page).locator("input[value=no]").isChecked()).toBe(true);
  // What is drawn in one step is there when people come back to it.
  await mouse.press(page, "Next");
  await mouse.press(page, "Next");
  await expect.poll(() => inkOn(page, 0)).toBeGreaterThan(0.005);
  await page.locator("drawing-pad").nth(0).getByRole("button", { name: /^More/ }).click();
  await page.getByRole("menuitem", { name: /Clear/ }).click();
  await expect.poll(() => inkOn(page, 0)).toBe(0);
  await mouse.press(page, "Next");
  await mouse.press(page, "Next");
  await expect.poll(() => inkOn(page, 0)).toBeGreaterThan(0.005);
  await mouse.press(page, "Go back");
  await expect.poll(() => inkOn(page, 0)).toBe(0);
  await mouse.press(page, "Go back");
  await mouse.press(page, "Start this step again");
  await expect.poll(() => inkOn(page, 0)).toBeGreaterThan(0.005);
  await close(visited);
});

it("cannot leave a locked lesson by undo, key, address, drop or paste", async () => {
  const visited = await open("#lesson=one-wire&step=1&lock=leave,undo,files,preset&hide=share,settings");
  const { page } = visited;
  await expect.poll(() => page.locator("input[name=preset][value=fast]").isChecked()).toBe(true);
  const at = () => page.evaluate(() => location.hash);
  const there = await at();
  expect(await panel(page).getByRole("button", { name: "Leave the lesson" }).count()).toBe(0);
  expect(await page.getByRole("tab", { name: /views|picture/ }).count()).toBe(0);
  expect(await page.getByRole("link", { name: "Gallery" }).count()).toBe(0);
  for (const key of ["z", "Control+z", "Shift+Z", "s"]) await page.keyboard.press(key);
  expect(await page.getByRole("dialog").count()).toBe(0);

  for (const hash of ["", "#v=1&seed=5", `#v=1&w=${codeOf("multiview")}`, "#lesson=views", "#lesson=one-wire", "#open=gallery/works/swan.wire.json"]) {
    await page.evaluate((hash) => (location.hash = hash), hash);
    await expect.poll(at).toBe(there);
    await expect.poll(() => heading(page).textContent()).toBe(textsOf("one-wire")["hello.title"]);
  }
  await page.locator("notice-list").getByText("This page is locked for a lesson").waitFor();
  // Within the lesson an address may turn the page, and takes no lock away.
  await page.evaluate(() => (location.hash = "#lesson=one-wire&step=2"));
  await expect.poll(() => heading(page).textContent()).toBe(textsOf("one-wire")["guess.title"]);
  expect(await at()).toContain("lock=leave,undo,files,preset");

  await page.evaluate((text) => {
    const data = new DataTransfer();
    data.setData("text", text);
    dispatchEvent(new ClipboardEvent("paste", { clipboardData: data }));
    const files = new DataTransfer();
    files.items.add(new File(["<svg/>"], "own.png", { type: "image/png" }));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: files, bubbles: true, cancelable: true }));
  }, `${site.url}#v=1&w=${codeOf("stroke")}`);
  await page.locator("notice-list").getByText("files and links are not opened here").waitFor();
  await expect.poll(() => heading(page).textContent()).toBe(textsOf("one-wire")["guess.title"]);
  expect(await page.locator("input[name=preset][value=best]").isDisabled()).toBe(true);
  expect(await page.locator("#part-settings").isVisible()).toBe(false);
  expect(await runButton(page).count() + (await page.getByRole("button", { name: "Remix" }).count())).toBe(1);
  // And so it is after a reload.
  await page.reload();
  await expect.poll(() => heading(page).textContent()).toBe(textsOf("one-wire")["guess.title"]);
  expect(await panel(page).getByRole("button", { name: "Leave the lesson" }).count()).toBe(0);
  await close(visited);
});

it.each([
  ["#lesson=dance", /There is no lesson “dance”/],
  ["#lesson=views&step=40", /This lesson has 9 steps/],
  [`#v=1&lesson=views&w=${codeOf("multiview")}`, /a lesson and for a wire/],
  ["#lesson=views&job=fill&curve_spacing=0.1", /another job than its lesson/],
  ["#v=2&lesson=views", /newer Wire4D/],
  ["#lesson=views&lock=curve_spacing", /“curve_spacing”, which this job does not have/],
  ["#lesson=views&hide=moon", /“moon”, which is not known here/],
  ["#lock=moon", /“moon”, which is not known here/],
  ["#kiosk=1", /A stand needs a lesson/],
])("says what is wrong with %s, and shows the page all the same", async (hash, words) => {
  const visited = await visit(browser, `${site.url}${hash}`);
  const { page } = visited;
  await page.locator("notice-list").getByText(words).waitFor();
  await expect.poll(() => page.locator("wire-stage").isVisible()).toBe(true);
  await close(visited);
});

it("locks and hides on the page as it is, without a lesson, and keeps its address", async () => {
  const visited = await visit(browser, `${site.url}#v=1&preset=fast&lock=preset&hide=share,save`);
  const { page } = visited;
  await settled(page);
  // Settings come with the engine.
  await expect.poll(() => page.locator("input[name=preset][value=fast]").isChecked()).toBe(true);
  expect(await page.locator("input[name=preset][value=best]").isDisabled()).toBe(true);
  expect(await page.getByRole("button", { name: "Share", exact: true }).count()).toBe(0);
  await choose(page, "seed", "5");
  await expect.poll(() => page.evaluate(() => location.hash)).toBe("#v=1&lock=preset&hide=share,save&preset=fast&seed=5");
  await close(visited);
});

it("makes a link for a class, which does as it says", async () => {
  const visited = await visit(browser, site.url);
  const { page } = visited;
  await settled(page);
  await page.locator("class-fold summary").first().click();
  const editor = page.locator("class-editor");
  await editor.locator("#lesson").selectOption("views");
  await editor.locator("[data-name=leave] select").selectOption("locked");
  await editor.locator("[data-name=settings] select").selectOption("hidden");
  await editor.getByText("Single settings").click();
  await editor.locator("[data-name=seed] select").selectOption("locked");
  await shoot(page, "class-editor");
  const link = await editor.locator("#link").inputValue();
  expect(new URL(link).hash).toBe("#v=1&lesson=views&lock=leave,seed&hide=settings");
  expect(await editor.getByRole("link", { name: "QR sheet" }).getAttribute("href")).toBe(`./teachers.html#class=${encodeURIComponent(link)}`);
  await page.goto("about:blank");
  await page.goto(link);
  await heading(page).waitFor();
  expect(await page.locator("#part-settings").isVisible()).toBe(false);
  await close(visited);
});

it("hangs a class's wires on the wall out of links, and takes them down", async () => {
  const steps = lessonOf("views").steps.length;
  const visited = await open(`#lesson=views&step=${steps}`);
  const { page } = visited;
  await panel(page).getByRole("button", { name: "Open the wall" }).click();
  const wall = page.getByRole("dialog", { name: "The wall" });
  await wall.locator("textarea").fill(`Zoe: https://school.example/#v=1&w=${codeOf("multiview")}\nAda\nhttps://school.example/#v=1&w=${codeOf("stroke")}\nhttps://school.example/#v=1&w=${codeOf("fill").slice(0, -20)}`);
  await wall.getByRole("button", { name: "Hang them up" }).click();
  await expect.poll(() => wall.getByRole("status").first().textContent()).toBe("2 wires hang up. One link is cut off or damaged: ask for it again.");
  const names = () => wall.locator("li b").allTextContents();
  expect(await names()).toEqual(["Zoe", "Ada"]);
  await wall.getByRole("button", { name: "Sort by name" }).click();
  await expect.poll(names).toEqual(["Ada", "Zoe"]);
  await expect.poll(() => wall.locator("wire-sculpture").first().evaluate((element) => element.shadowRoot !== null)).toBe(true);
  await page.waitForTimeout(1000);
  await inspect(page, "wall");
  await wall.getByRole("button", { name: "Take down Ada" }).click();
  await expect.poll(names).toEqual(["Zoe"]);
  await wall.getByRole("button", { name: "Close the wall" }).click();
  await panel(page).getByRole("button", { name: "Open the wall" }).click();
  await expect.poll(names).toEqual(["Zoe"]);
  await close(visited);
});

it("brings a pupil's wire to the wall by the photo of its code", async () => {
  const visited = await open(`#lesson=spline&step=${lessonOf("spline").steps.length}`);
  const { page } = visited;
  await panel(page).getByRole("button", { name: "Share my wire" }).click();
  const link = await page.locator("share-dialog #link").inputValue();
  expect(new URL(link).hash).toMatch(/^#v=1&w=/);
  expect(await page.evaluate(() => location.hash)).toContain("lesson=spline");
  await page.keyboard.press("Escape");
  // On paper, a little askew.
  const photo = await page.evaluate(async (svg) => {
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
    await image.decode();
    const canvas = new OffscreenCanvas(1200, 1000);
    const context = canvas.getContext("2d")!;
    context.fillStyle = "#eee";
    context.fillRect(0, 0, 1200, 1000);
    context.rotate(0.05);
    context.drawImage(image, 250, 100, 700, 700);
    return [...new Uint8Array(await (await canvas.convertToBlob({ type: "image/jpeg" })).arrayBuffer())];
  }, qrSvg(qrOf(link)!));
  await panel(page).getByRole("button", { name: "Open the wall" }).click();
  const wall = page.getByRole("dialog", { name: "The wall" });
  const scan = async (bytes: readonly number[], name: string) => wall.locator("input[type=file]").setInputFiles({ name, mimeType: "image/jpeg", buffer: Buffer.from(bytes) });
  await scan([...(await picture(page, 400, 300, "cross", "image/jpeg"))], "no-code.jpg");
  await expect.poll(() => wall.getByRole("status").first().textContent()).toMatch(/^No code was found/);
  await scan(photo, "code.jpg");
  await expect.poll(() => wall.getByRole("status").first().textContent()).toBe("One wire hangs up.");
  expect(await wall.locator("wire-sculpture").getAttribute("code")).toBe(/w=([^&]+)/.exec(link)![1]);
  await close(visited);
});

it("goes through a lesson where the browser keeps nothing", async () => {
  const visited = await open("#lesson=one-wire", { storage: "blocked" });
  await walk(visited.page, "one-wire", mouse);
  await close(visited);
});

it("begins anew at a stand when nobody is there, and lets any touch stop that", async () => {
  const visited = await visit(browser, "about:blank");
  const { page } = visited;
  await page.clock.install();
  await page.goto(`${site.url}#lesson=impossible&step=3&kiosk=1`);
  await heading(page).waitFor();
  const texts = textsOf("impossible");
  await expect.poll(() => heading(page).textContent()).toBe(texts["why.title"]);
  const countdown = page.getByRole("alert").filter({ hasText: "Still there?" });
  const wait = async (shown: boolean) => expect.poll(async () => (await page.clock.runFor(1000), countdown.isVisible())).toBe(shown);
  await wait(true);
  await page.mouse.move(300, 300);
  await expect.poll(() => countdown.isVisible()).toBe(false);
  await wait(true);
  await expect.poll(async () => (await page.clock.runFor(1000), heading(page).textContent())).toBe(texts["hello.title"]);
  await page.context().close();
});
