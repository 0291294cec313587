//! One curve over a mesh, bent and thickened by a style.
//!
//! [`plan`] covers the mesh with one closed curve; [`Run::start`](super::Run::start) fits a wire of even width to it; the fit then looks at it
//! from other views every step. Each view asks for as much ink on the mesh's silhouette as the density says (the paper's
//! `α · mask`), more of it where the style's picture, laid on the surface, is dark, and for the texture of that picture.
//! Strands behind the surface are not seen, and all are held to it, so that what is seen and what is not stays clear.

mod asked;
mod first;
mod looks;
mod motif;
mod texture;

use super::fit::{at_once, recipe};
use super::run::Run;
use crate::Result;
use crate::mesh::{Depths, Mesh, Nearest, Shape};
use crate::metrics::{ResultReport, SurfaceReport};
use crate::objective::Texture;
use crate::optimize::{Problem, Schedule, Seen, Surface};
use crate::picture::Pattern;
use crate::sculpture::{Sculpture, render, render_seen};
use crate::settings::{Flow, Motif as Laid, Settings, Start, Task};
use crate::start::{self, FillOptions, Filling, Guide, Method};
use crate::view::{Image, Target};
use crate::wire::Wire;
use first::{width_bounds, width_unit};
use motif::Motif;
use std::sync::Arc;

/// What a person gives.
#[derive(Debug, Clone)]
pub struct Given {
    /// The mesh as the person knows it.
    pub name: String,
    /// The surface.
    pub mesh: Arc<Mesh>,
    /// What was mended about it, in plain words.
    pub notes: Vec<String>,
    /// What it should look like.
    pub style: Option<Style>,
}

/// A picture whose look the wire should take on.
#[derive(Debug, Clone, PartialEq)]
pub struct Style {
    /// Its name as the person knows it.
    pub name: String,
    /// Ink, 0 (ground) to 1 (ink).
    pub ink: Image,
    /// Whether its borders meet when it is repeated.
    pub tiles: bool,
}

/// Side of a pattern's picture, px: the curve depends on it, so it is one for all.
const PATTERN_PX: usize = 512;

impl Style {
    /// A built-in pattern.
    pub fn pattern(pattern: Pattern) -> Style {
        Style { name: pattern.name().to_owned(), ink: pattern.picture(PATTERN_PX), tiles: true }
    }
}

/// The curve and what it should show, before anything is fitted.
pub struct Plan {
    settings: Settings,
    name: String,
    mesh: Arc<Mesh>,
    nearest: Arc<Nearest>,
    motif: Option<Arc<Motif>>,
    texture: Option<Arc<Texture>>,
    filling: Filling,
    /// What the report compares with: the five sides.
    targets: Vec<Target>,
    notes: Vec<String>,
}

/// Share of the positions' step size where no style asks strands to bend: the density is a matter of width.
const STILL: f64 = 0.1;
/// Weight of the texture at full strength: beside a motif it only helps, else it has to say it all.
const TEXTURE_WEIGHTS: [f64; 2] = [0.05, 0.3];
/// Weight of the pull to the surface at 1 in the settings: strands stay within a tenth of their distance.
const SURFACE_WEIGHT: f64 = 100.0;
/// Iterations after which the surface's tangent planes are taken anew.
const PLANES_EVERY: usize = 10;

impl Given {
    /// A mesh from a file, with what was mended about it.
    pub fn mesh(name: &str, mesh: Mesh, notes: Vec<String>) -> Given {
        Given { name: name.to_owned(), mesh: Arc::new(mesh), notes, style: None }
    }

    /// A built-in shape.
    pub fn shape(shape: Shape) -> Given {
        Given { name: shape.name().into(), mesh: Arc::new(shape.mesh()), notes: Vec::new(), style: None }
    }

    fn motif(&self, settings: &Settings) -> Option<Arc<Motif>> {
        self.style.as_ref().map(|style| Arc::new(Motif::new(style, settings)))
    }

    /// The style, if it is to count.
    fn style_asked(&self, settings: &Settings) -> Option<&Style> {
        self.style.as_ref().filter(|_| settings.style_strength > 0.0)
    }

    fn texture(&self, settings: &Settings) -> Result<Option<Arc<Texture>>> {
        let Some(style) = self.style_asked(settings) else { return Ok(None) };
        Ok(texture::texture(style, settings)?.map(Arc::new))
    }
}

