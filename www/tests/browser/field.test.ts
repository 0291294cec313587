/** Pictures as people have them: the page finds in them the ink that the command line finds (`tests/field.rs`). */

import { readFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import { give, pad, ROOT, visit } from "./browser";
import { inkOn, padsReady, previewed } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite();
let page: Page;
let faults: string[];

beforeAll(async () => {
  ({ page, faults } = await visit(browser, site.url));
  await padsReady(page);
});

const field = (name: string) => join(ROOT, "tests/field", name);

/** Share of the pad that is ink, once it shows the picture of that name as the fit will see it. */
async function read(name: string, file: Parameters<typeof give>[2] = field(name)): Promise<number> {
  await give(page, 0, file);
  const label = (typeof file === "string" ? name : file.name).replace(/^.*\//, "").replace(/\.\w+$/, "");
  await pad(page, 0).getByLabel(`Front: ${label}`).first().waitFor();
  await previewed(page);
  return inkOn(page, 0);
}

/** In each folder, the picture that the others are to be read as. */
it.each([
  ["colour-ink", "front.png", ["yellow-on-white.png", "blue-on-black.png", "orange-marker-on-kraft.png", "pink-on-white.png", "green-neon-on-black.png"], 0.04],
  ["white-icon-dark-fringe", "front.png", ["white-straight.png", "white-premultiplied.png", "white-replaced.png", "white-la.png", "white-palette-trns.png", "one-bit.png"], 0.04],
  ["photo-on-dark-desk", "front-framed.png", ["front-thin-frame.png", "front-dark-strips.png"], 0.04],
  ["jpeg-motion-photo", "front-plain.jpg", ["front-motion.jpg", "front-two-jpegs.jpg", "front-no-end-marker.jpg"], 0.01],
  ["fineliner-scan", "same-2px-of-600.png", ["scan-2px-of-2400.png", "scan-3px-of-2400.png"], 0.06],
  ["stray-alpha", "../colour-ink/front.png", ["front.png"], 0.01],
] as const)("%s", async (folder, first, others, most) => {
  const wanted = await read(`${folder}/${first}`);
  expect(wanted).toBeGreaterThan(0.02);
  for (const name of others) expect(Math.abs((await read(`${folder}/${name}`)) / wanted - 1), name).toBeLessThan(most);
});

it("draws an SVG, and says what other files are", async () => {
  const drawing = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><path d='M16 16h32v32h-32z'/></svg>";
  const share = await read("", { name: "square.svg", mimeType: "image/svg+xml", buffer: Buffer.from(drawing) });
  // A square of half the drawing's side; a pad leaves a margin of 4% all round.
  expect(share).toBeCloseTo(0.92 ** 2 / 4, 1);
  const heic = { name: "photo.heic", mimeType: "image/heic", buffer: Buffer.from("\0\0\0\x18ftypheic\0\0\0\0mif1heic", "latin1") };
  await give(page, 0, heic);
  await pad(page, 0).getByRole("alert").filter({ hasText: "photo.heic is a HEIC photo" }).waitFor();
  const whole = readFileSync(field("jpeg-motion-photo/front-plain.jpg"));
  await give(page, 0, { name: "cut.jpg", mimeType: "image/jpeg", buffer: whole.subarray(0, 3000) });
  await pad(page, 0).getByRole("alert").filter({ hasText: "cut.jpg" }).waitFor();
  expect(faults).toEqual([]);
});
