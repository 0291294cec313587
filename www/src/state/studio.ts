/** Everything a person can do on the page, and the state that follows from it. Knows no elements. */

import { Cancelled, EngineClient } from "../engine/client";
import type { ExportFormat, Finished, Frame, Ink, News, Picture, SettingRow, SettingValues, Target, View } from "../engine/protocol";
import type { WireShape } from "../embed/shape";
import { linkTo } from "./link";
import { readPicture } from "./picture";
import { Store } from "./store";
import { asSentence, explain, placement } from "./words";

export const SLOTS = ["front", "side", "top"] as const;
export type Slot = (typeof SLOTS)[number];

/** A drawing's place. */
export interface Pad {
  readonly picture: Picture | null;
  /** What the core sees in it. */
  readonly ink: Ink | null;
  readonly note: string;
  /** Where its drawing went in the last run, in words, if not simply where it was put. */
  readonly placed: string;
  /** What was wrong with the last picture that was given; the one before is kept. */
  readonly problem: string;
  readonly busy: boolean;
}

export type Phase = "idle" | "preparing" | "running" | "paused" | "finishing";

export interface Progress {
  readonly words: string;
  /** 0 to 1. */
  readonly share: number;
  readonly secondsLeft: number | null;
}

export interface StudioState {
  readonly pads: Readonly<Record<Slot, Pad>>;
  readonly phase: Phase;
  readonly progress: Progress;
  /** [iteration, loss] since the run began. */
  readonly losses: readonly (readonly [number, number])[];
  /** Where the wire on the stage is to be looked at from. */
  readonly views: readonly View[];
  readonly targets: readonly Target[];
  /** What a person should know about the drawings of this run. */
  readonly notes: readonly string[];
  readonly finished: Finished | null;
  /** Where the wire on the stage is from. */
  readonly source: "none" | "example" | "run" | "link";
  /** The core's settings table, once it is loaded. */
  readonly rows: readonly SettingRow[];
  /** What differs from the defaults. */
  readonly settings: SettingValues;
  readonly problem: string;
  /** A short word about what was just done, such as "Link copied". */
  readonly said: string;
}

const EMPTY_PAD: Pad = { picture: null, ink: null, note: "", placed: "", problem: "", busy: false };
const READY: Progress = { words: "", share: 0, secondsLeft: null };

export class Studio {
  readonly store = new Store<StudioState>({
    pads: { front: EMPTY_PAD, side: EMPTY_PAD, top: EMPTY_PAD },
    phase: "idle",
    progress: READY,
    losses: [],
    views: [],
    targets: [],
    notes: [],
    finished: null,
    source: "none",
    rows: [],
    settings: { preset: "best", bend: "little" },
    problem: "",
    said: "",
  });
  private readonly engine = new EngineClient((news) => this.hear(news));
  private readonly wireListeners = new Set<(wire: WireShape | null) => void>();
  private wire: WireShape | null = null;
  private fitStartMs = 0;
  /** The pads whose pictures the present run was given, in its order. */
  private given: readonly Slot[] = [];
  /** The last finished wire as a share code. */
  private kept = "";

  constructor() {
    this.engine.call("settings", {}).then(
      (rows) => this.store.set({ rows }),
      (error: unknown) => this.store.set({ problem: explain(error, "The engine") }),
    );
  }

  /** The wire changes too often for the store. */
  followWire(listener: (wire: WireShape | null) => void): () => void {
    this.wireListeners.add(listener);
    listener(this.wire);
    return () => this.wireListeners.delete(listener);
  }

  /** Puts a file into a pad. A bad one leaves what was there. */
  async give(slot: Slot, file: Blob, name: string): Promise<void> {
    this.setPad(slot, { busy: true, problem: "" });
    try {
      const { width, height, rgba, note } = await readPicture(file, name);
      const picture: Picture = { name: slot, width, height, rgba };
      const ink = await this.engine.call("read", { picture: { ...picture, name }, settings: this.store.get().settings });
      this.setPad(slot, { picture, ink, note, placed: "", busy: false });
    } catch (error) {
      this.setPad(slot, { busy: false, problem: explain(error, name) });
    }
  }

  clear(slot: Slot): void {
    this.setPad(slot, EMPTY_PAD);
  }

  set(name: string, value: string): void {
    this.store.set({ settings: { ...this.store.get().settings, [name]: value } });
  }

  async run(): Promise<void> {
    const { pads, phase, settings } = this.store.get();
    if (phase !== "idle") return;
    this.given = SLOTS.filter((slot) => pads[slot].picture);
    const pictures = this.given.map((slot) => pads[slot].picture!);
    if (pictures.length < 2) {
      this.store.set({ problem: "A wire needs at least two drawings. Put one into another pad, then press Run." });
      return;
    }
    this.store.set({
      phase: "preparing",
      progress: { words: "Reading the drawings", share: 0, secondsLeft: null },
      losses: [],
      notes: [],
      finished: null,
      problem: "",
      said: "",
    });
    try {
      const finished = await this.engine.call("run", { pictures, settings });
      this.showWire(finished.wire);
      this.store.set({ phase: "idle", progress: READY, finished, views: finished.views, targets: finished.targets });
      this.kept = await this.engine.call("share", {});
    } catch (error) {
      const problem = error instanceof Cancelled ? "" : explain(error, "The run");
      this.store.set({ phase: "idle", progress: READY, problem });
      await this.bringBack();
    }
  }

