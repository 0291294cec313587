import { centred } from "./engine/centred";
import { describe, expect, it } from "vitest";
import { compose, drawingOf, isBlank, mirrored, PAPER_PX, turned, withStamp, withStroke, type Paper } from "./paper";

const line = (...points: number[]): Float32Array<ArrayBuffer> => new Float32Array(points);
const pen = (...points: number[]) => ({ erase: false, widthPx: 16, points: line(...points) });
const at = (paper: Paper, x: number, y: number): number => compose(paper)[y * PAPER_PX + x]!;
const worst = (a: Uint8Array, b: Uint8Array): number => a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i]!)), 0);

function picture(width: number, height: number, ink: (x: number, y: number) => number): Paper {
  const pixels = new Uint8Array(width * height).map((_, i) => ink(i % width, Math.floor(i / width)));
  const layer = {
    kind: "picture",
    picture: { name: "cat.png", width, height, rgba: new Blob() },
    reading: { ink: "auto", threshold: 0 },
    found: { width: PAPER_PX, height: PAPER_PX, ink: centred({ width, height, ink: pixels }, PAPER_PX), polarity: "dark" },
    lay: { mirrored: false, quarterTurns: 0 },
  } as const;
  return { layers: [layer], label: "cat.png" };
}

function stampOf(ink: (x: number, y: number) => number): Uint8Array<ArrayBuffer> {
  return new Uint8Array(PAPER_PX ** 2).map((_, i) => ink(i % PAPER_PX, Math.floor(i / PAPER_PX)));
}

/** Nothing about it is symmetric: a picture, a stamp, strokes and a rubbed-out gap. */
function everything(): Paper {
  const stamp = { kind: "stamp", label: "corner", ink: stampOf((x, y) => (x < 60 && y < 110 ? 200 : 0)) } as const;
  const below = { layers: [...picture(300, 170, (x, y) => (x * 7 + y * y) % 256).layers, stamp], label: "all" };
  const drawn = withStroke(below, pen(80.3, 400.7, 200.1, 470.9, 431.4, 455.2));
  return withStroke(drawn, { ...pen(100, 380, 130, 500), erase: true, widthPx: 31 });
}

describe("strokes", () => {
  it("cover what lies under the pen, with soft rims", () => {
    const paper = withStroke(null, pen(100, 200, 300, 200));
    expect(at(paper, 200, 200)).toBe(255);
    expect(at(paper, 200, 192)).toBe(255);
    expect(at(paper, 200, 191)).toBe(0);
    expect(at(paper, 93, 199)).toBeGreaterThan(0);
    expect(at(paper, 90, 200)).toBe(0);
  });

  it("cover the pen's area", () => {
    const total = compose(withStroke(null, pen(100.5, 150.25, 380, 333))).reduce((sum, value) => sum + value / 255, 0);
    const length = Math.hypot(380 - 100.5, 333 - 150.25);
    expect(total / (length * 16 + Math.PI * 64)).toBeCloseTo(1, 2);
  });

  it("make a dot of a single point", () => {
    const total = compose(withStroke(null, pen(256, 256))).reduce((sum, value) => sum + value / 255, 0);
    expect(total / (Math.PI * 64)).toBeCloseTo(1, 1);
  });

  it("keep no more points than they need", () => {
    const circle = Float32Array.from({ length: 800 }, (_, i) => 256 + 100 * (i % 2 ? Math.sin : Math.cos)((2 * Math.PI * Math.floor(i / 2)) / 399));
    const paper = withStroke(null, { erase: false, widthPx: 16, points: circle });
    const { points } = paper.layers[0] as { points: Float32Array };
    expect(points.length / 2).toBeLessThan(80);
    const radii = Array.from({ length: points.length / 2 }, (_, i) => Math.hypot(points[2 * i]! - 256, points[2 * i + 1]! - 256));
    for (const radius of radii) expect(Math.abs(radius - 100)).toBeLessThan(0.1);
    const there = line(...Array.from({ length: 100 }, (_, i) => [100 + i, 300]).flat(), 100, 300);
    expect(withStroke(null, { erase: false, widthPx: 16, points: there }).layers[0]).toMatchObject({ points: line(100, 300, 199, 300, 100, 300) });
  });

  it("stop at the sheet's edge", () => {
    expect(at(withStroke(null, pen(-40, 10, 560, 10)), 511, 10)).toBe(255);
  });

  it("rub out all that is below, and nothing that comes later", () => {
    const rubbed = withStroke(withStroke(null, pen(100, 200, 300, 200)), { ...pen(200, 100, 200, 300), erase: true });
    expect(at(rubbed, 200, 200)).toBe(0);
    expect(at(rubbed, 150, 200)).toBe(255);
    expect(at(withStroke(rubbed, pen(200, 200)), 200, 200)).toBe(255);
  });
});

