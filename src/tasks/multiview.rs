//! Two, three or more drawings to one wire that shows each from its own side.
//!
//! [`plan`] arranges the drawings and says what any object could show of them; [`Run::start`] grows the first wire;
//! [`Run::step`] fits it; [`Run::sculpture`] and [`Run::result`] give what came of it.

use super::fit::recipe;
use crate::Result;
use crate::optimize::{Event, Problem, Session, WidthBounds};
use crate::sculpture::{MadeWith, Sculpture};
use crate::settings::{Bend, OnOff, Settings, Start, Turn};
use crate::start::{self, ArrangeOptions, Arrangement, Drawing, TrailOptions, TreeOptions};
use crate::view::Image;
use crate::wire::{Form, Wire};

/// Drawings in their views, before anything is fitted.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Which drawing went where, the object's box, and what each view should show (never bent).
    pub arrangement: Arrangement,
}

/// Arranges the drawings: which goes where, mirrored or turned how, and the object's box.
///
/// # Errors
/// [`Error::Picture`] for a drawing without ink, [`Error::Pictures`] when they are too few or share no ink at all.
pub fn plan(drawings: &[Drawing], settings: &Settings) -> Result<Plan> {
    settings.check()?;
    let options = ArrangeOptions {
        permute: settings.may_swap,
        mirror: settings.may_mirror,
        turn_top: settings.may_turn != Turn::None,
        max_stretch: settings.max_stretch,
        size_px: settings.size,
    };
    let options = if settings.arrange == OnOff::On { options } else { options.pinned() };
    Ok(Plan { arrangement: start::arrange(drawings, &options)? })
}

impl Plan {
    /// World units in one pixel of a 256 px picture.
    fn world_per_px_256(&self) -> f64 {
        self.arrangement.height_world / 256.0
    }

    /// The wire the fit starts from. `progress` (0 to 1) stops the search by returning false; what there is is used.
    ///
    /// # Errors
    /// As the start chosen by the settings.
    fn first_wire(&self, settings: &Settings, progress: &mut dyn FnMut(f32) -> bool) -> Result<Wire> {
        let Arrangement { targets, half_extents_world, .. } = &self.arrangement;
        let path = match settings.start {
            Start::Tree | Start::Hull | Start::Ball => {
                let tree = TreeOptions { across: settings.grid, ..TreeOptions::default() };
                start::tree_path(targets, *half_extents_world, &tree, &TrailOptions::default(), progress)?
            }
        };
        let wire = match settings.control_points {
            0 => start::wire_along(&path, 4.0 * self.world_per_px_256())?,
            count => start::wire_with(&path, count)?,
        };
        if settings.form == Form::Spline { Ok(wire) } else { wire.to_form(settings.form) }
    }
}

/// A fit under way.
pub struct Run {
    plan: Plan,
    settings: Settings,
    session: Session,
}

impl Run {
    /// Makes the first wire and readies the fit. `progress` is told how far the start is (0 to 1) and cuts it short by
    /// returning false.
    ///
    /// # Errors
    /// As the start chosen by the settings, and [`Problem::check`].
    pub fn start(plan: Plan, settings: &Settings, progress: &mut dyn FnMut(f32) -> bool) -> Result<Run> {
        let wire = plan.first_wire(settings, progress)?;
        let px = plan.world_per_px_256();
        let problem = Problem {
            wire,
            targets: plan.arrangement.targets.clone(),
            view_weights: Vec::new(),
            width: WidthBounds { min_world: settings.min_width * px, max_world: settings.max_width * px },
            recipe: recipe(settings),
            seed: settings.seed,
        };
        Ok(Run { plan, settings: settings.clone(), session: Session::new(problem)? })
    }

    /// Does up to `count` more iterations and says what happened. To pause, stop calling; to cancel, drop the run.
    pub fn step(&mut self, count: usize) -> Vec<Event> {
        self.session.step(count)
    }

    /// How the drawings were arranged.
    pub fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The session, for its progress, history and pictures.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The settings it runs with.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The best wire so far with its views.
    pub fn sculpture(&self) -> Sculpture {
        Sculpture {
            wire: self.session.best(),
            views: self.plan.arrangement.targets.iter().map(|target| target.view.clone()).collect(),
            made_with: MadeWith {
                task: "multiview".into(),
                seed: self.settings.seed,
                settings: self.settings.to_map(),
                ..MadeWith::default()
            },
        }
    }

    /// Each view's target as it is bent now; `None` where nothing bends.
    pub fn bent(&self) -> Option<Vec<(Image, crate::objective::Displacement)>> {
        (self.settings.bend != Bend::None).then(|| self.session.bent_targets())
    }
}
