import { expect, it } from "vitest";
import { carriesWire } from "./recognised";

const PNG = "\x89PNG\r\n\x1a\n";
const carries = (text: string): Promise<boolean> => carriesWire(new Blob([Uint8Array.from(text, (c) => c.charCodeAt(0))]));

it("knows files that carry a wire by their bytes", async () => {
  for (const text of [
    `${PNG}\0\0\0\rIHDR…iTXtwire4d\0\0\0\0\0{`,
    `${PNG}${"x".repeat(900_000)}iTXtwire4d\0`,
    'glTF\x02\0\0\0{"extras":{"wire4d":{"closed":true,"format":"wire4d"}}}',
    '\xef\xbb\xbf<?xml version="1.0"?><svg><metadata id="wire4d">{}</metadata></svg>',
    '{"format":"wire4d","version":1}',
    '{ "version": 1, "format": "wire4d" }',
  ]) {
    expect(await carries(text)).toBe(true);
  }
});

it("takes nothing else for one", async () => {
  for (const text of ["", `${PNG}tEXtwire4d\0`, "GIF89a iTXtwire4d\0", '<svg id="wire4d"></svg>', 'glTF{"extras":{"wire4d":{"version":"0.1.0"}}}', '{"format":"gltf"}', 'say "format":"wire4d"']) {
    expect(await carries(text)).toBe(false);
  }
});
