import { expect, it } from "vitest";
import type { Subject } from "./given";
import { stroke } from "./task";

it("gives the engine one picture with its object, and none where the app is to find it", async () => {
  const rgba = new Uint8ClampedArray(16).fill(7);
  const picture = { name: "cat.png", width: 2, height: 2, rgba: new Blob([rgba]) };
  const found = { width: 1, height: 2, mask: Uint8Array.of(0, 255), labels: Uint8Array.of(0, 1), count: 1, notes: [] };
  const subject: Subject = { picture, object: 1, strokes: [], found, depth: null };
  expect(await stroke.work(subject, null)).toEqual({ key: expect.any(Number), picture: { name: "cat.png", width: 2, height: 2, rgba }, mask: { width: 1, height: 2, ink: found.mask }, hints: { box: null, marks: [] }, depth: null });
  expect(await stroke.work({ ...subject, found: null, depth: picture }, null)).toMatchObject({ mask: null, depth: { name: "cat.png", rgba } });
  // What is pointed at is the core's to look into, unless a hand has painted over what was found there.
  const boxed: Subject = { ...subject, box: [0.25, 0, 1, 0.5] };
  expect(await stroke.work(boxed, null)).toMatchObject({ mask: null, hints: { box: [0.5, 0, 2, 1] } });
  const marked: Subject = { ...subject, marks: [{ adds: false, width: 0.5, points: [0.5, 0.5] }] };
  expect(await stroke.work(marked, null)).toMatchObject({ mask: null, hints: { box: null, marks: [{ onObject: false, radius: 0.5 }] } });
  expect(await stroke.work({ ...boxed, strokes: [{ adds: true, width: 0.5, points: [0.5, 0.5] }] }, null)).toMatchObject({ mask: { width: 1, height: 2 } });
});
