/** Runs on WebGPU, computed by SwiftShader: right, not fast. And what the page says where there is none. */

import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { inspect } from "./a11y";
import { idle, KEEP_DEVICES, phase, runButton, runSettings, shoot, visit, type VisitOptions } from "./browser";
import { padsReady } from "./pads";
import { openSite } from "./site";

/** No address of this machine's own, so that what is there is no secure context. */
const ELSEWHERE = "wire4d.test";
/** Small: SwiftShader computes it. */
const small = (iterations: number) => `#v=1&preset=fast&size=64&control_points=40&samples=2&grid=32&iterations=${iterations}`;
const SWIFTSHADER = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", `--host-resolver-rules=MAP ${ELSEWHERE} 127.0.0.1`];
const { browser, site } = await openSite("/", { args: SWIFTSHADER });

/** Stops a run so long that nobody can miss it running. */
async function stop(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Stop" }).click();
  await idle(page);
}
const device = (page: Page) => page.locator("run-panel [data-backend]");
const notice = (page: Page) => page.locator("notice-list .notice");

async function opened(address: string, options: VisitOptions = {}) {
  const visited = await visit(browser, address, options);
  await padsReady(visited.page);
  await device(visited.page).waitFor();
  return visited;
}

/** Destroys the device that the engine computes on. */
async function loseDevice(page: Page): Promise<void> {
  for (const worker of page.workers()) {
    const lost = await worker.evaluate(() => {
      const { devices = [] } = self as unknown as { devices?: { destroy(): void }[] };
      devices.at(-1)?.destroy();
      return devices.length > 0;
    });
    if (lost) return;
  }
  throw new Error("no worker has a device");
}

it("runs to the end on the graphics card that the address asks for, and names it", async () => {
  const { page, faults } = await opened(`${site.url}?renderer=webgpu${small(12)}`);
  await expect.poll(() => device(page).textContent()).toMatch(/^Will use: Graphics card/);
  await runButton(page).click();
  await phase(page, "running");
  await expect.poll(() => device(page).getAttribute("data-backend")).toBe("gpu");
  await expect.poll(() => page.locator("run-panel p").textContent(), { timeout: 60_000 }).toMatch(/steps a second/);
  await shoot(page, "webgpu-running");
  await idle(page);
  await expect.poll(() => device(page).getAttribute("data-backend")).toBe("gpu");
  await expect.poll(() => page.locator(".verdict").textContent()).toMatch(/match|ink/);
  await expect.poll(() => notice(page).count()).toBe(0);
  const setting = await runSettings(page);
  await expect.poll(() => setting.textContent()).toMatch(/Graphics card.*\?renderer=webgpu|\?renderer=webgpu.*Graphics card/s);
  await inspect(page, "webgpu");
  expect(faults).toEqual([]);
  await page.context().close();
});

it("does one step at a time on it, pauses and stops", async () => {
  const { page, faults } = await opened(`${site.url}?renderer=webgpu${small(5000)}`);
  const step = async () => parseInt((/Step ([\d,]+) of/.exec((await page.locator("run-panel p").textContent())!)?.[1] ?? "-1").replaceAll(",", ""));
  await runButton(page).click();
  await phase(page, "running");
  await expect.poll(step, { timeout: 60_000 }).toBeGreaterThan(2);
  await page.getByRole("button", { name: "Pause" }).click();
  await phase(page, "paused");
  await page.waitForTimeout(2000);
  const held = await step();
  for (let i = 1; i <= 2; i++) {
    await page.getByRole("button", { name: "Step" }).click();
    await expect.poll(step).toBe(held + i);
  }
  await stop(page);
  expect(faults).toEqual([]);
  await page.context().close();
});

it("prefers the processor to a card that is none, and says why", async () => {
  const { page, faults } = await opened(site.url + small(20_000));
  await expect.poll(() => device(page).textContent()).toBe("Will use: Processor");
  const setting = await runSettings(page);
  const why = (await setting.locator(".where p").last().textContent())!;
  expect(why).toMatch(/software|SwiftShader|fallback/i);
  await expect.poll(() => device(page).getAttribute("title")).toContain(why);
  await runButton(page).click();
  await phase(page, "running");
  await stop(page);
  await expect.poll(() => device(page).getAttribute("data-backend")).toBe("cpu");
  expect(faults).toEqual([]);
  await page.context().close();
});

it("comes to its end where the device is lost on the way, once and again", async () => {
  const { page } = await opened(`${site.url}?renderer=webgpu${small(3000)}`, { inEngine: KEEP_DEVICES });
  await runButton(page).click();
  await phase(page, "running");
  await expect.poll(() => page.locator("run-panel p").textContent(), { timeout: 60_000 }).toMatch(/Step /);
  await loseDevice(page);
  await notice(page).first().waitFor();
  await expect.poll(() => notice(page).first().textContent()).toMatch(/[A-Z].*\./);
  await shoot(page, "webgpu-lost");
  await phase(page, "running");
  // On a new device; the second time on the processor.
  await loseDevice(page);
  await expect.poll(() => device(page).getAttribute("data-backend"), { timeout: 60_000 }).toBe("cpu");
  await phase(page, "running");
  await stop(page);
  await expect.poll(() => page.locator(".verdict").textContent()).toMatch(/match|ink/);
  await page.context().close();
});

describe("without a card to compute on", () => {
  const CASES: Readonly<Record<string, { options: VisitOptions; insecure?: boolean; words: RegExp }>> = {
    missing: { options: { webgpu: "missing" }, words: /WebGPU/ },
    adapterless: { options: { webgpu: "adapterless" }, words: /graphics card/i },
    blocked: { options: { webgpu: "blocked" }, words: /block|refuse|allow/i },
    insecure: { options: {}, insecure: true, words: /https|secure/i },
  };
  const said = new Set<string>();

  for (const [name, { options, insecure, words }] of Object.entries(CASES)) {
    it(`has a sentence of its own and works: ${name}`, async () => {
      const base = insecure ? site.url.replace("127.0.0.1", ELSEWHERE) : site.url;
      const { page } = await opened(`${base}?renderer=webgpu${small(20_000)}`, options);
      await expect.poll(() => device(page).textContent()).toBe("Will use: Processor");
      const setting = await runSettings(page);
      const refusal = (await setting.locator(".refusal").textContent())!;
      expect(refusal).toMatch(words);
      expect(said).not.toContain(refusal);
      said.add(refusal);
      await inspect(page, `webgpu-${name}`);
      await runButton(page).click();
      await phase(page, "running");
      await expect.poll(() => notice(page).first().textContent()).toContain(refusal);
      await stop(page);
      await expect.poll(() => page.locator(".verdict").textContent()).toMatch(/match|ink/);
      await page.context().close();
    });
  }
});
