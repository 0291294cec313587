/** The helpers of the browser tests themselves: each can see the fault it looks for. */

import { join } from "node:path";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { axeFaults } from "./a11y";
import { contextWithProfile, DRAWINGS, launch, requestsElsewhere, visit } from "./browser";
import { downloaded, drawStroke, dropFiles, pasteFile } from "./gestures";
import { openSite } from "./site";
import { throttle, watchLongTasks } from "./throttle";

const { browser, site } = await openSite();

/** An empty page of ours: the address must be a real one for storage to be there. */
async function empty(body: string, options: Parameters<typeof visit>[2] = {}): Promise<Page> {
  const { page } = await visit(browser, `${site.url}icon.svg`, options);
  await page.route("**/empty", (route) => route.fulfill({ contentType: "text/html", body: `<!doctype html><html lang="en"><title>Empty</title><main>${body}</main>` }));
  await page.goto(`${site.url}empty`);
  return page;
}

it("axe finds a button without a name, also in a shadow root", async () => {
  const page = await empty("<h1>Buttons</h1><button></button><div id=host></div>");
  await page.evaluate(() => (document.querySelector("#host")!.attachShadow({ mode: "open" }).innerHTML = "<button class=inner></button>"));
  const faults = await axeFaults(page);
  expect(faults).toHaveLength(1);
  expect(faults[0]).toMatch(/^button-name \(critical\).*button, #host >> \.inner/);
  expect(await axeFaults(page, ["main > button", "#host"])).toEqual([]);
  await page.context().close();
});

it("a stroke, a paste and a drop reach the element", async () => {
  const page = await empty("<canvas width=200 height=100></canvas><output></output>");
  const said = await page.evaluateHandle(() => {
    const said: string[] = [];
    const canvas = document.querySelector("canvas")!;
    for (const type of ["pointerdown", "pointerup"] as const) {
      canvas.addEventListener(type, (event) => said.push(`${type} ${event.offsetX},${event.offsetY}`));
    }
    addEventListener("paste", (event) => said.push(`paste ${event.clipboardData!.files[0]!.name}`));
    canvas.addEventListener("dragover", (event) => event.preventDefault());
    canvas.addEventListener("drop", (event) => {
      event.preventDefault();
      const entries = [...event.dataTransfer!.items].map((item) => item.webkitGetAsEntry()!);
      said.push(...entries.map((entry) => `drop ${entry.isDirectory ? "folder" : "file"} ${entry.name}`));
    });
    return said;
  });
  const canvas = page.locator("canvas");
  await drawStroke(page, canvas, [[0.1, 0.1], [0.5, 0.9], [0.9, 0.5]]);
  await pasteFile(page, "pasted.png", "image/png", Buffer.from("x"));
  await dropFiles(page, canvas, [join(DRAWINGS, "t01-animals"), { name: "made.svg", buffer: Buffer.from("<svg/>") }]);
  const heard = await said.jsonValue();
  expect(heard).toEqual(["pointerdown 20,10", "pointerup 180,50", "paste pasted.png", "drop folder t01-animals", "drop file made.svg"]);
  await page.context().close();
});

it("a saved file comes with its name", async () => {
  const page = await empty("<a download=wire.txt href=data:text/plain,hello>Save</a>");
  const { name, bytes } = await downloaded(page, () => page.getByText("Save").click());
  expect([name, bytes.toString()]).toEqual(["wire.txt", "hello"]);
  await page.context().close();
});

it("takes away what a device may lack", async () => {
  const page = await empty("", { rightToLeft: true, storage: "blocked", webgl2: false, worker: false, forcedColors: "active" });
  const found = await page.evaluate(() => {
    const fault = (action: () => unknown) => {
      try {
        return String(action());
      } catch (error) {
        return (error as Error).name;
      }
    };
    return [
      getComputedStyle(document.body).direction, fault(() => localStorage), fault(() => indexedDB.open("x")),
      String(document.createElement("canvas").getContext("webgl2")), typeof Worker, String(matchMedia("(forced-colors: active)").matches),
    ];
  });
  expect(found).toEqual(["rtl", "SecurityError", "SecurityError", "null", "undefined", "true"]);
  await page.context().close();
});

it("a browser without SIMD refuses it, in a worker too", async () => {
  const poor = await launch({ simd: false });
  const page = await poor.newPage();
  // A function of v128 type.
  const [here, there] = await page.evaluate(async () => {
    const check = "WebAssembly.validate(new Uint8Array([0,97,115,109,1,0,0,0,1,5,1,96,0,1,123,3,2,1,0,10,10,1,8,0,65,0,253,15,253,98,11]))";
    const worker = new Worker(URL.createObjectURL(new Blob([`postMessage(${check})`])));
    return [eval(check), await new Promise((done) => (worker.onmessage = (event) => done(event.data)))];
  });
  expect([here, there]).toEqual([false, false]);
  await poor.close();
});

it("long tasks are seen and said where, and a slower processor makes them longer", async () => {
  const page = await empty("<button onclick=\"let x = 0; for (let i = 0; i < 1.5e8; i++) x += i % 7; this.value = x\">Work</button>");
  const longTasks = await watchLongTasks(page);
  const work = async (times: number) => {
    await throttle(page, times);
    await page.reload();
    for (let i = 0; i < 3; i++) await page.getByText("Work").click();
    const ofClicks = async () => (await longTasks()).filter(({ scripts }) => /onclick/.test(scripts[0]?.name ?? ""));
    await expect.poll(async () => (await ofClicks()).length).toBe(3);
    return (await ofClicks()).sort((a, b) => a.ms - b.ms)[0]!;
  };
  const fast = await work(1);
  expect((await work(8)).ms).toBeGreaterThan(1.5 * fast.ms);
  await page.context().close();
});

it("a profile keeps things from one visit to the next, and a request elsewhere is noticed", async () => {
  const context = await contextWithProfile(browser);
  const first = await visit(context, site.url);
  await first.page.evaluate(() => localStorage.setItem("kept", "yes"));
  await first.page.close();
  const second = await visit(context, `${site.url}#w=x`);
  expect(await second.page.evaluate(() => localStorage.getItem("kept"))).toBe("yes");
  expect(requestsElsewhere(second)).toEqual([]);
  expect(requestsElsewhere({ ...second, requests: ["http://127.0.0.1:1/x", `${site.url}y`] })).toEqual(["http://127.0.0.1:1/x"]);
  await context.close();
});
