//! Where a step looks: random windows onto what a view shows.

use crate::rng::Rng;
use crate::view::Image;

/// `mask` inside `count` square windows of `size_px` a side whose centres are drawn from the mask, 0 elsewhere.
///
/// Statistics of a part, and of another one in each step, make a pattern even over the whole: over all of it a flower
/// here could stand for stripes there. No windows leave the mask as it is.
pub fn crop_weights(mask: &Image, count: usize, size_px: usize, rng: &mut Rng) -> Image {
    if count == 0 {
        return mask.clone();
    }
    let mut weights = Image::new(mask.width, mask.height);
    let row_sums: Vec<f64> = mask.data.chunks_exact(mask.width.max(1)).map(total).collect();
    let whole: f64 = row_sums.iter().sum();
    for _ in 0..count {
        // Always two draws, so that a blank mask does not shift what comes after.
        let (down, across) = (rng.unit(), rng.unit());
        if !(whole > 0.0 && whole.is_finite()) {
            continue;
        }
        let y = place(row_sums.iter().copied(), down * whole);
        let row = &mask.data[y * mask.width..][..mask.width];
        let x = place(row.iter().map(|&value| f64::from(value.max(0.0))), across * row_sums[y]);
        let span = |centre: usize, size: usize| {
            let low = centre.saturating_sub(size_px / 2);
            low..(low.max(centre) + size_px - size_px / 2).min(size).max(low)
        };
        let columns = span(x, mask.width);
        for y in span(y, mask.height) {
            let part = y * mask.width + columns.start..y * mask.width + columns.end;
            weights.data[part.clone()].copy_from_slice(&mask.data[part]);
        }
    }
    weights
}

fn total(row: &[f32]) -> f64 {
    row.iter().map(|&value| f64::from(value.max(0.0))).sum()
}

/// The first index by which the running sum of `parts` exceeds `sum`, or the last that has a part.
fn place(parts: impl Iterator<Item = f64>, mut sum: f64) -> usize {
    let mut last = 0;
    for (i, part) in parts.enumerate() {
        if part > 0.0 {
            last = i;
            if sum < part {
                return i;
            }
        }
        sum -= part;
    }
    last
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_lie_round_the_mask() {
        let mut mask = Image::new(40, 30);
        for y in 10..25 {
            mask.data[y * 40 + 20..y * 40 + 38].fill(1.0);
        }
        let draw = |seed, count, size| crop_weights(&mask, count, size, &mut Rng::new(seed, 1));
        for seed in 0..50 {
            let weights = draw(seed, 1, 8);
            let seen = weights.data.iter().filter(|&&value| value > 0.0).count();
            assert!((16..=64).contains(&seen), "{seen}");
            assert!(weights.data.iter().zip(&mask.data).all(|(&weight, &mask)| weight == 0.0 || weight == mask));
        }
        assert_eq!(draw(1, 3, 8), draw(1, 3, 8));
        assert_ne!(draw(1, 3, 8), draw(2, 3, 8));
        assert_eq!(draw(1, 0, 8), mask);
        assert_eq!(draw(1, 1, 500), mask, "a window larger than the picture shows all of it");
        assert!(draw(1, 4, 0).data.iter().all(|&value| value == 0.0));
    }

    #[test]
    fn blank_and_odd_masks_are_no_trouble() {
        for data in [vec![0.0; 12], vec![-1.0; 12], vec![f32::NAN; 12], vec![f32::INFINITY; 12]] {
            crop_weights(&Image { width: 4, height: 3, data }, 3, 2, &mut Rng::new(1, 1));
        }
        assert_eq!(crop_weights(&Image::new(0, 0), 3, 2, &mut Rng::new(1, 1)).data.len(), 0);
    }
}