describe("pictures", () => {
  it("are fitted into the middle, not stretched", () => {
    const wide = picture(100, 50, () => 255);
    expect(at(wide, 256, 256)).toBe(255);
    expect([at(wide, 15, 256), at(wide, 496, 256), at(wide, 256, 130), at(wide, 256, 381)]).toEqual([0, 0, 0, 0]);
    expect([at(wide, 22, 256), at(wide, 489, 256), at(wide, 256, 145), at(wide, 256, 366)]).toEqual([255, 255, 255, 255]);
  });

  it("keep their mean tone when they are scaled down", () => {
    const fine = picture(1024, 1024, (x, y) => ((x + y) % 2 ? 255 : 0));
    expect(Math.abs(at(fine, 200, 300) - 127.5)).toBeLessThan(20);
  });

  it("survive being one pixel", () => {
    expect(at(picture(1, 1, () => 255), 256, 256)).toBe(255);
  });
});

describe("moving a sheet", () => {
  const paper = everything();
  const ink = compose(paper);

  it("mirrors left to right", () => {
    const flipped = stampOf((x, y) => ink[y * PAPER_PX + PAPER_PX - 1 - x]!);
    expect(worst(compose(mirrored(paper)), flipped)).toBeLessThanOrEqual(1);
  });

  it("turns counter-clockwise: what was on the right is on top", () => {
    const left = stampOf((x, y) => ink[x * PAPER_PX + PAPER_PX - 1 - y]!);
    expect(worst(compose(turned(paper, 1)), left)).toBeLessThanOrEqual(1);
  });

  it("gives the very same ink after two mirrors, four turns, or a turn and back", () => {
    const same = [mirrored(mirrored(paper)), turned(turned(turned(turned(paper, 1), 1), 1), 1), turned(turned(paper, 1), -1), turned(paper, 4)];
    expect(same.map((again) => worst(compose(again), ink))).toEqual([0, 0, 0, 0]);
  });

  it("mirrors what is turned", () => {
    const turnedInk = compose(turned(paper, 1));
    const flipped = stampOf((x, y) => turnedInk[y * PAPER_PX + PAPER_PX - 1 - x]!);
    expect(worst(compose(mirrored(turned(paper, 1))), flipped)).toBeLessThanOrEqual(1);
  });
});

describe("composing", () => {
  it("gives out the same ink for the same layers, and leaves it alone when something is drawn on top", () => {
    const paper = withStroke(null, pen(100, 200, 300, 200));
    const ink = compose(paper);
    const before = ink.slice();
    const more = compose(withStroke(paper, pen(10, 10, 500, 500)));
    expect(compose({ ...paper })).toBe(ink);
    expect(worst(ink, before)).toBe(0);
    expect(worst(more, before)).toBe(255);
  });

  it("does not take a different stack with the same top for the same", () => {
    const top = withStroke(null, pen(50, 50)).layers[0]!;
    const below = withStroke(null, pen(400, 400)).layers[0]!;
    compose({ layers: [below, top], label: "" });
    expect(at({ layers: [top], label: "" }, 400, 400)).toBe(0);
  });

  it("adds a stroke without doing everything again", () => {
    let paper = everything();
    for (let i = 0; i < 200; i++) paper = withStroke(paper, pen(i, 2 * i, 500 - i, 300, 20, 500 - i));
    const seconds = (work: () => unknown): number => {
      const start = performance.now();
      work();
      return performance.now() - start;
    };
    // The quickest of each: other work on the machine only ever makes things longer.
    const anew = Math.min(...[0, 1, 2].map(() => seconds(() => compose({ ...paper, layers: structuredClone(paper.layers) }))));
    compose(paper);
    const added = Math.min(...Array.from({ length: 20 }, (_, i) => seconds(() => compose((paper = withStroke(paper, pen(10 + i, 10, 200, 300 + i)))))));
    expect(added).toBeLessThan(anew / 4);
  });
});

describe("a sheet", () => {
  it("has one thing that fills it, with what was drawn over it", () => {
    const bike = { label: "bike", ink: stampOf((x) => (x < 100 ? 255 : 0)) };
    const star = { label: "star", ink: stampOf((x) => (x > 400 ? 255 : 0)) };
    const drawn = withStroke(withStroke(withStamp(withStroke(null, pen(256, 256)), bike), pen(300, 50)), { ...pen(450, 50), erase: true });
    expect([at(drawn, 50, 50), at(drawn, 256, 256), at(drawn, 300, 50)]).toEqual([255, 255, 255]);
    const paper = withStamp(drawn, star);
    expect(paper.label).toBe("star");
    expect([at(paper, 50, 50), at(paper, 450, 50), at(paper, 256, 256), at(paper, 300, 50)]).toEqual([0, 255, 255, 0]);
    expect(at(withStamp(picture(9, 9, () => 255), bike), 256, 256)).toBe(0);
  });

  it("knows when it is blank", () => {
    const paper = withStroke(null, pen(100, 100));
    expect(isBlank(null)).toBe(true);
    expect(isBlank(paper)).toBe(false);
    expect(isBlank(withStroke(paper, { ...pen(100, 100), erase: true, widthPx: 40 }))).toBe(true);
  });

  it("is the drawing of its pad", () => {
    const drawing = drawingOf(withStroke(null, pen(100, 100)), "side");
    expect(drawing).toMatchObject({ name: "side", width: PAPER_PX, height: PAPER_PX });
    expect(drawing.ink.length).toBe(PAPER_PX ** 2);
  });
});
