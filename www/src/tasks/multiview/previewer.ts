/** Keeps a preview of the drawings as they are now: soon after they change, one at a time, and only of the newest. */

import { msg } from "@lit/localize";
import type { BendPreview, DrawingPreview, Preview, Remedy, SettingValues } from "../../engine/protocol";
import { nextTurn } from "../../state/common/next-turn";
import { explain } from "../../words/sentences";
import { drawingOf, isBlank } from "./paper";
import { laidOut, SLOTS, type Papers, type Slot } from "./given";
import type { Drawing } from "./protocol";

/** What the drawings come to, by the pads they are in. */
export interface PreviewBySlot {
  readonly drawings: Readonly<Partial<Record<Slot, DrawingPreview>>>;
  readonly coverable: number;
  readonly asGiven: number;
  readonly remedies: readonly PadRemedy[];
  readonly bends: readonly BendPreview[];
  readonly notes: readonly string[];
}

export interface PadRemedy extends Remedy {
  readonly slots: readonly Slot[];
}

export interface PreviewState {
  readonly preview: PreviewBySlot | null;
  readonly previewBusy: boolean;
  readonly previewProblem: string;
}

export const NO_PREVIEW: PreviewState = { preview: null, previewBusy: false, previewProblem: "" };

/** The drawings, and the settings they would run with. */
export interface Wanted {
  readonly papers: Papers;
  readonly settings: SettingValues;
}

/** A hand that draws is not to be disturbed at every stroke. */
const WAIT_MS = 200;

export class Previewer {
  private wanted: Wanted | null = null;
  private shownPapers: Papers | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private working = false;

  constructor(
    private readonly ask: (drawings: readonly Drawing[], settings: SettingValues) => Promise<Preview>,
    private readonly show: (state: Partial<PreviewState>) => void,
    /** Lets the browser do something else between two sheets. */
    private readonly pause: () => Promise<void> = nextTurn,
  ) {}

  /** To be called after every change. */
  follow(wanted: Wanted): void {
    const before = this.wanted;
    if (before && before.papers === wanted.papers && before.settings === wanted.settings) return;
    this.wanted = wanted;
    clearTimeout(this.timer);
    // Whether one of them is blank is seen later: this is called while somebody waits.
    if (laidOut(wanted.papers).length < 2) {
      this.shownPapers = null;
      this.show(NO_PREVIEW);
      return;
    }
    // What is known of other sheets is not shown over these.
    if (this.shownPapers && SLOTS.some((slot) => this.shownPapers![slot] !== wanted.papers[slot])) {
      this.shownPapers = null;
      this.show({ preview: null });
    }
    this.show({ previewBusy: true });
    this.timer = setTimeout(() => void this.work(), before ? WAIT_MS : 0);
  }

  private async work(): Promise<void> {
    if (this.working) return;
    this.working = true;
    const wanted = this.wanted!;
    const current = (): boolean => this.wanted === wanted;
    try {
      const drawings = await this.drawingsOf(wanted);
      const preview = current() && drawings.length >= 2 ? await this.ask(drawings, wanted.settings) : null;
      if (current()) {
        this.shownPapers = preview && wanted.papers;
        const bySlots = preview && bySlot(preview, drawings.map(({ name }) => name));
        this.show({ preview: bySlots, previewBusy: false, previewProblem: "" });
      }
    } catch (error) {
      if (current()) this.show({ preview: null, previewBusy: false, previewProblem: explain(error, msg("The preview")) });
    }
    this.working = false;
    if (!current() && this.wanted) void this.work();
  }

  /** Each sheet is put together in a turn of its own. */
  private async drawingsOf({ papers }: Wanted): Promise<(Drawing & { name: Slot })[]> {
    const drawings: (Drawing & { name: Slot })[] = [];
    for (const slot of SLOTS) {
      const paper = papers[slot];
      if (!paper) continue;
      await this.pause();
      if (!isBlank(paper)) drawings.push({ ...drawingOf(paper, slot), name: slot });
    }
    return drawings;
  }
}

function bySlot({ drawings, remedies, ...rest }: Preview, slots: readonly Slot[]): PreviewBySlot {
  return {
    ...rest,
    drawings: Object.fromEntries(drawings.map((drawing, i) => [slots[i]!, drawing])),
    remedies: remedies.map((remedy) => ({ ...remedy, slots: remedy.sources.map((source) => slots[source]!) })),
  };
}
