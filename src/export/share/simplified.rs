//! A wire too long for a link, made simpler until it fits: fewer control points, laid by least squares along the same
//! curve, on a coarser grid.

use super::code_of;
use super::grid::{Sight, rounded_coarsely};
use crate::sculpture::Sculpture;
use crate::wire::{Form, LinearMap, Wire};
use serde::Serialize;

/// A code that shows nearly the same wire.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Simplified {
    /// As from [`super::share_code`].
    pub code: String,
    /// How far the curve and its radius move at most in any view, in pixels of a view of 512 px.
    pub most_px: f64,
    /// The same in the mean along the wire, over all views.
    pub mean_px: f64,
}

/// Control points are rounded to steps of about a pixel.
const COARSER: f64 = 1.8;
/// Tries until the number of control points is right.
const TRIES: usize = 7;
const FEWEST: usize = 24;
/// Places at which curves are compared, for each control point.
const COMPARED: usize = 8;
/// Of conjugate gradients; the equations are well conditioned.
const STEPS: usize = 40;

/// A code of at most `max_characters`; `None` where nothing like the wire is as short, and for loose Béziers.
pub fn simplified_code(sculpture: &Sculpture, max_characters: usize) -> Option<Simplified> {
    let wire = &sculpture.wire;
    if wire.form() != Form::Spline {
        return None;
    }
    let sight = Sight::new(sculpture);
    let all = wire.control_points().len();
    // Characters grow with control points, nearly in proportion.
    let (mut count, mut best) = (all, None);
    let (mut fits, mut too_many) = (FEWEST, all + 1);
    for _ in 0..TRIES {
        let simpler = Sculpture { wire: with_fewer_points(wire, count)?, ..sculpture.clone() };
        let code = code_of(&simpler, rounded_coarsely(&simpler, COARSER));
        let length = code.len();
        if length <= max_characters {
            best = Some(code);
            fits = count;
        } else {
            too_many = count;
        }
        let wanted = (count as f64 * 0.995 * max_characters as f64 / length as f64) as usize;
        let next = wanted.clamp(fits.saturating_add(1), too_many.saturating_sub(1).max(fits));
        if too_many <= fits + 1 || next <= fits + all / 200 {
            break;
        }
        count = next;
    }
    let code = best?;
    let opened = super::open_share_code(&code).ok()?;
    let along = |wire: &Wire| -> Vec<[f64; 4]> {
        let (start, end) = wire.domain();
        let count = COMPARED * all;
        (0..=count).map(|k| wire.evaluate(start + (end - start) * k as f64 / count as f64)).collect()
    };
    let (most_px, mean_px) = sight.apart_px(&along(wire), &along(&opened.wire));
    Some(Simplified { code, most_px, mean_px })
}

/// The spline with evenly spaced knots that is nearest to the curve at equal shares of its knots' range.
fn with_fewer_points(wire: &Wire, count: usize) -> Option<Wire> {
    let all = wire.control_points().len();
    if count >= all {
        return Some(wire.clone());
    }
    let blank = Wire::uniform(Form::Spline, wire.closed(), vec![[0.0; 4]; count]).ok()?;
    let samples = (2 * all).div_ceil(count) + 1;
    let (map, _) = blank.sampling_map::<f64>(samples, false);
    let ([from, to], [start, end]) = (<[f64; 2]>::from(blank.domain()), <[f64; 2]>::from(wire.domain()));
    let at = |t: f64| wire.evaluate((start + (end - start) * (t - from) / (to - from)).clamp(start, end));
    let curve: Vec<_> = blank.sample_parameters(samples).into_iter().map(at).collect();
    let mut simpler = blank;
    let mut points = least_squares(&map, &curve);
    points.iter_mut().for_each(|point| point[3] = point[3].max(0.0));
    simpler.set_control_points(&points).ok()?;
    Some(simpler)
}

/// The inputs whose outputs are nearest to `wanted`.
fn least_squares(map: &LinearMap<f64>, wanted: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let dot = |a: &[[f64; 4]], b: &[[f64; 4]]| -> f64 {
        a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| a * b).sum()
    };
    let add = |a: &mut [[f64; 4]], scale: f64, b: &[[f64; 4]]| {
        a.iter_mut().flatten().zip(b.iter().flatten()).for_each(|(a, b)| *a += scale * b);
    };
    let mut points = vec![[0.0; 4]; map.columns()];
    let mut rest = points.clone();
    map.apply_transpose(wanted, &mut rest);
    let mut direction = rest.clone();
    let mut left = dot(&rest, &rest);
    let enough = left * 1e-16;
    let (mut outputs, mut turned) = (Vec::new(), points.clone());
    for _ in 0..STEPS {
        map.apply(&direction, &mut outputs);
        let energy = dot(&outputs, &outputs);
        if left <= enough || energy <= 0.0 {
            break;
        }
        turned.fill([0.0; 4]);
        map.apply_transpose(&outputs, &mut turned);
        add(&mut points, left / energy, &direction);
        add(&mut rest, -left / energy, &turned);
        let now = dot(&rest, &rest);
        let mut next = rest.clone();
        add(&mut next, now / left, &direction);
        (direction, left) = (next, now);
    }
    points
}
