//! The paper's error figure: how far projected Bézier control points are from the projected curve, by pieces a span.

use std::fmt::Write;
use wire4d::{
    rng::Rng,
    view::{Projection, View, projection_error_bound_px},
    wire::Wire,
};

/// One column of the figure: every span cut into `pieces`.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    /// Bézier pieces a span.
    pub pieces: usize,
    /// Largest bound of any piece, px.
    pub bound_px: f64,
    /// Largest distance at equal parameters, px.
    pub largest_px: f64,
    /// Mean distance at equal parameters, px.
    pub mean_px: f64,
    /// Largest distance square to the curve, px: what a picture shows.
    pub drawn_px: f64,
    /// The paper's measure: both curves resampled by arc length, mean distance over the diagonal of the projection's box.
    pub by_arc_length: f64,
    /// Largest share of its own bound that any piece uses: at most 1 if the bound holds.
    pub bound_used: f64,
}

/// Samples a piece at which distances are taken.
const SAMPLES: usize = 16;

/// Wires of `control_points` through a greedy tour of random points in a ball; several, each seen from several sides.
pub fn columns(control_points: usize) -> Vec<Column> {
    let wires: Vec<Wire> = (0..3).map(|seed| tour(control_points, seed)).collect();
    let views: Vec<View> = (0..4).map(|k| view(f64::from(k) * 1.7, f64::from(k) * 0.4 - 0.6)).collect();
    [1, 2, 4, 8, 16, 32, 64].into_iter().map(|pieces| column(&wires, &views, pieces)).collect()
}

/// The paper's camera: 20° at 3.8, 512 px.
pub fn view(azimuth_rad: f64, elevation_rad: f64) -> View {
    let mut view = View::orthographic("figure", azimuth_rad, elevation_rad, 2.0, 512);
    view.eye = view.eye.map(|c| c * 3.8 / 3.0);
    view.projection = Projection::Perspective { fov_y_rad: 20f64.to_radians() };
    view
}

/// A clamped spline along a short tour of random points in a ball of radius 0.8: each followed by the nearest one left,
/// then pieces turned round while that shortens it (2-opt).
pub fn tour(count: usize, seed: u64) -> Wire {
    let mut rng = Rng::new(seed, 3);
    let mut left: Vec<[f64; 3]> = (0..count).map(|_| rng.in_ball(0.8)).collect();
    let mut at = left.pop().expect("at least one point");
    let mut points = vec![at];
    while !left.is_empty() {
        let distance = |p: &[f64; 3]| (0..3).map(|c| (p[c] - at[c]).powi(2)).sum::<f64>();
        let next = (0..left.len()).min_by(|&a, &b| distance(&left[a]).total_cmp(&distance(&left[b])));
        at = left.swap_remove(next.expect("not empty"));
        points.push(at);
    }
    let distance = |p: &[f64; 3], q: &[f64; 3]| (0..3).map(|c| (p[c] - q[c]).powi(2)).sum::<f64>().sqrt();
    let mut shorter = true;
    while std::mem::take(&mut shorter) {
        for i in 0..points.len().saturating_sub(3) {
            for j in i + 2..points.len() - 1 {
                let [a, b, c, d] = [i, i + 1, j, j + 1].map(|k| &points[k]);
                if distance(a, c) + distance(b, d) < distance(a, b) + distance(c, d) - 1e-9 {
                    points[i + 1..=j].reverse();
                    shorter = true;
                }
            }
        }
    }
    Wire::open_uniform(points.into_iter().map(|[x, y, z]| [x, y, z, 0.02]).collect()).expect("a valid wire")
}

