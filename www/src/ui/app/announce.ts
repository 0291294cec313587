/** What a screen reader hears of the page, at a bearable pace. */

import type { Phase, StudioState } from "../../state/studio";
import { percent } from "../../state/words";
import { verdict } from "../run/verdict";

const PHASES: Readonly<Record<Phase, string>> = {
  idle: "",
  preparing: "Preparing the run.",
  running: "The wire is being bent into shape.",
  paused: "Paused.",
  finishing: "Keeping the best wire so far.",
};

/** What changed from one state to the next, as far as it is worth saying; empty if nothing is. */
export function news(before: StudioState, now: StudioState): string {
  if (now.doc.made !== before.doc.made && now.doc.made?.source === "run" && now.phase === "idle") return `Done. ${verdict(now.doc.made)}`;
  if (now.said !== before.said && now.said) return now.said;
  if (now.phase !== before.phase) return PHASES[now.phase] || "The run has ended.";
  const quarter = Math.floor(4 * now.progress.share);
  if (now.phase === "running" && quarter > Math.floor(4 * before.progress.share) && quarter < 4) return `${percent(quarter / 4)} done.`;
  return "";
}

const PAUSE_MS = 3000;

/** Lets through one message in three seconds at most; of those that come meanwhile the newest. */
export class Pacer {
  private waiting = "";
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly say: (message: string) => void) {}

  add(message: string): void {
    if (!message) return;
    this.waiting = message;
    if (this.timer === undefined) this.next();
  }

  stop(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.waiting = "";
  }

  private next(): void {
    this.timer = undefined;
    if (!this.waiting) return;
    this.say(this.waiting);
    this.waiting = "";
    this.timer = setTimeout(() => this.next(), PAUSE_MS);
  }
}
