//! Wire4D turns pictures into wire art: **one continuous 4D wire**, a cubic B-spline with position and width, is
//! optimised by differentiable rendering until its views match what a person asked for.
//!
//! # Spaces and units
//!
//! | space | axes | unit | where |
//! |---|---|---|---|
//! | parameter | `t` along the knots | knot units | [`wire`] |
//! | world | right-handed, y up; the object fits the unit ball | world units; width is the full diameter | [`wire`], [`view`] |
//! | camera | x right, y up, depth positive away from the eye | world units | [`view`] |
//! | pixel | x right, y **down**, pixel centres at +0.5 | px; radius is the half width | [`raster`], [`view::Image`] |
//!
//! # Data flows one way
//!
//! control points → samples ([`wire::LinearMap`]) → pixels ([`view::Camera`]) → coverage ([`raster`]) → loss
//! ([`objective`]) and the adjoints back the same way; [`optimize::Session`] drives it, [`tasks`] says what to drive.

#[cfg(feature = "files")]
pub mod files;

pub use wire4d_core::{
    Error, Result, error, geometry, mesh, objective, optimize, parallel, raster, rng, segment, sorting, view, wire,
};
#[cfg(feature = "files")]
pub use wire4d_model as model;

pub mod picture;
pub mod start;

#[cfg(feature = "gpu")]
pub mod gpu;

pub mod sculpture;

pub mod export;
pub mod metrics;

pub mod settings;
pub mod tasks;

/// What the README shows compiles.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(test)]
#[path = "core/few_cases.rs"]
mod few_cases;
