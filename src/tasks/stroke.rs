//! One picture to a wire that shows it from the front and still makes sense as it turns.
//!
//! [`plan`] finds the object, guesses the solid behind it and says what the wire should show from the front and from sides
//! drawn from the seed; [`Run::start`](super::Run::start) lays the first wire; the rest is as in [`super::multiview`].
//!
//! A wire is ink or blank, so a grey picture cannot be met: half the pixels of an even grey are wrong however it is
//! hatched, and the fit settles on strands that are nowhere. So the front's target is a picture of lines as wide as the
//! picture is dark ([`Lines`]). Nor can a wire fill a silhouette without spoiling the front, so each side's target is what
//! it shows of the same lines on the solid's surface, cut off at its silhouette. (A faint silhouette instead bends the
//! wire to and fro in depth: every strand then wants to hide behind another.) A start that knows no lines gets the faint
//! silhouette: inside it a blank pixel costs about as much as an inked one, while ink beside the solid costs the most.

use super::fit::{HAIRPIN_PX, at_once, recipe};
use super::widths::width_bounds;
use crate::optimize::{Problem, Refine, Schedule, Seen, TopologyEdit};
use crate::picture::{Ink, Mask, OBJECT_PX, Object, Picture, find_object};
use crate::rng::Rng;
use crate::sculpture::render_sampled;
use crate::settings::{OnOff, Preset, Settings, Shading, Start, Task};
use crate::start::{self, LineOptions, Lines, Solid, SolidOptions, Subject};
use crate::view::{Image, Target, View, ViewSpec};
use crate::wire::{Form, Wire, with_open_hairpins};
use crate::{Error, Result};

/// What a person gives.
#[derive(Debug, Clone)]
pub struct Given {
    /// The picture.
    pub picture: Picture,
    /// What of it is the object, 0 to 1, any size; `None` finds it.
    pub mask: Option<Image>,
    /// How near each of its pixels is, light is near; of the picture's size. `None` guesses.
    pub depth: Option<Picture>,
    /// The same object from other sides.
    pub others: Vec<(Picture, ViewSpec)>,
}

impl Given {
    /// One picture and nothing else.
    pub fn picture(picture: Picture) -> Given {
        Given { picture, mask: None, depth: None, others: Vec::new() }
    }
}

/// The object, its solid and what the wire should show, before anything is fitted.
#[derive(Debug, Clone)]
pub struct Plan {
    settings: Settings,
    /// The object as it was found, of the picture's own aspect.
    pub object: Object,
    /// The solid behind it.
    pub solid: Solid,
    /// What the report compares with: the front's ink, then the solid's silhouette from each side.
    pub targets: Vec<Target>,
    /// Names of the pictures as given: the front's, then the other sides'.
    sources: Vec<String>,
    /// The object's lines.
    lines: Lines,
    notes: Vec<String>,
}

/// Margin round the object in its picture, as a share of the picture's side.
const MARGIN: f64 = 0.08;
/// World height of the pictures of the sides: the unit ball with a margin.
const SIDE_HEIGHT_WORLD: f64 = 2.2;
/// Elevations from which sides are drawn, degrees.
const ELEVATIONS: [f64; 2] = [-10.0, 80.0];
/// Width of creases in the sides' targets, px at 256.
const CREASE_PX: f64 = 2.0;
/// Ink of the sides' targets where the solid is.
const SIDE_INK: f32 = 0.4;
/// Samples a knot span of the first wire in the sides' targets: its spans are a few pixels long.
const SIDE_SAMPLES: usize = 4;
/// Path between two control points where their number is given, px at 256: fewer points, sparser lines.
const PATH_PER_POINT_PX: f64 = 12.0;
/// Sparsest and densest lines tried for a given number of control points, px at 256.
const HATCHES: [f64; 2] = [4.0, 96.0];
/// Most control points of the first wire where the start chooses.
const MOST_FIRST_POINTS: f64 = 1800.0;
/// Width of the first wire on the solid's back and between lines, px at 256.
const THIN_PX: f64 = 1.4;
/// The paper's least number of control points.
const FEWEST_TOUR_POINTS: usize = 100;
/// Width of a tour's first wire, px at 256.
const TOUR_WIDTH_PX: f64 = 3.0;

