import { expect, it } from "vitest";
import { NO_PAPERS } from "./given";
import { packing } from "./packing";
import { compose, PAPER_PX, withStroke } from "./paper";

const line = (y: number) => withStroke(null, { erase: false, widthPx: 20, points: Float32Array.of(50, y, 450, y) });

it("brings drawings back onto their pads", async () => {
  const papers = { ...NO_PAPERS, front: line(100), top: line(300) };
  const packed = await packing.pack(papers);
  expect(packed.drawings.map(({ view, label }) => [view, label])).toEqual([["front", "Drawing"], ["top", "Drawing"]]);
  const back = (await packing.unpack(packed))!;
  expect(back.side).toBeNull();
  for (const slot of ["front", "top"] as const) expect(Buffer.compare(compose(back[slot]!), compose(papers[slot]!))).toBe(0);
});

it("puts drawings of other views onto the pads that are left, and nothing where there is nothing", async () => {
  const ink = new Uint8Array(64).fill(255);
  const drawing = (view: string) => ({ view, label: "", width: 8, height: 8, ink });
  const back = (await packing.unpack({ drawings: ["view-4", "side", "view-5", "view-6"].map(drawing), pairs: {} }))!;
  expect([back.front, back.side, back.top].map((paper) => paper !== null)).toEqual([true, true, true]);
  expect(compose(back.side!).every((value) => value === 255)).toBe(true);
  expect(compose(back.side!)).toHaveLength(PAPER_PX ** 2);
  expect(await packing.unpack({ drawings: [], pairs: {} })).toBeNull();
});
