import { readFileSync } from "node:fs";
import { launch, serveDist, visit, shoot } from "./tests/browser/browser";
export async function look(which: string) {
  const site = await serveDist("/wire/"); const browser = await launch();
  const code = readFileSync("src/tasks/multiview/example/wire.code","utf8");
  if (which.includes("e")) { const v = await visit(browser, `${site.url}embed.html#w=${code}&shadow&views`); await v.page.waitForTimeout(2500); await shoot(v.page, "d-embed"); console.log(v.faults, v.requests.map(x=>x.slice(0,80))); }
  if (which.includes("d")) for (const w of [360, 820, 1440]) { const v = await visit(browser, `${site.url}docs.html`, {viewport:{width:w,height:w<500?760:900}}); await v.page.waitForTimeout(2500); await shoot(v.page, `d-docs-${w}`); await v.page.screenshot({path:`../target/screenshots/d-docs-full-${w}.png`,fullPage:true}); console.log(w, v.faults); }
  if (which.includes("s")) for (const w of [360, 820, 1440]) { const v = await visit(browser, site.url, {viewport:{width:w,height:w<500?760:900}}); await v.page.waitForTimeout(3500);
    const tab = v.page.getByRole("tab", { name: "Share", exact: true }); if (await tab.count()) await tab.click();
    if (w>1000) await v.page.getByRole("button",{name:"Share"}).first().click(); else await v.page.getByRole("button",{name:/QR, embed/}).click(); await v.page.waitForTimeout(1500); await shoot(v.page, `d-share-${w}`);
    await v.page.locator("#tab-embed").click(); await v.page.waitForTimeout(2500); await shoot(v.page, `d-embedpanel-${w}`); console.log(w, v.faults); }
  await browser.close(); site.server.close();
}
