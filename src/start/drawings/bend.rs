//! Bending drawings before the start so that their hulls agree: a smooth displacement field per view, all together, that
//! moves ink to where some point of space lies on ink in every view. The field is the one that bends targets during the fit
//! ([`Warp`]), so straight strokes are kept straight in the same way.

use super::shared::are_canonical;
use crate::error::Result;
use crate::objective::{Displacement, Warp, WarpWeights, bend_ink};
use crate::optimize::{Adam, AdamOptions};
use crate::view::{Image, Target};

/// How freely drawings may bend. The weights were found by trial: drawings stay readable and agree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendOptions {
    /// What keeps the fields small, smooth and kind to straight strokes.
    pub weights: WarpWeights,
    /// How far a drawing's ink may move on average, px of a 256 px picture: beyond, people no longer see their drawing.
    pub max_mean_px: f64,
    /// Steps of the search.
    pub steps: usize,
}

impl Default for BendOptions {
    fn default() -> Self {
        let weights = WarpWeights { smooth: 3e-3, magnitude: 1e-4, straight: 1.5 };
        BendOptions { weights, max_mean_px: 6.0, steps: 160 }
    }
}

/// Drawings after bending.
#[derive(Debug, Clone, PartialEq)]
pub struct Bent {
    /// The bent targets.
    pub targets: Vec<Target>,
    /// For each view how far its ink moved.
    pub moved: Vec<Displacement>,
    /// Why nothing was bent, if so.
    pub note: Option<&'static str>,
}

/// Side of the pictures on which the search runs.
const SIDE: usize = 64;
/// Control vectors along each side of a field.
const GRID: usize = 12;
/// Pixels at 256 between two of them.
const SPACING_PX: f64 = 256.0 / (GRID - 3) as f64;
/// How far a step moves control vectors at first and in the end, px at 256.
const RATES_PX: [f64; 2] = [0.48, 0.096];
/// Agreement changes under the fields: they forget faster than a plain descent.
const ADAM: AdamOptions = AdamOptions { beta1: 0.9, beta2: 0.98, epsilon: 1e-9, ..AdamOptions::PLAIN };

/// Bends the drawings of two (front, side) or three (front, side, top) canonical orthographic views; other views are
/// left as they are, with a note. `progress` is told the share done and stops the search by returning false.
///
/// # Errors
/// None today; kept for pictures that cannot be bent.
pub fn bend(targets: &[Target], options: &BendOptions, progress: &mut dyn FnMut(f32) -> bool) -> Result<Bent> {
    if !are_canonical(targets) {
        let note = "only front, side and top views without perspective can be bent before the start";
        let moved = vec![Displacement::default(); targets.len()];
        return Ok(Bent { targets: targets.to_vec(), moved, note: Some(note) });
    }
    let mut search = Search::new(targets, *options);
    for step in 0..options.steps {
        search.step(step);
        if step % 16 == 15 && !progress((step + 1) as f32 / options.steps as f32) {
            break;
        }
    }
    Ok(search.finished(targets))
}

/// One view in the search; the side is held mirrored so that its columns run along +z.
struct Sheet {
    /// Ink at [`SIDE`] px.
    ink: Image,
    /// Bends that.
    clean: Warp<f32>,
    /// Bends it blurred and saturated: what the search sees at its present coarseness.
    soft: Warp<f32>,
    field: Vec<[f32; 2]>,
    adam: Adam<2>,
    /// Soft ink as displaced.
    warped: Vec<f32>,
    d_warped: Vec<f32>,
}

struct Search {
    options: BendOptions,
    sheets: Vec<Sheet>,
}

impl Search {
    fn new(targets: &[Target], options: BendOptions) -> Search {
        let sheets = targets.iter().enumerate().map(|(v, target)| {
            let mut ink = target.ink.resized(SIDE, SIDE);
            if v == 1 {
                mirror(&mut ink);
            }
            Sheet::new(ink)
        });
        Search { options, sheets: sheets.collect() }
    }