/// Covers the mesh and says what it should show. `progress` is told how much is done, 0 to 1, and stops it by returning
/// false: then there is no plan.
///
/// # Errors
/// As [`cover`] and [`plan_over`].
pub fn plan(given: &Given, settings: &Settings, progress: &mut dyn FnMut(f32) -> bool) -> Result<Option<Plan>> {
    Task::Fill.check(settings)?;
    // What is wrong with a style is told before anybody waits for the curve.
    let texture = given.texture(settings)?;
    Ok(cover(given, settings, progress)?.map(|filling| planned(given, filling, texture, settings)))
}

/// The curve alone, which many settings have in common. `progress` as in [`plan`].
///
/// # Errors
/// [`Error::Setting`] for a spacing too fine for this mesh, [`Error::Input`] for a mesh that no curve covers.
pub fn cover(given: &Given, settings: &Settings, progress: &mut dyn FnMut(f32) -> bool) -> Result<Option<Filling>> {
    Task::Fill.check(settings)?;
    let options = FillOptions { name: given.name.clone(), ..fill_options(given.motif(settings).as_ref(), settings) };
    start::fill(&given.mesh, &options, progress)
}

/// What a curve that [`cover`] gave for this mesh should show.
///
/// # Errors
/// [`Error::Picture`] for a style that shows nothing, [`Error::Setting`] for one too small to show anything.
pub fn plan_over(given: &Given, filling: Filling, settings: &Settings) -> Result<Plan> {
    Ok(planned(given, filling, given.texture(settings)?, settings))
}

fn planned(given: &Given, filling: Filling, texture: Option<Arc<Texture>>, settings: &Settings) -> Plan {
    let mut notes: Vec<String> = given.notes.iter().chain(&filling.notes).cloned().collect();
    if given.style_asked(settings).is_some() && texture.is_none() {
        notes.push("the style is too small in the views for its texture to show: only its tones are used".to_owned());
    }
    notes.extend(first::width_note(settings));
    let mut plan = Plan {
        settings: settings.clone(),
        name: given.name.clone(),
        mesh: Arc::clone(&given.mesh),
        nearest: Arc::new(Nearest::new(&given.mesh)),
        motif: given.motif(settings),
        texture,
        notes,
        filling,
        targets: Vec::new(),
    };
    plan.targets = plan.seen(looks::sides(settings.size), settings).targets;
    plan
}

fn fill_options(motif: Option<&Arc<Motif>>, settings: &Settings) -> FillOptions {
    let upright = [0.0, 1.0, 0.0];
    let guide = match (settings.flow, motif) {
        (Flow::Along, _) => Guide::Along(upright),
        (Flow::Across, _) => Guide::Across(upright),
        (Flow::Style, Some(motif)) => {
            let motif = Arc::clone(motif);
            Guide::Custom(Box::new(move |point, normal| motif.along(point, normal)))
        }
        (Flow::Smooth | Flow::Style, _) => Guide::Smooth,
    };
    let method = if settings.start == Start::Tour { Method::Tour } else { Method::Stripes };
    let (spacing_world, seed) = (settings.curve_spacing, settings.seed);
    FillOptions { spacing_world, guide, method, seed, ..FillOptions::default() }
}

/// World units in a pixel of a view, at the origin.
fn world_per_px(settings: &Settings) -> f64 {
    let view = &looks::sides(settings.size)[0];
    1.0 / view.camera::<f64>().pixels_per_world(&[0.0; 4])
}

/// Weight of bending: lines that cover a mesh bend little but for their style.
const BENDING: f64 = 0.5;

impl Plan {
    /// What a person should know before the run, in plain words.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The curve that covers the mesh.
    pub fn filling(&self) -> &Filling {
        &self.filling
    }

    /// The surface that it covers.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// What the five sides should show.
    pub fn targets(&self) -> &[Target] {
        &self.targets
    }

    /// What view `view` of the targets shows of a wire: without what lies behind the surface, unless the settings say so.
    fn draw(&self, wire: &Wire, view: usize, [width, height]: [usize; 2], settings: &Settings) -> Image {
        let seen_from = self.targets[view].view.with_size(width, height);
        if settings.hidden_lines {
            return render(wire, &seen_from);
        }
        render_seen(wire, &seen_from, &self.occluder(&Depths::render(&self.mesh, &seen_from), settings))
    }

