//! Every setting there is, once, in [`TABLE`]. The command line's flags, the page's controls, the saved file and the link are
//! all made from it, so they cannot drift apart.

mod parsing;
mod schema;
mod table;
mod task;
mod words;

pub use schema::{Affects, Group, Kind, Of, Setting};
pub use table::{Settings, TABLE};
pub use task::Task;
pub use words::{
    Backend, Bend, Flow, Hatching, Ink, Looks, Motif, NewPoint, OnOff, Preset, Pyramid, Read, Shade, Shading, Start,
    Turn, Width,
};