    fn step(&mut self, step: usize) {
        let done = step as f64 / self.options.steps as f64;
        // From a blur that bridges most gaps down to the drawing itself.
        let sigma = 2.5 * (1.0 - done) + 0.6;
        for sheet in &mut self.sheets {
            if step.is_multiple_of(20) {
                sheet.soften(sigma);
            }
            sheet.soft.bend(&sheet.field, &mut sheet.warped);
        }
        agreement_gradient(&mut self.sheets);
        let [first, last] = RATES_PX;
        let rate = first + done * (last - first);
        for sheet in &mut self.sheets {
            sheet.descend(&self.options.weights, rate as f32);
            sheet.soft.bend(&sheet.field, &mut sheet.warped);
            sheet.keep_size();
            sheet.keep_near(self.options.max_mean_px);
        }
    }

    fn finished(self, targets: &[Target]) -> Bent {
        let mut bent = Bent { targets: Vec::new(), moved: Vec::new(), note: None };
        for (v, (sheet, target)) in self.sheets.into_iter().zip(targets).enumerate() {
            let mut field = sheet.field;
            if v == 1 {
                // The side's field was found in its mirror image.
                field.chunks_exact_mut(GRID).for_each(<[_]>::reverse);
                field.iter_mut().for_each(|[across, _]| *across = -*across);
            }
            let (ink, moved) = bend_ink(&target.ink, GRID, &field);
            bent.targets.push(Target { view: target.view.clone(), ink });
            bent.moved.push(moved);
        }
        bent
    }
}

impl Sheet {
    fn new(ink: Image) -> Sheet {
        Sheet {
            clean: Warp::new(&ink, GRID),
            soft: Warp::new(&ink, GRID),
            ink,
            field: vec![[0.0; 2]; GRID * GRID],
            adam: Adam::new(GRID * GRID),
            warped: vec![0.0; SIDE * SIDE],
            d_warped: vec![0.0; SIDE * SIDE],
        }
    }

    fn soften(&mut self, sigma_px: f64) {
        let mut soft = self.ink.blurred(sigma_px);
        // Saturated, so that a blurred line is as dark in its middle as before.
        soft.data.iter_mut().for_each(|v| *v = (*v * (1.0 + 0.9 * sigma_px as f32)).min(1.0));
        self.soft = Warp::new(&soft, GRID);
    }

    /// One Adam step down the gradient left in `d_warped` plus the prices of bending.
    fn descend(&mut self, weights: &WarpWeights, rate_px: f32) {
        let mut gradient = vec![[0.0; 2]; GRID * GRID];
        self.soft.bend_vjp(&self.d_warped, &mut gradient);
        self.clean.regularise(&self.field, weights, &mut gradient);
        self.adam.step(&ADAM, &[rate_px; 2], &mut self.field, &gradient);
    }

    /// Each pixel with how much ink there is and how far it moves, px at 256.
    fn moving(&mut self) -> impl Iterator<Item = (usize, f64, [f64; 2])> {
        let moved = self.soft.displacements(&self.field);
        let ink = self.warped.iter().zip(moved).enumerate();
        ink.map(|(i, (&ink, moved))| (i, f64::from(ink), moved.map(f64::from)))
    }

    /// Takes out how much the displacement stretches the ink as a whole, across and down: shrinking always agrees
    /// better, for what is small strays little, but shows nobody's drawing better.
    fn keep_size(&mut self) {
        // Where pixels and control vectors stand, px at 256; control k of a uniform cubic B-spline stands at k - 1 steps.
        let place =
            |i: usize, c: usize| ((if c == 0 { i % SIDE } else { i / SIDE }) as f64 + 0.5) * 256.0 / SIDE as f64;
        let control = |i: usize, c: usize| ((if c == 0 { i % GRID } else { i / GRID }) as f64 - 1.0) * SPACING_PX;
        let moving: Vec<_> = self.moving().collect();
        let total = moving.iter().map(|(_, ink, _)| ink).sum::<f64>().max(1e-6);
        for c in 0..2 {
            let middle = moving.iter().map(|&(i, ink, _)| ink * place(i, c)).sum::<f64>() / total;
            let stretch: f64 = moving.iter().map(|&(i, ink, moved)| ink * (place(i, c) - middle) * moved[c]).sum();
            let size: f64 = moving.iter().map(|&(i, ink, _)| ink * (place(i, c) - middle).powi(2)).sum();
            let share = stretch / size.max(1e-6);
            for (i, d) in self.field.iter_mut().enumerate() {
                d[c] -= (share * (control(i, c) - middle)) as f32;
            }
        }
    }