fn column(wires: &[Wire], views: &[View], pieces: usize) -> Column {
    let mut out = Column {
        pieces,
        bound_px: 0.0,
        largest_px: 0.0,
        mean_px: 0.0,
        drawn_px: 0.0,
        by_arc_length: 0.0,
        bound_used: 0.0,
    };
    let mut count = 0usize;
    for wire in wires {
        let mut points = Vec::new();
        wire.subdivision_map::<f64>(&vec![pieces; wire.spans().count()]).apply(wire.control_points(), &mut points);
        for camera in views.iter().map(View::camera::<f64>) {
            let (mut exact, mut approximate) = (Vec::new(), Vec::new());
            for bezier in points.as_chunks::<4>().0 {
                let [bound, _] = projection_error_bound_px(&camera, bezier);
                out.bound_px = out.bound_px.max(bound);
                let projected = bezier.map(|point| camera.project(&point));
                let mut worst = 0.0f64;
                for j in 0..=SAMPLES {
                    let weights = bernstein(j as f64 / SAMPLES as f64);
                    let sum = |c: usize| (0..4).map(|k| weights[k] * bezier[k][c]).sum::<f64>();
                    let [x, y, _] = camera.project(&[sum(0), sum(1), sum(2), sum(3)]);
                    let flat = [0, 1].map(|c| (0..4).map(|k| weights[k] * projected[k][c]).sum::<f64>());
                    let error = (x - flat[0]).hypot(y - flat[1]);
                    worst = worst.max(error);
                    out.mean_px += error;
                    count += 1;
                    exact.push([x, y]);
                    approximate.push(flat);
                }
                out.largest_px = out.largest_px.max(worst);
                // Rounding alone makes differences of 1e-13 px where the bound is 0.
                out.bound_used = out.bound_used.max(worst / (bound + 1e-12));
            }
            out.drawn_px = out.drawn_px.max(largest_square_distance(&exact, &approximate));
            out.by_arc_length += arc_length_distance(&exact, &approximate) / (wires.len() * views.len()) as f64;
        }
    }
    out.mean_px /= count as f64;
    out
}

fn bernstein(s: f64) -> [f64; 4] {
    let r = 1.0 - s;
    [r * r * r, 3.0 * r * r * s, 3.0 * r * s * s, s * s * s]
}

