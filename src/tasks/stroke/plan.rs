//! What is decided before a fit: the object, the solid behind it, and the lines that show it.

use super::depth::nearness;
use super::drawn::{self, Found, Kept};
use super::given::Given;
use super::sides::{other_sides, side_views};
use crate::optimize::{Problem, Refine, Schedule, Seen, TopologyEdit};
use crate::picture::{Attention, Ink, OBJECT_PX, Object, ObjectFinder, Photo, Picture};
use crate::settings::{Preset, Read, Settings, Shade, Shading, Start, Task, Width};
use crate::start::{self, Layers, LineOptions, Lines, Solid, SolidOptions};
use crate::tasks::recipe::{at_once, recipe};
use crate::tasks::widths::width_bounds;
use crate::tasks::{self, photo};
use crate::view::{Image, Target, View};
use crate::wire::Wire;
use crate::{Error, Result};

/// The object, its solid and what the wire should show, before anything is fitted.
#[derive(Debug, Clone)]
pub struct Plan {
    pub(super) settings: Settings,
    /// The object as it was found, of the picture's own aspect.
    pub object: Object,
    /// How likely that is what a person would point at, 0 to 1; below [`SURE`](crate::picture::cut::SURE) better ask.
    pub sure: f32,
    /// The solid behind it.
    pub solid: Solid,
    /// What the report compares with: the front's ink, then the solid's silhouette from each side.
    pub targets: Vec<Target>,
    /// Names of the pictures as given: the front's, then the other sides'.
    pub(super) sources: Vec<String>,
    /// The object's lines.
    pub(super) lines: Lines,
    /// The first wire, once a fit has begun.
    first: Option<Wire>,
    notes: Vec<String>,
}

/// Margin round the object in its picture, as a share of the picture's side.
const MARGIN: f64 = 0.08;
/// How round the solid under a photograph's lines is, times the setting: lines that lie on a whole ball leave their places
/// when it is turned, and a face can no longer be told.
const DRAWN_ROUNDNESS: f64 = 0.7;
/// Path between two control points where their number is given, px at 256: fewer points, sparser lines.
const PATH_PER_POINT_PX: f64 = 12.0;
/// Sparsest and densest lines tried for a given number of control points, px at 256.
const HATCHES: [f64; 2] = [4.0, 96.0];

/// Finds the object, its solid and the targets.
///
/// # Errors
/// As [`find_object`](crate::picture::find_object) for each picture, and as [`Cutter::cut`](crate::picture::cut::Cutter::cut)
/// for one with a box or strokes; [`Error::Picture`] for a depth picture of another size; [`Error::Pictures`] if the
/// sides contradict each other.
pub fn plan(given: &Given, settings: &Settings) -> Result<Plan> {
    plan_with(given, settings, &mut Kept::default())
}

/// [`plan`] with what is known of the picture from before, which only saves time.
///
/// # Errors
/// As there.
pub fn plan_with(given: &Given, settings: &Settings, kept: &mut Kept) -> Result<Plan> {
    Task::Stroke.check(settings)?;
    let name = given.picture.name();
    let Found { object, is_drawn, sure, unseen } = drawn::find_with(given, settings, kept)?;
    let mut notes = object.notes.clone();
    if is_drawn && settings.read == Read::Auto {
        notes.push(format!("{name}: it is taken for a photograph, so the lines of its object are drawn"));
    }
    // Depth belongs to the whole picture, and a box of which all is drawn is looked at as it is.
    let is_closer = is_drawn && given.depth.is_none() && unseen.is_none();
    let closer = is_closer.then(|| photo::closer(&given.picture, &object.mask)).flatten();
    let near = closer.map(|(picture, mask)| Near::new(picture, &mask)).transpose()?;
    let seen = near.as_ref().map_or(&object, |near| &near.object);
    let Some(part) = seen.mask.threshold(0.5).bounding_box() else {
        return Err(Error::picture(name, "shows no object", "use a picture with a larger object, or paint a mask"));
    };
    let margin_px = MARGIN * OBJECT_PX as f64;
    let laid = |image: &Image| image.letterboxed(part, OBJECT_PX, OBJECT_PX, margin_px, false);
    let (mask, body, tone) = (laid(&seen.mask), laid(&seen.body), laid(&seen.tone));

    let draws_lines = is_drawn && settings.shade != Shade::Full;
    let roundness = if draws_lines { DRAWN_ROUNDNESS * settings.roundness } else { settings.roundness };
    let options = SolidOptions { roundness, most_depth: settings.most_depth };
    let mut solid = Solid::inflated(name, &body, &options)?;
    let height_px = body.threshold(0.5).bounding_box().map_or(OBJECT_PX, |part| part.height());
    let others = other_sides(given, height_px, solid.height_world(), &mut notes)?;
    if !others.is_empty() {
        solid = solid.carved(&others)?;
    }
    if let Some(depth) = &given.depth {
        solid = solid.with_depth(&laid(&nearness(depth, &given.picture, &object, &mut notes)?));
    }
    if settings.relief > 0.0 {
        let lightness = Image { data: tone.data.iter().map(|tone| 1.0 - tone).collect(), ..tone };
        solid = solid.with_relief(&lightness, settings.relief);
    }

    let lines = if draws_lines {
        let closer = near.as_ref().map(|near| Photo::of(&near.picture));
        let photo = closer.as_ref().unwrap_or_else(|| kept.photo(&given.picture));
        let strokes = drawn::strokes(photo, seen, unseen, margin_px, settings)?;
        let lines = Lines::of_strokes(&mask, &tone, &strokes, &line_options(settings.hatch, settings));
        // A wire of one width has no thin lines.
        let share = if settings.width == Width::Constant { 0.0 } else { settings.sections };
        lines.with_sections(&solid, share)
    } else {
        let finder = near.as_ref().map_or_else(|| kept.finder(&given.picture), |near| &near.finder);
        let Attention { saliency, highlight } = finder.attention(&seen.mask);
        let all_seen = body != mask;
        let layers = Layers { mask, tone, saliency: laid(&saliency), highlight: laid(&highlight), all_seen };
        lines(&layers, &solid, settings)
    };
    let front = View::orthographic("front", 0.0, 0.0, solid.height_world(), settings.size);
    let ink = match settings.shading {
        Shading::Lines => lines.ink(settings.size),
        Shading::Grey => lines.grey(settings.size),
    };
    let mut targets = vec![Target { view: front, ink }];
    let given_sides = others.into_iter().map(|(view, _)| view);
    for view in given_sides.chain(side_views(0, settings)) {
        let view = View::with_size(&view, settings.size, settings.size);
        targets.push(Target { ink: solid.silhouette(&view), view });
    }
    let names = std::iter::once(&given.picture).chain(given.others.iter().map(|other| &other.0));
    let sources = names.map(|picture| picture.name().to_owned()).collect();
    Ok(Plan { settings: settings.clone(), object, sure, solid, targets, sources, lines, first: None, notes })
}