    /// Scales the displacement down where the ink would move farther than `most_px` on average.
    fn keep_near(&mut self, most_px: f64) {
        let (mut far, mut total) = (0.0, 1e-6);
        for (_, ink, [across, down]) in self.moving() {
            (far, total) = (far + ink * across.hypot(down), total + ink);
        }
        if far / total > most_px {
            let share = (most_px * total / far) as f32;
            self.field.iter_mut().flatten().for_each(|d| *d *= share);
        }
    }
}

/// Fills each sheet's `d_warped` with the gradient of Σ_views Σ A (1 - cov A)² / Σ A, where for the front
/// cov A(y, x) = max_z B(y, z) C(z, x) and likewise for side B and top C; without a top C is 1.
fn agreement_gradient(sheets: &mut [Sheet]) {
    const N: usize = SIDE;
    let soft: Vec<Vec<f32>> = sheets.iter().map(|sheet| sheet.warped.clone()).collect();
    let (front, side) = (&soft[0], &soft[1]);
    let ones = vec![1.0; N * N];
    let top = soft.get(2).unwrap_or(&ones);
    let mut cover = [vec![0.0f32; N * N], vec![0.0f32; N * N], vec![0.0f32; N * N]];
    let mut arg = [vec![0u32; N * N], vec![0u32; N * N], vec![0u32; N * N]];
    for y in 0..N {
        let a = &front[y * N..][..N];
        for z in 0..N {
            let b = side[y * N + z];
            let c = &top[z * N..][..N];
            let (cover_a, rest) = cover.split_at_mut(1);
            let (cover_b, cover_c) = rest.split_at_mut(1);
            let (arg_a, rest) = arg.split_at_mut(1);
            let (arg_b, arg_c) = rest.split_at_mut(1);
            if b > 1e-4 {
                raise(&mut cover_a[0][y * N..][..N], &mut arg_a[0][y * N..][..N], b, c, z as u32);
                raise(&mut cover_c[0][z * N..][..N], &mut arg_c[0][z * N..][..N], b, a, y as u32);
                (cover_b[0][y * N + z], arg_b[0][y * N + z]) = largest_product(a, c);
            }
        }
    }
    let views = sheets.len();
    let total: Vec<f32> = soft.iter().map(|ink| ink.iter().sum::<f32>().max(1e-6)).collect();
    for sheet in sheets.iter_mut() {
        sheet.d_warped.fill(0.0);
    }
    for v in 0..views {
        for i in 0..N * N {
            let (ink, short) = (soft[v][i], 1.0 - cover[v][i]);
            // Own ink moves to covered places…
            sheets[v].d_warped[i] += short * short / total[v];
            // … and the two others' ink to where it covers.
            let pull = 2.0 * ink * short / total[v];
            if pull < 1e-9 {
                continue;
            }
            let (row, column, k) = (i / N, i % N, arg[v][i] as usize);
            let pairs = match v {
                0 => [(1, row * N + k), (2, k * N + column)],
                1 => [(0, row * N + k), (2, column * N + k)],
                _ => [(1, k * N + row), (0, k * N + column)],
            };
            let value = |(u, at): (usize, usize)| if u < views { soft[u][at] } else { 1.0 };
            let (p, q) = (value(pairs[0]), value(pairs[1]));
            for ((u, at), other) in [(pairs[0], q), (pairs[1], p)] {
                if u < views {
                    sheets[u].d_warped[at] -= pull * other;
                }
            }
        }
    }
}

/// Where `factor` times `with` is more than the best so far, makes it the best and `name` whose it is. Written so that
/// the processor does several x at once: the compiler must not see a choice whether to read.
fn raise(best: &mut [f32], who: &mut [u32], factor: f32, with: &[f32], name: u32) {
    for ((best, who), with) in best.iter_mut().zip(who).zip(with) {
        let (value, before, former) = (factor * with, *best, *who);
        let is_more = value > before;
        *best = if is_more { value } else { before };
        *who = if is_more { name } else { former };
    }
}

