//! The wire at its true size, at even steps of arc length.

use glam::DVec3;
use wire4d_core::wire::{Form, Wire};
use wire4d_core::{Error, Result};

/// Sizes that can be built, mm.
pub const MIN_SIZE_MM: f64 = 10.0;
/// Longer than that nobody bends by hand.
pub const MAX_SIZE_MM: f64 = 5000.0;
/// Gauges that can be bent by hand, mm.
pub const MIN_GAUGE_MM: f64 = 0.2;
/// Thicker wire is a rod.
pub const MAX_GAUGE_MM: f64 = 10.0;
/// A wire is at least so many gauges across: anything less is a lump.
const LEAST_GAUGES: f64 = 4.0;

/// Samples a knot span from which places are looked up by arc length.
const SAMPLES_PER_SPAN: usize = 16;
/// Steps a gauge.
const STEPS_PER_GAUGE: f64 = 4.0;
/// Bounds the work for very long wires.
const MOST_STEPS: f64 = 200_000.0;
const FEWEST_STEPS: f64 = 64.0;

/// The middle of the wire, mm. The middle of its box is the origin; y is up, z towards who looks at the front.
#[derive(Debug, Clone)]
pub struct Centreline {
    points: Vec<DVec3>,
    tangents: Vec<DVec3>,
    closed: bool,
    length_mm: f64,
    gauge_mm: f64,
    mm_per_world: f64,
    middle_world: DVec3,
}

impl Centreline {
    /// The longest side of the box round the wire's middle is `size_mm` long.
    ///
    /// # Errors
    /// [`Error::Setting`] for a size or gauge that cannot be built, [`Error::Wire`] for one without length and for a bag
    /// of loose curves.
    pub fn new(wire: &Wire, size_mm: f64, gauge_mm: f64) -> Result<Centreline> {
        check_range("--size-mm", size_mm, [MIN_SIZE_MM, MAX_SIZE_MM], "the longest side")?;
        check_range("--wire-mm", gauge_mm, [MIN_GAUGE_MM, MAX_GAUGE_MM], "the wire's thickness")?;
        if LEAST_GAUGES * gauge_mm > size_mm {
            return Err(Error::setting(
                "--wire-mm",
                format!("a wire {gauge_mm} mm thick makes no sculpture {size_mm} mm across"),
                format!("give at most {} mm, or a larger --size-mm", size_mm / LEAST_GAUGES),
            ));
        }
        let points = wire.control_points().len();
        if wire.form() == Form::Bag {
            return Err(Error::wire(
                "wire",
                format!("is a bag of {} loose curves, which hold nothing together", points / 4),
                "make it with --form wire",
            ));
        }
        let parameters = parameters(wire);
        let places: Vec<DVec3> = parameters.iter().map(|&t| place(wire, t)).collect();
        let low = places.iter().copied().reduce(DVec3::min).unwrap_or_default();
        let high = places.iter().copied().reduce(DVec3::max).unwrap_or_default();
        let longest = (high - low).max_element();
        if longest <= 1e-9 {
            return Err(Error::wire("wire", "all of it lies in one place", "open another wire"));
        }
        let (mm_per_world, middle_world) = (size_mm / longest, 0.5 * (low + high));

        let mut along = vec![0.0];
        along.extend(places.windows(2).scan(0.0, |sum, pair| {
            *sum += pair[0].distance(pair[1]) * mm_per_world;
            Some(*sum)
        }));
        let length_mm = along[along.len() - 1];
        let steps = (length_mm / gauge_mm * STEPS_PER_GAUGE).ceil().clamp(FEWEST_STEPS, MOST_STEPS) as usize;
        let count = if wire.closed() { steps } else { steps + 1 };
        let mut cell = 0;
        let even = (0..count).map(|i| {
            let s = length_mm * i as f64 / steps as f64;
            while cell + 2 < along.len() && along[cell + 1] < s {
                cell += 1;
            }
            let share = ((s - along[cell]) / (along[cell + 1] - along[cell]).max(1e-300)).clamp(0.0, 1.0);
            parameters[cell] + share * (parameters[cell + 1] - parameters[cell])
        });
        let even: Vec<f64> = even.collect();
        let points: Vec<DVec3> = even.iter().map(|&t| (place(wire, t) - middle_world) * mm_per_world).collect();
        let tangents = even.iter().enumerate().map(|(i, &t)| {
            let [x, y, z, _] = wire.derivative(t, 1);
            // Where the curve stands still, along its chord.
            let ends = if wire.closed() {
                [points[(i + count - 1) % count], points[(i + 1) % count]]
            } else {
                [points[i.saturating_sub(1)], points[(i + 1).min(count - 1)]]
            };
            DVec3::new(x, y, z).try_normalize().or_else(|| (ends[1] - ends[0]).try_normalize()).unwrap_or(DVec3::X)
        });
        let tangents = tangents.collect();
        Ok(Centreline { points, tangents, closed: wire.closed(), length_mm, gauge_mm, mm_per_world, middle_world })
    }

