/** What a person makes on the page: everything that undo goes over and that is kept. */

import type { Finished, SettingValues } from "../../engine/protocol";
import type { Paper } from "../drawing/paper";
import type { Track } from "../run/track";

export const SLOTS = ["front", "side", "top"] as const;
export type Slot = (typeof SLOTS)[number];

export interface Doc {
  readonly papers: Readonly<Record<Slot, Paper | null>>;
  /** What differs from the preset, and the preset itself if it is not `best`. */
  readonly settings: SettingValues;
  /** The wire on the stage while nothing runs. */
  readonly made: Made | null;
}

/** A wire with where it is from. */
export interface Made {
  readonly finished: Finished;
  readonly source: "example" | "link" | "file" | "run";
  /** The run it came from; null for a wire from elsewhere. */
  readonly track: Track | null;
  /** Whether the run was stopped before its end. */
  readonly stopped: boolean;
  /** Seconds the run took; 0 for a wire from elsewhere. */
  readonly seconds: number;
}

export const BLANK: Doc = { papers: { front: null, side: null, top: null }, settings: {}, made: null };
