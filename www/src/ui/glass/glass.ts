/** The optimiser, opened: what pulls at the wire, what it sees at each scale, and how the wire runs. */

import type { WireShape } from "#sculpture/scene/shape";
import type { Insight } from "../../engine/protocol";
import { Store } from "../../state/common/store";
import type { Studio, StudioState } from "../../state/studio";
import { pageColours } from "../../view/colours";
import { profileOf, type Profile } from "../../view/profile";
import { isDark } from "../shared/theme";
import type { WireStage } from "../stage/wire-stage";
import { onPicture } from "../../view/on-picture";
import { paintOverlay, type Pulling } from "./arrows";
import { ALL, inkOf, OF_ALL, together, type Ink } from "./terms";

export interface GlassState {
  /** The run as it was last taken apart; null before that. */
  readonly insight: Insight | null;
  /** Names of the terms whose arrows are drawn. */
  readonly shown: readonly string[];
  /** Whether each term's arrows are as long as can be read, and not all on one scale. */
  readonly stretched: boolean;
  /** Of the wire on the stage. */
  readonly profile: Profile | null;
  /** The sample of it that is looked at. */
  readonly at: number | null;
}

/** Between two looks into a run under way, and how many times as long as a look took: most of the time is the run's. */
const REST_MS = 400;
const REST_SHARE = 4;
/** Between two looks at how a wire runs that is being made. */
const PROFILE_MS = 150;
/** How near to the wire somebody has to point, CSS pixels. */
const NEAR_PX = 14;

export class Glass {
  readonly store = new Store<GlassState>({ insight: null, shown: [ALL], stretched: false, profile: null, at: null });
  private readonly canvas = document.createElement("canvas");
  private wire: WireShape | null = null;
  private profiled: ReturnType<typeof setTimeout> | undefined;
  private isAsking = false;
  private isDue = false;
  private painting = 0;

  constructor(
    readonly studio: Studio,
    private readonly stage: WireStage,
  ) {
    this.canvas.setAttribute("aria-hidden", "true");
    stage.lay(this.canvas);
    studio.followWire((wire) => {
      this.wire = wire;
      void this.ask();
      this.profiled ??= setTimeout(() => this.profile(), PROFILE_MS);
    });
    studio.store.watch(({ tool, phase, looking, running, doc }) => [tool, phase, looking, running, doc.task], () => {
      this.profile();
      void this.ask();
      this.repaint();
    });
    this.store.follow(() => this.repaint());
    for (const event of ["camera-change", "look-change"]) stage.addEventListener(event, () => this.repaint());
    stage.addEventListener("pointermove", (event) => this.point(event));
    new ResizeObserver(() => this.repaint()).observe(this.canvas);
    addEventListener("theme-change", () => this.repaint());
    this.profile();
    void this.ask();
  }

  private get isOpen(): boolean {
    return this.studio.store.get().tool === "glass";
  }

  /** Whether the run whose arrows there are is what the stage shows. */
  isLive({ running, doc, looking, phase }: StudioState = this.studio.store.get()): boolean {
    return running === doc.task && looking === null && (phase === "running" || phase === "paused");
  }

  show(name: string, on: boolean): void {
    const others = this.store.get().shown.filter((other) => other !== name);
    this.store.set({ shown: on ? [...others, name] : others });
  }

  /** How a term's arrows look now. */
  colourOf({ light, dark }: Ink): string {
    return matchMedia("(forced-colors: active)").matches ? pageColours().ink : isDark() ? dark : light;
  }

  private profile(): void {
    clearTimeout(this.profiled);
    this.profiled = undefined;
    if (!this.isOpen) return;
    const before = this.store.get();
    const profile = this.wire && profileOf(this.wire);
    // As far along as before.
    const at = before.at === null || !profile?.count ? null : Math.min(profile.count - 1, Math.round((before.at * profile.count) / Math.max(1, before.profile?.count ?? 1)));
    this.store.set({ profile, at });
  }

  /** Looks into the run: again and again while it goes on, and once more where it rests. */
  private async ask(): Promise<void> {
    this.isDue = true;
    if (this.isAsking) return;
    this.isAsking = true;
    try {
      while (this.isDue && this.isOpen && this.isLive()) {
        this.isDue = false;
        const beganMs = performance.now();
        const insight = await this.studio.bench.engine.call("insight", {});
        if (insight) this.store.set({ insight });
        const restMs = this.studio.store.get().phase === "paused" ? 0 : Math.max(REST_MS, REST_SHARE * (performance.now() - beganMs));
        await new Promise((resolve) => setTimeout(resolve, restMs));
      }
    } catch (error) {
      // The engine is gone, and says so itself.
      console.warn(error);
    } finally {
      this.isAsking = false;
    }
  }

  /** Whoever points at the wire sees where that is along it. */
  private point({ clientX, clientY, buttons }: PointerEvent): void {
    const { profile } = this.store.get();
    if (!this.isOpen || !profile || buttons !== 0) return;
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const clip = this.stage.clipFromWorld(width, height);
    if (!clip) return;
    let [nearest, at] = [NEAR_PX, -1];
    for (let i = 0; i < profile.count; i++) {
      const seen = onPicture(clip, width, height, profile.places[3 * i]!, profile.places[3 * i + 1]!, profile.places[3 * i + 2]!);
      const away = seen ? Math.hypot(seen[0] + left - clientX, seen[1] + top - clientY) : Infinity;
      if (away < nearest) [nearest, at] = [away, i];
    }
    if (at >= 0) this.store.set({ at });
  }

  private repaint(): void {
    this.painting ||= requestAnimationFrame(() => {
      this.painting = 0;
      this.paint();
    });
  }

  private paint(): void {
    this.canvas.hidden = !this.isOpen;
    if (!this.isOpen) return;
    const { insight, shown, stretched, profile, at } = this.store.get();
    const { clientWidth, clientHeight } = this.canvas;
    const pulls: Pulling[] = [];
    if (insight && this.isLive()) {
      const { pulls: terms } = insight;
      terms.forEach((term, index) => {
        const ink = inkOf(term, index);
        if (shown.includes(term.name)) pulls.push({ ...ink, gradient: term.gradient, colour: this.colourOf(ink) });
      });
      if (shown.includes(ALL)) pulls.push({ ...OF_ALL, gradient: together(terms), colour: this.colourOf(OF_ALL) });
    }
    const place = profile && at !== null ? ([0, 1, 2].map((c) => profile.places[3 * at + c]!) as [number, number, number]) : null;
    const points = insight?.wire.controlPoints ?? null;
    const style = getComputedStyle(this.stage);
    paintOverlay(this.canvas, this.stage.clipFromWorld(clientWidth, clientHeight), { points, pulls, stretched, place, ink: pageColours().ink, halo: style.getPropertyValue("--stage") });
  }
}
