//! Pulls a wire towards its targets: problem and recipe (pure data), session, engines, Adam, edits of the topology.

mod adam;
mod bending;
mod checkpoint;
mod cpu;
mod engine;
mod handed;
mod history;
mod insight;
mod problem;
mod pull;
mod recipe;
mod reinit;
mod schedule;
mod session;
mod smooth;
mod term;
mod topology;

pub use crate::work::{Work, wait};
pub use adam::{Adam, AdamOptions, SecondMoment};
pub use bending::Bending;
pub use checkpoint::Checkpoint;
pub use cpu::{Answer, Courier, CpuEngine, Mate};
pub use engine::{Engine, FindNeighbours, Picture, Place, Scene, SceneView, State, Step, Tally};
pub use history::{Event, EventKind, History};
pub use insight::{Insight, Level, Pull};
pub use problem::{Problem, Seen, WidthBounds};
pub use pull::SurfacePull;
pub use recipe::{RasterKind, Recipe, Stage};
pub use reinit::{NewPoint, Reinit};
pub use schedule::Schedule;
pub use session::Session;
pub use smooth::Smooth;
pub use term::{Term, term_count};
pub use topology::{Moment, Refine, Respace, Thin, TopologyEdit, TopologyEvent};
