//! Files and links from a sculpture: tube meshes (GLB, STL, OBJ), drawings and centre lines (SVG), bend lists, share codes.

mod bend;
mod format;
mod glb;
mod lines;
mod mesh;
mod obj;
mod seen;
mod share;
mod stl;
mod svg;
mod tube;

pub use bend::bend_csv;
pub use format::{ExportOptions, Format, export};
pub use glb::glb;
pub use lines::lines;
pub use mesh::TriangleMesh;
pub use obj::obj;
pub use share::{Simplified, open_link, open_share_code, share_code, simplified_code};
pub use stl::stl;
pub use svg::{SvgOptions, svg};
pub use tube::{TubeOptions, tube};
