/** What is remembered of a run: its losses, events, and a wire every few iterations. Immutable. */

import type { Frame, Guide, RunEvent, SettingValues, Snapshot } from "../../engine/protocol";

/** In what a run differs from that of the wire beside which its own is laid. */
export const VARIANTS = ["loose", "reinit", "refine", "respace", "smoothness", "tightness", "clearance", "level_weight", "bend", "start", "picture"] as const;
export type Variant = (typeof VARIANTS)[number];

export interface Track {
  /** The task it is of, and what was given for that; only the task knows what it is. */
  readonly task: string;
  readonly given: unknown;
  readonly settings: SettingValues;
  /** What guided it besides; nothing without. */
  readonly guide?: Guide | null;
  /** To be laid beside the wire on the stage, and not to take its place: loose strokes, where `variant` says nothing else. */
  readonly loose?: boolean;
  readonly variant?: Variant;
  readonly iterations: number;
  /** [iteration, loss] in order. */
  readonly losses: readonly (readonly [iteration: number, loss: number])[];
  readonly events: readonly RunEvent[];
  readonly snapshots: readonly Snapshot[];
}

/** In what it differs from that of the wire on the stage; null where it is that wire's. */
export function variantOf(track: Track | null | undefined): Variant | null {
  return track?.loose ? (track.variant ?? "loose") : null;
}

export function freshTrack(task: string, given: unknown, settings: SettingValues, guide: Guide | null = null): Track {
  return { task, given, settings, guide, iterations: 0, losses: [], events: [], snapshots: [] };
}

/** More losses than a curve of this many points can show are thinned out. */
const MOST_LOSSES = 600;

export function withFrame(track: Track, frame: Frame): Track {
  const losses = [...track.losses.filter(([iteration]) => iteration < frame.iteration), [frame.iteration, frame.loss] as const];
  const thinned = losses.length > MOST_LOSSES ? losses.filter((_, i) => i % 2 === 0 || i === losses.length - 1) : losses;
  return { ...track, iterations: frame.iterations, losses: thinned };
}

export function withEvent(track: Track, event: RunEvent): Track {
  return { ...track, events: [...track.events, event] };
}

export function withSnapshot(track: Track, snapshot: Snapshot): Track {
  const before = track.snapshots.filter(({ iteration }) => iteration < snapshot.iteration);
  return { ...track, iterations: snapshot.iterations, snapshots: [...before, snapshot] };
}

/** The same as it was at a snapshot: what came later is gone. */
export function upTo(track: Track, snapshot: Snapshot): Track {
  const until = snapshot.iteration;
  return {
    ...track,
    losses: track.losses.filter(([iteration]) => iteration <= until),
    events: track.events.filter(({ iteration, kind }) => iteration <= until && kind !== "done"),
    snapshots: track.snapshots.filter(({ iteration }) => iteration <= until),
  };
}
