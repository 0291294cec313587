import { it } from "vitest";
import { launch, serveDist, shoot, visit, choose, idle } from "./browser";
it("looks", async () => {
  const browser = await launch();
  const site = await serveDist("/");
  const { page, faults } = await visit(browser, site.url + "#v=1&job=fill" + (process.env["HASH"] ?? ""), { viewport: { width: 1440, height: 900 } });
  page.setDefaultTimeout(60000);
  const t0 = Date.now();
  const t = (w: string) => console.log(((Date.now() - t0) / 1000).toFixed(1), w);
  await page.locator("shape-pad input").first().waitFor({ state: "attached", timeout: 60000 });
  try {
    await page.getByText("Shown as they will run").waitFor({ state: "attached", timeout: 90000 });
    t("planned");
    await page.waitForTimeout(4000);
    await shoot(page, "real-first");
    await choose(page, "preset", "fast");
    await page.getByRole("button", { name: /Cover it/ }).click();
    await page.locator("[data-phase=running]").first().waitFor({ state: "attached", timeout: 90000 });
    t("running");
    await page.waitForTimeout(3000);
    await shoot(page, "real-running");
    await idle(page);
    t("idle");
    await page.waitForTimeout(6000);
    await shoot(page, "real-finished");
    console.log(await page.locator("surface-result").evaluate((e) => e.shadowRoot!.textContent!.replace(/\s+/g, " ")));
    const code = await page.evaluate(() => (document.querySelector("wire-app") as any).studio.link("http://x/"));
    console.log(code.length, code.slice(0, 200));
    (await import("node:fs")).writeFileSync("/tmp/h/example-link.txt", code);
    await page.getByRole("button", { name: "front", exact: true }).click();
    await page.waitForTimeout(5000);
    await shoot(page, "real-front");
  } catch (e) {
    console.log(String(e));
    await shoot(page, "real-error");
  }
  console.log(faults);
  await browser.close();
  site.server.close();
});
