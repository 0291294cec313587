import { describe, expect, it, vi } from "vitest";
import type { CoreRun, OwnShape } from "./core";
import type { Frame, News, Snapshot } from "./protocol";
import { Pull } from "./pull";

const wire = (): OwnShape => ({ closed: false, knots: new Float64Array(8), controlPoints: new Float32Array(16) });

/** A run that takes `ms` an iteration, and a snapshot `snapshotMs`. */
function runOf(iterations: number, ms = 1, snapshotMs = 0, from = 0) {
  let clock = 0;
  vi.spyOn(performance, "now").mockImplementation(() => clock);
  const run = {
    iteration: from,
    iterations,
    asked: [] as number[],
    async step(count: number) {
      this.asked.push(count);
      clock += count * ms;
      this.iteration = Math.min(iterations, this.iteration + count);
      return this.iteration === iterations ? [{ iteration: iterations, kind: "done" as const, count: 1 }] : [];
    },
    frame: () => ({ wire: wire(), iteration: run.iteration, iterations, loss: 1 }),
    snapshot: () => ((clock += snapshotMs), { ...run.frame(), checkpoint: new Blob() }),
    targets: () => [],
    finish: () => {
      throw new Error("not in this test");
    },
    free: () => undefined,
  };
  return run satisfies CoreRun;
}

/** Pulls to the end; `page` hears the news and may answer. */
async function pulled(run: ReturnType<typeof runOf>, page: (pull: Pull, news: News) => void, resumed = false) {
  const told: News[] = [];
  const pull: Pull = new Pull((news) => {
    told.push(news);
    page(pull, news);
  });
  await pull.toTheEnd(run, resumed);
  const frames = told.flatMap((news): Frame[] => (news.news === "frame" ? [news.frame] : []));
  const snapshots = told.flatMap((news): Snapshot[] => (news.news === "snapshot" ? [news.snapshot] : []));
  return { told, frames, snapshots };
}

const sees = (pull: Pull, news: News) => {
  if (news.news === "frame") pull.hear("seen");
};

describe("a pulled run", () => {
  it("shows at most thirty frames a second, and none before the last was seen", async () => {
    const { frames } = await pulled(runOf(3000), sees);
    expect(frames.length).toBeGreaterThan(60);
    expect(frames.length).toBeLessThanOrEqual(3 * 30 + 2);
    expect(frames.at(-1)!.iteration).toBe(3000);
    expect(frames.at(-1)!.iterationsPerSecond).toBeCloseTo(1000, 0);
    const unseen = await pulled(runOf(3000), () => undefined);
    expect(unseen.frames.map((frame) => frame.iteration)).toEqual([frames[0]!.iteration, 3000]);
  });

  it("keeps about forty snapshots, the first and the last among them", async () => {
    const { snapshots, told } = await pulled(runOf(800), sees);
    expect(snapshots.map((snapshot) => snapshot.iteration)).toEqual(Array.from({ length: 41 }, (_, i) => 20 * i));
    expect(told.filter((news) => news.news === "event")).toHaveLength(1);
    const resumed = await pulled(runOf(800, 1, 0, 400), sees, true);
    expect(resumed.snapshots[0]!.iteration).toBe(420);
  });

  it("lets snapshots take no more than a few hundredths of its time", async () => {
    const { snapshots } = await pulled(runOf(1000, 1, 10), sees);
    expect(snapshots.length).toBeGreaterThan(2);
    // Five at a hundredth of a second each are a twentieth of the second it takes; the first and the last come on top.
    expect(snapshots.length).toBeLessThan(9);
  });

  it("pauses with all it has, does single steps, and goes on", async () => {
    const run = runOf(100);
    const at: number[] = [];
    let paused = false;
    const { snapshots } = await pulled(run, (pull, news) => {
      sees(pull, news);
      if (news.news === "frame" && !paused) {
        paused = true;
        pull.hear("pause");
      } else if (news.news === "snapshot" && paused && at.length < 4) {
        at.push(news.snapshot.iteration);
        setTimeout(() => pull.hear(at.length < 4 ? "step" : "resume"));
      }
    });
    expect(at.slice(1)).toEqual([1, 2, 3].map((more) => at[0]! + more));
    expect(snapshots.at(-1)!.iteration).toBe(100);
  });

  it("takes one step and rests even while it runs", async () => {
    const run = runOf(1000);
    const { frames, snapshots } = await pulled(run, (pull, news) => {
      if (news.news !== "frame") return;
      pull.hear("seen");
      if (run.asked.length < 20) {
        pull.hear("step");
        setTimeout(() => pull.hear("stop"), 20);
      }
    });
    expect(run.asked.at(-1)).toBe(1);
    expect(snapshots.at(-1)!.iteration).toBe(run.iteration);
    expect(frames.at(-1)!.iteration).toBe(run.iteration);
    expect(run.iteration).toBeLessThan(1000);
  });

  it("stops before it begins if told so while the core was loading", async () => {
    const run = runOf(100);
    const told: News[] = [];
    const pull = new Pull((news) => told.push(news));
    pull.hear("stop");
    await pull.toTheEnd(run, false);
    expect(run.asked).toEqual([]);
    expect(told.map((news) => news.news)).toEqual(["snapshot", "frame"]);
  });
});
