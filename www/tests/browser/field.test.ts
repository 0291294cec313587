/** Pictures as people have them: the page finds in them the ink that the command line finds (`tests/field.rs`). */

import { join } from "node:path";
import type { Page } from "playwright-core";
import { beforeAll, expect, it } from "vitest";
import { give, pad, ROOT, visit } from "./browser";
import { inkOn, padsReady } from "./pads";
import { openSite } from "./site";

const { browser, site } = await openSite();
let page: Page;
let faults: string[];

beforeAll(async () => {
  ({ page, faults } = await visit(browser, site.url));
  await padsReady(page);
});

const field = (name: string) => join(ROOT, "tests/field", name);

/** Share of the pad that is ink, once it shows the picture of that name. */
async function read(name: string, file: Parameters<typeof give>[2] = field(name)): Promise<number> {
  await give(page, 0, file);
  const label = (typeof file === "string" ? name : file.name).replace(/^.*\//, "").replace(/\.\w+$/, "");
  await expect.poll(() => pad(page, 0).innerText()).toContain(label);
  return inkOn(page, 0);
}

/** Of the picture itself; a pad leaves a margin of 4% all round. */
const ON_PAPER = 0.92 ** 2;

it.each([
  ["colour-ink", ["yellow-on-white.png", "blue-on-black.png", "orange-marker-on-kraft.png", "pink-on-white.png", "green-neon-on-black.png"], 0.0856],
  ["white-icon-dark-fringe", ["white-straight.png", "white-premultiplied.png", "white-replaced.png", "white-la.png", "white-palette-trns.png", "one-bit.png"], 0.0856],
  ["photo-on-dark-desk", ["front-framed.png", "front-thin-frame.png", "front-dark-strips.png"], 0.0635],
  ["jpeg-motion-photo", ["front-plain.jpg", "front-motion.jpg", "front-two-jpegs.jpg", "front-no-end-marker.jpg"], 0.0856],
  ["stray-alpha", ["front.png"], 0.0856],
] as const)("%s", async (folder, names, share) => {
  for (const name of names) expect(await read(`${folder}/${name}`), name).toBeCloseTo(ON_PAPER * share, 2.5);
});

it("keeps thin lines of large scans", async () => {
  const thin = await read("fineliner-scan/same-2px-of-600.png");
  for (const name of ["scan-2px-of-2400.png", "scan-3px-of-2400.png"]) {
    const scanned = await read(`fineliner-scan/${name}`);
    expect(scanned / thin, name).toBeGreaterThan(0.7);
    expect(scanned / thin, name).toBeLessThan(1.4);
  }
});

it("draws an SVG, and says what other files are", async () => {
  const drawing = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 64 64'><path d='M16 16h32v32h-32z'/></svg>";
  const share = await read("", { name: "square.svg", mimeType: "image/svg+xml", buffer: Buffer.from(drawing) });
  expect(share).toBeCloseTo(ON_PAPER / 4, 2);
  const heic = { name: "photo.heic", mimeType: "image/heic", buffer: Buffer.from("\0\0\0\x18ftypheic\0\0\0\0mif1heic", "latin1") };
  await give(page, 0, heic);
  await pad(page, 0).getByRole("alert").filter({ hasText: "photo.heic is a HEIC photo" }).waitFor();
  expect(faults).toEqual([]);
});
