//! A plausible solid behind one silhouette: two height fields over the picture, one for the front and one for the back.

mod shown;

use super::envelope::{FAR, lower_envelope};
use crate::error::{Error, Result};
use crate::picture::{Ink, Mask};
use crate::rng::Rng;
use crate::start::Path;
use crate::start::ball::spread_points;
use crate::start::tour::short_tour;
use crate::view::{Image, View};

/// How thick a silhouette becomes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolidOptions {
    /// Half thickness as a share of the way to the outline: 1 makes a ball of a disc, 0 nearly a sheet.
    pub roundness: f64,
    /// Largest half thickness as a share of half the silhouette's smaller side.
    pub most_depth: f64,
}

impl Default for SolidOptions {
    fn default() -> Self {
        SolidOptions { roundness: 0.9, most_depth: 1.0 }
    }
}

/// A solid seen from the front as its silhouette. It fits the unit ball.
#[derive(Debug, Clone)]
pub struct Solid {
    inside: Mask,
    /// World z of front and back in each cell; 0 outside.
    front: Image,
    back: Image,
    /// World units in a cell.
    cell_world: f64,
}

/// Cells along each side of the grid.
const CELLS: usize = 128;
/// Thinnest half thickness, cells: a sheet is a solid too.
const THINNEST: f32 = 0.75;
/// Standard deviation of the smoothing of heights, cells.
const SMOOTHING: f64 = 2.0;

impl Solid {
    /// The solid of a square picture of its silhouette (0 to 1): the union of all balls about the picture's plane that
    /// the silhouette holds, so that a disc becomes a ball and a bar a rod, flattened to `roundness`.
    ///
    /// # Errors
    /// [`Error::Picture`] with `name` if the silhouette is empty.
    pub fn inflated(name: &str, body: &Image, options: &SolidOptions) -> Result<Solid> {
        let inside = body.resized(CELLS, CELLS).threshold(0.4);
        let Some(extent) = inside.bounding_box() else {
            return Err(Error::picture(name, "is too small to make a solid of", "use a picture with a larger object"));
        };
        let radius = inside.inverted().distance_px();
        // Minus the squared radius, as the envelope takes the least.
        let mut squared: Vec<f32> =
            radius.data.iter().map(|r| if *r > 0.0 { -(r - 0.5).powi(2) } else { FAR }).collect();
        lower_envelope(&mut squared, CELLS);
        let cap = (options.most_depth * 0.5 * extent.width().min(extent.height()) as f64) as f32;
        let height = |(square, inside): (&f32, &bool)| {
            let height = (-square).max(0.0).sqrt() * options.roundness as f32;
            if *inside { height.min(cap).max(THINNEST) } else { 0.0 }
        };
        let front = Image { width: CELLS, height: CELLS, data: squared.iter().zip(&inside.data).map(height).collect() };
        let front = smoothed(front, &inside);
        let back = Image { data: front.data.iter().map(|z| -z).collect(), ..front };
        let mut solid = Solid { inside, front, back, cell_world: 1.0 };
        solid.fit_unit_ball();
        Ok(solid)
    }

    /// Lifts the front where `relief` (square, 0 to 1, 0.5 for as it is) is high and lowers it where it is low, by up to
    /// `share` of the greatest half thickness.
    pub fn with_relief(mut self, relief: &Image, share: f64) -> Solid {
        let relief = relief.resized(CELLS, CELLS).blurred(1.5);
        let reach = 2.0 * share as f32 * self.front.data.iter().copied().fold(0.0, f32::max);
        for i in self.cells() {
            let least = self.back.data[i] + THINNEST * self.cell_world as f32;
            self.front.data[i] = (self.front.data[i] + reach * (relief.data[i] - 0.5)).max(least);
        }
        self.fit_unit_ball();
        self
    }

    /// Follows a depth picture (square, 1 nearest, 0 farthest): its range becomes the solid's depth, and the solid a third
    /// as thick as it was.
    pub fn with_depth(mut self, depth: &Image) -> Solid {
        let depth = depth.resized(CELLS, CELLS);
        let range = self.cells().map(|i| depth.data[i]).fold([1.0f32, 0.0], |[low, high], d| [low.min(d), high.max(d)]);
        let reach = self.front.data.iter().copied().fold(0.0, f32::max);
        for i in self.cells() {
            let middle = reach * (2.0 * (depth.data[i] - range[0]) / (range[1] - range[0]).max(1e-3) - 1.0);
            self.front.data[i] = middle + self.front.data[i] / 3.0;
            self.back.data[i] = middle + self.back.data[i] / 3.0;
        }
        self.fit_unit_ball();
        self
    }

