//! How far the edges of two pictures are from each other.

use super::Perceptual;
use crate::picture::Mask;
use crate::view::Image;

/// Pictures are smoothed by a Gaussian of this σ, pixels, before their slope is taken.
const SIGMA_PX: f64 = 1.0;
/// Least slope of an edge, ink a pixel: that of a line a quarter of a pixel wide, the thinnest one that reports count as
/// visible. A smoothed line of mass m is at most m / (σ² √(2 π e)) = 0.242 m steep.
const LEAST_SLOPE: f32 = 0.25 * 0.242;

/// Mean distance from an edge pixel ([`edges`]) of the one picture to the nearest of the other, taken both ways and
/// averaged; pixels of 256, 0 for identical pictures. 0 where neither picture has an edge, the picture's diagonal where
/// only one has.
pub struct EdgeDistance;

impl Perceptual for EdgeDistance {
    fn name(&self) -> &'static str {
        "edge_distance_px"
    }

    fn best(&self) -> f64 {
        0.0
    }

    fn score(&self, rendered: &Image, target: &Image) -> f64 {
        let (a, b) = (edges(rendered), edges(target));
        match (a.count(), b.count()) {
            (0, 0) => 0.0,
            (0, _) | (_, 0) => (rendered.width as f64).hypot(rendered.height as f64),
            _ => 0.5 * (mean_distance(&a, &b) + mean_distance(&b, &a)),
        }
    }
}

fn mean_distance(from: &Mask, to: &Mask) -> f64 {
    let distance = to.distance_px();
    let each = from.data.iter().zip(&distance.data).filter(|(edge, _)| **edge);
    each.map(|(_, &distance)| f64::from(distance)).sum::<f64>() / from.count() as f64
}

/// The pixels on edges, as Canny (1986) finds them but with one threshold: the picture is smoothed (Gaussian, σ 1 px, no
/// ink outside), its slope taken by central differences; an edge pixel's slope is at least 0.06 ink a pixel, and neither
/// one pixel up nor one pixel down the slope (bilinear) is it steeper. Of two equally steep ones the upper has the edge.
pub fn edges(image: &Image) -> Mask {
    let smooth = image.blurred(SIGMA_PX);
    let (width, height) = (image.width, image.height);
    let mut out = Mask::new(width, height);
    let ink = |x: isize, y: isize| {
        let inside = x >= 0 && y >= 0 && x < width as isize && y < height as isize;
        if inside { smooth.at(x as usize, y as usize) } else { 0.0 }
    };
    let slope = |i: usize| {
        let (x, y) = ((i % width) as isize, (i / width) as isize);
        [0.5 * (ink(x + 1, y) - ink(x - 1, y)), 0.5 * (ink(x, y + 1) - ink(x, y - 1))]
    };
    let slopes: Vec<[f32; 2]> = (0..width * height).map(slope).collect();
    let steepness = Image { width, height, data: slopes.iter().map(|[dx, dy]| dx.hypot(*dy)).collect() };
    for (i, &[dx, dy]) in slopes.iter().enumerate() {
        let steep = steepness.data[i];
        if steep < LEAST_SLOPE {
            continue;
        }
        let (x, y) = ((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
        let (up, down) =
            (steepness.sample(x + dx / steep, y + dy / steep), steepness.sample(x - dx / steep, y - dy / steep));
        out.data[i] = steep >= up && steep > down;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bar(columns: std::ops::Range<usize>) -> Image {
        let mut image = Image::new(64, 64);
        for row in image.data.chunks_exact_mut(64) {
            row[columns.clone()].fill(1.0);
        }
        image
    }

    #[test]
    fn a_bar_has_two_straight_edges_one_pixel_wide() {
        let found = edges(&bar(20..40));
        // Away from the picture's top and bottom, where the bar ends too.
        for y in 4..60 {
            let columns: Vec<usize> = (0..64).filter(|&x| found.at(x, y)).collect();
            assert_eq!(columns.len(), 2, "row {y}: {columns:?}");
            assert!((19..=20).contains(&columns[0]) && (39..=40).contains(&columns[1]), "row {y}: {columns:?}");
        }
    }

    #[test]
    fn parallel_edges_are_as_far_as_they_are_apart() {
        // Both edges move by 3 px, and so does the nearest edge of each.
        let middle = |image: &Image| {
            let mut mask = edges(image);
            mask.data[..64 * 4].fill(false);
            mask.data[64 * 60..].fill(false);
            mask
        };
        let (a, b) = (middle(&bar(20..40)), middle(&bar(23..43)));
        assert_eq!((mean_distance(&a, &b), mean_distance(&b, &a)), (3.0, 3.0));
        assert_ne!(mean_distance(&a, &middle(&bar(24..44))), 3.0);
        // One way alone misses what the other picture has more: a second bar far away.
        let mut two = bar(20..40);
        two.data.chunks_exact_mut(64).for_each(|row| row[50..60].fill(1.0));
        let there = mean_distance(&edges(&bar(20..40)), &edges(&two));
        let back = mean_distance(&edges(&two), &edges(&bar(20..40)));
        assert!(there < 0.2 && back > 4.0, "{there} {back}");
        assert!((EdgeDistance.score(&bar(20..40), &two) - 0.5 * (there + back)).abs() < 1e-12);
    }

    #[test]
    fn lines_from_a_quarter_of_a_pixel_on_have_edges() {
        let line = |ink: f32| {
            let mut image = Image::new(64, 64);
            image.data.chunks_exact_mut(64).for_each(|row| row[30] = ink);
            image
        };
        assert!(edges(&line(0.4)).count() >= 2 * 60);
        assert_eq!(edges(&line(0.15)).count(), 0);
        let diagonal = 64.0 * 2f64.sqrt();
        assert!((EdgeDistance.score(&line(0.15), &line(1.0)) - diagonal).abs() < 1e-9);
    }
}
