//! What a picture is where it is read as ink: yes or no, and its hair lines thickened.

use super::Mask;
use crate::view::Image;

/// Ink above this is looked for when hair lines are traced: thinner than a pixel, they are grey all along.
const TRACE_LEVEL: f32 = 0.35;

/// A picture read as ink, 0 (ground) to 1 (ink).
pub trait Ink {
    /// Where there is more than `level`.
    fn threshold(&self, level: f32) -> Mask;

    /// The drawing with strokes thinner than `min_width_px` redrawn that wide, antialiased; wider ones, solid areas and
    /// their corners stay as they are.
    ///
    /// Discs of half the width are laid along the skeleton wherever such a disc does not fit into the ink; not nearer to
    /// ink where one fits than its radius, which spares the corners of wide strokes.
    fn with_min_stroke(&self, min_width_px: f32) -> Image;

    /// A drawing that can be scaled down to `side_px` without losing its thin lines to averaging: those that would be
    /// thinner than [`LEAST_WIDTH`] of a pixel there are redrawn that wide, as above. Specks, shorter than a few pixels
    /// there, stay specks. Drawings of up to twice that size stay as they are.
    fn with_hair_lines(&self, side_px: usize) -> Image;
}

/// Width at which a line is still traced wherever it lies between pixels, px.
const LEAST_WIDTH: f32 = 0.85;
/// Shortest line that is none of dust, px of the smaller picture.
const SHORTEST: f32 = 4.0;

impl Ink for Image {
    fn threshold(&self, level: f32) -> Mask {
        let data = self.data.iter().map(|&value| value > level).collect();
        Mask { width: self.width, height: self.height, data }
    }

    fn with_min_stroke(&self, min_width_px: f32) -> Image {
        redrawn(self, min_width_px, 0.0)
    }

    fn with_hair_lines(&self, side_px: usize) -> Image {
        let step = self.width.max(self.height) as f32 / side_px as f32;
        if step <= 2.0 { self.clone() } else { redrawn(self, LEAST_WIDTH * step, SHORTEST * step) }
    }
}

/// See [`Ink::with_min_stroke`]; lines whose skeleton is not longer than `shortest_px` stay.
fn redrawn(image: &Image, min_width_px: f32, shortest_px: f32) -> Image {
    let radius = 0.5 * min_width_px;
    let ink = image.threshold(TRACE_LEVEL);
    // From a pixel's centre to the border of the ink it is half a pixel less than to the next ground centre.
    let to_ground = ink.inverted().distance_px();
    let fits = to_ground.threshold(radius + 0.5 - 0.25);
    let to_fitting = fits.distance_px();
    let mut thin = ink.thin();
    if shortest_px > 0.0 {
        let lines = thin.components();
        let long = |&label: &u32| label > 0 && lines.sizes[label as usize - 1] as f32 > shortest_px;
        thin.data = lines.labels.iter().map(long).collect();
    }
    for (on, &distance) in thin.data.iter_mut().zip(&to_fitting.data) {
        // As far again as the disc that fits reaches, and a radius more.
        *on &= distance > 2.0 * radius;
    }
    let mut out = image.clone();
    for i in (0..thin.data.len()).filter(|&i| thin.data[i]) {
        add_disc(&mut out, centre_of_ink(image, i % image.width, i / image.width), radius);
    }
    out
}

/// The middle of a stroke near a skeleton pixel, to a fraction of a pixel: the centroid of the ink round it.
fn centre_of_ink(image: &Image, x: usize, y: usize) -> [f32; 2] {
    let (mut sum, mut mass) = ([0.0f32; 2], 0.0f32);
    for ny in y.saturating_sub(1)..image.height.min(y + 2) {
        for nx in x.saturating_sub(1)..image.width.min(x + 2) {
            let value = image.at(nx, ny);
            sum[0] += value * (nx as f32 - x as f32);
            sum[1] += value * (ny as f32 - y as f32);
            mass += value;
        }
    }
    // Some ink is always there: the pixel itimage.
    [x as f32 + 0.5 + sum[0] / mass, y as f32 + 0.5 + sum[1] / mass]
}

