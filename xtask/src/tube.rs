//! A wire drawn as the round, dark metal it is: the balls along it with a depth buffer, lit from the upper left.
//!
//! Three cues say what is in front. Near is darker than far, light falls on a round surface (Lambert 1760; the highlight is
//! Blinn's of 1977), and a strand leaves a gap beside it in what passes well behind it (the haloed lines of Appel, Rohlf
//! and Stein 1979).

use image::{GrayImage, Luma, imageops};
use wire4d_core::view::View;
use wire4d_core::wire::Wire;

/// The ground's grey, 0 to 255.
pub const PAPER: u8 = 255;
/// Drawn so many times larger, then averaged down.
const OVERSAMPLING: usize = 4;
/// Balls are no farther apart than this share of their radius, and no strand looks thinner than this diameter, px drawn.
const STEP: f64 = 0.15;
const THINNEST_PX: f64 = 3.0;
/// Towards the light and half way to it from the eye: right, up, towards the eye.
const LIGHT: [f64; 3] = [-0.48, 0.62, 0.62];
const HALFWAY: [f64; 3] = [-0.267, 0.345, 0.9];
/// Grey of the metal, of 1: in shadow, what light adds, and the highlight.
const SHADOW: f64 = 0.04;
const LIT: f64 = 0.34;
const SHINE: f64 = 0.5;
/// Share of the way to the paper's grey at the far end of the object, and nothing at the near one.
const HAZE: f64 = 0.55;
/// Width of the gap beside a strand in radii, and the share of what lies in it that is left out.
const GAP: f64 = 0.6;
const LEFT_OUT: f64 = 0.8;
/// How far behind a strand something must be for the gap to begin and to be whole, world units.
const BEHIND: [f64; 2] = [0.06, 0.14];

/// What one place of the picture shows.
#[derive(Clone, Copy)]
struct Place {
    /// From the eye, world units.
    depth: f64,
    /// Grey of the metal, before haze.
    grey: f64,
    /// Nearest strand whose gap this lies in.
    gap: f64,
}

/// The wire in a view, at the view's own size, dark on [`PAPER`].
pub fn draw(wire: &Wire, view: &View) -> GrayImage {
    let (width, height) = (view.width_px * OVERSAMPLING, view.height_px * OVERSAMPLING);
    let balls = balls(wire, &view.with_size(width, height));
    let mut places = vec![Place { depth: f64::INFINITY, grey: 1.0, gap: f64::INFINITY }; width * height];
    balls.iter().for_each(|ball| ball.cover(&mut places, [width, height]));
    let depths = || balls.iter().map(|ball| ball.depth);
    let (near, far) = (depths().fold(f64::INFINITY, f64::min), depths().fold(f64::NEG_INFINITY, f64::max));
    let grey = |place: &Place| {
        if place.depth == f64::INFINITY {
            return PAPER;
        }
        let haze = HAZE * (place.depth - near) / (far - near).max(1e-9);
        let hidden = (place.depth - place.gap - BEHIND[0]) / (BEHIND[1] - BEHIND[0]);
        let paper = 1.0 - (1.0 - haze.clamp(0.0, 1.0)) * (1.0 - LEFT_OUT * hidden.clamp(0.0, 1.0));
        let metal = 255.0 * place.grey;
        (metal + paper * (f64::from(PAPER) - metal)).round() as u8
    };
    let large =
        GrayImage::from_fn(width as u32, height as u32, |x, y| Luma([grey(&places[y as usize * width + x as usize])]));
    imageops::resize(&large, view.width_px as u32, view.height_px as u32, imageops::FilterType::Triangle)
}

/// One ball of the wire in a view.
struct Ball {
    x_px: f64,
    y_px: f64,
    radius_px: f64,
    depth: f64,
    /// World units a pixel.
    unit: f64,
}

/// The curve as chords from point to next point, `[x, y, z, width]` each; a closed one ends where it begins.
pub fn chords(wire: &Wire) -> Vec<[[f64; 4]; 2]> {
    let (map, strokes) = wire.sampling_map::<f64>(8, false);
    let mut points = Vec::new();
    map.apply(wire.control_points(), &mut points);
    let mut chords = Vec::new();
    for stroke in strokes {
        let points = &points[stroke.start..stroke.start + stroke.count];
        let ends = points.iter().zip(points.iter().cycle().skip(1));
        let count = if stroke.closed { stroke.count } else { stroke.count - 1 };
        chords.extend(ends.take(count).map(|(&a, &b)| [a, b]));
    }
    chords
}

