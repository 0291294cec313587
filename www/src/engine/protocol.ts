/** The messages between page and worker. Each request gets exactly one answer; a run also sends news on its way. */

import type { WireShape } from "../embed/shape";

/** Straight (not premultiplied) RGBA, row by row from the top left. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
}

/** A picture with the name people know it by. */
export interface Picture extends Pixels {
  readonly name: string;
}

/** One channel, 0 (ground) to 255 (ink). */
export interface Ink {
  readonly width: number;
  readonly height: number;
  readonly ink: Uint8Array<ArrayBuffer>;
}

/** A view as in wire.json. */
export interface View {
  readonly name: string;
  readonly projection: "orthographic" | "perspective";
  readonly eye: readonly [number, number, number];
  readonly target: readonly [number, number, number];
  readonly up: readonly [number, number, number];
  readonly fov_y_rad?: number;
  readonly height_world?: number;
  readonly width_px: number;
  readonly height_px: number;
}

/** A view and the ink it should show. */
export interface Target extends Ink {
  readonly view: View;
  /** Share of its ink that any object at all could show, 0 to 1. */
  readonly coverable: number;
  /** Which of the run's pictures it is, and how that was laid. */
  readonly source: number;
  readonly mirrored: boolean;
  readonly quarterTurns: number;
}

/** What the run is at. */
export interface Frame {
  readonly wire: WireShape;
  readonly iteration: number;
  readonly iterations: number;
  readonly loss: number;
}

/** A finished wire, or one from a link: what can be shown, measured and saved. */
export interface Finished {
  readonly wire: WireShape;
  readonly views: readonly View[];
  /** Empty for a wire from a link: the pictures are not in it. */
  readonly targets: readonly Target[];
  readonly measures: Measures;
}

/** Numbers about a wire: the `result` part of report.json, as far as the page shows it. */
export interface Measures {
  readonly views: readonly ViewMeasures[];
  readonly components: number;
  readonly length: number;
  readonly control_points: number;
}

export interface ViewMeasures {
  readonly name: string;
  /** Against the drawing as given; null where there is none to compare with. */
  readonly soft_iou: number | null;
  /** Against the drawing as it was bent. */
  readonly bent: { readonly soft_iou: number; readonly mean_px: number } | null;
}

/** A row of the core's settings table. */
export interface SettingRow {
  readonly name: string;
  readonly group: string;
  readonly unit: string;
  readonly help: string;
  readonly kind: "integer" | "number" | "choice" | "switch";
  readonly min?: number;
  readonly max?: number;
  readonly choices?: readonly string[];
}

/** Settings that differ from their preset, by name, as text. */
export type SettingValues = Readonly<Record<string, string>>;

export type ExportFormat = "glb" | "wire.json";

/** What the page can ask for: arguments and answer by name. */
export interface Calls {
  settings: { arguments: Record<never, never>; answer: readonly SettingRow[] };
  /** What the core sees in a picture. */
  read: { arguments: { picture: Picture; settings: SettingValues }; answer: Ink };
  /** Answered when the run has ended by itself or was stopped. */
  run: { arguments: { pictures: readonly Picture[]; settings: SettingValues }; answer: Finished };
  open: { arguments: { code: string }; answer: Finished };
  /** Of the last finished or opened wire. */
  export: { arguments: { format: ExportFormat }; answer: Uint8Array<ArrayBuffer> };
  share: { arguments: Record<never, never>; answer: string };
}

export type CallName = keyof Calls;
export type Request = { [K in CallName]: { id: number; call: K } & Calls[K]["arguments"] }[CallName];
/** Words to a run that is under way; they need no answer. `seen` asks for the next frame: none comes before it. */
export type Control = { control: "pause" | "resume" | "stop" | "seen" };

export type News =
  | { news: "progress"; words: string; share: number }
  | { news: "note"; words: string }
  | { news: "targets"; targets: readonly Target[] }
  | { news: "frame"; frame: Frame };
export type Answer = { id: number; answer: unknown } | { id: number; problem: string };
