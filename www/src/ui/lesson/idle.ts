/** Notices when nobody has touched the page for a while, and counts down before it says so: any touch ends that. */

import type { ReactiveController, ReactiveControllerHost } from "lit";

export const STILL_MS = 60_000;
export const COUNTED_S = 15;
const TOUCHES = ["pointerdown", "pointermove", "keydown", "wheel"] as const;

export class Idle implements ReactiveController {
  /** Null as long as nothing is counted. */
  secondsLeft: number | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private watching = false;

  constructor(
    private readonly host: ReactiveControllerHost,
    private readonly of: { readonly watches: () => boolean; readonly over: () => void },
  ) {
    host.addController(this);
  }

  hostConnected(): void {
    for (const touch of TOUCHES) addEventListener(touch, this.touched, { capture: true, passive: true });
  }

  hostDisconnected(): void {
    for (const touch of TOUCHES) removeEventListener(touch, this.touched, { capture: true });
    this.rest();
  }

  /** Begins to watch, or ends. */
  look(): void {
    const watches = this.of.watches();
    if (watches === this.watching) return;
    this.rest();
    this.watching = watches;
    if (watches) this.wait();
  }

  private rest(): void {
    clearTimeout(this.timer);
    this.watching = false;
    this.count(null);
  }

  private wait(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.tick(COUNTED_S), STILL_MS);
  }

  private tick(left: number): void {
    if (left > 0) {
      this.count(left);
      this.timer = setTimeout(() => this.tick(left - 1), 1000);
      return;
    }
    this.count(null);
    this.of.over();
    this.wait();
  }

  private count(secondsLeft: number | null): void {
    if (secondsLeft === this.secondsLeft) return;
    this.secondsLeft = secondsLeft;
    this.host.requestUpdate();
  }

  private readonly touched = (): void => {
    if (!this.watching) return;
    this.count(null);
    this.wait();
  };
}
