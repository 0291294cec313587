import { expect, it } from "vitest";
import { kept } from "../../state/picture/picture";
import type { Cover } from "./given";
import { packing } from "./packing";

const picture = kept({ width: 2, height: 1, rgba: Uint8ClampedArray.of(0, 0, 0, 255, 255, 255, 255, 255) }, "lines.png");
const packed = async (cover: Cover | null) => packing.unpack(await packing.pack(cover));

it("names what is built in, and takes a style's picture along", async () => {
  const vase: Cover = { mesh: { shape: "vase" }, style: "leaves" };
  expect(await packing.pack(vase)).toEqual({ drawings: [], pairs: { shape: "vase", style: "leaves" } });
  expect(await packed(vase)).toEqual(vase);
  const drawn = await packing.pack({ ...vase, style: picture });
  expect(drawn.drawings.map(({ view, label, ink }) => [view, label, ...ink])).toEqual([["style", "lines.png", 255, 0]]);
  expect(await packing.unpack(drawn)).toMatchObject({ mesh: { shape: "vase" }, style: { name: "lines.png", width: 2, height: 1 } });
});

it("has nothing to go on from where the mesh is a file, or a word is unknown", async () => {
  expect(await packed({ mesh: { key: "k", name: "cup.stl", file: new Blob() }, style: picture })).toBeNull();
  expect(await packing.unpack({ drawings: [], pairs: { shape: "<b>", style: "leaves" } })).toBeNull();
  expect(await packed(null)).toBeNull();
});
