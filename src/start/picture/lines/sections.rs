//! Section lines: thin lines round the solid that keep it a body when it is turned, where the picture has no lines for that.
//!
//! A view turned by some angle ends where the solid's surface turns away from it: its contour there. Seen from the front,
//! the contour of one side on the solid's front and that of the other turn on its back are one line, so it is drawn once
//! and walked twice, a ring that leaves the rim and comes back to it.

use super::Lines;
use super::strokes::pixels;
use crate::picture::{Ink, Mask};
use crate::start::Solid;

/// Turn whose contours are drawn, radians: 35 degrees, about as far as a sculpture is turned to be seen as one.
const TURN: f64 = 0.610_865;
/// Rows are this far apart, px at 256.
const ROW_PX: f64 = 2.0;
/// The rim does for the contour that lies this near to it when turned, px at 256.
const NEAR_PX: f64 = 1.2;
/// Contours are followed to where they are this near to the rim.
const MET_PX: f64 = 0.7;
/// From row to row a contour moves aside at most this much, px at 256.
const STEP_PX: f64 = 10.0;
/// Thinnest body that a section goes round, px at 256: the two strands of one round a thinner body touch, and show.
const THINNEST_PX: f64 = 10.0;
/// Shorter stretches of contours say nothing, share of the object's height.
const SHORTEST: f64 = 0.25;
/// Standard deviation of the smoothing along a contour, rows.
const SMOOTHING_ROWS: f64 = 3.0;

/// A section line from rim to rim.
struct Section {
    /// Its corners, px of the picture.
    points: Vec<[f64; 2]>,
    /// How much of the turned contours nothing else shows, px.
    gain_px: f64,
    length_px: f64,
    /// How much of it shows from the front beside what is drawn, px.
    shown_px: f64,
}

impl Lines {
    /// With thin lines round the solid, those that say the most for their length, together at most `share` as long as the
    /// lines that are drawn. Where the drawing has lines already they say more, since they show less.
    pub fn with_sections(mut self, solid: &Solid, share: f64) -> Lines {
        let mut left = share * self.on.thin().count() as f64;
        let mut found = self.found_sections(solid);
        let worth = |section: &Section| section.gain_px / (section.length_px + section.shown_px);
        found.sort_by(|a, b| worth(b).total_cmp(&worth(a)));
        for section in found {
            if section.length_px > left {
                continue;
            }
            left -= section.length_px;
            let corners: Vec<[f32; 2]> = section.points.iter().map(|p| p.map(|c| c as f32)).collect();
            for i in pixels(&corners, self.side) {
                self.sections.data[i] = true;
                self.back.data[i] = true;
            }
        }
        self
    }

    /// Every contour of the solid turned either way, in stretches.
    fn found_sections(&self, solid: &Solid) -> Vec<Section> {
        let scale = self.side as f64 / 256.0;
        let body = self.object.threshold(0.5);
        let Some(extent) = body.bounding_box() else { return Vec::new() };
        let to_ink = self.on.distance_px().data;
        let row = ROW_PX * scale;
        let rows: Vec<Vec<Place>> = (0..(extent.height() as f64 / row) as usize)
            .map(|k| (extent.top as f64 + (k as f64 + 0.5) * row) as usize)
            .map(|y| places(&body, solid, y))
            .collect();
        let least = SHORTEST * extent.height() as f64;
        let mut sections = Vec::new();
        for sign in [-1.0, 1.0] {
            for chain in chains(&rows, sign, STEP_PX * scale, MET_PX * scale) {
                let gain_px = row * chain.iter().filter(|place| place.beyond > NEAR_PX * scale).count() as f64;
                if gain_px < least {
                    continue;
                }
                let points = self.to_rim(smoothed(&chain));
                let length = |p: &[[f64; 2]]| (p[0][0] - p[1][0]).hypot(p[0][1] - p[1][1]);
                let shown = |p: &[[f64; 2]]| {
                    let middle =
                        [0, 1].map(|c| (0.5 * (p[0][c] + p[1][c])).clamp(0.0, self.side as f64 - 1.0) as usize);
                    let is_shown = to_ink[middle[1] * self.side + middle[0]] > (NEAR_PX * scale) as f32;
                    if is_shown { length(p) } else { 0.0 }
                };
                let length_px = points.windows(2).map(length).sum();
                let shown_px = points.windows(2).map(shown).sum();
                sections.push(Section { points, gain_px, length_px, shown_px });
            }
        }
        sections
    }