    /// The visual hull of this silhouette and others (square pictures of the same scale): the thickness comes from them
    /// alone. Where nothing is left behind a cell, the cell goes.
    ///
    /// # Errors
    /// [`Error::Pictures`] if the silhouettes have nothing in common.
    pub fn carved(mut self, others: &[(View, Image)]) -> Result<Solid> {
        let cameras: Vec<_> =
            others.iter().map(|(view, mask)| (view.with_size(mask.width, mask.height).camera::<f64>(), mask)).collect();
        let step = self.cell_world;
        for i in self.cells().collect::<Vec<_>>() {
            let [x, y] = self.place(i);
            let inside = |z: f64| {
                cameras.iter().all(|(camera, mask)| {
                    let [u, v, _] = camera.project(&[x, y, z, 0.0]);
                    let within = u >= 0.0 && v >= 0.0 && u < mask.width as f64 && v < mask.height as f64;
                    within && mask.sample(u as f32, v as f32) > 0.5
                })
            };
            let depths = || (-(CELLS as i32)..=CELLS as i32).map(|k| 0.5 * f64::from(k) * step).filter(|&z| inside(z));
            match depths().fold(None, |range: Option<[f64; 2]>, z| Some([range.map_or(z, |[low, _]| low), z])) {
                Some([back, front]) => {
                    self.back.data[i] = (back - 0.25 * step) as f32;
                    self.front.data[i] = (front + 0.25 * step) as f32;
                }
                None => {
                    self.inside.data[i] = false;
                    (self.back.data[i], self.front.data[i]) = (0.0, 0.0);
                }
            }
        }
        if self.inside.count() == 0 {
            return Err(Error::Pictures {
                problem: "the silhouettes have nothing in common, so no solid shows them together".into(),
                remedy: "check the sides the pictures are seen from".into(),
            });
        }
        self.fit_unit_ball();
        Ok(self)
    }

    /// World height (and width) of the square picture the silhouette came from.
    pub fn height_world(&self) -> f64 {
        CELLS as f64 * self.cell_world
    }

    /// World z of `[back, front]` at a place; outside, that of the nearest cells (`None` far off).
    pub fn depths(&self, x: f64, y: f64) -> [f64; 2] {
        let [u, v] = [0.5 * CELLS as f64 + x / self.cell_world, 0.5 * CELLS as f64 - y / self.cell_world];
        [&self.back, &self.front].map(|field| f64::from(field.sample(u as f32, v as f32)))
    }

    /// Whether a point of the world lies inside.
    pub fn contains(&self, [x, y, z]: [f64; 3]) -> bool {
        let [u, v] = [0.5 * CELLS as f64 + x / self.cell_world, 0.5 * CELLS as f64 - y / self.cell_world];
        let on = u >= 0.0 && v >= 0.0 && u < CELLS as f64 && v < CELLS as f64;
        on && self.inside.at(u as usize, v as usize) && {
            let i = v as usize * CELLS + u as usize;
            (f64::from(self.back.data[i])..=f64::from(self.front.data[i])).contains(&z)
        }
    }

    /// The paper's start: `count` points spread evenly inside, joined by a short tour, all of one width.
    pub fn tour(&self, count: usize, width_world: f64, seed: u64) -> Path {
        let cells: Vec<usize> = self.cells().collect();
        // Deep cells hold more of the solid.
        let mut running = 0.0;
        let cumulative: Vec<f64> = cells
            .iter()
            .map(|&i| {
                running += f64::from(self.front.data[i] - self.back.data[i]);
                running
            })
            .collect();
        let mut rng = Rng::new(seed, 0x736f_6c69);
        let points = spread_points(count, || {
            let at = rng.range(0.0, running);
            let i = cells[cumulative.partition_point(|&sum| sum <= at).min(cells.len() - 1)];
            let [x, y] = self.place(i);
            let jitter = 0.5 * self.cell_world;
            [
                x + rng.range(-jitter, jitter),
                y + rng.range(-jitter, jitter),
                rng.range(self.back.data[i].into(), self.front.data[i].into()),
            ]
        });
        let order = short_tour(&points, false);
        let points = order.into_iter().map(|i| points[i as usize]).map(|[x, y, z]| [x, y, z, width_world]);
        Path { points: points.collect(), closed: false }
    }

    fn cells(&self) -> impl Iterator<Item = usize> + use<> {
        let inside = self.inside.data.clone();
        (0..inside.len()).filter(move |&i| inside[i])
    }

    /// World x and y of a cell's centre.
    fn place(&self, i: usize) -> [f64; 2] {
        let centred = |p: usize| (p as f64 + 0.5 - 0.5 * CELLS as f64) * self.cell_world;
        [centred(i % CELLS), -centred(i / CELLS)]
    }

    /// Centres it in depth and scales it so that its farthest point lies on the unit sphere.
    fn fit_unit_ball(&mut self) {
        let (low, high) = self
            .cells()
            .fold((f32::MAX, f32::MIN), |(low, high), i| (low.min(self.back.data[i]), high.max(self.front.data[i])));
        let middle = 0.5 * (low + high);
        let farthest = self.cells().map(|i| {
            let [x, y] = self.place(i);
            let z = (self.front.data[i] - middle).abs().max((self.back.data[i] - middle).abs());
            (x * x + y * y + f64::from(z).powi(2)).sqrt()
        });
        let scale = 1.0 / farthest.fold(1e-9, f64::max);
        for i in self.cells() {
            self.front.data[i] = (self.front.data[i] - middle) * scale as f32;
            self.back.data[i] = (self.back.data[i] - middle) * scale as f32;
        }
        self.cell_world *= scale;
    }
}