/// Finds the object, its solid and the targets.
///
/// # Errors
/// As [`find_object`] for each picture; [`Error::Picture`] for a depth picture of another size; [`Error::Pictures`] if the
/// sides contradict each other.
pub fn plan(given: &Given, settings: &Settings) -> Result<Plan> {
    Task::Stroke.check(settings)?;
    let name = given.picture.name();
    let object = find_object(&given.picture, given.mask.as_ref(), settings.object)?;
    let mut notes = object.notes.clone();
    let Some(part) = object.mask.threshold(0.5).bounding_box() else {
        return Err(Error::picture(name, "shows no object", "use a picture with a larger object, or paint a mask"));
    };
    let margin_px = MARGIN * OBJECT_PX as f64;
    let laid = |image: &Image| image.letterboxed(part, OBJECT_PX, OBJECT_PX, margin_px, false);
    let (mask, body, tone) = (laid(&object.mask), laid(&object.body), laid(&object.tone));

    let options = SolidOptions { roundness: settings.roundness, most_depth: settings.most_depth };
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

    let (saliency, highlight) = (laid(&object.saliency), laid(&object.highlight));
    let all_seen = body != mask;
    let lines = lines(&Subject { mask, tone, saliency, highlight, all_seen }, &solid, settings);
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
    Ok(Plan { settings: settings.clone(), object, solid, targets, sources, lines, notes })
}

/// The silhouettes from other sides, as high as the front's, and the views they are seen from.
fn other_sides(
    given: &Given,
    height_px: usize,
    height_world: f64,
    notes: &mut Vec<String>,
) -> Result<Vec<(View, Image)>> {
    let each = given.others.iter().map(|(picture, seen_from)| {
        let object = find_object(picture, None, 1)?;
        notes.extend(object.notes);
        let view = seen_from.resolve(&[], height_world, OBJECT_PX)?;
        let part =
            object.body.threshold(0.5).bounding_box().ok_or_else(|| {
                Error::picture(picture.name(), "shows no object", "use a picture with a larger object")
            })?;
        let half = 0.5 * OBJECT_PX as f64 * part.height() as f64 / height_px as f64;
        let [x, y] = [0.5 * (part.left + part.right) as f64, 0.5 * (part.top + part.bottom) as f64];
        Ok((view, object.body.window([x - half, y - half, x + half, y + half], OBJECT_PX, OBJECT_PX)))
    });
    each.collect()
}

/// Things are nearer in their middle than at their rim: where a measured depth goes the other way by this much of its
/// spread, it tells distances.
const INWARD: f32 = 0.1;

/// A depth picture as nearness over the object's picture. What is not known of the object is filled in from round it.
fn nearness(depth: &Picture, picture: &Picture, object: &Object, notes: &mut Vec<String>) -> Result<Image> {
    let (width, height) = (depth.width(), depth.height());
    if (width, height) != (picture.width(), picture.height()) {
        let problem = format!("is {width} x {height} px, and its picture {} x {}", picture.width(), picture.height());
        return Err(Error::picture(depth.name(), problem, "give a depth picture of the same size"));
    }
    let grey = |p: &[u8]| (f32::from(p[0]) + f32::from(p[1]) + f32::from(p[2])) / 765.0;
    let data: Vec<f32> = depth.rgba().chunks_exact(4).map(grey).collect();
    // What is known of the object: its ground's depth has no say, nor has nothing, where depths were measured.
    let body = object.body.resized(width, height);
    let known = |i: usize| f32::from(body.data[i] > 0.9 && (!depth.is_measured() || data[i] > 0.0));
    let known: Vec<f32> = (0..data.len()).map(known).collect();
    let small = |data: Vec<f32>| Image { width, height, data }.resized(object.mask.width, object.mask.height);
    let values = small(data.iter().zip(&known).map(|(value, known)| value * known).collect());
    let weights = small(known);
    let sigma_px = FILLED_IN * values.width.max(values.height) as f64;
    let (values_near, weights_near) = (values.blurred(sigma_px), weights.blurred(sigma_px));
    let filled = (0..values.data.len()).map(|i| match weights.data[i] {
        0.0 => values_near.data[i] / weights_near.data[i].max(1e-6),
        weight => values.data[i] / weight,
    });
    let mut near = Image { data: filled.collect(), ..values };
    let body = object.body.threshold(0.5);
    if depth.is_measured() && correlation(&near, &body.inverted().distance_px(), &body) < -INWARD {
        let name = depth.name();
        notes.push(format!("{name}: its middle is darker than its rim, so it is taken for distances, dark is near"));
        near.data.iter_mut().for_each(|value| *value = 1.0 - *value);
    }
    Ok(near)
}

