//! Photographs of a wire: three lamps, three shadows, and light that goes on from wall to wire to wall, by path tracing.
//!
//! The wire is exact: cones between balls, not triangles. Same setting, same seed: same picture, bit for bit, on any number of
//! threads.

mod cone;
mod film;
mod lamp;
mod lens;
mod matter;
mod paths;
mod sampler;
mod setting;
mod strands;

pub use film::{Develop, Film};
pub use glam::Vec3;
pub use lens::Lens;
pub use setting::{Arrangement, Finish, Place, Setting, Sky, WALL_AWAY};
