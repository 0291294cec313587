//! Every setting there is, once: name, group, unit, range, default, the tasks that have it, what it affects, and one line of
//! help.

use super::Task;
use super::schema::{Affects, Group, Kind, Of, Setting};
use super::words::*;
use crate::wire::Form;
use serde::{Deserialize, Serialize};

macro_rules! settings {
    ($($group:ident $(#[doc = $help:literal])+ $(#[serde($serde:meta)])? $name:ident: $type:ty = $default:expr, $unit:literal, $kind:expr, $of:expr, $affects:expr;)*) => {
        /// Values for every row of [`TABLE`]. `Default` is the preset `best`.
        #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
        #[serde(deny_unknown_fields, default)]
        pub struct Settings {
            $($(#[doc = $help])+ $(#[serde($serde)])? pub $name: $type,)*
        }
        impl Default for Settings {
            fn default() -> Self {
                Settings { $($name: $default,)* }
            }
        }
        /// Every setting in the order people should see them.
        pub const TABLE: &[Setting] = &[$(Setting {
            name: stringify!($name),
            group: Group::$group,
            unit: $unit,
            help: concat!($($help),+).trim_ascii_start(),
            kind: $kind,
            of: $of,
            affects: $affects,
        }),*];
    };
}

use Affects::{Course, Curve, Look, Pictures, State, StyledCurve, StyledLook};
use Kind::{Choice, Integer, Number, Switch};

const fn any(task: Task) -> Of {
    Of { task, choices: None }
}

const fn only(task: Task, choices: &'static [&'static str]) -> Of {
    Of { task, choices: Some(choices) }
}

const EVERY: &[Of] = &{
    let mut every = [any(Task::ALL[0]); Task::ALL.len()];
    let mut i = 1;
    while i < every.len() {
        every[i].task = Task::ALL[i];
        i += 1;
    }
    every
};
const VIEWS: &[Of] = &[any(Task::Multiview)];
const PICTURE: &[Of] = &[any(Task::Stroke)];
const MESH: &[Of] = &[any(Task::Fill)];
/// A curve that covers a mesh chooses its own points.
const NO_MESH: &[Of] = &[any(Task::Multiview), any(Task::Stroke)];
const STARTS: &[Of] = &[
    only(Task::Multiview, &["circuit", "tree", "hull", "ball"]),
    only(Task::Stroke, &["contour", "hull", "ball"]),
    only(Task::Fill, &["stripes", "tour"]),
];
const READ: &[Of] = &[only(Task::Multiview, &["auto", "ink", "lines"]), only(Task::Stroke, &["auto", "lines", "tone"])];
/// Where there is nothing to agree with, only that can be said.
const ARRANGED: &[Of] = &[any(Task::Multiview), only(Task::Stroke, &["off"]), only(Task::Fill, &["off"])];
const BENT: &[Of] = &[any(Task::Multiview), only(Task::Stroke, &["none"]), only(Task::Fill, &["none"])];

settings! {
    Run /// A bundle of defaults: best, fast or the paper's.
    preset: Preset = Preset::Best, "", Choice { choices: Preset::WORDS }, EVERY, &[Course];
    Run /// The same seed and pictures give the same wire.
    seed: u64 = 0, "", Integer { min: 0, max: 9_007_199_254_740_991 }, EVERY, &[Pictures, Curve];
    Run /// What computes the fit.
    backend: Backend = Backend::Auto, "", Choice { choices: Backend::WORDS }, EVERY, &[Course];
    Run /// How many steps the fit takes in all.
    iterations: usize = 900, "steps", Integer { min: 1, max: 100_000 }, EVERY, &[Course];
    Run /// Side of the square pictures the wire is fitted to.
    size: usize = 256, "px", Integer { min: 32, max: 2048 }, EVERY, &[Pictures];

    Wire /// One spline, a chain of Béziers with corners, or loose Béziers (the last two to compare with).
    #[serde(with = "form_word")]
    form: Form = Form::Spline, "", Choice { choices: FORMS }, EVERY, &[State];
    Wire /// Keep the wire a wire: soft bends, nowhere through itself; off follows every line of the pictures.
    smooth: OnOff = OnOff::On, "", Choice { choices: OnOff::WORDS }, EVERY, &[Course];
    Wire /// The least bend radius while fitting, where the wire is kept smooth.
    bend_radius: f64 = 1.5, "diameters", Number { min: 0.0, max: 20.0 }, EVERY, &[Course];
    Wire /// Thicker and thinner as the pictures ask, or the same width everywhere.
    width: Width = Width::Varying, "", Choice { choices: Width::WORDS }, EVERY, &[Course];
    Wire /// Control points of the first wire; 0 lets the start choose.
    control_points: usize = 0, "points", Integer { min: 0, max: 20_000 }, EVERY, &[Pictures];
    Wire /// Distance between control points where the start chooses their number.
    spacing: f64 = 5.0, "px at 256", Number { min: 0.5, max: 64.0 }, NO_MESH, &[Course];
    Wire /// Make the first wire shorter: cross over inside strokes instead of walking branches there and back.
    shorter: bool = false, "", Switch, VIEWS, &[Course];
    Wire /// Thinnest the wire may get, as seen in a picture of 256 px.
    min_width: f64 = 1.5, "px at 256", Number { min: 0.0, max: 64.0 }, EVERY, &[Pictures];
    Wire /// Thickest the wire may get, as seen in a picture of 256 px.
    max_width: f64 = 8.0, "px at 256", Number { min: 0.1, max: 128.0 }, EVERY, &[Pictures];

    Views /// Try which drawing goes where, mirrored or turned, and keep what agrees best.
    arrange: OnOff = OnOff::On, "", Choice { choices: OnOff::WORDS }, ARRANGED, &[Pictures];
    Views /// Drawings may change places while arranging.
    may_swap: bool = true, "", Switch, VIEWS, &[Pictures];
    Views /// Drawings may be mirrored while arranging.
    may_mirror: bool = true, "", Switch, VIEWS, &[Pictures];
    Views /// Which views may be turned by quarters while arranging.
    may_turn: Turn = Turn::Top, "", Choice { choices: Turn::WORDS }, VIEWS, &[Pictures];
    Views /// How far the drawings may bend to agree with each other.
    bend: Bend = Bend::Little, "", Choice { choices: Bend::WORDS }, BENT, &[State];
    Views /// What of a picture is drawn: a drawing's ink, a photograph's lines, or shades; auto tells them apart.
    read: Read = Read::Auto, "", Choice { choices: Read::WORDS }, READ, &[Pictures];
    Views /// How many lines of a photograph are drawn; 0 takes all that say something.
    lines: usize = 0, "lines", Integer { min: 0, max: 200 }, NO_MESH, &[Pictures];
    Views /// What is ink in the pictures.
    ink: Ink = Ink::Auto, "", Choice { choices: Ink::WORDS }, VIEWS, &[Course];
    Views /// Lines thinner than this are thickened to it before the fit; 0 leaves them alone.
    min_stroke: f64 = 4.0, "px at 256", Number { min: 0.0, max: 32.0 }, VIEWS, &[Pictures];
    Views /// The most a drawing may be stretched so that views agree along shared axes.
    max_stretch: f64 = 1.35, "times", Number { min: 1.0, max: 4.0 }, VIEWS, &[Pictures];

    Fit /// Where the first wire comes from.
    start: Start = Start::Circuit, "", Choice { choices: Start::WORDS }, STARTS, &[Course, Curve];
    Fit /// Move control points whose width has vanished to where they are needed.
    reinit: bool = false, "", Switch, EVERY, &[Course];
    Fit /// Add control points where the pictures pull hardest.
    refine: bool = false, "", Switch, EVERY, &[Course];
    Fit /// How calm the wire is: weight of its bending, or of the jerk of positions where it is not kept smooth.
    smoothness: f64 = 1.0, "times", Number { min: 0.0, max: 1000.0 }, EVERY, &[Course];

    Stroke /// Which of several objects, the largest first.
    object: usize = 1, "", Integer { min: 1, max: 999 }, PICTURE, &[Pictures];
    Stroke /// How much of a photograph's tone its lines show: none, as an accent, or all of it.
    shade: Shade = Shade::Accent, "", Choice { choices: Shade::WORDS }, PICTURE, &[Pictures];
    Stroke /// What the front should show: lines as wide as the picture is dark, or its own greys.
    shading: Shading = Shading::Lines, "", Choice { choices: Shading::WORDS }, PICTURE, &[Pictures];
    Stroke /// Lines that fill run along the outline, or round the solid like slices; auto takes what suits its shape.
    hatching: Hatching = Hatching::Auto, "", Choice { choices: Hatching::WORDS }, PICTURE, &[Pictures];
    Stroke /// From line to line where areas are filled; wider is more abstract.
    hatch: f64 = 11.0, "px at 256", Number { min: 2.0, max: 128.0 }, PICTURE, &[Pictures];
    Stroke /// Width of the outline and of inner edges.
    outline: f64 = 3.0, "px at 256", Number { min: 0.5, max: 32.0 }, PICTURE, &[Pictures];
    Stroke /// How much more ink darker parts get: 0 none, 1 from hair lines to filled.
    tone: f64 = 1.0, "of 1", Number { min: 0.0, max: 1.0 }, PICTURE, &[Pictures];
    Stroke /// How readily inner edges are drawn: 0 not at all, 1 the clear ones, more the faint ones too.
    edges: f64 = 1.0, "times", Number { min: 0.0, max: 8.0 }, PICTURE, &[Pictures];
    Stroke /// How readily parts that catch the eye get closer and finer lines and the rest sparser ones: 0 not at all.
    saliency: f64 = 0.0, "of 1", Number { min: 0.0, max: 1.0 }, PICTURE, &[Pictures];
    Stroke /// Material: how readily highlights stay blank with a line round them; 0 is matte.
    gloss: f64 = 0.0, "of 1", Number { min: 0.0, max: 1.0 }, PICTURE, &[Pictures];
    Stroke /// Thickness of the solid: 1 makes a ball of a disc, 0 nearly a sheet; under a photograph's lines it is less.
    roundness: f64 = 0.9, "times", Number { min: 0.0, max: 2.0 }, PICTURE, &[Pictures];
    Stroke /// Largest half thickness, as a share of half the object's smaller side.
    most_depth: f64 = 1.0, "times", Number { min: 0.01, max: 4.0 }, PICTURE, &[Pictures];
    Stroke /// Thin lines round the body of a photographed object that show when it is turned: how long, of its lines.
    sections: f64 = 0.22, "of 1", Number { min: 0.0, max: 1.0 }, PICTURE, &[Pictures];
    Stroke /// How far light parts come forward and dark ones go back, as a share of the solid's thickness.
    relief: f64 = 0.0, "of 1", Number { min: 0.0, max: 1.0 }, PICTURE, &[Pictures];
    Stroke /// From how many more sides, drawn from the seed, the wire is held against the solid.
    side_views: usize = 6, "views", Integer { min: 0, max: 24 }, PICTURE, &[Pictures];
    Stroke /// After how many steps other sides are drawn; 0 keeps to those that are measured in the end.
    new_sides: usize = 50, "steps", Integer { min: 0, max: 100_000 }, PICTURE, &[Course];
    Stroke /// How strongly sides ask for a line where the solid's outline or a crease lies: 0 not at all.
    creases: f64 = 0.3, "of 1", Number { min: 0.0, max: 1.0 }, PICTURE, &[Course];
    Stroke /// Weight of all those sides together; the front's is 1.
    side_weight: f64 = 0.4, "times", Number { min: 0.0, max: 16.0 }, PICTURE, &[Course];

    Surface /// From line to line on the surface; the shape fits a ball of radius 1 world unit.
    curve_spacing: f64 = 0.06, "world units", Number { min: 0.02, max: 0.2 }, MESH, &[Course, Curve];
    Surface /// Which way the lines run: smooth, along the upright, across it, or along the style's strokes.
    flow: Flow = Flow::Style, "", Choice { choices: Flow::WORDS }, MESH, &[Course, Curve];
    Surface /// How much of the surface is ink.
    density: f64 = 0.5, "of 1", Number { min: 0.1, max: 1.0 }, MESH, &[Pictures, Look];
    Surface /// How strongly the style bends and thickens the wire: 0 not at all.
    style_strength: f64 = 0.6, "of 1", Number { min: 0.0, max: 1.0 }, MESH, &[Pictures, StyledLook];
    Surface /// Side of the style's picture on the surface, which fits a ball of radius 1 world unit.
    style_size: f64 = 1.2, "world units", Number { min: 0.1, max: 4.0 }, MESH, &[Pictures, StyledCurve, StyledLook];
    Surface /// How the style's picture is laid on the surface: box from six sides, front once; off only asks for its texture.
    motif: Motif = Motif::Box, "", Choice { choices: Motif::WORDS }, MESH, &[Pictures, StyledCurve, StyledLook];
    Surface /// Draw lines on the far side too.
    hidden_lines: bool = false, "", Switch, MESH, &[Course];
    Surface /// From where the wire is looked at: five sides a little turned each time, or anywhere.
    looks: Looks = Looks::Sides, "", Choice { choices: Looks::WORDS }, MESH, &[Course];
    Surface /// How many views each step looks through.
    views_at_once: usize = 1, "views", Integer { min: 1, max: 16 }, MESH, &[Pictures];
    Surface /// How far each look may turn from its side.
    jitter: f64 = 20.0, "degrees", Number { min: 0.0, max: 45.0 }, MESH, &[Course];
    Surface /// How suddenly a line vanishes behind the surface.
    visibility: f64 = 60.0, "a world unit", Number { min: 1.0, max: 1000.0 }, MESH, &[Course];
    Surface /// How far behind the surface a line is half seen.
    visibility_bias: f64 = 0.05, "world units", Number { min: 0.0, max: 0.5 }, MESH, &[Course];
    Surface /// How strongly the wire is held to the surface.
    surface_pull: f64 = 1.0, "times", Number { min: 0.0, max: 1000.0 }, MESH, &[Course];

    Expert /// How far the finished curve may move so that control points can go that it does without; 0 keeps them all.
    thin: f64 = 0.0, "px at 256", Number { min: 0.0, max: 8.0 }, EVERY, &[Course];
    Expert /// How strongly strands push each other away, where the wire is kept smooth.
    clearance: f64 = 1.0, "times", Number { min: 0.0, max: 1000.0 }, EVERY, &[Course];
    Expert /// How strongly bends that are too tight open, where the wire is kept smooth.
    tightness: f64 = 1.0, "times", Number { min: 0.0, max: 1000.0 }, EVERY, &[Course];
    Expert /// Step size for positions, in pixels of a 128 px picture.
    position_rate: f64 = 0.6, "px at 128", Number { min: 1e-4, max: 10.0 }, EVERY, &[Course];
    Expert /// Step size for widths, in pixels of a 128 px picture.
    width_rate: f64 = 0.075, "px at 128", Number { min: 0.0, max: 10.0 }, EVERY, &[Course];
    Expert /// How pictures are made coarser for the loss.
    pyramid: Pyramid = Pyramid::Average, "", Choice { choices: Pyramid::WORDS }, EVERY, &[Course];
    Expert /// Weight of each coarser level of the loss relative to the finer one, at the start.
    level_weight: f64 = 0.5, "times", Number { min: 0.0, max: 16.0 }, EVERY, &[Course];
    Expert /// Share of the iterations at half size, where each costs a quarter.
    coarse_share: f64 = 0.6, "of 1", Number { min: 0.0, max: 1.0 }, EVERY, &[Course];
    Expert /// Exact points on each span of the wire while fitting.
    samples: usize = 2, "a span", Integer { min: 1, max: 32 }, EVERY, &[Course];
    Expert /// Where re-initialised control points go.
    new_point: NewPoint = NewPoint::Lacking, "", Choice { choices: NewPoint::WORDS }, EVERY, &[Course];
    Expert /// Voxels along each side of the grid in which the first wire grows.
    grid: usize = 128, "voxels", Integer { min: 16, max: 160 }, VIEWS, &[Course];
}