/// Heights without the ridges that come of a pixelled outline; those outside have no say.
fn smoothed(heights: Image, inside: &Mask) -> Image {
    let (blurred, weight) = (heights.blurred(SMOOTHING), inside.to_image().blurred(SMOOTHING));
    // Thin places and the steep rim stay as they are: only what is high enough to have ridges is smoothed.
    let smooth = |i: usize| {
        let share = ((heights.data[i] - SMOOTHING as f32) / (2.0 * SMOOTHING as f32)).clamp(0.0, 1.0);
        heights.data[i] + share * (blurred.data[i] / weight.data[i].max(1e-3) - heights.data[i])
    };
    Image { data: (0..heights.data.len()).map(smooth).collect(), ..heights }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::soft_iou;

    fn picture(on: impl Fn(f32, f32) -> bool) -> Image {
        let mut image = Image::new(256, 256);
        (0..256 * 256).for_each(|i| {
            image.data[i] = f32::from(on((i % 256) as f32 + 0.5 - 128.0, (i / 256) as f32 + 0.5 - 128.0));
        });
        image
    }

    fn solid(body: &Image, roundness: f64) -> Solid {
        Solid::inflated("thing", body, &SolidOptions { roundness, ..SolidOptions::default() }).unwrap()
    }

    #[test]
    fn a_disc_becomes_a_ball_and_a_bar_a_rod() {
        let disc = picture(|x, y| x.hypot(y) < 90.0);
        let ball = solid(&disc, 1.0);
        for (azimuth, elevation) in [(0.0, 0.0), (1.2, 0.0), (0.6, 0.9), (-2.0, 0.3)] {
            let view = View::orthographic("any", azimuth, elevation, ball.height_world(), 256);
            let found = soft_iou(&ball.silhouette(&view), &disc);
            assert!(found > 0.95, "{azimuth} {elevation}: {found}");
        }
        let flat = solid(&disc, 0.3);
        let side = View::orthographic("side", std::f64::consts::FRAC_PI_2, 0.0, flat.height_world(), 256);
        assert!(soft_iou(&flat.silhouette(&side), &disc) < 0.5, "the check can fail");
        let bar = picture(|x, y| x.abs() < 20.0 && y.abs() < 90.0);
        let rod = solid(&bar, 1.0);
        let side = View::orthographic("side", std::f64::consts::FRAC_PI_2, 0.0, rod.height_world(), 256);
        assert!(soft_iou(&rod.silhouette(&side), &bar) > 0.85);
    }

    #[test]
    fn from_the_front_it_is_its_silhouette() {
        let shape = picture(|x, y| (x.hypot(y) - 60.0).abs() < 25.0 || (y - 80.0).abs() < 9.0 && x > 0.0);
        let solid = solid(&shape, 0.9);
        let front = View::orthographic("front", 0.0, 0.0, solid.height_world(), 256);
        assert!(soft_iou(&solid.silhouette(&front), &shape) > 0.93);
        assert!(!solid.contains([0.0; 3]), "the hole stays");
        let mut rng = Rng::new(4, 0);
        for _ in 0..2000 {
            let p = rng.in_ball(1.2);
            assert!(!solid.contains(p) || p.iter().map(|c| c * c).sum::<f64>() < 1.02, "it fits the unit ball");
        }
        for point in solid.tour(60, 0.01, 7).points {
            let [back, front] = solid.depths(point[0], point[1]);
            assert!((back - 0.1..front + 0.1).contains(&point[2]));
        }
        assert_eq!(solid.tour(60, 0.01, 7), solid.tour(60, 0.01, 7));
    }

    #[test]
    fn other_sides_carve_and_depth_bends() {
        let disc = picture(|x, y| x.hypot(y) < 90.0);
        let round = solid(&disc, 0.9);
        let side = View::orthographic("side", std::f64::consts::FRAC_PI_2, 0.0, round.height_world(), 256);
        let thin = picture(|x, y| x.abs() < 20.0 && y.abs() < 90.0);
        let carved = round.clone().carved(&[(side.clone(), thin.clone())]).unwrap();
        let view = View::orthographic("side", std::f64::consts::FRAC_PI_2, 0.0, carved.height_world(), 256);
        let front = View::orthographic("front", 0.0, 0.0, carved.height_world(), 256);
        assert!(soft_iou(&carved.silhouette(&view), &thin) > 0.85);
        assert!(soft_iou(&carved.silhouette(&front), &disc) > 0.93);
        let away = picture(|_, y| y > 120.0);
        assert!(matches!(round.clone().carved(&[(side, away)]), Err(Error::Pictures { .. })));
        let slope = picture(|x, _| x > 0.0);
        let bent = round.with_depth(&slope);
        assert!(bent.depths(0.4, 0.0)[0] > bent.depths(-0.4, 0.0)[1], "the right half is nearer");
    }
}
