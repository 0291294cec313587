//! What a network is shown of a view: square patches, resampled to its size, as dark ink on white paper; and the way back.
//!
//! A picture of `width x height` px is the rectangle of its pixels' squares. Inside it ink is bilinear between pixel centres,
//! with the outermost pixels continued to the rim, so that even ink stays even; outside there is blank paper. A patch's pixel is
//! the mean of samples no more than a pixel of the picture apart, which is what keeps fine lines when a patch is shrunk.
//! All of that is linear in the ink, and [`Patch::pull`] is exactly the transposed map of [`Patch::draw`].

use crate::rng::Rng;

/// A parallelogram of a picture that becomes a network's square. In px of the picture, x right, y down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    /// Where the square's upper left corner lies.
    pub corner: [f32; 2],
    /// From there to its upper right corner.
    pub across: [f32; 2],
    /// From there to its lower left corner.
    pub down: [f32; 2],
}

impl Patch {
    /// An upright square of `side` px.
    pub fn square(x: f32, y: f32, side: f32) -> Patch {
        Patch { corner: [x, y], across: [side, 0.0], down: [0.0, side] }
    }

    /// The smallest upright square round a whole picture.
    pub fn whole(width: usize, height: usize) -> Patch {
        let side = width.max(height) as f32;
        Patch::square((width as f32 - side) / 2.0, (height as f32 - side) / 2.0, side)
    }

    /// The same part of a picture that is `factor` times as wide.
    pub fn scaled(&self, factor: f32) -> Patch {
        let scaled = |vector: [f32; 2]| vector.map(|value| value * factor);
        Patch { corner: scaled(self.corner), across: scaled(self.across), down: scaled(self.down) }
    }

    /// Draws `ink`, 0 to 1 row by row and `width` wide, into `image`: `[3, size, size]`, rows from the top, 1 where paper is
    /// blank and 0 where it is covered, equal in all channels.
    pub fn draw(&self, ink: &[f32], width: usize, size: usize, image: &mut [f32]) {
        image.fill(1.0);
        let (first, others) = image.split_at_mut(size * size);
        self.each_tap(width, ink.len() / width, size, |at, pixel, share| first[at] -= share * ink[pixel]);
        others.chunks_exact_mut(first.len()).for_each(|channel| channel.copy_from_slice(first));
    }

    /// Adjoint of [`Patch::draw`]: adds to `d_ink` what `d_image` (d loss / d image) makes of it.
    pub fn pull(&self, d_image: &[f32], size: usize, width: usize, d_ink: &mut [f32]) {
        let count = size * size;
        let height = d_ink.len() / width;
        self.each_tap(width, height, size, |at, pixel, share| {
            d_ink[pixel] -= share * (d_image[at] + d_image[at + count] + d_image[at + 2 * count]);
        });
    }

    /// Every pixel of the square, with every pixel of the picture that it sees and the share of it: the linear map itself.
    fn each_tap(&self, width: usize, height: usize, size: usize, mut tap: impl FnMut(usize, usize, f32)) {
        // Less a little, for sides of whole pixels that are rounded up.
        let samples = |[x, y]: [f32; 2]| ((x.hypot(y) / size as f32 - 1e-4).ceil() as usize).max(1);
        let (columns, rows) = (samples(self.across), samples(self.down));
        let share = 1.0 / (columns * rows) as f32;
        for row in 0..size * rows {
            let v = (row as f32 + 0.5) / (size * rows) as f32;
            for column in 0..size * columns {
                let u = (column as f32 + 0.5) / (size * columns) as f32;
                let [x, y] = [0, 1].map(|k| self.corner[k] + u * self.across[k] + v * self.down[k]);
                let (Some((x, right)), Some((y, below))) = (between(x, width), between(y, height)) else { continue };
                let at = row / rows * size + column / columns;
                let pixel = y * width + x;
                for (pixel, part) in [
                    (pixel, (1.0 - right) * (1.0 - below)),
                    (pixel + 1, right * (1.0 - below)),
                    (pixel + width, (1.0 - right) * below),
                    (pixel + width + 1, right * below),
                ] {
                    if part > 0.0 {
                        tap(at, pixel, share * part);
                    }
                }
            }
        }
    }
}

/// The pixel whose centre is at or before `x`, and how far `x` is on the way to the next one's, 0 to 1. None outside `0..count`.
fn between(x: f32, count: usize) -> Option<(usize, f32)> {
    if !(0.0..=count as f32).contains(&x) {
        return None;
    }
    let inside = (x - 0.5).clamp(0.0, (count - 1) as f32);
    Some((inside as usize, inside.fract()))
}