/// Unites the picture with a disc, edges one pixel soft.
fn add_disc(image: &mut Image, [x_px, y_px]: [f32; 2], radius_px: f32) {
    let reach = radius_px + 0.5;
    let range = |centre: f32, size: usize| {
        (centre - reach).max(0.0) as usize..((centre + reach).ceil().max(0.0) as usize).min(size)
    };
    for y in range(y_px, image.height) {
        for x in range(x_px, image.width) {
            let distance = (x as f32 + 0.5 - x_px).hypot(y as f32 + 0.5 - y_px);
            let value = &mut image.data[y * image.width + x];
            *value = value.max((reach - distance).clamp(0.0, 1.0).min(2.0 * radius_px));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coverage of a segment `width_px` wide, by 8 x 8 samples a pixel.
    fn line(from: [f32; 2], to: [f32; 2], width_px: f32) -> Image {
        let mut image = Image::new(80, 64);
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length2 = dx * dx + dy * dy;
        for i in 0..image.data.len() {
            let hits = (0..64).filter(|s| {
                let x = (i % 80) as f32 + (s % 8) as f32 / 8.0 + 1.0 / 16.0 - from[0];
                let y = (i / 80) as f32 + (s / 8) as f32 / 8.0 + 1.0 / 16.0 - from[1];
                let t = ((x * dx + y * dy) / length2).clamp(0.0, 1.0);
                (x - t * dx).hypot(y - t * dy) < 0.5 * width_px
            });
            image.data[i] = hits.count() as f32 / 64.0;
        }
        image
    }

    fn union(mut a: Image, b: &Image) -> Image {
        for (a, b) in a.data.iter_mut().zip(&b.data) {
            *a = a.max(*b);
        }
        a
    }

    fn ink(image: &Image) -> f32 {
        image.data.iter().sum()
    }

    #[test]
    fn hair_lines_become_as_wide_as_asked() {
        for to in [[70.0, 20.5], [60.0, 55.0], [66.0, 36.3]] {
            for thin in [0.8, 1.5, 3.0] {
                let drawn = line([10.3, 20.5], to, thin).with_min_stroke(5.0);
                let wanted = line([10.3, 20.5], to, 5.0);
                // Ends may differ by a pixel or so; the sides may not.
                let wrong: f32 = drawn.data.iter().zip(&wanted.data).map(|(a, b)| (a - b).abs()).sum();
                let share = wrong / ink(&wanted);
                assert!(share < 0.08, "{thin} to {to:?}: {share}");
                // Sibling: another width is told apart.
                let other = line([10.3, 20.5], to, 6.0);
                let wrong: f32 = drawn.data.iter().zip(&other.data).map(|(a, b)| (a - b).abs()).sum();
                assert!(wrong / ink(&other) > 0.12);
            }
        }
    }

    #[test]
    fn hair_lines_survive_scaling_down_and_dust_does_not_grow() {
        let large = |inked: &dyn Fn(usize, usize) -> bool| {
            let data = (0..1200 * 1200).map(|i| f32::from(inked(i % 1200, i / 1200))).collect();
            Image { width: 1200, height: 1200, data }
        };
        let hair = |x: usize, y: usize| (100..1100).contains(&x) && y == 300 + x / 3;
        let bar = |x: usize, y: usize| (200..1000).contains(&x) && (900..960).contains(&y);
        let dust = |x: usize, y: usize| (x % 97, y % 89) == (5, 7);
        let small = |image: &Image| image.resized(256, 256).with_min_stroke(3.0);
        let lines = large(&|x, y| hair(x, y) || bar(x, y));
        assert!(ink(&small(&lines)) < 1.1 * ink(&small(&large(&bar))), "averaging alone loses it");
        let kept = small(&lines.with_hair_lines(256));
        let wanted = 3.0 * (1000f32 / 1200.0 * 256.0) * (1.0f32 + 1.0 / 9.0).sqrt() + ink(&small(&large(&bar)));
        assert!((ink(&kept) / wanted - 1.0).abs() < 0.05, "{} of {wanted}", ink(&kept));
        let dusty = large(&dust);
        assert_eq!(dusty.with_hair_lines(256), dusty);
        let as_drawn = large(&bar);
        assert_eq!(as_drawn.with_hair_lines(256), as_drawn, "wide strokes stay");
        assert_eq!(lines.with_hair_lines(600), lines, "so does what is hardly scaled down");
    }

    #[test]
    fn wide_strokes_and_their_corners_stay() {
        let wide = line([15.0, 15.0], [60.0, 48.0], 9.0);
        assert_eq!(wide.with_min_stroke(5.0), wide);
        let mut square = Image::new(40, 40);
        for y in 10..30 {
            square.data[y * 40 + 10..y * 40 + 30].fill(1.0);
        }
        assert_eq!(square.with_min_stroke(6.0), square, "corners are no thin strokes");
        // A hair line that leaves a wide stroke grows, the wide stroke does not, and no gap opens.
        let mixed = union(wide.clone(), &line([15.0, 15.0], [70.0, 8.0], 1.5));
        let drawn = mixed.with_min_stroke(5.0);
        assert!(ink(&drawn) > ink(&mixed) + 60.0);
        assert_eq!(drawn.threshold(0.5).components().sizes.len(), 1);
        assert_eq!(drawn.at(50, 45), wide.at(50, 45));
        assert_eq!(Image::new(8, 8).with_min_stroke(5.0), Image::new(8, 8));
        assert_eq!(wide.with_min_stroke(0.0), wide);
    }
}
