/** What the core hands over as JSON. Written by `cargo xtask types` from the Rust types of the same names: change those. */

/** What a setting changes. */
export type Affects = "course" | "pictures" | "state" | "curve" | "styled-curve" | "look" | "styled-look";

/** What computes the fit. */
export type Backend = "auto" | "cpu" | "gpu";

/** How far the drawings may bend to agree with each other. */
export type Bend = "none" | "little" | "free";

/** What one choice of `bend` comes to. `None` where only the fit can tell. */
export type BendPreview = {
  /** The choice. */
  bend: Bend,
  /** Mean share of the bent ink that any object could show. */
  coverable: number | null,
  /** Mean soft IoU of the drawings as bent and as arranged, 0 to 1. */
  likeness: number | null,
  /** How far ink moves on average, pixels of 256. */
  movedPx: number | null,
};

/** How well one view matches its bent drawing, and how far bending moved the ink. */
export type BentReport = {
  /** As [`ViewReport::soft_iou`]. */
  soft_iou: number,
  /** As [`ViewReport::precision_2px`]. */
  precision_2px: number,
  /** As [`ViewReport::recall_2px`]. */
  recall_2px: number,
  /** How far ink moved on average, pixels at 256. */
  mean_px: number,
  /** How far ink moved at most, pixels at 256. */
  max_px: number,
};

/** A drawing as the fit will see it. */
export type DrawingPreview = {
  /** The view that shows it. */
  view: View,
  /** Which of the pictures given it is, from 0; `None` for a side that nobody gave a picture of. */
  source: number | null,
  /** Whether it is mirrored left to right. */
  mirrored: boolean,
  /** By how many quarters it is turned counter-clockwise after mirroring. */
  quarterTurns: number,
  /** Share of its ink that any object at all could show, 0 to 1. */
  coverable: number,
};

/** Something that happened before the iteration of that number. */
export type Event = {
  /** Iterations done before it. */
  iteration: number,
  /** What. */
  kind: EventKind,
  /** How many; see [`EventKind`]. */
  count: number,
};

/** What kind of thing happened. */
export type EventKind = "stage" | "restart" | "reinit" | "refine" | "respace" | "thin" | "undone" | "done" | "unguided";

/** Where a wire fails, world units: a place for every stretch that does. */
export type Faults = {
  /** Where it has kinks. */
  kinks: Array<[number, number, number]>,
  /** The tightest place of every stretch that is bent too tightly; kinks are among them. */
  tight: Array<[number, number, number]>,
  /** The deepest place of every stretch inside another strand, between the two; one for both. */
  penetrating: Array<[number, number, number]>,
};

/** Where a control is shown. */
export type Group = "run" | "wire" | "views" | "fit" | "stroke" | "surface" | "expert";

/** Where an engine computes. */
export type Place = {
  /** `cpu` or `gpu`. */
  backend: "cpu" | "gpu",
  /** The device's own name. */
  device: string,
  /** Why there, a sentence for people. */
  why: string,
};

/** How a picture was laid into a view. */
export type Placed = {
  /** The view that shows it. */
  view: View,
  /** Which of the pictures given it is, from 0; `None` for a side that nobody gave a picture of. */
  source: number | null,
  /** Whether it is mirrored left to right. */
  mirrored: boolean,
  /** By how many quarters it is turned counter-clockwise after mirroring. */
  quarterTurns: number,
  /** Share of its ink that any object at all could show, 0 to 1. */
  coverable: number,
};

/** What two or three drawings come to before a run. */
export type Preview = {
  /** One a drawing, in the order they were given. */
  drawings: Array<DrawingPreview>,
  /** Mean over the views of the share of ink that any object could show, 0 to 1, as arranged. */
  coverable: number,
  /** The same with every drawing where it was put, upright and not mirrored. */
  asGiven: number,
  /** What would help, best first. */
  remedies: Array<Remedy>,
  /** What each choice of `bend` comes to. */
  bends: Array<BendPreview>,
  /** [`Plan::notes`]. */
  notes: Array<string>,
};

export type ProjectionKind = "perspective" | "orthographic";

/** Something a person can do to the drawings with one click. */
export type Remedy = {
  /** What. */
  kind: RemedyKind,
  /** The drawings it moves: one to mirror or turn, two to swap, all to arrange. */
  sources: Array<number>,
  /** Counter-clockwise; 0 but for turns. */
  quarterTurns: number,
  /** Mean share of ink that any object could show, 0 to 1, after it. */
  coverable: number,
};

/** What a remedy does. */
export type RemedyKind = "arrange" | "mirror" | "turn" | "swap";

