import { expect, it } from "vitest";
import { kept, pixelsOf } from "../../state/picture/picture";
import type { Subject } from "./given";
import { packing } from "./packing";

const SIDE = 32;
/** A square in the middle, of one shade on another. */
async function subject(object: number, ground: number, isFound = true): Promise<Subject> {
  const inside = (i: number): boolean => [i % SIDE, Math.floor(i / SIDE)].every((at) => at >= 8 && at < 24);
  const rgba = Uint8ClampedArray.from({ length: 4 * SIDE * SIDE }, (_, i) => (i % 4 === 3 ? 255 : inside(i >> 2) ? object : ground));
  const mask = Uint8Array.from({ length: SIDE * SIDE }, (_, i) => (inside(i) ? 255 : 0));
  const found = isFound ? { width: SIDE, height: SIDE, mask, labels: mask, count: 1, notes: [] } : null;
  return { picture: kept({ width: SIDE, height: SIDE, rgba }, "Mug.png"), object: 1, strokes: [], found, depth: null };
}
const inks = async (subject: Subject): Promise<[number, number]> => {
  const [drawing] = (await packing.pack(subject)).drawings;
  expect([drawing!.view, drawing!.label, drawing!.width]).toEqual(["front", "Mug.png", SIDE]);
  return [drawing!.ink[16 * SIDE + 16]!, drawing!.ink[0]!];
};

it("leaves a drawing on paper as it is, and takes the ground from a photo", async () => {
  expect(await inks(await subject(20, 250))).toEqual([235, 5]);
  const [dark, none] = await inks(await subject(20, 90));
  expect([dark > 200, none]).toEqual([true, 0]);
  // A light thing stands out from the paper that is now round it.
  const [light, alsoNone] = await inks(await subject(250, 40));
  expect([light >= 64, alsoNone]).toEqual([true, 0]);
  expect(await inks(await subject(20, 90, false))).toEqual([235, 165]);
});

it("comes back as a picture whose object is to be found", async () => {
  const back = (await packing.unpack(await packing.pack(await subject(20, 250))))!;
  expect([back.found, back.strokes, back.object, back.picture.name]).toEqual([null, [], 1, "Mug.png"]);
  const { rgba } = await pixelsOf(back.picture);
  expect([...rgba.slice(0, 4)]).toEqual([250, 250, 250, 255]);
  expect(await packing.unpack({ drawings: [], pairs: {} })).toBeNull();
  expect(await packing.pack(null)).toEqual({ drawings: [], pairs: {} });
});
