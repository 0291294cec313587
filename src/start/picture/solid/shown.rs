//! What a view shows of a solid: its silhouette, and the lines an artist would draw of it.

use super::Solid;
use crate::picture::Mask;
use crate::view::{Image, View};

/// Pictures are made this many times as large, then averaged.
const FINER: usize = 2;
/// Two surfaces are apart where the depth jumps by this from pixel to pixel, world units: two cells or so.
const JUMP_WORLD: f32 = 0.06;
/// A crease turns the surface by this within [`TURN_PX`], radians.
const TURN: f32 = 0.9;
/// Pixels at 256 to either side over which a turn is measured.
const TURN_PX: f64 = 4.0;
/// Standard deviation of the blur that hides the grid's stairs, px at 256.
const BLUR_PX: f64 = 1.5;

/// What a view shows of a solid.
pub struct Shown<'a> {
    view: &'a View,
    /// Distance in front of the eye, world units, infinite beside it; [`FINER`] than the view.
    depth: Image,
}

impl Shown<'_> {
    /// 1 on the solid, 0 beside it, edges soft.
    pub fn silhouette(&self) -> Image {
        let data = self.depth.data.iter().map(|depth| f32::from(depth.is_finite())).collect();
        Image { data, ..self.depth }.resized(self.view.width_px, self.view.height_px)
    }

    /// Lines `width_px` wide (of the view's pixels) along the solid's outline, where one part of it lies before another, and
    /// where its surface turns sharply; 0 to 1.
    pub fn creases(&self, width_px: f64) -> Image {
        let Shown { view, depth } = self;
        let (width, height) = (depth.width, depth.height);
        let on = Mask { width, height, data: depth.data.iter().map(|depth| depth.is_finite()).collect() };
        let known = |i: usize| if on.data[i] { depth.data[i] } else { 0.0 };
        let scale = (height as f64) / 256.0;
        let [sum, weight] = [Image { width, height, data: (0..width * height).map(known).collect() }, on.to_image()]
            .map(|image| image.blurred(BLUR_PX * scale));
        let smooth: Vec<f32> = sum.data.iter().zip(&weight.data).map(|(sum, weight)| sum / weight.max(1e-3)).collect();
        let reach = ((TURN_PX * scale) as usize).max(1);
        let px_world = (1.0 / view.with_size(width, height).camera::<f64>().pixels_per_world(&[0.0; 4])) as f32;
        let line = |i: usize| {
            let (x, y) = (i % width, i / width);
            if !on.data[i] || x < reach || y < reach || x + reach >= width || y + reach >= height {
                return false;
            }
            [(1, reach), (width, reach * width)].iter().any(|&(step, far)| {
                let (before, after) = (i - step, i + step);
                // The nearer of two parts has the outline.
                let apart = |n: usize| !on.data[n] || depth.data[n] - depth.data[i] > JUMP_WORLD;
                let smooth_round = [i - far, i + far].iter().all(|&n| on.data[n]);
                let slope = |from: usize, to: usize| ((smooth[to] - smooth[from]) / (reach as f32 * px_world)).atan();
                apart(before) || apart(after) || smooth_round && (slope(i - far, i) - slope(i, i + far)).abs() > TURN
            })
        };
        let lines = Mask { width, height, data: (0..width * height).map(line).collect() }.thin();
        let half = (0.5 * width_px * FINER as f64) as f32;
        let soft = |distance: &f32| (half + 0.5 - distance).clamp(0.0, 1.0);
        let drawn = Image { width, height, data: lines.distance_px().data.iter().map(soft).collect() };
        drawn.resized(view.width_px, view.height_px)
    }
}