/// The largest a(x) c(x) above 0 and the first x that has it; 0 and 0 where there is none. Several x side by side, as
/// the processor can do them at once.
fn largest_product(a: &[f32], c: &[f32]) -> (f32, u32) {
    const LANES: usize = 8;
    let (mut best, mut who) = ([0.0f32; LANES], [0u32; LANES]);
    for (block, (a, c)) in a.chunks_exact(LANES).zip(c.chunks_exact(LANES)).enumerate() {
        for lane in 0..LANES {
            let value = a[lane] * c[lane];
            who[lane] = if value > best[lane] { block as u32 } else { who[lane] };
            best[lane] = best[lane].max(value);
        }
    }
    let mut found = (0.0, 0);
    for lane in 0..LANES {
        let x = who[lane] * LANES as u32 + lane as u32;
        if best[lane] > found.0 || (best[lane] == found.0 && best[lane] > 0.0 && x < found.1) {
            found = (best[lane], x);
        }
    }
    found
}

fn mirror(image: &mut Image) {
    for row in image.data.chunks_exact_mut(image.width) {
        row.reverse();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::start::testing::{letters, picture, targets};
    use crate::start::{REPORT_ACROSS, coverable};

    #[test]
    fn bent_drawings_agree_better_and_say_how_far_they_moved() {
        // Three rings of different sizes: their hull is poor.
        let ring = |rx: f64, ry: f64| picture(move |x, y| (((x - 0.5) / rx).hypot((y - 0.5) / ry) - 1.0).abs() < 0.09);
        let drawings = targets(vec![ring(0.36, 0.3), ring(0.3, 0.36), ring(0.36, 0.36)]);
        let share = |targets: &[Target]| -> f32 {
            coverable(targets, [0.6; 3], REPORT_ACROSS).unwrap().iter().map(|c| c.share).sum::<f32>() / 3.0
        };
        let bent = bend(&drawings, &BendOptions::default(), &mut |_| true).unwrap();
        assert!(bent.note.is_none());
        let (before, after) = (share(&drawings), share(&bent.targets));
        assert!(after > before + 0.1, "{before} to {after}");
        for v in 0..3 {
            let Displacement { mean_px, max_px } = bent.moved[v];
            assert!(mean_px > 0.5 && mean_px < 20.0 && max_px < 40.0);
        }
        let weights = WarpWeights { smooth: 10.0, magnitude: 10.0, straight: 1.0 };
        let kept = bend(&drawings, &BendOptions { weights, ..BendOptions::default() }, &mut |_| true).unwrap();
        assert!(kept.moved.iter().all(|moved| moved.max_px < 1.0), "{:?}", kept.moved);
        assert_eq!(bent, bend(&drawings, &BendOptions::default(), &mut |_| true).unwrap());
    }

    #[test]
    fn agreement_gradient_is_that_of_finite_differences() {
        let mut sheets: Vec<Sheet> = Search::new(&letters(), BendOptions::default()).sheets;
        for (v, sheet) in sheets.iter_mut().enumerate() {
            sheet.soften(1.5);
            for (i, [across, _]) in sheet.field.iter_mut().enumerate() {
                *across = ((i * 7 + v) % 5) as f32 * 0.8;
            }
            sheet.soft.bend(&sheet.field, &mut sheet.warped);
        }
        let cost = |sheets: &[Sheet]| -> f64 {
            const N: usize = SIDE;
            let w: Vec<&Vec<f32>> = sheets.iter().map(|sheet| &sheet.warped).collect();
            let mut sum = 0.0;
            for v in 0..3 {
                let total: f64 = w[v].iter().map(|&x| f64::from(x)).sum();
                for i in 0..N * N {
                    let (row, column) = (i / N, i % N);
                    let cover = (0..N)
                        .map(|k| match v {
                            0 => w[1][row * N + k] * w[2][k * N + column],
                            1 => w[0][row * N + k] * w[2][column * N + k],
                            _ => w[1][k * N + row] * w[0][k * N + column],
                        })
                        .fold(0.0, f32::max);
                    sum += f64::from(w[v][i] * (1.0 - cover) * (1.0 - cover)) / total;
                }
            }
            sum
        };
        agreement_gradient(&mut sheets);
        // The gradient leaves out how the total ink changes; compare what is left when that is put back.
        let base = cost(&sheets);
        let mut worst = 0.0f64;
        for v in 0..3 {
            let total: f64 = sheets[v].warped.iter().map(|&x| f64::from(x)).sum();
            let own: f64 = base / 3.0 / total;
            let pixels: Vec<usize> = (0..SIDE * SIDE).filter(|&i| sheets[v].warped[i] > 0.3).step_by(67).collect();
            for i in pixels {
                let h = 2e-3;
                let kept = sheets[v].warped[i];
                sheets[v].warped[i] = kept + h;
                let up = cost(&sheets);
                sheets[v].warped[i] = kept - h;
                let down = cost(&sheets);
                sheets[v].warped[i] = kept;
                let numeric = (up - down) / f64::from(2.0 * h);
                worst = worst.max((numeric - f64::from(sheets[v].d_warped[i])).abs() - 2.0 * own);
            }
        }
        let size = sheets.iter().flat_map(|s| &s.d_warped).fold(0.0f32, |m, d| m.max(d.abs()));
        assert!(worst < 0.1 * f64::from(size), "{worst} of {size}");
    }

    #[test]
    fn the_largest_product_is_the_first_of_equals() {
        let mut rng = crate::rng::Rng::new(2, 0);
        for round in 0..200 {
            // Few values, so that equals are common.
            let mut some = || (0..SIDE).map(|_| rng.below(4 + round % 3) as f32 * 0.25).collect::<Vec<f32>>();
            let (a, c) = (some(), some());
            let mut plain = (0.0, 0);
            for x in 0..SIDE {
                if a[x] * c[x] > plain.0 {
                    plain = (a[x] * c[x], x as u32);
                }
            }
            assert_eq!(largest_product(&a, &c), plain);
        }
        assert_eq!(largest_product(&[0.0; SIDE], &[1.0; SIDE]), (0.0, 0));
    }

    #[test]
    fn drawings_keep_their_size_and_stay_near() {
        // A ring, a square's outline and a triangle's: little agrees.
        let ring = picture(|x, y| ((x - 0.5).hypot(y - 0.5) - 0.38).abs() < 0.02);
        let square = picture(|x, y| ((x - 0.5).abs().max((y - 0.5).abs()) - 0.3).abs() < 0.02);
        let triangle = picture(|x, y| ((2.0 * (x - 0.5).abs() + 0.2 - y).max(y - 0.85) + 0.02).abs() < 0.02);
        let drawings = targets(vec![ring, square, triangle]);
        // Standard deviation of the ink's place down the picture, px.
        let spread = |ink: &Image| {
            let rows = || ink.data.iter().enumerate().map(|(i, &w)| (f64::from(w), (i / ink.width) as f64));
            let total: f64 = rows().map(|r| r.0).sum();
            let middle = rows().map(|(w, y)| w * y).sum::<f64>() / total;
            (rows().map(|(w, y)| w * (y - middle).powi(2)).sum::<f64>() / total).sqrt()
        };
        let keeps_size = |before: &Image, after: &Image| (spread(after) / spread(before) - 1.0).abs() < 0.05;
        let moved = |max_mean_px: f64| {
            let options = BendOptions { max_mean_px, ..BendOptions::default() };
            let bent = bend(&drawings, &options, &mut |_| true).unwrap();
            for (after, before) in bent.targets.iter().zip(&drawings) {
                assert!(keeps_size(&before.ink, &after.ink), "{} {}", spread(&before.ink), spread(&after.ink));
            }
            bent.moved.iter().fold(0.0f64, |most, moved| most.max(moved.mean_px))
        };
        assert!(moved(1.0) < 1.3 && moved(6.0) < 7.8, "{} {}", moved(1.0), moved(6.0));
        assert!(moved(100.0) > moved(1.0), "the check can fail");
        let larger = picture(|x, y| ((x - 0.5).hypot(y - 0.5) - 0.42).abs() < 0.02);
        assert!(!keeps_size(&drawings[0].ink, &larger));
    }

    #[test]
    fn other_views_are_left_alone_with_a_note() {
        let mut drawings = letters();
        drawings[2].view = crate::view::View::orthographic("oblique", 0.4, 0.3, 1.375, 128);
        let bent = bend(&drawings, &BendOptions::default(), &mut |_| true).unwrap();
        assert!(bent.note.is_some() && bent.targets == drawings);
    }
}
