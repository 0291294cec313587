//! The wire that is bought, and how many pieces of it are needed.

use crate::{Centreline, Metal};
use serde::Serialize;
use wire4d_core::{Error, Result};

/// Shorter pieces are joints and nothing else, mm.
pub const MIN_STOCK_MM: f64 = 50.0;
/// A piece may be cut shorter by this share, so that its end lies where the wire is straight.
const SLACK: f64 = 0.15;

/// What is in the shop.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Stock {
    /// What it is made of.
    pub metal: Metal,
    /// Its thickness, mm.
    pub gauge_mm: f64,
    /// How long a piece of it is, mm.
    pub length_mm: f64,
}

impl Default for Stock {
    fn default() -> Self {
        Stock { metal: Metal::Copper, gauge_mm: 1.6, length_mm: 5000.0 }
    }
}

/// Pieces of stock for a wire.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Pieces {
    /// How many.
    pub count: usize,
    /// Where two ends meet, mm from the start; with 0 where a closed wire's ends do.
    pub joints_mm: Vec<f64>,
}

impl Stock {
    /// Lays pieces along the wire, with joints in straight places.
    ///
    /// # Errors
    /// [`Error::Setting`] for stock that is too short.
    pub fn pieces(&self, line: &Centreline) -> Result<Pieces> {
        if !(MIN_STOCK_MM..=1e9).contains(&self.length_mm) {
            return Err(Error::setting(
                "--stock-mm",
                format!("{} mm is no length of wire to work with", self.length_mm),
                format!("give {MIN_STOCK_MM} mm or more"),
            ));
        }
        let (step, steps) = (line.step_mm(), line.steps());
        let piece = ((self.length_mm / step).floor() as usize).max(1);
        // No joint may cost one more piece.
        let spare = steps.div_ceil(piece) * piece - steps;
        let slack = ((SLACK * piece as f64) as usize).min(spare / steps.div_ceil(piece));
        let mut joints_mm: Vec<f64> = line.closed().then_some(0.0).into_iter().collect();
        let mut start = 0;
        while steps - start > piece {
            let latest = start + piece;
            let earliest = latest - slack;
            let turn = |i: usize| line.tangent(i - 1).angle_between(line.tangent(i + 1));
            // The latest of the straightest.
            start =
                (earliest.max(start + 1)..=latest).rev().min_by(|&a, &b| turn(a).total_cmp(&turn(b))).unwrap_or(latest);
            joints_mm.push(start as f64 * step);
        }
        Ok(Pieces { count: joints_mm.len() + usize::from(!line.closed()), joints_mm })
    }
}
