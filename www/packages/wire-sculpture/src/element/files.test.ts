import { describe, expect, it } from "vitest";
import { carriedBy } from "./files";

const JSON_TEXT = `{"format":"wire4d","name":"ä <b> & \\"c\\""}`;
const utf8 = (text: string): number[] => [...new TextEncoder().encode(text)];
const big = (x: number): number[] => [x >>> 24, (x >>> 16) & 255, (x >>> 8) & 255, x & 255];
const little = (x: number): number[] => big(x).reverse();
const chunk = (kind: string, data: readonly number[]): number[] => [...big(data.length), ...utf8(kind), ...data, 0, 0, 0, 0];
const png = (...chunks: readonly number[][]): Uint8Array => Uint8Array.from([0x89, ...utf8("PNG\r\n"), 0x1a, 0x0a, ...chunks.flat()]);
const itxt = (keyword: string, text: string, compressed = 0): number[] => chunk("iTXt", [...utf8(keyword), 0, compressed, 0, ...utf8("en"), 0, ...utf8("x"), 0, ...utf8(text)]);

function glb(scene: unknown): Uint8Array {
  const text = utf8(JSON.stringify(scene));
  return Uint8Array.from([...utf8("glTF"), ...little(2), ...little(20 + text.length), ...little(text.length), ...utf8("JSON"), ...text]);
}

const svg = (inside: string): Uint8Array => Uint8Array.from(utf8(`<svg xmlns="http://www.w3.org/2000/svg">${inside}<path d="M0 0"/></svg>`));
const escaped = JSON_TEXT.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;").replace("ä", "&#xe4;");

const CARRIERS: readonly [string, Uint8Array][] = [
  ["a PNG", png(chunk("IHDR", Array<number>(13).fill(0)), itxt("Title", "x"), itxt("wire4d", JSON_TEXT), chunk("IEND", []))],
  ["an SVG", svg(`<metadata id="wire4d">${escaped}</metadata>`)],
  ["an SVG of another hand", svg(`<metadata class="x" id='wire4d'><![CDATA[${JSON_TEXT}]]></metadata>`)],
  ["a wire.json", Uint8Array.from(utf8(`\ufeff ${JSON_TEXT}`.slice(1)))],
];

describe("what a file carries", () => {
  it.each(CARRIERS)("is found in %s", (_, bytes) => expect(carriedBy(bytes)).toBe(JSON_TEXT));

  it.each([{ extras: { wire4d: JSON.parse(JSON_TEXT) as unknown } }, { asset: { version: "2.0", extras: { wire4d: JSON.parse(JSON_TEXT) as unknown } } }])("is found in a GLB", (scene) => {
    expect(JSON.parse(carriedBy(glb(scene))!)).toEqual(JSON.parse(JSON_TEXT));
  });

  it("is not made up where there is none", () => {
    const none = [png(chunk("IHDR", []), chunk("IEND", [])), png(itxt("wire4d", "packed", 1)), glb({ extras: { wire4d: { version: "0.1.0" } } }), glb("x"), svg(""), new Uint8Array(), Uint8Array.of(1, 2, 3)];
    for (const bytes of none) expect(carriedBy(bytes)).toBeNull();
  });

  it("never throws, however a file was cut or changed", () => {
    for (const [, whole] of [...CARRIERS, ["a GLB", glb({ extras: { wire4d: { format: "wire4d" } } })] as const]) {
      for (let length = 0; length < whole.length; length++) carriedBy(whole.subarray(0, length));
      for (let at = 0; at < whole.length; at++) {
        const other = whole.slice();
        other[at]! ^= 0xff;
        carriedBy(other);
      }
    }
  });
});
