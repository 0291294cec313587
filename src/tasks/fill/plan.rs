//! What is decided before a fit: the curve over the mesh, and what sides show of it.

use super::first::{width_bounds, width_note, width_unit};
use super::given::{Given, Style};
use super::motif::Motif;
use super::{looks, texture};
use crate::Result;
use crate::mesh::{Depths, Mesh, Nearest};
use crate::metrics::{ResultReport, SurfaceReport};
use crate::objective::Texture;
use crate::optimize::{Problem, Schedule, Seen, Session, SurfacePull};
use crate::parallel;
use crate::sculpture::{Sculpture, render, render_seen};
use crate::settings::{Flow, Motif as Laid, Settings, Start, Task};
use crate::start::{self, FillOptions, Filling, Guide, Method};
use crate::tasks;
use crate::tasks::recipe::{at_once, recipe};
use crate::view::{Image, Target};
use crate::wire::Wire;
use std::sync::Arc;

/// The curve and what it should show, before anything is fitted.
pub struct Plan {
    pub(super) settings: Settings,
    pub(super) name: String,
    pub(super) mesh: Arc<Mesh>,
    pub(super) nearest: Arc<Nearest>,
    pub(super) motif: Option<Arc<Motif>>,
    pub(super) texture: Option<Arc<Texture>>,
    pub(super) filling: Filling,
    /// What the report compares with: the five sides.
    pub(super) targets: Vec<Target>,
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
    notes.extend(width_note(settings));
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
    plan.targets = plan.seen(looks::sides(settings.size)).targets;
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
pub(super) fn world_per_px(settings: &Settings) -> f64 {
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
    fn shown(&self, wire: &Wire, view: usize, [width, height]: [usize; 2]) -> Image {
        let seen_from = self.targets[view].view.with_size(width, height);
        if self.settings.hidden_lines {
            return render(wire, &seen_from);
        }
        render_seen(wire, &seen_from, &self.occluder(&Depths::render(&self.mesh, &seen_from)))
    }

    /// The fit of `wire` from iteration `iteration` on.
    fn problem(&self, wire: Wire, iteration: usize) -> Problem {
        let settings = &self.settings;
        let Seen { targets, occluders, texture_masks } = self.looked_at(iteration);
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
            surface: Some(SurfacePull {
                nearest: Arc::clone(&self.nearest),
                weight: SURFACE_WEIGHT * settings.surface_pull,
                every: PLANES_EVERY,
            }),
            ..Problem::for_drawings(wire, targets, recipe)
        }
    }
}

impl tasks::Plan for Plan {
    fn task(&self) -> Task {
        Task::Fill
    }

    fn settings(&self) -> &Settings {
        &self.settings
    }

    fn targets(&self) -> &[Target] {
        &self.targets
    }

    fn begin(&mut self, from: Option<(Wire, usize)>, _: &mut dyn FnMut(f32) -> bool) -> Result<Problem> {
        let (wire, iteration) = match from {
            Some(from) => from,
            None => (self.first_wire()?, 0),
        };
        Ok(self.problem(wire, iteration))
    }

    fn hides(&self) -> bool {
        true
    }

    fn draw(&self, wire: &Wire, view: usize, size: [usize; 2]) -> Image {
        self.shown(wire, view, size)
    }

    /// How evenly a wire covers the mesh, and how far it is off it.
    fn complete(&self, result: &mut ResultReport, made: &Sculpture, _: &Session) {
        let spacing = self.settings.curve_spacing;
        result.surface = SurfaceReport::measure(&self.mesh, &self.nearest, &made.wire, spacing).ok();
    }

    fn change_views_every(&self) -> usize {
        1
    }

    fn views_from(&self, iterations: &[usize]) -> Vec<Seen> {
        parallel::map(iterations, 1, |&iteration| self.looked_at(iteration))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Shape;
    use crate::picture::Pattern;
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