/// Largest distance from the approximate points to the exact polyline near them.
fn largest_square_distance(exact: &[[f64; 2]], approximate: &[[f64; 2]]) -> f64 {
    let to_segment = |p: [f64; 2], a: [f64; 2], b: [f64; 2]| {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length2 = dx * dx + dy * dy;
        let t = if length2 > 0.0 { (((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2).clamp(0.0, 1.0) } else { 0.0 };
        (p[0] - a[0] - t * dx).hypot(p[1] - a[1] - t * dy)
    };
    let near = |i: usize| {
        let range = i.saturating_sub(4)..(i + 4).min(exact.len() - 1);
        range.map(|k| to_segment(approximate[i], exact[k], exact[k + 1])).fold(f64::INFINITY, f64::min)
    };
    (0..exact.len()).map(near).fold(0.0, f64::max)
}

/// Mean distance of both polylines resampled at equal shares of their length, over the diagonal of the exact one's box.
fn arc_length_distance(exact: &[[f64; 2]], approximate: &[[f64; 2]]) -> f64 {
    const COUNT: usize = 2000;
    let [a, b] = [exact, approximate].map(|points| resampled(points, COUNT));
    let mean = a.iter().zip(&b).map(|(p, q)| (p[0] - q[0]).hypot(p[1] - q[1])).sum::<f64>() / COUNT as f64;
    let extent = |c: usize| {
        let values = || exact.iter().map(|p| p[c]);
        values().fold(f64::MIN, f64::max) - values().fold(f64::MAX, f64::min)
    };
    mean / extent(0).hypot(extent(1))
}

fn resampled(points: &[[f64; 2]], count: usize) -> Vec<[f64; 2]> {
    let mut lengths = vec![0.0];
    for pair in points.windows(2) {
        let step = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        lengths.push(lengths[lengths.len() - 1] + step);
    }
    let total = lengths[lengths.len() - 1];
    let mut at = 0;
    let place = |i: usize| {
        let wanted = total * i as f64 / (count - 1) as f64;
        while at + 2 < lengths.len() && lengths[at + 1] < wanted {
            at += 1;
        }
        let share = ((wanted - lengths[at]) / (lengths[at + 1] - lengths[at]).max(1e-300)).clamp(0.0, 1.0);
        [0, 1].map(|c| points[at][c] + share * (points[at + 1][c] - points[at][c]))
    };
    (0..count).map(place).collect()
}

/// Slope of `log y` over `log(1 / pieces)` by least squares: 2 if the error falls with the square of the length.
pub fn slope(columns: &[Column], value: impl Fn(&Column) -> f64) -> f64 {
    let points: Vec<[f64; 2]> = columns.iter().map(|c| [-(c.pieces as f64).ln(), value(c).ln()]).collect();
    let mean = [0, 1].map(|c| points.iter().map(|p| p[c]).sum::<f64>() / points.len() as f64);
    let moment = |c: usize| points.iter().map(|p| (p[0] - mean[0]) * (p[c] - mean[c])).sum::<f64>();
    moment(1) / moment(0)
}

/// The figure: error in pixels over pieces a span, both logarithmic.
pub fn svg(columns: &[Column]) -> String {
    let x = |pieces: f64| 70.0 + 75.0 * pieces.log2();
    let y = |px: f64| 40.0 + 46.0 * (1.0 - px.max(1e-6).log10());
    let mut out = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 680 440\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"680\" height=\"440\" fill=\"#fff\"/>\n",
    );
    let mut line = |text: String| {
        out.push_str(&text);
        out.push('\n');
    };
    for power in -6..=1 {
        let level = y(10f64.powi(power));
        line(format!("<path d=\"M70 {level:.1} H520\" stroke=\"#ddd\"/>"));
        line(format!(
            "<text x=\"62\" y=\"{:.1}\" text-anchor=\"end\" fill=\"#444\">{}</text>",
            level + 4.0,
            10f64.powi(power)
        ));
    }
    for column in columns {
        let place = x(column.pieces as f64);
        line(format!("<path d=\"M{place:.1} 40 V362\" stroke=\"#ddd\"/>"));
        line(format!("<text x=\"{place:.1}\" y=\"380\" text-anchor=\"middle\" fill=\"#444\">{}</text>", column.pieces));
    }
    line("<text x=\"295\" y=\"402\" text-anchor=\"middle\">Bézier pieces a span</text>".into());
    line("<text x=\"70\" y=\"24\">error of projected control points, px of 512</text>".into());
    let tenth = y(0.1);
    line(format!("<path d=\"M70 {tenth:.1} H520\" stroke=\"#888\" stroke-dasharray=\"5 4\"/>"));
    type Series = (&'static str, &'static str, fn(&Column) -> f64);
    let series: [Series; 4] = [
        ("bound", "#b3261e", |c| c.bound_px),
        ("largest", "#1f5fbf", |c| c.largest_px),
        ("mean", "#2e8b57", |c| c.mean_px),
        ("as drawn", "#8a5cc2", |c| c.drawn_px),
    ];
    for (name, colour, value) in series {
        let mut path = String::new();
        for (i, column) in columns.iter().enumerate() {
            let command = if i == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{command}{:.1} {:.1} ", x(column.pieces as f64), y(value(column)));
        }
        line(format!("<path d=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>", path.trim_end()));
        let Some(last) = columns.last() else { continue };
        // Over the finest four: where the leading term leads.
        let label = format!("{name}, slope {:.1}", slope(&columns[columns.len().saturating_sub(4)..], value));
        line(format!("<text x=\"530\" y=\"{:.1}\" fill=\"{colour}\">{label}</text>", y(value(last)) + 4.0));
    }
    if let [first, .., last] = columns {
        line(format!(
            "<text x=\"70\" y=\"428\" fill=\"#444\">resampled by arc length, mean over the box's diagonal: {:.0e} at {}, {:.0e} at {} pieces</text>",
            first.by_arc_length, first.pieces, last.by_arc_length, last.pieces
        ));
    }
    out.push_str("</svg>\n");
    out
}