/** The `result` part: views, then the shape of the wire. */
export type ResultReport = {
  /** One entry a view. */
  views: Array<ViewReport>,
  /** Number of control points. */
  control_points: number,
  /** Length of the wire over that of the middle lines of all targets, as bent; `None` without targets. */
  length_over_lines: number | null,
  /** How the wire covers a surface, where that was asked for. */
  surface?: SurfaceReport | null,
  /** Arc length of the visible parts. A part is visible where its width in the widest view is a quarter of a pixel at
   * 256 px or more. */
  length: number,
  /** Visible parts, after joining those that touch (distance at most the sum of the radii). */
  components: number,
  /** Weight of the minimum spanning tree that joins the components by the nearest points of their centre lines. */
  connectivity_cost: number,
  /** Least width of the whole wire, visible or not. */
  min_width: number,
  /** Greatest width of the whole wire. */
  max_width: number,
  /** Least radius of curvature of the visible parts; `None` where nothing bends. */
  min_bend_radius: number | null,
  /** `∫ |C'''|² dt` over position and width, on the wire's own knots. */
  jerk: number,
  /** Mean curvature, radians a unit. */
  turning_per_unit: number,
  /** Places where the direction turns by more than 60 degrees within a gauge, at most one every two gauges. */
  kinks: number,
  /** Share of the length that is bent tighter than 1.5 gauges. */
  tight_share: number,
  /** Share of the length with another strand (more than 0.1 along the wire away) nearer than a gauge. */
  touching_share: number,
  /** Share of the length where another strand (more than six of its own diameters along the wire away) is nearer than
   * 0.9 of the sum of both radii. */
  penetrating_share: number,
};

/** One row of the table. */
export type Setting = {
  /** Snake case; the flag is the same with dashes. */
  name: string,
  /** Where it is shown. */
  group: Group,
  /** Unit for people, empty where there is none. */
  unit: string,
  /** One line of help. */
  help: string,
  /** What other values of it change. */
  affects: Array<Affects>, } & ({ "kind": "integer",
  /** Smallest value. */
  min: number,
  /** Largest value. */
  max: number, } | { "kind": "number",
  /** Smallest value. */
  min: number,
  /** Largest value. */
  max: number, } | { "kind": "choice",
  /** The words. */
  choices: Array<string>, } | { "kind": "switch" });

/** Figures of a wire on a surface. */
export type SurfaceReport = {
  /** Distance between neighbouring lines that was asked for, world units. */
  spacing: number,
  /** Area of the surface, square world units. */
  area: number,
  /** How many triangles it has. */
  triangles: number,
  /** Mean distance of the wire's centre line from the surface, world units. */
  drift_mean: number,
  /** The largest. */
  drift_max: number,
  /** From places spread evenly over the surface to the curve; a quarter is the ideal for parallel strands. */
  mean: number,
  /** The median of these. */
  median: number,
  /** 99 of 100 places are nearer than this. */
  p99: number,
  /** The farthest place. */
  worst: number,
  /** Area of the mesh over length of the curve, over the spacing; 1 if the curve is as long as it should be. */
  spacing_ratio: number,
  /** Length of the curve, world units. */
  length_world: number,
  /** Share of the curve's length by its distance to the nearest other strand: bin `k` from `k / 10` to `(k + 1) / 10`,
   * the last from 2 on. */
  strands: Array<number>,
  /** Share of the length that is nearer than half a spacing to another strand. */
  crowded: number,
  /** Pairs of segments that cross on the same side of the surface. */
  crossings: number,
};

/** A named view: where from, where to, which way is up, and the picture's size.
 *
 * Serialises as wire.json's `views` and is checked ([`View::check`]) when read.
 *
 * ```
 * use wire4d_core::view::View;
 *
 * let [front, side, top] = View::canonical(2.2, 256);
 * assert_eq!(side.eye.map(f64::round), [3.0, 0.0, 0.0], "the side is seen from +x");
 * assert_eq!((front.width_px, top.name.as_str()), (256, "top"));
 * ``` */
export type View = { name: string, projection: ProjectionKind, eye: [number, number, number], target: [number, number, number], up: [number, number, number], fov_y_rad?: number, height_world?: number, width_px: number, height_px: number,
};

/** How well one view matches its drawing, arranged but not bent. `null` where there is no drawing to compare with. */
export type ViewReport = {
  /** Name of the view. */
  name: string,
  /** Σ min / Σ max of rendering and target at the target's size. */
  soft_iou: number | null,
  /** Peak signal-to-noise ratio at the target's size. */
  psnr_db: number | null,
  /** Share of rendered ink within 2 px of target ink, at 256 px. */
  precision_2px: number | null,
  /** Share of target ink within 2 px of rendered ink, at 256 px. */
  recall_2px: number | null,
  /** Share of the target's ink that any object could show together with the other views. */
  target_coverable: number | null,
  /** The same against the bent target, where it was bent. */
  bent: BentReport | null,
  /** By which factor the drawing was stretched to fit the box, 1 for not at all. */
  stretch: number,
};