/// How far known depths reach into what is not known, as a share of the picture's longer side.
const FILLED_IN: f64 = 0.02;

/// Pearson's, of two pictures within a mask; 0 where one of them is even.
fn correlation(a: &Image, b: &Image, mask: &Mask) -> f32 {
    let inside = || (0..mask.data.len()).filter(|&i| mask.data[i]);
    let mean = |of: &dyn Fn(usize) -> f32| inside().map(of).sum::<f32>() / inside().count().max(1) as f32;
    let [mean_a, mean_b] = [a, b].map(|image| mean(&|i| image.data[i]));
    let moment = |p: &Image, m: f32, q: &Image, n: f32| mean(&|i| (p.data[i] - m) * (q.data[i] - n));
    let spread = (moment(a, mean_a, a, mean_a) * moment(b, mean_b, b, mean_b)).sqrt();
    if spread > 0.0 { moment(a, mean_a, b, mean_b) / spread } else { 0.0 }
}

/// The object's lines: as close as the settings say, or as close as the number of control points allows.
fn lines(subject: &Subject, solid: &Solid, settings: &Settings) -> Lines {
    let draw = |spacing_px: f64| {
        let options = LineOptions {
            hatching: settings.hatching.into(),
            spacing_px,
            outline_px: settings.outline,
            edges: settings.edges,
            tone: settings.tone,
            saliency: settings.saliency,
            gloss: settings.gloss,
            width_px: [settings.min_width, settings.max_width],
        };
        Lines::draw(subject, &options)
    };
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

/// Views from all round, drawn from the seed: azimuths evenly spread, elevations at random. Turn 0 is what the report
/// measures, named by its directions; others are fitted, and named by number since they change.
fn side_views(turn: u64, settings: &Settings) -> Vec<View> {
    let mut rng = Rng::new(settings.seed, 0x7369_6465 + turn);
    let count = settings.side_views;
    let first = rng.unit();
    let each = (0..count).map(|k| {
        let azimuth = (360.0 * (k as f64 + first + rng.range(-0.25, 0.25)) / count as f64).round().rem_euclid(360.0);
        let elevation = rng.range(ELEVATIONS[0], ELEVATIONS[1]).round();
        let name = if turn == 0 { format!("{azimuth},{elevation}") } else { format!("side {}", k + 1) };
        View::orthographic(&name, azimuth.to_radians(), elevation.to_radians(), SIDE_HEIGHT_WORLD, settings.size)
    });
    each.collect()
}

/// Weight of bending: the first wire lies along the lines already.
const BENDING: f64 = 4.0;
/// How far strands that lie on one another are moved apart before the fit, px of a 256 px picture.
const JITTER_PX: f64 = 1.0;

impl Plan {
    /// What a person should know before the run, in plain words.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// World units in one pixel of a 256 px picture of the front.
    fn world_per_px_256(&self) -> f64 {
        self.solid.height_world() / 256.0
    }

    fn first_wire(&self, settings: &Settings) -> Result<Wire> {
        let px = self.world_per_px_256();
        let count = if settings.control_points == 0 { FEWEST_TOUR_POINTS } else { settings.control_points };
        let tour_width = TOUR_WIDTH_PX * px;
        let wire = match settings.start {
            Start::Contour => {
                let mut path = self.lines.walk(&self.solid, settings.min_width.max(THIN_PX) * px);
                if settings.smooth == OnOff::On {
                    start::jittered(&mut path, JITTER_PX * px, settings.seed);
                    path.points = with_open_hairpins(&path.points, path.closed, HAIRPIN_PX * px);
                }
                let finest = start::length(&path) / MOST_FIRST_POINTS;
                match settings.control_points {
                    0 => start::wire_along(&path, (settings.spacing * px).max(finest))?,
                    count => start::wire_with(&path, count)?,
                }
            }
            // The points of the tour are the control points (the paper's choice).
            Start::Hull => Wire::open_uniform(self.solid.tour(count, tour_width, settings.seed).points)?,
            Start::Ball => Wire::open_uniform(start::ball_path(count, 0.8, tour_width, false, settings.seed).points)?,
            Start::Circuit | Start::Tree | Start::Stripes | Start::Tour => {
                return Err(Task::Stroke.refused("start", settings));
            }
        };
        if settings.form == Form::Spline { Ok(wire) } else { wire.to_form(settings.form) }
    }

    /// What is fitted from iteration `iteration` on: the front, the sides that were given, and the drawn ones of that time.
    fn fitted(&self, first: &Wire, iteration: usize, settings: &Settings) -> Vec<Target> {
        let turn = iteration.checked_div(settings.new_sides).map_or(0, |turn| turn as u64 + 1);
        let given = self.targets[1..self.sources.len()].iter().map(|target| target.view.clone());
        let sides: Vec<View> = given.chain(side_views(turn, settings)).collect();
        let sides = in_parallel(&sides, |view| self.side_target(view, first, settings));
        std::iter::once(self.targets[0].clone()).chain(sides).collect()
    }

    /// What the fit asks of the side seen in `view`: what it shows of the `first` wire within the solid, and faintly the
    /// solid's outline and creases there, so that strands nearby move onto them.
    fn side_target(&self, view: &View, first: &Wire, settings: &Settings) -> Target {
        let mut ink = self.solid.silhouette(view);
        match settings.start {
            Start::Contour => {
                let lines = render_sampled(first, view, SIDE_SAMPLES);
                ink.data.iter_mut().zip(&lines.data).for_each(|(ink, line)| *ink = ink.min(*line));
            }
            _ => ink.data.iter_mut().for_each(|ink| *ink *= SIDE_INK),
        }
        if settings.creases > 0.0 {
            let creases = self.solid.creases(view, CREASE_PX * view.height_px as f64 / 256.0);
            let wanted = |crease: &f32| settings.creases as f32 * crease;
            ink.data.iter_mut().zip(&creases.data).for_each(|(ink, crease)| *ink = ink.max(wanted(crease)));
        }
        Target { view: view.clone(), ink }
    }

    /// The fit of `wire` from iteration `iteration` on; `first` is the first wire.
    fn problem(&self, wire: Wire, first: &Wire, iteration: usize, settings: &Settings) -> Problem {
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
            ..Problem::for_drawings(wire, self.fitted(first, iteration, settings), recipe)
        }
    }
}