    /// The fit of `wire` from iteration `iteration` on.
    fn problem(&self, wire: Wire, iteration: usize, settings: &Settings) -> Problem {
        let Seen { targets, occluders, texture_masks } = self.looked_at(iteration, settings);
        let share = 1.0 / targets.len() as f64;
        let mut recipe = recipe(settings);
        if let Some(smooth) = &mut recipe.smooth {
            smooth.bending = Schedule::Constant(BENDING * settings.smoothness);
            smooth.tightness = at_once(&smooth.tightness);
            smooth.clearance = at_once(&smooth.clearance);
            // Dense lines lie side by side: only what passes through another is too near.
            smooth.clearance_diameters = 1.0;
            smooth.least_clearance_px =
                smooth.least_clearance_px.min(0.5 * settings.curve_spacing / width_unit(settings));
        }
        let strength = if self.motif.is_some() { settings.style_strength } else { 0.0 };
        recipe.position_rate_px = recipe.position_rate_px.scaled(STILL + (1.0 - STILL) * strength);
        Problem {
            view_weights: vec![share; targets.len()],
            width: width_bounds(settings),
            seed: settings.seed,
            occluders,
            texture: self.texture.clone(),
            texture_weight: TEXTURE_WEIGHTS[usize::from(settings.motif == Laid::Off)] * settings.style_strength,
            texture_masks,
            surface: Some(Surface {
                nearest: Arc::clone(&self.nearest),
                weight: SURFACE_WEIGHT * settings.surface_pull,
                every: PLANES_EVERY,
            }),
            ..Problem::for_drawings(wire, targets, recipe)
        }
    }

    /// How evenly a wire covers the mesh, and how far it is off it.
    fn measure(&self, wire: &Wire, settings: &Settings) -> Result<SurfaceReport> {
        SurfaceReport::measure(&self.mesh, &self.nearest, wire, settings.curve_spacing)
    }
}

impl super::Plan for Plan {
    fn prepare(
        self,
        from: Option<(Wire, usize)>,
        _: &mut dyn FnMut(f32) -> bool,
    ) -> Result<(Box<dyn super::Job>, Problem)> {
        let (wire, iteration) = match from {
            Some(from) => from,
            None => (self.first_wire(&self.settings)?, 0),
        };
        let problem = self.problem(wire, iteration, &self.settings);
        Ok((Box::new(Job { plan: self }), problem))
    }

    fn settings(&self) -> &Settings {
        &self.settings
    }

    fn targets(&self) -> &[Target] {
        &self.targets
    }
}

/// The mesh's part in a run.
struct Job {
    plan: Plan,
}

impl super::Job for Job {
    fn task(&self) -> Task {
        Task::Fill
    }

    fn targets(&self) -> &[Target] {
        &self.plan.targets
    }

    fn hides(&self) -> bool {
        true
    }

    fn draw(&self, wire: &Wire, view: usize, size: [usize; 2], settings: &Settings) -> Image {
        self.plan.draw(wire, view, size, settings)
    }

    fn complete(&self, result: &mut ResultReport, made: &Sculpture, run: &Run) {
        result.surface = self.plan.measure(&made.wire, run.settings()).ok();
    }

    fn change_views_every(&self, _: &Settings) -> usize {
        1
    }

    fn views_from(&self, iteration: usize, settings: &Settings) -> Seen {
        self.plan.looked_at(iteration, settings)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Preset;

    #[test]
    fn a_mesh_of_specks_is_refused_by_its_name() {
        let speck = |x: f64| [[x, 0.0, 0.0], [x + 1e-4, 0.0, 0.0], [x, 1e-4, 0.0]];
        let positions = [speck(-1.0), speck(1.0 - 1e-4)].concat();
        let mesh = Arc::new(Mesh::new("specks", positions, vec![[0, 1, 2], [3, 4, 5]]).unwrap());
        let given = Given { name: "specks.obj".into(), mesh, notes: Vec::new(), style: None };
        for (curve_spacing, is_lowest) in [(0.1, false), (0.02, true)] {
            let settings = Settings { curve_spacing, ..Task::Fill.preset(Preset::Best) };
            let error = cover(&given, &settings, &mut |_| true).unwrap_err().to_string();
            assert!(error.starts_with("specks.obj: has no part large enough"), "{error}");
            assert_eq!(error.contains("lower curve_spacing"), !is_lowest, "{error}");
        }
    }

    #[test]
    fn a_style_that_cannot_show_is_refused_before_anything_is_covered() {
        let style = Style { name: "petals".into(), ink: Pattern::Petals.picture(128), tiles: true };
        let given = Given { style: Some(style), ..Given::shape(Shape::Sphere) };
        let settings = Settings { style_size: 0.1, motif: Laid::Off, ..Task::Fill.preset(Preset::Best) };
        let error = plan(&given, &settings, &mut |_| panic!("nothing is covered")).err().map(|error| error.to_string());
        assert!(error.is_some_and(|error| error.starts_with("style_size: ")));
        let settings = Settings { motif: Laid::Box, curve_spacing: 0.2, ..settings };
        let plan = plan(&given, &settings, &mut |_| true).unwrap().unwrap();
        assert!(plan.texture.is_none() && plan.notes().iter().any(|note| note.contains("only its tones")));
    }
}
