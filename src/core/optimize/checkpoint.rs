//! Everything a session needs to go on later exactly as if it had never stopped.

use super::bending::Field;
use super::engine::{State, Tally};
use super::history::{Event, History};
use super::session::Session;
use super::{Adam, CpuEngine, Engine, Problem};
use crate::rng::Rng;
use crate::wire::Wire;
use crate::{Error, Result};

/// The present format; others are refused.
const VERSION: u32 = 3;

/// A session at one iteration, without its problem. Serialises to any format that keeps `f32` exactly.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Checkpoint {
    version: u32,
    iteration: usize,
    halvings: u32,
    wire: Wire,
    state: SavedState,
    good: SavedState,
    best_wire: Wire,
    best_points: Vec<[f32; 4]>,
    /// None before the first loss of a stage.
    best_loss: Option<f32>,
    /// Where the planes of the pull to a surface were laid; none without such a pull.
    plane_points: Vec<[f32; 4]>,
    /// Where neighbours were last looked for; none where nobody asks.
    strand_points: Vec<[f32; 4]>,
    fields: Vec<SavedField>,
    gradient_norms: Vec<f32>,
    gradient_count: u32,
    rng: Rng,
    history: History,
    events: Vec<Event>,
}

#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
struct SavedState {
    points: Vec<[f32; 4]>,
    first: Vec<[f32; 4]>,
    second: Vec<[f32; 4]>,
    count: u32,
}

#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
struct SavedField {
    values: Vec<[f32; 2]>,
    first: Vec<[f32; 2]>,
    second: Vec<[f32; 2]>,
    count: u32,
}

impl SavedState {
    fn new(state: &State) -> Self {
        let State { points, adam } = state.clone();
        SavedState { points, first: adam.first, second: adam.second, count: adam.count }
    }

    fn restore(self, count: usize) -> Option<State> {
        let SavedState { points, first, second, count: steps } = self;
        let state = State { points, adam: Adam { first, second, count: steps } };
        let lengths = [state.points.len(), state.adam.first.len(), state.adam.second.len()];
        (lengths == [count; 3] && state.is_finite()).then_some(state)
    }
}

impl SavedField {
    fn new(field: &Field) -> Self {
        let Field { values, adam } = field.clone();
        SavedField { values, first: adam.first, second: adam.second, count: adam.count }
    }

    fn restore(self, count: usize) -> Option<Field> {
        let SavedField { values, first, second, count: steps } = self;
        let fine = [&values, &first, &second]
            .iter()
            .all(|list| list.len() == count && list.iter().flatten().all(|value| value.is_finite()));
        fine.then_some(Field { values, adam: Adam { first, second, count: steps } })
    }
}

impl Checkpoint {
    /// Iterations done when it was taken.
    pub fn iteration(&self) -> usize {
        self.iteration
    }

    /// The wire as it was last laid out: form and knots are those of its iteration, the control points may be older.
    pub fn wire(&self) -> &Wire {
        &self.wire
    }

    /// The same without the best wire so far: for a recipe whose losses cannot be compared with those before.
    pub fn without_best(self) -> Checkpoint {
        Checkpoint { best_wire: self.wire.clone(), best_points: self.state.points.clone(), best_loss: None, ..self }
    }

    /// Whether no counter claims more than its iterations allow.
    fn counts_add_up(&self) -> bool {
        let adam = [self.state.count, self.good.count];
        let fields = self.fields.iter().map(|field| field.count);
        let mut counts = adam.into_iter().chain(fields).chain([self.halvings, self.gradient_count]);
        counts.all(|count| count as usize <= self.iteration)
    }
}

impl Session {
    /// The session's state, to be resumed with the same problem.
    pub fn checkpoint(&self) -> Checkpoint {
        let fields = match &self.bender {
            Some(bender) => bender.fields().map(SavedField::new).collect(),
            None => self.fields.iter().map(SavedField::new).collect(),
        };
        Checkpoint {
            version: VERSION,
            iteration: self.iteration,
            halvings: self.halvings,
            wire: self.wire.clone(),
            state: SavedState::new(&self.state),
            good: SavedState::new(&self.good),
            best_wire: self.best_wire.clone(),
            best_points: self.tally.best_points.clone(),
            best_loss: self.tally.best_loss.is_finite().then_some(self.tally.best_loss),
            plane_points: self.plane_points.clone(),
            strand_points: self.strand_points.clone(),
            fields,
            gradient_norms: self.tally.gradient_norms.clone(),
            gradient_count: self.gradient_count,
            rng: self.rng.clone(),
            history: self.history.clone(),
            events: self.events.clone(),
        }
    }