/// A small object of a photograph, looked at from nearer.
struct Near {
    picture: Picture,
    finder: ObjectFinder,
    object: Object,
}

impl Near {
    fn new(picture: Picture, mask: &Image) -> Result<Near> {
        let finder = ObjectFinder::new(&picture);
        Ok(Near { object: finder.object(Some(mask), 1)?, finder, picture })
    }
}

fn line_options(spacing_px: f64, settings: &Settings) -> LineOptions {
    LineOptions {
        hatching: settings.hatching.into(),
        spacing_px,
        outline_px: settings.outline,
        edges: settings.edges,
        tone: settings.tone,
        saliency: settings.saliency,
        gloss: settings.gloss,
        width_px: [settings.min_width, settings.max_width],
    }
}

/// The object's lines: as close as the settings say, or as close as the number of control points allows.
fn lines(layers: &Layers, solid: &Solid, settings: &Settings) -> Lines {
    let draw = |spacing_px: f64| Lines::draw(layers, &line_options(spacing_px, settings));
    if settings.control_points == 0 || settings.start != Start::Contour {
        return draw(settings.hatch);
    }
    let most = settings.control_points as f64 * PATH_PER_POINT_PX * solid.height_world() / 256.0;
    let [mut dense, mut sparse] = HATCHES;
    for _ in 0..5 {
        let middle = (dense * sparse).sqrt();
        if start::length(&draw(middle).walk(solid, 0.0)) > most { dense = middle } else { sparse = middle }
    }
    draw(sparse)
}

/// Weight of bending: the first wire lies along the lines already.
const BENDING: f64 = 4.0;

impl Plan {
    /// What a person should know before the run, in plain words.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// World units in one pixel of a 256 px picture of the front.
    pub(super) fn world_per_px_256(&self) -> f64 {
        self.solid.height_world() / 256.0
    }

    /// The fit of `wire` from iteration `iteration` on; `first` is the first wire.
    fn problem(&self, wire: Wire, first: &Wire, iteration: usize) -> Problem {
        let settings = &self.settings;
        let px = self.world_per_px_256();
        let sides = &self.targets[1..];
        let side_weight = settings.side_weight / sides.len().max(1) as f64;
        let mut recipe = recipe(settings);
        if let Some(smooth) = &mut recipe.smooth {
            smooth.bending = Schedule::Constant(BENDING * settings.smoothness);
            smooth.tightness = at_once(&smooth.tightness);
            smooth.clearance = at_once(&smooth.clearance);
        }
        if settings.preset == Preset::Paper {
            for event in &mut recipe.topology {
                if let TopologyEdit::Refine(refine) = &mut event.edit {
                    *refine = Refine { share: 5.0 / 6.0, ..refine.clone() };
                }
            }
        }
        Problem {
            view_weights: std::iter::once(1.0).chain(sides.iter().map(|_| side_weight)).collect(),
            width: width_bounds(&self.targets[..1], px, settings),
            seed: settings.seed,
            ..Problem::for_drawings(wire, self.fitted(first, iteration), recipe)
        }
    }
}

impl tasks::Plan for Plan {
    fn task(&self) -> Task {
        Task::Stroke
    }

    fn settings(&self) -> &Settings {
        &self.settings
    }

    fn targets(&self) -> &[Target] {
        &self.targets
    }

    fn begin(&mut self, from: Option<(Wire, usize)>, _: &mut dyn FnMut(f32) -> bool) -> Result<Problem> {
        let first = self.first_wire()?;
        let (wire, iteration) = from.unwrap_or_else(|| (first.clone(), 0));
        let problem = self.problem(wire, &first, iteration);
        self.first = Some(first);
        Ok(problem)
    }

    fn sources(&self) -> &[String] {
        &self.sources
    }

    fn change_views_every(&self) -> usize {
        self.settings.new_sides
    }

    fn views_from(&self, iterations: &[usize]) -> Vec<Seen> {
        let fitted = |&iteration| {
            let first = self.first.as_ref();
            let targets = first.map_or_else(|| self.targets.clone(), |first| self.fitted(first, iteration));
            Seen { targets, ..Seen::default() }
        };
        iterations.iter().map(fitted).collect()
    }
}