    /// With both ends led to the nearest pixel of the rim.
    fn to_rim(&self, mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        let ends = [points.first(), points.last()].map(|end| end.and_then(|&end| self.nearest_rim(end)));
        if let [Some(first), Some(last)] = ends {
            points.insert(0, first);
            points.push(last);
        }
        points
    }
}

/// Where a row's part of the solid ends when it is turned, one way (-1) or the other (1).
#[derive(Debug, Clone, Copy)]
struct Place {
    sign: f64,
    x: f64,
    y: f64,
    /// How much farther out than the rim it is then, px.
    beyond: f64,
}

/// The contours' places in row `y`: two for each stretch of the body.
fn places(body: &Mask, solid: &Solid, y: usize) -> Vec<Place> {
    let side = body.width;
    let px = solid.height_world() / side as f64;
    let (sin, cos) = TURN.sin_cos();
    let world = |x: usize| (x as f64 + 0.5 - 0.5 * side as f64) * px;
    let down = (0.5 * side as f64 - y as f64 - 0.5) * px;
    let mut found = Vec::new();
    let mut x = 0;
    while x < side {
        if !body.at(x, y) {
            x += 1;
            continue;
        }
        let from = x;
        while x < side && body.at(x, y) {
            x += 1;
        }
        for sign in [-1.0, 1.0] {
            // Half the thickness, so that front and back count alike.
            let out = |x: usize| {
                let [back, front] = solid.depths(world(x), down);
                sign * world(x) * cos + 0.5 * (front - back) * sin
            };
            let best = (from..x).max_by(|&a, &b| out(a).total_cmp(&out(b)).then(b.cmp(&a))).unwrap_or(from);
            let [back, front] = solid.depths(world(best), down);
            if (front - back) / px < THINNEST_PX * side as f64 / 256.0 {
                continue;
            }
            let rim = if sign < 0.0 { from } else { x - 1 };
            let beyond = (out(best) - sign * world(rim) * cos) / px;
            found.push(Place { sign, x: best as f64 + 0.5, y: y as f64 + 0.5, beyond });
        }
    }
    found
}

/// Places of one sign in neighbouring rows, joined where they lie at most `step` aside and all are beyond the rim.
fn chains(rows: &[Vec<Place>], sign: f64, step: f64, met: f64) -> Vec<Vec<Place>> {
    let mut open: Vec<Vec<Place>> = Vec::new();
    let mut ended = Vec::new();
    for row in rows {
        let mut next: Vec<Vec<Place>> = Vec::new();
        for &place in row.iter().filter(|place| place.sign == sign && place.beyond > met) {
            let aside = |chain: &Vec<Place>| chain.last().map_or(f64::INFINITY, |last| (last.x - place.x).abs());
            let nearest = (0..open.len()).min_by(|&a, &b| aside(&open[a]).total_cmp(&aside(&open[b])));
            let mut chain = match nearest.filter(|&k| aside(&open[k]) < step) {
                Some(k) => open.swap_remove(k),
                None => Vec::new(),
            };
            chain.push(place);
            next.push(chain);
        }
        ended.append(&mut open);
        open = next;
    }
    ended.append(&mut open);
    ended
}

