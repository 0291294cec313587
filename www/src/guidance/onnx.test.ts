import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { mix } from "./noise";
import { outlineOf } from "./onnx";
import { message, number, withoutWeights } from "./test-onnx";

const VIT = new Uint8Array(readFileSync(join(import.meta.dirname, "../../../tests/data/guidance/vit-tiny.onnx")));

it("knows a whole ONNX file", () => {
  expect(outlineOf(VIT)).toEqual({ external: false });
  expect(outlineOf(withoutWeights())).toEqual({ external: true });
});

it("knows one that was cut off, and what is none", () => {
  for (const length of [0, 1, 2, 100, 5000, VIT.length >> 1, VIT.length - 1]) expect(outlineOf(VIT.subarray(0, length)), String(length)).toBeNull();
  for (const text of ["<!doctype html><html>", "PK\x03\x04zip", '{"kind": "guidance-v1"}', "\x89PNG\r\n", "\x80\x02}q"]) {
    expect(outlineOf(new TextEncoder().encode(text)), text).toBeNull();
  }
  // Whole messages, but of something else.
  for (const bytes of [number(1, 8), [...number(1, 8), ...message(7, [])], [...number(1, 1e6), ...message(7, []), ...message(8, [])]]) expect(outlineOf(Uint8Array.from(bytes))).toBeNull();
  // A length that runs over every number.
  expect(outlineOf(Uint8Array.from([0x0a, ...Array(30).fill(0xff)]))).toBeNull();
});

it("comes to an end on any bytes", () => {
  for (let seed = 0; seed < 500; seed++) outlineOf(Uint8Array.from({ length: 200 }, (_, i) => mix(i + 1000 * seed)));
  for (let seed = 0; seed < 200; seed++) {
    const spoilt = VIT.slice();
    spoilt[mix(seed) % 2000] = mix(seed + 1);
    outlineOf(spoilt);
  }
});
