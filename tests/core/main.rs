//! What the wire is made of and moved by: spline, views, rasteriser, losses, optimiser, starts, figures.

#[path = "../support/export_support/mod.rs"]
mod export_support;
#[path = "../../benches/projection_error/figure.rs"]
mod figure;
mod filling;
mod guidance;
#[path = "../support/guided/mod.rs"]
mod guided;
mod metrics_elegance;
mod metrics_shape;
#[path = "../support/optimize_common/mod.rs"]
mod optimize_common;
mod optimize_crew;
mod optimize_gradient;
mod optimize_occlusion;
mod optimize_refit;
mod optimize_session;
mod optimize_smooth;
mod raster_coincident;
mod raster_gradient;
mod raster_properties;
mod raster_reference;
#[path = "../support/raster_wires/mod.rs"]
mod raster_wires;
mod rational_reference;
#[path = "../../benches/rational/reference.rs"]
mod reference;
mod start_views;
mod texture;
mod view_projection;
