import { describe, expect, it, vi } from "vitest";
import type { WireShape } from "#sculpture/scene/shape";
import type { Made } from "../../state/keeping/document";
import { wayOf, wiresFor } from "./wires";

/** Replays of as many wires as their first byte says; a zero is none. */
vi.mock("#sculpture/share/replay", () => ({
  openReplay: ([count]: Uint8Array) => {
    if (!count) throw new Error("this replay is damaged");
    return Array.from({ length: count }, (_, iteration) => ({ iteration, wire: wire(iteration) }));
  },
}));

const wire = (x: number): WireShape => ({ closed: true, knots: [0, 1, 2], controlPoints: [x, 0, 0, 1] });

it("takes at most sixty wires from all of the way, the finished one last", () => {
  const way = Array.from({ length: 500 }, (_, i) => wire(i));
  const wires = wiresFor(way, wire(1000));
  expect(wires).toHaveLength(60);
  const firsts = wires.map(({ controlPoints }) => controlPoints[0]!);
  expect(firsts[0]).toBe(0);
  expect(firsts.at(-1)).toBe(1000);
  expect(firsts.at(-2)).toBeGreaterThan(480);
  expect([...firsts].sort((a, b) => a - b)).toEqual(firsts);
});

it("takes all of a short way, and the wire alone where there is none", () => {
  expect(wiresFor([wire(1), wire(2)], wire(3))).toHaveLength(3);
  expect(wiresFor([], wire(3))).toHaveLength(1);
});

describe("the way of a wire", () => {
  const made = (track: unknown, file: string): Made => ({ track, finished: { file: new TextEncoder().encode(file) } }) as unknown as Made;
  const firsts = (of: Made): number[] => wayOf(of).map(({ controlPoints }) => controlPoints[0]!);

  it("is that of its run", () => {
    const snapshots = [{ wire: wire(4) }, { wire: wire(5) }];
    expect(firsts(made({ snapshots }, "{}"))).toEqual([4, 5]);
    expect(firsts(made({ snapshots, loose: true }, "{}"))).toEqual([]);
  });

  it("is what its file says of one, without the wire itself; nothing where that is damaged or no JSON", () => {
    // A byte of three, and one of none.
    expect(firsts(made(null, `{"replay":"Aw"}`))).toEqual([0, 1]);
    expect(firsts(made(null, `{"replay":"AA"}`))).toEqual([]);
    for (const file of [`{"replay":"!"}`, `{"replay":7}`, "{}", "", "null"]) expect(firsts(made(null, file))).toEqual([]);
  });
});