/// Balls along the wire, close enough for their union to look like a tube.
fn balls(wire: &Wire, view: &View) -> Vec<Ball> {
    let camera = view.camera::<f64>();
    let ball = |point: &[f64; 4]| {
        let [x_px, y_px, radius_px] = camera.project(point);
        let unit = 0.5 * point[3].max(1e-9) / radius_px.max(1e-9);
        Ball { x_px, y_px, radius_px: radius_px.max(0.5 * THINNEST_PX), depth: camera.depth(point), unit }
    };
    let mut balls = Vec::new();
    for [a, b] in chords(wire) {
        let [from, to] = [&a, &b].map(ball);
        let apart = (to.x_px - from.x_px).hypot(to.y_px - from.y_px).hypot((to.depth - from.depth) / from.unit);
        let steps = (apart / (STEP * from.radius_px)).ceil().clamp(1.0, 1e4) as usize;
        let between = |k: usize| [0, 1, 2, 3].map(|c| a[c] + (b[c] - a[c]) * k as f64 / steps as f64);
        balls.extend((0..steps).map(|k| ball(&between(k))));
    }
    balls
}

impl Ball {
    /// Puts what can be seen of it, and its gap, into the picture.
    fn cover(&self, places: &mut [Place], [width, height]: [usize; 2]) {
        let reach = self.radius_px * (1.0 + GAP);
        let range = |middle: f64, size: usize| {
            let to = (middle + reach).ceil().clamp(0.0, size as f64) as usize;
            (middle - reach).floor().clamp(0.0, size as f64) as usize..to
        };
        for row in range(self.y_px, height) {
            for column in range(self.x_px, width) {
                let x = (column as f64 + 0.5 - self.x_px) / self.radius_px;
                let y = (self.y_px - row as f64 - 0.5) / self.radius_px;
                let square = x * x + y * y;
                let place = &mut places[row * width + column];
                if square < (1.0 + GAP).powi(2) {
                    place.gap = place.gap.min(self.depth);
                }
                if square < 1.0 {
                    let z = (1.0 - square).sqrt();
                    let depth = self.depth - z * self.radius_px * self.unit;
                    if depth < place.depth {
                        (place.depth, place.grey) = (depth, lit([x, y, z]));
                    }
                }
            }
        }
    }
}

/// Grey of metal with this unit normal, 0 to 1.
fn lit(normal: [f64; 3]) -> f64 {
    let towards = |direction: [f64; 3]| (0..3).map(|c| normal[c] * direction[c]).sum::<f64>().max(0.0);
    (SHADOW + LIT * towards(LIGHT) + SHINE * towards(HALFWAY).powi(24)).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use wire4d_core::view::ViewSpec;

    /// Two straight strands 0.2 wide and parallel to x or y, each at its own height above the picture.
    fn crossing(level: f64, upright: f64) -> Wire {
        let line = |at: fn(f64, f64) -> [f64; 4], z: f64| (0..4).map(move |k| at(f64::from(k) / 1.5 - 1.0, z));
        let points = line(|t, z| [t, 0.0, z, 0.2], level).chain(line(|t, z| [0.0, t, z, 0.2], upright));
        Wire::uniform(wire4d_core::wire::Form::Bag, false, points.collect()).unwrap()
    }

    fn seen(wire: &Wire, view: &str) -> GrayImage {
        draw(wire, &view.parse::<ViewSpec>().unwrap().resolve(&[], 2.2, 110).unwrap())
    }

    fn grey(picture: &GrayImage, x: i32, y: i32) -> u8 {
        picture.get_pixel((55 + x) as u32, (55 - y) as u32).0[0]
    }

    #[test]
    fn what_is_in_front_is_seen_whole_and_cuts_what_is_behind() {
        let front = seen(&crossing(0.3, -0.3), "0,0");
        let behind = seen(&crossing(-0.3, 0.3), "0,0");
        // 6 px beside the crossing there is a strand behind, or the gap that the one in front leaves.
        assert!(grey(&front, 6, 0) < 150 && grey(&front, 0, 6) > 200, "{} {}", grey(&front, 6, 0), grey(&front, 0, 6));
        assert!(grey(&behind, 0, 6) < 150 && grey(&behind, 6, 0) > 200);
        // From behind it is the other way round.
        let back = seen(&crossing(0.3, -0.3), "180,0");
        assert!(grey(&back, 0, 6) < 150 && grey(&back, 6, 0) > 200);
        // Far is paler, and the ground is paper.
        assert!(grey(&front, 25, 0) + 40 < grey(&front, 0, 25));
        assert_eq!(grey(&front, 30, 30), PAPER);
    }

    #[test]
    fn light_comes_from_the_upper_left() {
        let picture = seen(&crossing(0.0, 0.0), "0,0");
        assert!(grey(&picture, 25, 2) > grey(&picture, 25, -3) + 40, "above and below the level one");
        assert!(grey(&picture, -3, 25) > grey(&picture, 2, 25) + 40, "left and right of the upright one");
    }

    #[test]
    fn hair_and_what_lies_outside_are_drawn_without_fault() {
        let points = [[-90.0, 0.0, 0.0, 0.0], [-0.5, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0], [90.0, 0.0, 0.0, 0.0]];
        let picture = seen(&Wire::open_uniform(points.to_vec()).unwrap(), "0,0");
        assert!(
            (0..110).all(|x| picture.get_pixel(x, 55).0[0] < PAPER - 40 || picture.get_pixel(x, 54).0[0] < PAPER - 40)
        );
        assert_eq!(grey(&picture, 0, 20), PAPER);
    }
}
