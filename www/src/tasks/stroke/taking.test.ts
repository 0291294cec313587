import { describe, expect, it } from "vitest";
import { Problem } from "../../engine/client";
import { givenFor } from "../../state/contract/state";
import { testBench } from "../../state/contract/test-bench";
import { withGiven } from "../../state/keeping/document";
import type { Subject } from "./given";
import { hintsWithBox, hintsWithMark } from "./hints";
import type { FoundObject, PixelHints } from "./protocol";
import { stroke } from "./task";
import { SubjectTaker } from "./taking";

interface Asked {
  readonly key: number;
  readonly picture: object | null;
  readonly hints: PixelHints;
}

/** A taker with a picture, over an engine that knows pictures once it was given them. */
function taker(refuses: (asked: Asked) => boolean = () => false) {
  const asked: Asked[] = [];
  const known = new Set<number>();
  const call = async (_: string, given: Asked): Promise<FoundObject | null> => {
    asked.push(given);
    if (given.picture) known.add(given.key);
    if (!known.has(given.key)) return null;
    if (refuses(given)) throw new Problem("no object was found; draw on it");
    return { width: 1, height: 1, mask: Uint8Array.of(given.hints.marks.length), labels: Uint8Array.of(1), count: 1, notes: [] };
  };
  const bench = testBench([stroke], { call });
  const picture = { name: "cup.jpg", width: 100, height: 100, rgba: new Blob([new Uint8Array(40_000)]) };
  const subject: Subject = { picture, object: 2, strokes: [], found: null, depth: null };
  bench.change(withGiven(bench.doc, stroke.name, subject));
  return { asked, bench, taker: new SubjectTaker(bench, stroke), subject: () => givenFor(bench.store.get(), stroke)! };
}

const mark = (x: number) => ({ adds: true, width: 0.02, points: [x, 0.5] });

describe("pointing", () => {
  it("sends the picture once, and each mark waits for the one before", async () => {
    const { asked, bench, taker: it, subject } = taker();
    const point = (x: number) => it.point(`Mark ${x}`, (subject) => hintsWithMark(subject, mark(x)), true);
    await Promise.all([point(0.2), point(0.4), point(0.6)]);
    expect(asked.map(({ picture, hints }) => [!!picture, hints.marks.length])).toEqual([[false, 1], [true, 1], [false, 2], [false, 3]]);
    expect(subject().marks).toEqual([mark(0.2), mark(0.4), mark(0.6)]);
    expect(subject().found!.mask).toEqual(Uint8Array.of(3));
    expect(subject().object).toBe(1);
    expect(bench.labels).toEqual(["Mark 0.2", "Mark 0.4", "Mark 0.6"]);
  });

  it("takes what was foreseen of the same mark", async () => {
    const { asked, taker: it, subject } = taker();
    const change = (subject: Subject) => hintsWithMark(subject, mark(0.5));
    const [foreseen] = await Promise.all([it.foresee(change), it.point("Mark", change, true)]);
    expect(asked).toHaveLength(2);
    expect(subject().found).toBe(foreseen);
  });

  it("leaves what was there where nothing is found, says so, and asks again", async () => {
    let refuses = true;
    const { bench, taker: it, subject } = taker(() => refuses);
    const before = subject();
    const box = (subject: Subject) => hintsWithBox(subject, [0, 0, 0.5, 0.5]);
    expect(await it.foresee(box)).toBeNull();
    await it.point("Box", box);
    expect(subject()).toBe(before);
    expect(bench.store.get().passing[stroke.name]).toMatchObject({ busy: false, problem: expect.stringContaining("draw on it") });
    refuses = false;
    await it.point("Box", box);
    expect(subject().box).toEqual([0, 0, 0.5, 0.5]);
    await it.point("Remove", (subject) => hintsWithBox(subject, null));
    expect(bench.labels).toEqual(["Box", "Remove"]);
  });
});
