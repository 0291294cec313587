//! Which lines are drawn: greedily, what says most that those before it do not.

use super::edges::Scored;
use super::line::length;
use super::{Budget, Kind, Line};
use crate::view::PixelBox;

/// A line nearer than this to one that is drawn is that one, and one that runs along within the second distance says
/// less; px where the object is 512 px large.
const SAME: f32 = 9.0;
const BESIDE: f32 = 22.0;
/// How much less a line beside others says, and from which cosine it runs along.
const REPEATS: f32 = 0.6;
const ALONG: f32 = 0.9;
/// Shortest piece that is drawn of a line, px where the object is 512 px large.
const SHORT: f32 = 14.0;
/// Length of a line, share of the object, that it need not exceed; contrast likewise.
const LONG: f32 = 0.6;
const CONTRAST: f32 = 40.0;
/// How much more a closed line says.
const CLOSED: f32 = 1.3;
/// Bends that are no fault, radians a step, and how much more is.
const CALM: [f32; 2] = [0.15, 1.2];

/// What is drawn so far, by place: how far it is, and which way it runs.
struct Drawn {
    corner: [f32; 2],
    width: usize,
    height: usize,
    squared: Vec<f32>,
    tangent: Vec<[f32; 2]>,
    reach: f32,
}

impl Drawn {
    fn add(&mut self, points: &[[f32; 2]]) {
        for (k, p) in points.iter().enumerate() {
            // Places two pixels apart are near enough for distances of nine and more.
            if k % 2 == 1 && k + 1 != points.len() {
                continue;
            }
            let tangent = tangent(points, k);
            let [px, py] = [p[0] - self.corner[0], p[1] - self.corner[1]];
            let range = |c: f32, side: usize| {
                (c - self.reach).max(0.0) as usize..((c + self.reach + 1.0).max(0.0) as usize).min(side)
            };
            for y in range(py, self.height) {
                for x in range(px, self.width) {
                    let squared = (x as f32 + 0.5 - px).powi(2) + (y as f32 + 0.5 - py).powi(2);
                    let at = y * self.width + x;
                    if squared < self.squared[at] {
                        self.squared[at] = squared;
                        self.tangent[at] = tangent;
                    }
                }
            }
        }
    }

    fn at(&self, p: &[f32; 2]) -> usize {
        let place = |c: f32, corner: f32, side: usize| ((c - corner).max(0.0) as usize).min(side - 1);
        place(p[1], self.corner[1], self.height) * self.width + place(p[0], self.corner[0], self.width)
    }

    /// Share of a line that is new, less what runs along what is drawn.
    fn new_share(&self, points: &[[f32; 2]], scale: f32) -> f32 {
        let (mut same, mut beside) = (0.0f32, 0.0f32);
        for (k, p) in points.iter().enumerate() {
            let at = self.at(p);
            let [t, d] = [tangent(points, k), self.tangent[at]];
            same += f32::from(u8::from(self.squared[at] < (SAME * scale).powi(2)));
            let along = (t[0] * d[0] + t[1] * d[1]).abs() > ALONG && self.squared[at] < (BESIDE * scale).powi(2);
            beside += f32::from(u8::from(along));
        }
        let count = points.len() as f32;
        let (same, beside) = (same / count, beside / count);
        if same > 0.98 { 0.0 } else { (1.0 - same).powf(1.5) * (1.0 - REPEATS * beside) }
    }
}

fn tangent(points: &[[f32; 2]], k: usize) -> [f32; 2] {
    let (a, b) = (points[k.saturating_sub(2)], points[(k + 2).min(points.len() - 1)]);
    let size = (b[0] - a[0]).hypot(b[1] - a[1]).max(1e-6);
    [(b[0] - a[0]) / size, (b[1] - a[1]) / size]
}

/// How much a line says by itself, 1 for the best there can be.
fn value(line: &Scored, size: f32) -> f32 {
    let long = (line.length.min(LONG * size) / (LONG * size)).powf(0.7);
    let strong = line.contrast.min(CONTRAST) / CONTRAST;
    let closed = if line.closed { CLOSED } else { 1.0 };
    let restless = (-CALM[1] * (line.turning - CALM[0]).max(0.0)).exp();
    long * strong * line.isolation * line.coherence.max(0.0).sqrt() * restless * closed
}

/// Outlines, then inner lines as far as the budget goes. All lie in `part` of
/// the photograph; widths are contrasts still.
pub fn chosen(
    outlines: Vec<Vec<[f32; 2]>>,
    inner: Vec<Scored>,
    part: PixelBox,
    size: f32,
    budget: Budget,
) -> Vec<Line> {
    let scale = (size / 512.0).clamp(0.5, 1.0);
    let (width, height) = (part.width(), part.height());
    let mut drawn = Drawn {
        corner: [part.left as f32, part.top as f32],
        width,
        height,
        squared: vec![f32::INFINITY; width * height],
        tangent: vec![[0.0; 2]; width * height],
        reach: BESIDE * scale,
    };
    let mut total = 0.0;
    let mut lines = Vec::new();
    for points in outlines {
        drawn.add(&points);
        total += length(&points);
        lines.push(Line { points, width_px: 20.0, importance: 1.0, kind: Kind::Outline });
    }
    let values: Vec<f32> = inner.iter().map(|line| value(line, size)).collect();
    // What a line says can only become less, so the one on top that is up to date is the best.
    let mut open: Vec<(f32, usize, usize)> = values.iter().enumerate().map(|(i, &v)| (v, 0, i)).collect();
    let mut version = 1;
    loop {
        let full = match budget {
            Budget::Lines(most) => lines.len() >= most,
            Budget::Length(most) => total >= most * size,
            Budget::Importance(_) => false,
        };
        let least = if let Budget::Importance(least) = budget { least } else { 1e-6 };
        let Some(best) = (0..open.len()).max_by(|&a, &b| open[a].0.total_cmp(&open[b].0).then(b.cmp(&a))) else {
            break;
        };
        let (worth, known, i) = open[best];
        if full || worth < least {
            break;
        }
        let line = &inner[i];
        if known != version {
            open[best] = (values[i] * drawn.new_share(&line.points, scale), version, i);
            continue;
        }
        open.swap_remove(best);
        for points in new_parts(&line.points, &drawn, scale) {
            drawn.add(&points);
            total += length(&points);
            version += 1;
            lines.push(Line { points, width_px: line.contrast, importance: worth.min(1.0), kind: Kind::Inner });
        }
    }
    lines
}

/// The stretches of a line that are not drawn yet; short gaps within are kept.
fn new_parts(points: &[[f32; 2]], drawn: &Drawn, scale: f32) -> Vec<Vec<[f32; 2]>> {
    let far = |p: &[f32; 2]| drawn.squared[drawn.at(p)] >= (0.6 * SAME * scale).powi(2);
    let mut keep: Vec<bool> = points.iter().map(far).collect();
    if keep.iter().all(|&keep| keep) {
        return vec![points.to_vec()];
    }
    // Gaps of up to ten points between new stretches close.
    let mut last = None;
    for k in 0..keep.len() {
        if keep[k] {
            if let Some(last) = last
                && k - last <= 11
            {
                keep[last..k].fill(true);
            }
            last = Some(k);
        }
    }
    let mut parts = vec![Vec::new()];
    for (p, keep) in points.iter().zip(keep) {
        if keep {
            parts.last_mut().expect("there is always one").push(*p);
        } else if parts.last().is_some_and(|part| !part.is_empty()) {
            parts.push(Vec::new());
        }
    }
    parts.retain(|part| length(part) >= SHORT * scale);
    parts
}
