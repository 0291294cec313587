//! Photographs: the object, and its lines, against scenes of known truth.

mod cuts;
mod drawings;
mod judge;
mod kinds;
#[path = "../support/photo_judge/mod.rs"]
mod photo_judge;
mod poor_pictures;
#[path = "../support/scenes/mod.rs"]
mod scenes;
mod scenes_are_true;
mod wires;
