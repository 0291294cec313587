/** Keeps a preview of the drawings as they are now: soon after they change, one at a time, and only of the newest. */

import type { BendPreview, Drawing, DrawingPreview, Preview, Remedy, SettingValues } from "../../engine/protocol";
import { SLOTS, type Desk, type Doc, type Slot } from "../../state/keeping/document";
import { drawingOf, isBlank } from "./drawing/paper";
import { nextTask } from "../../state/common/next-turn";
import { explain } from "../../state/common/words";
import type { Sheet } from "../../state/keeping/track";

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
export type Sheets = Pick<Doc, "papers"> & Pick<Desk, "settings">;

/** A hand that draws is not to be disturbed at every stroke. */
const WAIT_MS = 200;

export class Previewer {
  private wanted: Sheets | null = null;
  private shownPapers: Doc["papers"] | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private working = false;

  constructor(
    private readonly ask: (drawings: readonly Drawing[], settings: SettingValues) => Promise<Preview>,
    private readonly show: (state: Partial<PreviewState>) => void,
    /** Lets the browser do something else between two sheets. */
    private readonly pause: () => Promise<void> = nextTask,
  ) {}

  /** To be called after every change. */
  follow(doc: Sheets): void {
    const before = this.wanted;
    if (before && before.papers === doc.papers && before.settings === doc.settings) return;
    this.wanted = doc;
    clearTimeout(this.timer);
    // Whether one of them is blank is seen later: this is called while somebody waits.
    if (SLOTS.filter((slot) => doc.papers[slot]).length < 2) {
      this.shownPapers = null;
      this.show(NO_PREVIEW);
      return;
    }
    // What is known of other sheets is not shown over these.
    if (this.shownPapers && SLOTS.some((slot) => this.shownPapers![slot] !== doc.papers[slot])) {
      this.shownPapers = null;
      this.show({ preview: null });
    }
    this.show({ previewBusy: true });
    this.timer = setTimeout(() => void this.work(), before ? WAIT_MS : 0);
  }

  private async work(): Promise<void> {
    if (this.working) return;
    this.working = true;
    const doc = this.wanted!;
    const current = (): boolean => this.wanted === doc;
    try {
      const drawings = await this.drawingsOf(doc);
      const preview = current() && drawings.length >= 2 ? await this.ask(drawings, doc.settings) : null;
      if (current()) {
        this.shownPapers = preview && doc.papers;
        const bySlots = preview && bySlot(preview, drawings.map(({ name }) => name));
        this.show({ preview: bySlots, previewBusy: false, previewProblem: "" });
      }
    } catch (error) {
      if (current()) this.show({ preview: null, previewBusy: false, previewProblem: explain(error, "The preview") });
    }
    this.working = false;
    if (!current() && this.wanted) void this.work();
  }

  /** Each sheet is put together in a task of its own. */
  private async drawingsOf({ papers }: Sheets): Promise<(Drawing & { name: Slot })[]> {
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

/** The pads that hold ink, in order. */
export function sheetsOf({ papers }: Pick<Doc, "papers">): Sheet[] {
  return SLOTS.flatMap((slot) => {
    const paper = papers[slot];
    return paper && !isBlank(paper) ? [{ slot, paper }] : [];
  });
}

function bySlot({ drawings, remedies, ...rest }: Preview, slots: readonly Slot[]): PreviewBySlot {
  return {
    ...rest,
    drawings: Object.fromEntries(drawings.map((drawing, i) => [slots[i]!, drawing])),
    remedies: remedies.map((remedy) => ({ ...remedy, slots: remedy.sources.map((source) => slots[source]!) })),
  };
}
