/** Mesh files of the kinds that people have, opened in the page; the part that reads them comes when the first is given. */

import { join } from "node:path";
import { expect, it } from "vitest";
import { inspect } from "./a11y";
import { contextWithProfile, ROOT, visit } from "./browser";
import { openSite } from "./site";

const { browser, site } = await openSite();

const FIELD = join(ROOT, "tests/field");
/** With the number of triangles and the axis that is up. */
const FILES = [
  ["foreign-meshes/ball.3mf", "80", "z"],
  ["glb-skinned/standing-man.glb", "192", "y"],
  ["ply-tristrips/vase.ply", "288", "y"],
  ["obj-negative-interleaved/torus-comma.obj", "576", "y"],
  ["stl-count-zero/ball-count-0.stl", "80", "z"],
  ["stl-z-up/pawn.stl", "512", "z"],
] as const;

it("reads them, says what is up, and turns them", async () => {
  const context = await contextWithProfile(browser, { viewport: { width: 1440, height: 900 } });
  const { page, faults } = await visit(context, site.url);
  const pad = page.locator("shape-pad");
  const up = pad.getByLabel("Up in this file");
  const reader = () => site.sent.filter(({ file }) => /wire4d_model_bg.*\.wasm$/.test(file)).length;
  await page.getByRole("tab", { name: "A shape" }).click();
  await pad.getByText(/triangles\./).waitFor({ timeout: 60_000 });
  expect([await up.count(), reader()]).toEqual([0, 0]);
  for (const [path, triangles, axis] of FILES) {
    await pad.locator("#mesh").setInputFiles(join(FIELD, path));
    await pad.locator("#open.chosen").getByText(path.split("/")[1]!).waitFor();
    await pad.getByText(new RegExp(`^\\s*${triangles} triangles`)).waitFor();
    expect(await up.inputValue(), path).toBe(axis);
  }
  expect(reader()).toBe(1);
  await pad.locator("#mesh").setInputFiles(join(FIELD, "foreign-meshes/part.step"));
  await pad.getByRole("alert").getByText(/part\.step: is a STEP file.*export it as 3MF or STL/).waitFor();
  await expect.poll(() => up.inputValue()).toBe("z");

  // A choice is one step of what was done, and is kept.
  await up.selectOption("y");
  await page.getByRole("button", { name: "Undo: Turn pawn.stl" }).click();
  await expect.poll(() => up.inputValue()).toBe("z");
  await up.selectOption("y");
  await expect.poll(() => up.inputValue()).toBe("y");
  await pad.getByText(/^\s*512 triangles/).waitFor();
  await inspect(page, "mesh-turned");
  await page.waitForTimeout(600);
  await page.reload();
  await pad.getByText(/^\s*512 triangles/).waitFor({ timeout: 60_000 });
  await expect.poll(() => up.inputValue()).toBe("y");
  expect(faults).toEqual([]);
  await context.close();
});