    /// Goes on from a checkpoint of the same problem, on the processor: bit for bit as if never interrupted.
    ///
    /// # Errors
    /// As [`Problem::check`]; [`Error::Input`] for a checkpoint that is damaged or of another problem.
    pub fn resume(problem: Problem, checkpoint: Checkpoint) -> Result<Session> {
        Session::resume_with_engine(problem, checkpoint, Box::new(CpuEngine::new()))
    }

    /// [`Session::resume`] on an engine of one's choice.
    ///
    /// # Errors
    /// As [`Session::resume`].
    pub fn resume_with_engine(problem: Problem, saved: Checkpoint, engine: Box<dyn Engine>) -> Result<Session> {
        let mut session = Session::with_engine(problem, engine)?;
        let refuse = |problem: &str| Error::input("checkpoint", problem, "resume from one of this very problem");
        if saved.version != VERSION {
            return Err(Error::input(
                "checkpoint",
                format!("it has version {}", saved.version),
                format!("resume with the program that wrote it, or take one of version {VERSION}"),
            ));
        }
        if saved.iteration > session.total() || saved.history.len() != saved.iteration {
            return Err(refuse("it does not fit the number of iterations"));
        }
        if !saved.counts_add_up() {
            return Err(refuse("its counters are damaged"));
        }
        let saved = Checkpoint { history: saved.history.completed(), ..saved };
        if !saved.history.is_valid(session.problem.targets.len()) {
            return Err(refuse("its history is of other views"));
        }
        let (form, closed) = (session.problem.wire.form(), session.problem.wire.closed());
        if [&saved.wire, &saved.best_wire].iter().any(|wire| (wire.form(), wire.closed()) != (form, closed)) {
            return Err(refuse("its wire is of another form"));
        }
        let count = saved.wire.control_points().len();
        let restored = saved.state.restore(count).zip(saved.good.restore(count));
        let (state, good) = restored.ok_or_else(|| refuse("its control points are damaged"))?;
        let best_fits = saved.best_points.len() == saved.best_wire.control_points().len();
        let norms_fit = saved.gradient_norms.len() == count;
        let planes_fit =
            [&saved.plane_points, &saved.strand_points].iter().all(|list| [0, count].contains(&list.len()));
        let points = saved.best_points.iter().chain(&saved.plane_points).chain(&saved.strand_points).flatten();
        let finite = points.chain(&saved.gradient_norms).all(|value| value.is_finite());
        let takes = |wire: &Wire, points: &[[f32; 4]]| {
            let points: Vec<_> = points.iter().map(|point| point.map(f64::from)).collect();
            wire.clone().set_control_points(&points).is_ok()
        };
        let taken = takes(&saved.wire, &state.points) && takes(&saved.best_wire, &saved.best_points);
        if !(best_fits && norms_fit && planes_fit && finite && taken) {
            return Err(refuse("its control points are damaged"));
        }
        let grid = session.problem.recipe.bending.as_ref().map_or(0, |bending| bending.grid);
        let fields: Option<Vec<Field>> = saved.fields.into_iter().map(|field| field.restore(grid * grid)).collect();
        let fields = fields.filter(|fields| fields.len() == session.fields.len());
        session.fields = fields.ok_or_else(|| refuse("its bent targets are of another problem"))?;
        session.best_wire = saved.best_wire;
        session.tally = Tally {
            best_points: saved.best_points,
            best_loss: saved.best_loss.unwrap_or(f32::INFINITY),
            gradient_norms: saved.gradient_norms,
        };
        session.plane_points = match (&session.problem.surface, saved.plane_points.is_empty()) {
            (None, _) => Vec::new(),
            // The pull begins here.
            (Some(_), true) => state.points.clone(),
            (Some(_), false) => saved.plane_points,
        };
        session.strand_points = match (&session.problem.recipe.smooth, saved.strand_points.is_empty()) {
            (None, _) => Vec::new(),
            (Some(_), true) => state.points.clone(),
            (Some(_), false) => saved.strand_points,
        };
        session.speed = 0.0;
        session.iteration = saved.iteration;
        session.halvings = saved.halvings;
        session.wire = saved.wire;
        session.state = state;
        session.good = good;
        session.gradient_count = saved.gradient_count;
        session.rng = saved.rng;
        session.history = saved.history;
        session.events = saved.events;
        Ok(session)
    }
}