/// A chain's places, smoothed along it, its ends held.
fn smoothed(chain: &[Place]) -> Vec<[f64; 2]> {
    let reach = (3.0 * SMOOTHING_ROWS) as usize;
    let at = |k: usize| {
        // The same reach on both sides keeps straight stretches and ends where they are.
        let reach = reach.min(k).min(chain.len() - 1 - k);
        let weighted = (k - reach..=k + reach).map(|n| {
            let far = (n as f64 - k as f64) / SMOOTHING_ROWS;
            ((-0.5 * far * far).exp(), chain[n].x)
        });
        let (weights, sum) =
            weighted.fold((0.0, 0.0), |(weights, sum), (weight, x)| (weights + weight, sum + weight * x));
        [sum / weights, chain[k].y]
    };
    (0..chain.len()).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::start::picture::lines::{Hatching, LineOptions, Stroke};
    use crate::start::{Path, SolidOptions};
    use crate::view::{Image, View};

    const SIDE: usize = 256;

    fn picture(value: impl Fn(f32, f32) -> bool) -> Image {
        let at = |i: usize| f32::from(value((i % SIDE) as f32 - 127.5, (i / SIDE) as f32 - 127.5));
        Image { width: SIDE, height: SIDE, data: (0..SIDE * SIDE).map(at).collect() }
    }

    fn outline(points: Vec<[f32; 2]>) -> Stroke {
        Stroke { points, width_px: 3.0, is_outline: true }
    }

    fn circle() -> Stroke {
        let at = |k: usize| (k as f32 * 0.01 * std::f32::consts::TAU).sin_cos();
        outline((0..=100).map(at).map(|(sin, cos)| [128.0 + 99.0 * cos, 128.0 + 99.0 * sin]).collect())
    }

    /// The solid of a silhouette, and the lines drawn of it.
    fn drawn(mask: &Image, strokes: &[Stroke]) -> (Solid, Lines) {
        let options = LineOptions {
            hatching: Hatching::Auto,
            spacing_px: 12.0,
            outline_px: 3.0,
            edges: 1.0,
            tone: 1.0,
            saliency: 0.0,
            gloss: 0.0,
            width_px: [1.0, 20.0],
        };
        (
            Solid::inflated("thing", mask, &SolidOptions::default()).unwrap(),
            Lines::of_strokes(mask, &Image::new(SIDE, SIDE), strokes, &options),
        )
    }

    /// Share of the solid's border that has some of the path within 2 px, seen turned by `degrees`.
    fn rim_shown(solid: &Solid, path: &Path, degrees: f64) -> f64 {
        let view = View::orthographic("turned", degrees.to_radians(), 0.0, solid.height_world(), SIDE);
        let camera = view.camera::<f64>();
        let mut met = Mask::new(SIDE, SIDE);
        for point in &path.points {
            let [u, v, _] = camera.project(point);
            met.data[v as usize * SIDE + u as usize] = true;
        }
        let (far, depth) =
            (met.distance_px().data, solid.silhouette(&view).threshold(0.5).inverted().distance_px().data);
        let rim: Vec<usize> = (0..SIDE * SIDE).filter(|&i| depth[i] > 0.0 && depth[i] < 1.5).collect();
        rim.iter().filter(|&&i| far[i] <= 2.5).count() as f64 / rim.len() as f64
    }

    #[test]
    fn a_ball_stays_one_when_it_is_turned() {
        let (solid, lines) = drawn(&picture(|x, y| x.hypot(y) < 100.0), &[circle()]);
        let ink = lines.ink(SIDE);
        let flat = [-35.0, 35.0].map(|turn| rim_shown(&solid, &lines.walk(&solid, 0.005), turn));
        let round = lines.with_sections(&solid, 1.0);
        assert_eq!(round.ink(SIDE), ink, "they are not drawn");
        let path = round.walk(&solid, 0.005);
        let turned = [-35.0, 35.0].map(|turn| rim_shown(&solid, &path, turn));
        assert!(flat.iter().all(|&shown| shown < 0.5), "{flat:?}");
        assert!(turned.iter().all(|&shown| shown > 0.9), "{turned:?}");
    }

    #[test]
    fn sections_keep_within_their_share_and_a_thin_thing_needs_none() {
        let ball = || drawn(&picture(|x, y| x.hypot(y) < 100.0), &[circle()]);
        let sections = |share: f64| {
            let (solid, lines) = ball();
            lines.with_sections(&solid, share).sections.count()
        };
        let (none, one, both) = (sections(0.1), sections(0.5), sections(1.0));
        assert!(none == 0 && one > 150 && both > one + 150, "{none} {one} {both}");
        let corners = [[124.0, 40.0], [132.0, 40.0], [132.0, 216.0], [124.0, 216.0], [124.0, 40.0]];
        let (rod, lines) = drawn(&picture(|x, y| x.abs() < 4.0 && y.abs() < 88.0), &[outline(corners.to_vec())]);
        assert_eq!(lines.with_sections(&rod, 1.0).sections.count(), 0);
    }

    #[test]
    fn a_line_from_rim_to_rim_goes_on_round_the_back_and_others_do_not() {
        let across =
            |from: f32, to: f32| Stroke { points: vec![[from, 128.0], [to, 128.0]], width_px: 3.0, is_outline: false };
        let behind = |stroke: Stroke| {
            let (solid, lines) = drawn(&picture(|x, y| x.hypot(y) < 100.0), &[circle(), stroke]);
            lines.walk(&solid, 0.005).points.iter().any(|p| p[2] < -0.5 && p[1].abs() < 0.05)
        };
        assert!(behind(across(34.0, 222.0)), "its ends are led to the rim");
        assert!(!behind(across(34.0, 128.0)) && !behind(across(100.0, 150.0)));
    }
}
