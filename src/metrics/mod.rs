//! Numbers about a sculpture: how well pictures match, how many parts the wire shows, how long and how bent it is.
//!
//! The definitions are those of the README's table of figures; every figure says its unit, and lengths are in units where
//! the object fits the unit ball.

mod connectivity;
mod elegance;
mod evenness;
mod lines;
pub mod perceptual;
mod picture;
mod pieces;
mod report;
mod shape;
mod surface;

pub use elegance::{Elegance, Faults, GAUGE, TIGHT_GAUGES, elegance};
pub use evenness::Evenness;
pub use lines::length_over_lines;
pub use picture::{PictureMatch, match_pictures, match_pictures_with, precision_2px, psnr_db, recall_2px, soft_iou};
pub use report::{
    ArrangementReport, AskedReport, BentReport, DistillationReport, EventReport, GuidanceReport, NetworkReport,
    REPORT_SIZE_PX, ReadingReport, Report, ResultReport, TimeReport, ViewReport, WordsReport,
};
pub use shape::{ShapeMetrics, shape};
pub use surface::SurfaceReport;
