//! Numbers that change over a run, as data.

use crate::{Error, Result};

/// A value as a function of progress, 0 at the run's start and 1 at its end.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Schedule {
    /// Always the same.
    Constant(f64),
    /// Half a cosine wave from `from` to `to`.
    Cosine {
        /// Value at the start.
        from: f64,
        /// Value at the end.
        to: f64,
    },
    /// By a constant factor an iteration from `from` to `to`, reached at progress `until` and kept. Both positive.
    Geometric {
        /// Value at the start.
        from: f64,
        /// Value from `until` on.
        to: f64,
        /// Progress at which `to` is reached.
        until: f64,
    },
    /// Straight lines through `[progress, value]` points in ascending order; constant before the first and after the last.
    Piecewise(Vec<[f64; 2]>),
}

impl Schedule {
    /// The value at `progress` (0 to 1).
    pub fn at(&self, progress: f64) -> f64 {
        match self {
            Schedule::Constant(value) => *value,
            Schedule::Cosine { from, to } => {
                to + (from - to) * 0.5 * (1.0 + (std::f64::consts::PI * progress.clamp(0.0, 1.0)).cos())
            }
            Schedule::Geometric { from, to, until } => {
                let share = if *until > 0.0 { (progress / until).clamp(0.0, 1.0) } else { 1.0 };
                from * (to / from).powf(share)
            }
            Schedule::Piecewise(points) => match points.iter().position(|point| point[0] > progress) {
                None => points.last().map_or(0.0, |last| last[1]),
                Some(0) => points[0][1],
                Some(i) => {
                    let ([t0, a], [t1, b]) = (points[i - 1], points[i]);
                    a + (b - a) * (progress - t0) / (t1 - t0)
                }
            },
        }
    }

    /// The same schedule times `factor`.
    pub fn scaled(&self, factor: f64) -> Schedule {
        match self {
            Schedule::Constant(value) => Schedule::Constant(value * factor),
            Schedule::Cosine { from, to } => Schedule::Cosine { from: from * factor, to: to * factor },
            // No factor leads from nothing to nothing.
            Schedule::Geometric { .. } if factor == 0.0 => Schedule::Constant(0.0),
            Schedule::Geometric { from, to, until } => {
                Schedule::Geometric { from: from * factor, to: to * factor, until: *until }
            }
            Schedule::Piecewise(points) => {
                Schedule::Piecewise(points.iter().map(|&[t, value]| [t, value * factor]).collect())
            }
        }
    }

    /// An error that names the setting unless every value is finite and at least 0.
    pub fn check(&self, name: &str) -> Result<()> {
        let good = |value: f64| value.is_finite() && value >= 0.0;
        let fine = match self {
            Schedule::Constant(value) => good(*value),
            Schedule::Cosine { from, to } => good(*from) && good(*to),
            Schedule::Geometric { from, to, until } => {
                let positive = |value: f64| value.is_finite() && value > 0.0;
                positive(*from) && positive(*to) && good(*until)
            }
            Schedule::Piecewise(points) => {
                !points.is_empty()
                    && points.iter().all(|point| point[0].is_finite() && good(point[1]))
                    && points.windows(2).all(|pair| pair[0][0] < pair[1][0])
            }
        };
        if fine {
            return Ok(());
        }
        Err(Error::setting(
            name,
            format!("the schedule {self:?} is not one of finite values from 0 up"),
            "give finite values, above 0 in a geometric schedule, and piecewise points in ascending order",
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_at_the_ends_and_between() {
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert_eq!(Schedule::Constant(3.0).at(0.4), 3.0);
        let cosine = Schedule::Cosine { from: 1.0, to: 0.05 };
        assert!(near(cosine.at(0.0), 1.0) && near(cosine.at(1.0), 0.05) && near(cosine.at(0.5), 0.525));
        let geometric = Schedule::Geometric { from: 1e-3, to: 1e-4, until: 0.5 };
        assert!(near(geometric.at(0.0), 1e-3) && near(geometric.at(0.25), 1e-3 / 10f64.sqrt()));
        assert!(near(geometric.at(0.5), 1e-4) && near(geometric.at(0.9), 1e-4));
        let piecewise = Schedule::Piecewise(vec![[0.2, 1.0], [0.6, 3.0]]);
        assert!(near(piecewise.at(0.0), 1.0) && near(piecewise.at(0.4), 2.0) && near(piecewise.at(1.0), 3.0));
        for schedule in [cosine, geometric, piecewise] {
            assert!(near(schedule.scaled(2.0).at(0.3), 2.0 * schedule.at(0.3)));
            assert!(schedule.check("x").is_ok());
            assert!(schedule.scaled(0.0).check("x").is_ok() && schedule.scaled(0.0).at(0.3) == 0.0);
        }
    }

    #[test]
    fn nonsense_is_named() {
        for bad in [
            Schedule::Constant(f64::NAN),
            Schedule::Constant(-1.0),
            Schedule::Cosine { from: f64::INFINITY, to: 0.0 },
            Schedule::Geometric { from: 0.0, to: 1.0, until: 1.0 },
            Schedule::Piecewise(vec![]),
            Schedule::Piecewise(vec![[0.5, 1.0], [0.5, 2.0]]),
        ] {
            assert!(matches!(bad.check("rate"), Err(Error::Setting { name, .. }) if name == "rate"), "{bad:?}");
        }
    }
}