#[cfg(feature = "threads")]
fn in_parallel(views: &[View], make: impl Fn(&View) -> Target + Sync + Send) -> Vec<Target> {
    use rayon::prelude::*;
    views.par_iter().map(make).collect()
}

#[cfg(not(feature = "threads"))]
fn in_parallel(views: &[View], make: impl Fn(&View) -> Target) -> Vec<Target> {
    views.iter().map(make).collect()
}

impl super::Plan for Plan {
    fn settings(&self) -> &Settings {
        &self.settings
    }

    fn targets(&self) -> &[Target] {
        &self.targets
    }

    fn prepare(
        self,
        from: Option<(Wire, usize)>,
        _: &mut dyn FnMut(f32) -> bool,
    ) -> Result<(Box<dyn super::Job>, Problem)> {
        let first = self.first_wire(&self.settings)?;
        let (wire, iteration) = from.unwrap_or_else(|| (first.clone(), 0));
        let problem = self.problem(wire, &first, iteration, &self.settings);
        Ok((Box::new(Job { plan: self, first }), problem))
    }
}

/// The picture's part in a run.
struct Job {
    plan: Plan,
    first: Wire,
}

impl super::Job for Job {
    fn task(&self) -> Task {
        Task::Stroke
    }

    fn targets(&self) -> &[Target] {
        &self.plan.targets
    }

    fn sources(&self) -> &[String] {
        &self.plan.sources
    }

    fn change_views_every(&self, settings: &Settings) -> usize {
        settings.new_sides
    }

    fn views_from(&self, iteration: usize, settings: &Settings) -> Seen {
        Seen { targets: self.plan.fitted(&self.first, iteration, settings), ..Seen::default() }
    }
}