/// How a network looks at a view.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Look {
    /// At all of it, every time.
    Whole,
    /// At `cells x cells` squares that tile the view's middle, each moved by up to half a side, never beyond the view. Four is
    /// what surface filling takes in the paper's code.
    Grid {
        /// Squares along a side, 1 or more.
        cells: usize,
    },
    /// At `count` views of all of it, each turned, scaled and shifted at random, so that no single raster decides.
    /// CLIPDraw's augmentation (Frans et al. 2021) with affine maps for perspective ones.
    Affine {
        /// How many.
        count: usize,
        /// Most turn to either side, radians.
        turn: f32,
        /// Least side of a patch, as a share of the whole; the most is 1.
        scale: f32,
        /// Most shift either way, as a share of the whole.
        shift: f32,
    },
}

impl Look {
    /// For words: what is seen in all of four such views of a picture is no accident of its pixels.
    pub const WORDS: Look = Look::Affine { count: 4, turn: 0.2, scale: 0.8, shift: 0.08 };

    /// The patches of a view in one iteration; the same for the same seed, iteration and view.
    pub fn patches(self, width: usize, height: usize, seed: u64, iteration: usize, view: usize) -> Vec<Patch> {
        let mut rng = Rng::new(seed, (iteration as u64) << 16 | view as u64);
        let mut within = |most: f32| rng.range(-f64::from(most), f64::from(most)) as f32;
        let (w, h) = (width as f32, height as f32);
        match self {
            Look::Whole => vec![Patch::whole(width, height)],
            Look::Grid { cells } => {
                let side = w.min(h) / cells as f32;
                let begin = [w, h].map(|length| (length - side * cells as f32) / 2.0);
                let place = |begin: f32, cell: usize, moved: f32, length: f32| {
                    (begin + cell as f32 * side + moved).clamp(0.0, length - side)
                };
                (0..cells * cells)
                    .map(|cell| {
                        let x = place(begin[0], cell % cells, within(side / 2.0), w);
                        let y = place(begin[1], cell / cells, within(side / 2.0), h);
                        Patch::square(x, y, side)
                    })
                    .collect()
            }
            Look::Affine { count, turn, scale, shift } => (0..count)
                .map(|_| {
                    let whole = w.max(h);
                    let side = whole * (1.0 - (1.0 - scale) * (0.5 + within(0.5)));
                    let middle = [w, h].map(|length| length / 2.0 + within(shift * whole));
                    let (sin, cos) = within(turn).sin_cos();
                    let (across, down) = ([side * cos, side * sin], [-side * sin, side * cos]);
                    let corner = [0, 1].map(|k| middle[k] - (across[k] + down[k]) / 2.0);
                    Patch { corner, across, down }
                })
                .collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTH: usize = 40;
    const HEIGHT: usize = 32;

    fn noise(count: usize, seed: u64) -> Vec<f32> {
        let mut rng = Rng::new(seed, 0);
        (0..count).map(|_| rng.unit() as f32).collect()
    }

    /// Patches of all kinds, some of them over the rim.
    fn patches() -> Vec<Patch> {
        let affine = Look::Affine { count: 4, turn: 0.5, scale: 0.4, shift: 0.2 };
        let looks = [Look::Whole, Look::Grid { cells: 2 }, affine];
        looks.iter().flat_map(|look| look.patches(WIDTH, HEIGHT, 7, 3, 1)).collect()
    }

    fn drawn(patch: &Patch, ink: &[f32], size: usize) -> Vec<f32> {
        let mut image = vec![0.0; 3 * size * size];
        patch.draw(ink, WIDTH, size, &mut image);
        image
    }

    fn dot(a: &[f32], b: &[f32]) -> f64 {
        a.iter().zip(b).map(|(&a, &b)| f64::from(a) * f64::from(b)).sum()
    }

    #[test]
    fn the_way_back_is_the_transposed_map() {
        let ink = noise(WIDTH * HEIGHT, 1);
        for size in [8, 24, 56] {
            for patch in patches() {
                let d_image = noise(3 * size * size, 2);
                let blank = drawn(&patch, &vec![0.0; ink.len()], size);
                let image = drawn(&patch, &ink, size);
                let linear: Vec<f32> = image.iter().zip(&blank).map(|(a, b)| a - b).collect();
                let mut d_ink = vec![0.0; ink.len()];
                patch.pull(&d_image, size, WIDTH, &mut d_ink);
                let (there, back) = (dot(&linear, &d_image), dot(&ink, &d_ink));
                assert!((there - back).abs() <= 1e-6 * there.abs(), "{patch:?} at {size}: {there} and {back}");
            }
        }
    }

    #[test]
    fn the_gradient_is_that_of_finite_differences() {
        let (ink, size) = (noise(WIDTH * HEIGHT, 1), 12);
        for patch in patches() {
            // A loss that is not linear: half the sum of squares, whose gradient is the image itself.
            let loss = |ink: &[f32]| dot(&drawn(&patch, ink, size), &drawn(&patch, ink, size)) / 2.0;
            let mut d_ink = vec![0.0; ink.len()];
            patch.pull(&drawn(&patch, &ink, size), size, WIDTH, &mut d_ink);
            for pixel in [0, 333, 500, 640, 1000] {
                let moved = |by: f32| {
                    let mut ink = ink.clone();
                    ink[pixel] += by;
                    loss(&ink)
                };
                let slope = (moved(0.05) - moved(-0.05)) / 0.1;
                assert!(
                    (slope - f64::from(d_ink[pixel])).abs() < 1e-4,
                    "{patch:?} at {pixel}: {slope}, {}",
                    d_ink[pixel]
                );
            }
        }
    }

    #[test]
    fn even_ink_stays_even_in_the_picture_and_is_blank_outside() {
        let even = vec![0.25; WIDTH * HEIGHT];
        for size in [7, 16, 50] {
            for patch in (Look::Grid { cells: 3 }).patches(WIDTH, HEIGHT, 1, 2, 0) {
                assert!(drawn(&patch, &even, size).iter().all(|value| (value - 0.75).abs() < 1e-5));
            }
        }
        // A whole picture that is wider than high has paper above and below.
        let image = drawn(&Patch::whole(WIDTH, HEIGHT), &vec![1.0; WIDTH * HEIGHT], 10);
        assert_eq!((image[5], image[55], image[95]), (1.0, 0.0, 1.0));
    }

    #[test]
    fn a_patch_of_the_same_size_is_the_picture_and_a_smaller_one_its_mean() {
        let ink = noise(WIDTH * HEIGHT, 1);
        let same = drawn(&Patch::square(4.0, 6.0, 16.0), &ink, 16);
        let half = drawn(&Patch::square(4.0, 6.0, 16.0), &ink, 8);
        for (x, y) in [(0, 0), (3, 5), (7, 7)] {
            let at = |x: usize, y: usize| 1.0 - ink[(y + 6) * WIDTH + x + 4];
            assert!((same[y * 16 + x] - at(x, y)).abs() < 1e-6);
            let mean =
                (at(2 * x, 2 * y) + at(2 * x + 1, 2 * y) + at(2 * x, 2 * y + 1) + at(2 * x + 1, 2 * y + 1)) / 4.0;
            assert!((half[y * 8 + x] - mean).abs() < 1e-6);
        }
    }

    #[test]
    fn squares_stay_in_the_view_and_cover_it_over_time() {
        let mut seen = vec![0.0; WIDTH * HEIGHT];
        let look = Look::Grid { cells: 4 };
        for iteration in 0..20 {
            for patch in look.patches(WIDTH, HEIGHT, 5, iteration, 0) {
                let [x, y] = patch.corner;
                assert!(x >= 0.0 && y >= 0.0 && x + 8.0 <= WIDTH as f32 && y + 8.0 <= HEIGHT as f32, "{patch:?}");
                patch.pull(&[-1.0; 3 * 64], 8, WIDTH, &mut seen);
            }
        }
        // The middle 32 of 40 columns are tiled; beyond them squares only wander.
        assert!((0..HEIGHT).all(|y| (4..WIDTH - 4).all(|x| seen[y * WIDTH + x] > 0.0)));
        assert_eq!(look.patches(WIDTH, HEIGHT, 5, 3, 2), look.patches(WIDTH, HEIGHT, 5, 3, 2));
        assert_ne!(look.patches(WIDTH, HEIGHT, 5, 3, 2), look.patches(WIDTH, HEIGHT, 5, 4, 2));
        assert_ne!(look.patches(WIDTH, HEIGHT, 5, 3, 2), look.patches(WIDTH, HEIGHT, 6, 3, 2));
    }

    #[test]
    fn turned_views_keep_their_shape_and_stay_near_the_middle() {
        let turned = Look::Affine { count: 200, turn: 0.3, scale: 0.8, shift: 0.1 }.patches(WIDTH, HEIGHT, 1, 1, 1);
        for Patch { corner, across, down } in turned {
            let side = across[0].hypot(across[1]);
            assert!((0.8 * 40.0 - 1e-3..40.0 + 1e-3).contains(&side));
            assert!((down[0] + across[1]).abs() < 1e-4 && (down[1] - across[0]).abs() < 1e-4);
            assert!(across[1].atan2(across[0]).abs() <= 0.3 + 1e-5);
            let middle = [0, 1].map(|k| corner[k] + (across[k] + down[k]) / 2.0);
            assert!((middle[0] - 20.0).abs() <= 4.0 + 1e-3 && (middle[1] - 16.0).abs() <= 4.0 + 1e-3);
        }
    }
}
