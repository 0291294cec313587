import { expect, it } from "vitest";
import type { Subject } from "./given";
import { stroke } from "./task";

it("gives the engine one picture with its object, and none where the app is to find it", async () => {
  const rgba = new Uint8ClampedArray(16).fill(7);
  const picture = { name: "cat.png", width: 2, height: 2, rgba: new Blob([rgba]) };
  const found = { width: 1, height: 2, mask: Uint8Array.of(0, 255), labels: Uint8Array.of(0, 1), count: 1, notes: [] };
  const subject: Subject = { picture, object: 1, strokes: [], found, depth: null };
  expect(await stroke.work(subject)).toEqual({ picture: { name: "cat.png", width: 2, height: 2, rgba }, mask: { width: 1, height: 2, ink: found.mask }, depth: null });
  expect(await stroke.work({ ...subject, found: null, depth: picture })).toMatchObject({ mask: null, depth: { name: "cat.png", rgba } });
});
