import { describe, expect, it, vi } from "vitest";
import type { CoreRun, OwnShape } from "./core";
import type { Frame, News, Place, Snapshot } from "./protocol";
import { Pull } from "./pull";

const wire = (): OwnShape => ({ closed: false, knots: new Float64Array(8), controlPoints: new Float32Array(16) });

const CPU: Place = { backend: "cpu", device: "processor", why: "The processor does the work." };
const GPU: Place = { backend: "gpu", device: "Card", why: "The graphics card does the work." };

/** A run that takes `ms` an iteration, and a snapshot `snapshotMs`; `waitMs` a slice are spent waiting for a graphics card. */
function runOf(iterations: number, ms = 1, snapshotMs = 0, from = 0, waitMs = 0) {
  let clock = 0;
  vi.spyOn(performance, "now").mockImplementation(() => clock);
  const run = {
    iteration: from,
    iterations,
    asked: [] as number[],
    where: waitMs ? GPU : CPU,
    /** What happens while the card is waited for. */
    meanwhile: () => undefined as void,
    async step(count: number) {
      this.asked.push(count);
      if (waitMs) {
        await new Promise((resolve) => setTimeout(resolve));
        this.meanwhile();
      }
      clock += waitMs + count * ms;
      this.iteration = Math.min(iterations, this.iteration + count);
      return this.iteration === iterations ? [{ iteration: iterations, kind: "done" as const, count: 1 }] : [];
    },
    hired: [] as unknown[],
    hire(ask: unknown) {
      this.hired.push(ask);
    },
    place: () => run.where,
    frame: () => ({ wire: wire(), iteration: run.iteration, iterations, loss: 1 }),
    snapshot: () => ((clock += snapshotMs), { ...run.frame(), checkpoint: new Blob() }),
    targets: () => [],
    pads: () => [],
    insight: () => ({ iteration: run.iteration, wire: wire(), pulls: [], views: [] }),
    guideByWords: () => undefined,
    guideByDiffusion: () => undefined,
    troubles: () => [],
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
    expect(frames.length).toBeGreaterThan(45);
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

  it("lets itself be looked into between slices, at rest too, and no more when it is over", async () => {
    const run = runOf(100);
    const looked: (number | undefined)[] = [];
    let pull!: Pull;
    await pulled(run, (mine, news) => {
      pull = mine;
      sees(mine, news);
      if (news.news === "snapshot" && news.snapshot.iteration === 0) void mine.insight().then((insight) => looked.push(insight?.iteration));
      if (news.news === "frame" && looked.length === 1) mine.hear("pause");
      else if (news.news === "snapshot" && looked.length === 1) {
        void mine.insight().then((insight) => {
          looked.push(insight?.iteration);
          mine.hear("resume");
        });
      }
    });
    expect(looked[0]).toBe(0);
    expect(looked[1]).toBeGreaterThan(0);
    expect(looked).toHaveLength(2);
    const late = pull.insight();
    pull.end();
    expect(await late).toBeNull();
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
    expect(told.map((news) => news.news)).toEqual(["place", "snapshot", "frame"]);
  });

  it("does many iterations at once on a fast card, and still shows, keeps and hears", async () => {
    const run = runOf(20_000, 0.05, 2, 0, 3);
    const { frames, snapshots } = await pulled(run, sees);
    expect(Math.max(...run.asked)).toBeGreaterThan(300);
    const seconds = run.asked.reduce((sum, count) => sum + 3 + 0.05 * count, 0) / 1000;
    expect(frames.length).toBeGreaterThan(10 * seconds);
    expect(frames.length).toBeLessThanOrEqual(30 * seconds + 2);
    expect(snapshots.length).toBeGreaterThan(15);
    expect(snapshots.length).toBeLessThanOrEqual(41);
    expect(frames.at(-1)!.iterationsPerSecond).toBeGreaterThan(10_000);
  });

  it("hears a word that comes while the card is waited for, and acts on it after that slice", async () => {
    const run = runOf(10_000, 1, 0, 0, 40);
    let slices = 0;
    const at: number[] = [];
    let stepped = 0;
    let pull!: Pull;
    run.meanwhile = () => {
      if (++slices === 10) pull.hear("pause");
    };
    const { snapshots } = await pulled(run, (its, news) => {
      pull = its;
      sees(pull, news);
      if (news.news !== "snapshot" || slices < 10) return;
      at.push(news.snapshot.iteration);
      setTimeout(() => pull.hear(++stepped < 3 ? "step" : "stop"));
    });
    expect(slices).toBe(12);
    expect(run.asked.slice(10)).toEqual([1, 1]);
    expect(at).toEqual([0, 1, 2].map((more) => at[0]! + more));
    expect(snapshots.at(-1)!.iteration).toBe(run.iteration);
  });

  it("hires who is ready, once, between two slices", async () => {
    const run = runOf(300);
    const [early, late] = [() => Promise.reject(new Error()), () => Promise.reject(new Error())];
    const pull = new Pull(
      () => undefined,
      {
        get ready() {
          return run.iteration < 100 ? [early] : [early, late];
        },
      },
    );
    await pull.toTheEnd(run, false);
    expect(run.hired).toEqual([early, late]);
    const { told } = await pulled(Object.assign(runOf(60), { place: () => ({ ...CPU, workers: 2 }) }), sees);
    expect(told.filter(({ news }) => news === "place")).toEqual([{ news: "place", place: { ...CPU, workers: 2 } }]);
  });

  it("tells where it is computed, again when that changes, and begins with short slices there", async () => {
    const run = runOf(5000, 0.05, 0, 0, 3);
    const lost: Place = { ...CPU, why: "The graphics card was lost; the processor goes on." };
    let slices = 0;
    run.meanwhile = () => {
      if (++slices !== 12) return;
      run.where = lost;
      // Back to what was kept.
      run.iteration -= 400;
    };
    const { told, frames } = await pulled(run, sees);
    expect(told.flatMap((news) => (news.news === "place" ? [news.place] : []))).toEqual([GPU, lost]);
    expect(told[0]!.news).toBe("place");
    expect(run.asked[12]).toBe(1);
    expect(frames.every(({ iterationsPerSecond }) => iterationsPerSecond >= 0)).toBe(true);
    expect(run.iteration).toBe(5000);
  });
});