  /** The last finished wire again, after a run that came to nothing: the worker that held it may be gone. */
  private async bringBack(): Promise<void> {
    if (!this.kept) return;
    const finished = await this.engine.call("open", { code: this.kept });
    if (this.store.get().phase !== "idle") return;
    this.showWire(finished.wire);
    this.store.set({ finished, views: finished.views, targets: finished.targets });
  }

  /** Ends the run and keeps the best wire so far; while there is none yet it simply ends. */
  stop(): void {
    const { phase } = this.store.get();
    if (phase === "preparing") {
      this.engine.cancel();
    } else if (phase === "running" || phase === "paused") {
      this.store.set({ phase: "finishing" });
      this.engine.control("stop");
    }
  }

  pause(): void {
    const { phase } = this.store.get();
    if (phase === "running") {
      this.store.set({ phase: "paused" });
      this.engine.control("pause");
    } else if (phase === "paused") {
      this.store.set({ phase: "running" });
      this.engine.control("resume");
    }
  }

  /** Shows the wire that a code carries, unless another has been made meanwhile. */
  async open(code: string, source: "link" | "example"): Promise<void> {
    try {
      const finished = await this.engine.call("open", { code });
      if (this.store.get().phase !== "idle") return;
      this.showWire(finished.wire);
      this.kept = code;
      const { views, targets } = finished;
      const said = source === "example" ? "An example, made from these three drawings. Run makes it again." : "";
      this.store.set({ finished, source, views, targets, losses: [], notes: [], problem: "", said });
    } catch (error) {
      this.store.set({ problem: explain(error, "The link") });
    }
  }

  /** The last finished wire as a file. */
  async export(format: ExportFormat): Promise<Blob | null> {
    try {
      const bytes = await this.engine.call("export", { format });
      this.store.set({ problem: "" });
      return new Blob([bytes], { type: format === "glb" ? "model/gltf-binary" : "application/json" });
    } catch (error) {
      this.store.set({ problem: explain(error, "The file") });
      return null;
    }
  }

  /** A link that carries the whole wire. */
  async link(page: string): Promise<string | null> {
    try {
      return linkTo(await this.engine.call("share", {}), page);
    } catch (error) {
      this.store.set({ problem: explain(error, "The link") });
      return null;
    }
  }

  say(said: string): void {
    this.store.set({ said });
  }

  warn(problem: string): void {
    this.store.set({ problem });
  }

  private setPad(slot: Slot, change: Partial<Pad>): void {
    const { pads } = this.store.get();
    this.store.set({ pads: { ...pads, [slot]: { ...pads[slot], ...change } } });
  }

  private showWire(wire: WireShape): void {
    this.wire = wire;
    for (const listener of this.wireListeners) listener(wire);
  }

  private hear(news: News): void {
    switch (news.news) {
      case "progress":
        this.store.set({ progress: { words: news.words, share: news.share, secondsLeft: null } });
        break;
      case "note":
        this.store.set({ notes: [...this.store.get().notes, asSentence(news.words)] });
        break;
      case "targets":
        this.fitStartMs = performance.now();
        this.store.set({
          targets: news.targets,
          views: news.targets.map((target) => target.view),
          phase: "running",
          source: "run",
        });
        for (const target of news.targets) {
          const slot = this.given[target.source];
          if (slot) this.setPad(slot, { placed: placement(slot, target) });
        }
        break;
      case "frame":
        this.hearFrame(news.frame);
        // After the browser has drawn what came of it (or at once in a hidden tab, where it draws nothing).
        afterDrawing(() => this.engine.control("seen"));
        break;
    }
  }

  private hearFrame(frame: Frame): void {
    const { losses, phase } = this.store.get();
    if (phase === "idle" || phase === "preparing") return;
    this.showWire(frame.wire);
    const share = frame.iteration / Math.max(1, frame.iterations);
    const elapsedS = (performance.now() - this.fitStartMs) / 1000;
    this.store.set({
      losses: [...losses, [frame.iteration, frame.loss] as const],
      progress: {
        words: "Bending the wire into shape",
        share,
        secondsLeft: share > 0.05 ? Math.ceil((elapsedS * (1 - share)) / share) : null,
      },
    });
  }
}

/** Where drawing takes long, as long again is left for everything else. */
function afterDrawing(action: () => void): void {
  if (document.hidden) {
    action();
    return;
  }
  const askedMs = performance.now();
  requestAnimationFrame(() =>
    setTimeout(() => {
      const tookMs = performance.now() - askedMs;
      if (tookMs > 50) setTimeout(action, Math.min(1000, tookMs));
      else action();
    }),
  );
}
