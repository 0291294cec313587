/** A run while its tab is hidden: it keeps going, or rests until the tab is back, as the person chose. */

import type { Phase, WhenHidden } from "../contract/state";

export class HiddenTab {
  /** It was the tab that paused the run, not the person: only then the run goes on by itself. */
  private resting = false;

  constructor(
    private readonly choice: () => WhenHidden,
    private readonly run: { readonly phase: () => Phase; readonly pauseOrGoOn: () => void },
    private readonly page: Pick<Document, "hidden" | "addEventListener"> = document,
  ) {
    page.addEventListener("visibilitychange", () => this.look());
  }

  /** To be called also when the phase changes: a run may begin behind one's back. */
  look(): void {
    const phase = this.run.phase();
    if (this.page.hidden && phase === "running" && this.choice() === "pause") {
      this.resting = true;
      this.run.pauseOrGoOn();
    } else if (phase !== "paused") {
      this.resting = false;
    } else if (!this.page.hidden && this.resting) {
      this.resting = false;
      this.run.pauseOrGoOn();
    }
  }
}
