//! Files and links from a sculpture: tube meshes (GLB, STL, OBJ), drawings and centre lines (SVG), bend lists, share codes;
//! and back from those that carry it.

mod bend;
mod capsule;
mod format;
mod glb;
mod lines;
mod mesh;
mod obj;
mod open;
mod seen;
mod share;
mod stl;
mod svg;
mod tube;

pub use bend::bend_csv;
pub use capsule::in_png;
pub use format::{ExportOptions, Format, export};
pub use glb::glb;
pub use lines::lines;
pub use mesh::TriangleMesh;
pub use obj::obj;
pub use open::{MAX_CARRIER_BYTES, Opened, open_file};
pub use share::replay;
pub use share::{Simplified, open_link, open_share_code, share_code, simplified_code};
pub use stl::stl;
pub use svg::{SvgOptions, svg};
pub use tube::{TubeOptions, tube};
