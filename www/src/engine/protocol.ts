/** The messages between page and worker. Each request gets exactly one answer; a run also sends news on its way. */

import type { WireShape } from "#sculpture/scene/shape";
import type { View } from "#sculpture/scene/view";
import type { Answers, Kind } from "../guidance/contract";
import type { Facts } from "../guidance/model";
import type { Provider } from "../guidance/runtime";
import type { Opened, Question, Source } from "../guidance/service";
import type { Kept } from "../guidance/shelf";
import type * as core from "./generated/core";

export type { View };
export type { Affects } from "./generated/core";

/** What the core says, which nobody writes to. */
type Said<T> = { readonly [K in keyof T]: Said<T[K]> };

/** Straight (not premultiplied) RGBA, row by row from the top left. */
export interface Pixels {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
  /** It comes from values of 16 bits: as a depth picture it may tell distances. */
  readonly measured?: boolean;
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

/** How a drawing was laid into a view. */
export type Placed = Said<core.Placed>;

/** A view and the ink it should show. */
export interface Target extends Placed, Ink {}

/** What a person should know before a run. */
export interface Preview extends Omit<Said<core.Preview>, "drawings"> {
  /** One a drawing, in the order they were given. */
  readonly drawings: readonly DrawingPreview[];
}

/** A drawing as the optimiser will see it: lines thickened, laid back upright onto the drawing as given. */
export interface DrawingPreview extends Said<core.DrawingPreview> {
  readonly seen: Ink;
  /** The part of `seen` that no object can show together with the other drawings; same size. */
  readonly missing: Ink;
}

/** Something a person can do to the drawings with one click. */
export type Remedy = Said<core.Remedy>;

export type BendPreview = Said<core.BendPreview>;

/** Words of the setting that says where to compute. */
export const BACKENDS = ["auto", "cpu", "gpu"] as const satisfies readonly core.Backend[];
export type Backend = core.Backend;

/** Where a fit is computed. */
export interface Place extends Said<core.Place> {
  /** How many workers compute, where that is more than one. */
  readonly workers?: number;
}

/** What the run is at. */
export interface Frame {
  readonly wire: WireShape;
  readonly iteration: number;
  readonly iterations: number;
  readonly loss: number;
  /** Over the last second or so; 0 before that is known. */
  readonly iterationsPerSecond: number;
}

/** Something that happened before the iteration of that number. */
export type RunEvent = Said<core.Event>;

/** A point of the run to look back at, and to go on from. */
export interface Snapshot {
  readonly iteration: number;
  readonly iterations: number;
  readonly loss: number;
  readonly wire: WireShape;
  /** The run's whole state: the worker's own format. A blob, since it is large and only ever handed on. */
  readonly checkpoint: Blob;
}

/** A run at one moment, taken apart. */
export interface Insight {
  /** Iterations done. */
  readonly iteration: number;
  /** The wire whose control points are pulled. */
  readonly wire: WireShape;
  /** What pulls: a term for each view, in the views' order, then those that are about the wire. */
  readonly pulls: readonly TermPull[];
  /** By view, finest scale first. */
  readonly views: readonly (readonly LossLevel[])[];
}

/** A term of the loss. */
export interface TermPull {
  /** The view's, or the core's word for the term. */
  readonly name: string;
  readonly ofView: boolean;
  /** Weighted. */
  readonly loss: number;
  /** x, y, z, width for each control point: the wire is pulled the other way. */
  readonly gradient: Float32Array;
}

/** A view at one scale of the loss. */
export interface LossLevel {
  readonly loss: number;
  readonly seen: Ink;
  readonly wanted: Ink;
}

/** A finished wire, or one from a link or file: what can be shown, measured and saved. */
export interface Finished {
  readonly wire: WireShape;
  readonly views: readonly View[];
  /** As bent, where they were; empty for a wire from a link: the pictures are not in it. */
  readonly targets: readonly Target[];
  /** What each view shows of it as the fit sees it, where a surface hides what is behind; else empty. */
  readonly shown: readonly Ink[];
  readonly measures: Measures;
  /** Not with wires that were kept before there were any. */
  readonly faults?: Faults;
  /** The wire.json: exports start from it. */
  readonly file: Uint8Array<ArrayBuffer>;
  /** The share code. */
  readonly code: string;
  /** What could not be read of the file that it comes from, sentences. */
  readonly notes?: readonly string[];
}

/** Where a wire fails, world units: a place for every stretch that does. */
export type Faults = Pick<Said<core.Faults>, "tight" | "penetrating">;

type Result = Said<core.ResultReport>;
/** What was not always measured: wires that were kept before may lack it. */
type Later = "turning_per_unit" | "kinks" | "tight_share" | "touching_share" | "penetrating_share" | "length_over_lines";

/** Numbers about a wire: the `result` part of report.json, as far as the page shows it. */
export interface Measures
  extends Pick<Result, "components" | "connectivity_cost" | "length" | "control_points" | "min_width" | "max_width">,
    Partial<Pick<Result, Later>> {
  readonly views: readonly ViewMeasures[];
  /** Of a wire that covers a shape. */
  readonly surface?: SurfaceMeasures | null;
}

/** How evenly a wire covers a shape. */
export type SurfaceMeasures = Pick<
  Said<core.SurfaceReport>,
  "spacing" | "mean" | "p99" | "worst" | "drift_mean" | "drift_max" | "strands" | "crowded"
>;

export interface ViewMeasures extends Pick<Said<core.ViewReport>, "name" | "soft_iou" | "precision_2px" | "recall_2px" | "target_coverable"> {
  /** Against the drawing as it was bent. */
  readonly bent: Pick<Said<core.BentReport>, "soft_iou" | "precision_2px" | "recall_2px" | "mean_px"> | null;
}

/** A row of the core's settings table. */
export interface SettingRow extends Pick<Said<core.Setting>, keyof core.Setting> {
  /** Of numbers. */
  readonly min?: number;
  readonly max?: number;
  readonly choices?: readonly string[];
}

/** The core's settings: the table, and each preset's value for every row, as text. */
export interface SettingsTable {
  readonly rows: readonly SettingRow[];
  readonly presets: Readonly<Record<string, SettingValues>>;
}

/** Each task, by its name, has rows of its own and presets of its own. */
export type SettingsTables = Readonly<Record<string, SettingsTable>>;

/** Settings by name, as text; in a request, those that differ from their preset. */
export type SettingValues = Readonly<Record<string, string>>;

export type ExportFormat = "glb" | "stl" | "obj" | "svg" | "lines.svg" | "wire.json" | "bend.csv";

/** One thing done to a wire by hand; control points are counted from 0. */
export type WireEdit =
  | { readonly kind: "move"; readonly index: number; readonly to: readonly [x: number, y: number, z: number, width: number] }
  | { readonly kind: "insert"; readonly after: number }
  | { readonly kind: "remove"; readonly index: number }
  | { readonly kind: "smooth" | "straighten"; readonly from: number; readonly to: number };

export interface EditedFile {
  readonly file: Uint8Array<ArrayBuffer>;
  /** The control point that a hand would hold now. */
  readonly held: number;
  /** How far the curve may have moved though nobody moved it, world units. */
  readonly strayed: number;
}

/** A wire.json to be made simpler, for a share code of at most so many characters. */
export interface SimplifyArguments {
  readonly file: Uint8Array;
  readonly characters: number;
}

/** A code that shows nearly the same wire, and how far that is off in pixels of a view of 512 px: at most, and in the mean. */
export interface Simplified {
  readonly code: string;
  readonly most_px: number;
  readonly mean_px: number;
}

export interface ExportArguments {
  readonly file: Uint8Array<ArrayBuffer>;
  readonly format: ExportFormat;
  readonly view: string;
}

/** Of a guide: the small networks that come with the page, and its small diffusion model. */
export const ICONS = "icons";
export const DENOISER = "denoiser";
/** What words weigh where nobody says. */
export const USUAL_WEIGHT = 0.3;

/** Words that guide a run beside its pictures. */
export interface Guide {
  /** By the view's name; a view without is not guided. */
  readonly words: Readonly<Record<string, string>>;
  /** Against the pictures' own loss, from 0. */
  readonly weight: number;
  /** Whose idea of the words counts: `ICONS`, `DENOISER`, or the sha256 of a file of one. */
  readonly by: string;
  /** Whether a network of one's own looks at whole views, as where nothing is said, or at patches of them. */
  readonly look?: "views" | "patches";
  /** Whether views beside the first one are to be like its picture, where they have no words. */
  readonly likePicture?: boolean;
  /** What patches are to differ from as from words to words: words that say nothing; without, they become like the view's own. */
  readonly neutral?: string;
}

/** What the page can ask for: arguments and answer by name. A task adds its own, in its folder. */
export interface Calls {
  /** Of these tasks. */
  settings: { arguments: { tasks: readonly string[] }; answer: SettingsTables };
  /** Where a run with this setting would be computed; refused with a sentence if that cannot be. May take a second or two. */
  place: { arguments: { backend: Backend }; answer: Place };
  /** Answered when the run has ended by itself or was stopped. `work` is as the task's engine takes it, `from` a checkpoint of a run of the same, `first` that one's first wire. */
  run: { arguments: { task: string; work: unknown; settings: SettingValues; from: Blob | null; first: WireShape | null; guide: Guide | null }; answer: Finished };
  /** The run under way, taken apart as soon as it lets itself be asked; null where there is none, or is none by then. It changes no bit of it. */
  insight: { arguments: object; answer: Insight | null };
  /** The ink of a drawing of our own, dark on white. Aside, since to read pixels is to wait for a busy graphics card. */
  sheet: { arguments: { drawing: Blob }; answer: Ink };
  /** The wire of a share code, read without the core: no measures, and at once. */
  peek: { arguments: { code: string }; answer: { wire: WireShape; views: readonly View[] } };
  /** A share code, or the bytes of a file that carries a wire, with its name. */
  open: { arguments: { code: string } | { file: Uint8Array<ArrayBuffer>; name: string }; answer: Finished };
  /** A wire.json in another format; `view` is the name of the view an SVG draws. */
  export: { arguments: ExportArguments; answer: Uint8Array<ArrayBuffer> };
  /** A PNG picture that carries the wire of a wire.json, with all that this has. */
  carry: { arguments: { picture: Uint8Array<ArrayBuffer>; file: Uint8Array<ArrayBuffer> }; answer: Uint8Array<ArrayBuffer> };
  /** `null` where nothing like the wire is as short. */
  simplify: { arguments: SimplifyArguments; answer: Simplified | null };
  /** A wire.json after an edit by hand. Refused with a sentence where that cannot be. */
  edit: { arguments: { file: Uint8Array<ArrayBuffer>; edit: WireEdit }; answer: EditedFile };
  /** What a network from elsewhere is, before anything of it is used. */
  lookAtGuidance: { arguments: { from: Source }; answer: Facts };
  /**
   * Opens it, in place of the one of its kind that is open, and at once if it is that one; it tells how far that is, and keeps
   * the files if asked to.
   */
  openGuidance: { arguments: { from: Source; prefer: Provider; keep: boolean }; answer: Opened };
  /** Asks an open network. */
  askGuidance: { arguments: { question: Question }; answer: Answers[Kind] };
  /** Closes all that are open, and gives up what is being opened: that call then fails. */
  closeGuidance: { arguments: object; answer: void };
  /** What this browser keeps, newest first, after the one with that checksum was dropped. */
  guidanceShelf: { arguments: { drop: string | null }; answer: Kept[] };
}

export type CallName = keyof Calls;
export type Request = { [K in CallName]: { id: number; call: K } & Calls[K]["arguments"] }[CallName];
/**
 * Words to a run that is under way; they need no answer. `step` does one iteration and pauses. `seen` asks for the next
 * frame: none comes before it.
 */
export type Control = { control: "pause" | "resume" | "step" | "stop" | "seen" };

export type News =
  | { news: "progress"; words: string; share: number }
  | { news: "note"; words: string }
  /** What a person should know of a run even when it is over. */
  | { news: "notice"; words: string }
  /** Of what is asked before a run, and takes a while. */
  | { news: "share"; share: number }
  /** The page's own: the worker was ended, and nothing is open in the next one. */
  | { news: "fresh" }
  /** Of a network that is being opened. */
  | { news: "guidance"; words: string; share: number }
  /** When a run starts, and when it changes on the way. */
  | { news: "place"; place: Place }
  | { news: "targets"; targets: readonly Target[] }
  | { news: "frame"; frame: Frame }
  | { news: "event"; event: RunEvent }
  | { news: "snapshot"; snapshot: Snapshot };
export type Answer = { id: number; answer: unknown } | { id: number; problem: string };