impl Solid {
    /// What a view shows of it.
    pub fn shown<'a>(&self, view: &'a View) -> Shown<'a> {
        Shown { view, depth: self.depth_picture(view) }
    }

    /// See [`Shown::silhouette`].
    pub fn silhouette(&self, view: &View) -> Image {
        self.shown(view).silhouette()
    }

    /// See [`Shown`].
    fn depth_picture(&self, view: &View) -> Image {
        let (width, height) = (FINER * view.width_px, FINER * view.height_px);
        let camera = view.with_size(width, height).camera::<f64>();
        let radius = 0.75 * self.cell_world * camera.pixels_per_world(&[0.0; 4]);
        let mut shown = Image { width, height, data: vec![f32::INFINITY; width * height] };
        for i in self.cells() {
            let [x, y] = self.place(i);
            let (back, front) = (f64::from(self.back.data[i]), f64::from(self.front.data[i]));
            let steps = ((front - back) / self.cell_world).ceil().max(1.0);
            let [low, high] = self.hidden(i);
            for k in 0..=steps as usize {
                let z = back + (front - back) * k as f64 / steps;
                if low < z && z < high {
                    continue;
                }
                let point = [x, y, z, 0.0];
                let ([u, v, _], depth) = (camera.project(&point), camera.depth(&point) as f32);
                let range = |p: f64, size: usize| {
                    let clamp = |p: f64| p.clamp(0.0, size as f64) as usize;
                    clamp((p - radius).ceil())..clamp(p + radius + 1.0)
                };
                for row in range(v, height) {
                    let down = row as f64 + 0.5 - v;
                    for column in range(u, width) {
                        let across = column as f64 + 0.5 - u;
                        let near = across * across + down * down <= radius * radius;
                        let cell = &mut shown.data[row * width + column];
                        if near && depth < *cell {
                            *cell = depth;
                        }
                    }
                }
            }
        }
        shown
    }

    /// Between which world z the column of cell `i` lies deep among its neighbours, so that no side shows it.
    fn hidden(&self, i: usize) -> [f64; 2] {
        let (width, height) = (self.inside.width, self.inside.height);
        let (x, y) = (i % width, i / width);
        if x == 0 || y == 0 || x + 1 == width || y + 1 == height {
            return [0.0; 2];
        }
        let round = [i - 1, i + 1, i - width, i + width];
        if !round.iter().all(|&n| self.inside.data[n]) {
            return [0.0; 2];
        }
        let low = round.iter().fold(self.back.data[i], |low, &n| low.max(self.back.data[n]));
        let high = round.iter().fold(self.front.data[i], |high, &n| high.min(self.front.data[n]));
        // Two layers are left, so that nothing shows through between the discs.
        [f64::from(low) + 2.0 * self.cell_world, f64::from(high) - 2.0 * self.cell_world]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Ink;
    use crate::start::SolidOptions;

    fn solid(on: impl Fn(f32, f32) -> bool) -> Solid {
        let mut image = Image::new(256, 256);
        (0..256 * 256).for_each(|i| {
            image.data[i] = f32::from(on((i % 256) as f32 + 0.5 - 128.0, (i / 256) as f32 + 0.5 - 128.0));
        });
        Solid::inflated("thing", &image, &SolidOptions::default()).unwrap()
    }

    /// Ink within `near` px of the solid's outline and the rest inside it.
    fn ink(solid: &Solid, view: &View, near: f32) -> [f32; 2] {
        let shown = solid.shown(view);
        let (creases, silhouette) = (shown.creases(3.0), shown.silhouette().threshold(0.5));
        let inside = silhouette.inverted().distance_px();
        let mut ink = [0.0; 2];
        creases
            .data
            .iter()
            .zip(&inside.data)
            .for_each(|(ink_here, inside)| ink[usize::from(*inside > near)] += ink_here);
        ink
    }

    #[test]
    fn a_ball_shows_its_outline_alone_and_parts_before_others_show_theirs() {
        let ball = solid(|x, y| x.hypot(y) < 90.0);
        for (azimuth, elevation) in [(0.0, 0.0), (1.0, 0.3), (1.57, 0.0), (2.5, 1.0)] {
            let view = View::orthographic("any", azimuth, elevation, 2.2, 256);
            let [outline, inner] = ink(&ball, &view, 6.0);
            assert!(outline > 1200.0 && inner < 0.2 * outline, "{azimuth} {elevation}: {outline} {inner}");
        }
        let two =
            solid(|x, y| (x - 55.0).hypot(y) < 40.0 || (x + 55.0).hypot(y) < 60.0 || y.abs() < 6.0 && x.abs() < 60.0);
        let along = View::orthographic("side", std::f64::consts::FRAC_PI_2 - 0.3, 0.0, 2.2, 256);
        let [outline, inner] = ink(&two, &along, 6.0);
        assert!(inner > 0.15 * outline, "the near ball's outline before the far one: {outline} {inner}");
    }
}
