/** What a screen reader hears of the page, at a bearable pace. */

import { msg, str } from "@lit/localize";
import { deskOf, type Made, type Phase, type StudioState } from "../../state/studio";
import { percent } from "../../words/numbers";
import type { Task } from "../../state/contract/task";
import { variantOf } from "../../state/keeping/track";
import { compared, weighed } from "../run/compared";

const PHASES: Readonly<Record<Phase, string>> = {
  idle: "",
  preparing: msg("Preparing the run."),
  running: msg("The wire is being bent into shape."),
  paused: msg("Paused."),
  finishing: msg("Keeping the best wire so far."),
};

/** What is read here of tasks. */
type Told = Pick<Task, "name" | "compared" | "verdict">;

/** What changed from one state to the next, as far as it is worth saying; empty if nothing is. */
export function news(before: StudioState, now: StudioState, tasks: readonly Told[]): string {
  for (const { name, compared: views, verdict } of tasks) {
    const { made, loose } = deskOf(now.doc, name);
    const { made: madeBefore, loose: looseBefore } = deskOf(before.doc, name);
    if (now.phase !== "idle") break;
    // Of the run that was on the page, and not kept from before or brought back by undo.
    const fresh = ({ track }: Made): boolean => track !== null && track === before.track;
    if (made !== madeBefore && made?.source === "run" && fresh(made)) return msg(str`Done. ${verdict(made)}`);
    if (loose !== looseBefore && loose && made && fresh(loose)) return msg(str`Done. ${variantOf(loose.track) === "loose" ? compared(made, loose, views.length) : weighed(made, loose, views.length)}`);
  }
  if (now.said !== before.said && now.said) return now.said;
  if (now.phase !== before.phase) return PHASES[now.phase] || msg("The run has ended.");
  const quarter = Math.floor(4 * now.progress.share);
  if (now.phase === "running" && quarter > Math.floor(4 * before.progress.share) && quarter < 4) return msg(str`${percent(quarter / 4)} done.`);
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