    /// Places at even steps; a closed wire's last is a step before its first.
    pub fn points(&self) -> &[DVec3] {
        &self.points
    }

    /// Unit directions at the places.
    pub fn tangents(&self) -> &[DVec3] {
        &self.tangents
    }

    /// Whether the ends meet.
    pub fn closed(&self) -> bool {
        self.closed
    }

    /// Of all of it, mm.
    pub fn length_mm(&self) -> f64 {
        self.length_mm
    }

    /// Thickness, mm.
    pub fn gauge_mm(&self) -> f64 {
        self.gauge_mm
    }

    /// How much a world unit is.
    pub fn mm_per_world(&self) -> f64 {
        self.mm_per_world
    }

    /// Between two places, mm.
    pub fn step_mm(&self) -> f64 {
        self.length_mm / self.steps() as f64
    }

    /// Steps in all.
    pub fn steps(&self) -> usize {
        if self.closed { self.points.len() } else { self.points.len() - 1 }
    }

    /// The place after so many steps; round and round if closed.
    pub fn point(&self, i: usize) -> DVec3 {
        self.points[self.index(i)]
    }

    /// The direction after so many steps.
    pub fn tangent(&self, i: usize) -> DVec3 {
        self.tangents[self.index(i)]
    }

    /// Back in the wire's own units.
    pub fn to_world(&self, point: DVec3) -> [f64; 3] {
        (point / self.mm_per_world + self.middle_world).to_array()
    }

    /// Half the box round the wire's middle, mm.
    pub fn half_box_mm(&self) -> DVec3 {
        self.points.iter().map(|point| point.abs()).fold(DVec3::ZERO, DVec3::max)
    }

    fn index(&self, i: usize) -> usize {
        if self.closed { i % self.points.len() } else { i.min(self.points.len() - 1) }
    }
}

fn check_range(name: &str, given: f64, [least, most]: [f64; 2], what: &str) -> Result<()> {
    if (least..=most).contains(&given) {
        return Ok(());
    }
    Err(Error::setting(name, format!("{given} mm cannot be built"), format!("give {what} as {least} to {most} mm")))
}

/// Along the whole curve, in order, its end included.
fn parameters(wire: &Wire) -> Vec<f64> {
    let mut parameters: Vec<f64> = wire
        .spans()
        .flat_map(|span| {
            let step = (span.end - span.start) / SAMPLES_PER_SPAN as f64;
            (0..SAMPLES_PER_SPAN).map(move |j| span.start + j as f64 * step)
        })
        .collect();
    parameters.push(wire.domain().1);
    parameters
}

fn place(wire: &Wire, t: f64) -> DVec3 {
    let [x, y, z, _] = wire.evaluate(t);
    DVec3::new(x, y, z)
}
