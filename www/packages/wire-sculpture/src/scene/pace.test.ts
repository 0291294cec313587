import { describe, expect, it } from "vitest";
import { COARSEST, Pace } from "./pace";

const LIMIT = 0.1;

/** A pace that has seen pictures at rest, and then has a share of the time only. */
function rationed(byProcessor: boolean, finestMs: number): Pace {
  const pace = new Pace(byProcessor);
  pace.begin(true, false);
  pace.end(finestMs, false, false);
  pace.ration(LIMIT);
  return pace;
}

/** Pictures that follow each other as soon as they may, for so long by a clock of its own; `latency` is what is seen of a picture that costs so much. */
function follow(pace: Pace, finestMs: number, forMs: number, latency = (costMs: number, _count: number): number => costMs) {
  let [nowMs, drawnMs, count] = [0, 0, 0];
  while (nowMs < forMs) {
    pace.begin(false, false);
    const costMs = finestMs * pace.fineness ** 2;
    const tookMs = latency(costMs, count++);
    nowMs += tookMs + pace.end(tookMs, true, false);
    drawnMs += costMs;
  }
  return { share: drawnMs / nowMs, count };
}

describe("while something else needs the processor", () => {
  it("pictures drawn by it take no more than their share of the time, whatever they cost", () => {
    for (const finestMs of [1, 8, 40, 120, 600]) {
      const { share } = follow(rationed(true, finestMs), finestMs, 20_000);
      expect(share).toBeLessThan(1.1 * LIMIT);
    }
  });

  it("pictures are made coarser before they are made fewer", () => {
    const pace = rationed(true, 60);
    const { count } = follow(pace, 60, 10_000);
    expect(pace.fineness).toBeGreaterThan(COARSEST);
    expect(pace.fineness).toBeLessThan(1);
    expect(count).toBeGreaterThanOrEqual(45);
    expect(follow(rationed(true, 4), 4, 10_000).count).toBeGreaterThan(200);
  });

  it("pictures that others delay are taken for what they cost alone", () => {
    const quiet = follow(rationed(true, 200), 200, 20_000);
    const busy = follow(rationed(true, 200), 200, 20_000, (costMs, count) => (count % 3 === 0 ? costMs : 5 * costMs));
    expect(busy.count).toBeGreaterThan(0.6 * quiet.count);
    expect(busy.share).toBeLessThan(1.1 * LIMIT);
  });

  it("there is a picture every other second all the same", () => {
    expect(follow(rationed(true, 2500), 2500, 30_000).count).toBeGreaterThan(10);
  });

  it("who holds the camera does not wait", () => {
    const pace = rationed(true, 60);
    follow(pace, 60, 2000);
    const before = pace.fineness;
    pace.begin(false, true);
    expect(pace.end(20, true, true)).toBe(0);
    expect(pace.fineness).toBe(before);
  });

  it("a small canvas is not drawn coarser than it has pixels to spare", () => {
    const fineness = (longerPx: number): number => {
      const pace = rationed(true, 600);
      pace.resize(longerPx);
      follow(pace, 600, 5000);
      return pace.fineness;
    };
    expect(fineness(2000)).toBe(COARSEST);
    expect(fineness(500)).toBeCloseTo(0.68);
    // Still less than the finest: what is hasty besides saves time.
    expect(fineness(100)).toBe(0.9);
  });

  it("a graphics card draws as ever", () => {
    const pace = rationed(false, 12);
    expect(pace.rationed).toBe(false);
    const { count } = follow(pace, 12, 1200);
    expect(pace.fineness).toBe(1);
    expect(count).toBe(100);
  });

  it("what stands still is drawn at its finest, and what moves then as coarse as before", () => {
    const pace = rationed(true, 600);
    follow(pace, 600, 5000);
    const before = pace.fineness;
    expect(before).toBeLessThan(1);
    pace.begin(true, false);
    expect(pace.fineness).toBe(1);
    pace.end(600, false, false);
    pace.begin(false, false);
    expect(pace.fineness).toBe(before);
  });
});

describe("while nothing else needs it", () => {
  it("late pictures become coarser, and those that are late all the same are too much", () => {
    const pace = new Pace(true);
    const late = (): number => pace.end(60, true, false);
    while (pace.fineness > COARSEST) {
      const before = pace.fineness;
      expect(late()).toBe(0);
      expect(pace.fineness).toBeLessThan(before);
      expect(pace.overtaxed).toBe(false);
    }
    late();
    expect(pace.overtaxed).toBe(true);
  });

  it("very late ones leave a while to others, and one that nothing follows may be as late as it likes", () => {
    const pace = new Pace(false);
    expect(pace.end(100, true, false)).toBe(100);
    expect(pace.end(900, true, false)).toBe(150);
    const { fineness } = pace;
    expect(pace.end(900, false, false)).toBe(0);
    // The page slept.
    expect(pace.end(5000, true, false)).toBe(0);
    expect(pace.fineness).toBe(fineness);
  });
});
