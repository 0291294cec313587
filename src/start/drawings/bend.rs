//! Bending drawings before the start so that their hulls agree: a smooth displacement field per view, all together, that
//! moves ink to where some point of space lies on ink in every view. Straight strokes are kept straight.

use super::displacement::Lattice;
use super::shared::are_canonical;
use crate::error::Result;
use crate::view::{Image, Target};

/// How freely drawings may bend. The weights were found by trial: drawings stay readable and agree.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendOptions {
    /// Price of bending and shearing the paper.
    pub stiffness: f32,
    /// Price of moving at all.
    pub stay: f32,
    /// Price of bending a straight stroke, on top.
    pub straightness: f32,
    /// How far a drawing's ink may move on average, px of a 256 px picture: beyond, people no longer see their drawing.
    pub max_mean_px: f32,
    /// Steps of the search.
    pub steps: usize,
}

impl Default for BendOptions {
    fn default() -> Self {
        BendOptions { stiffness: 0.02, stay: 0.001, straightness: 1.0, max_mean_px: 6.0, steps: 160 }
    }
}

/// Drawings after bending.
#[derive(Debug, Clone, PartialEq)]
pub struct Bent {
    /// The bent targets.
    pub targets: Vec<Target>,
    /// For each view how far its ink moved on average, px of a 256 px picture.
    pub mean_px: Vec<f32>,
    /// For each view how far its ink moved at most, px of a 256 px picture.
    pub max_px: Vec<f32>,
    /// Why nothing was bent, if so.
    pub note: Option<&'static str>,
}

/// Side of the pictures on which the search runs.
const SIDE: usize = 64;
/// Lattice points a side of the displacement fields.
const CONTROLS: usize = 12;

/// Bends the drawings of two (front, side) or three (front, side, top) canonical orthographic views; other views are
/// left as they are, with a note. `progress` is told the share done and stops the search by returning false.
///
/// # Errors
/// None today; kept for pictures that cannot be bent.
pub fn bend(targets: &[Target], options: &BendOptions, progress: &mut dyn FnMut(f32) -> bool) -> Result<Bent> {
    if !are_canonical(targets) {
        let count = targets.len();
        let note = "only front, side and top views without perspective can be bent before the start";
        let zeros = vec![0.0; count];
        return Ok(Bent { targets: targets.to_vec(), mean_px: zeros.clone(), max_px: zeros, note: Some(note) });
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
    /// Ink blurred and saturated: what the search sees at its present coarseness.
    soft: Image,
    /// Displacement lattices across and down, px of [`SIDE`].
    lattice: [Vec<f32>; 2],
    momentum: [Vec<f32>; 2],
    spread: [Vec<f32>; 2],
    /// Displacement at every pixel.
    shift: [Vec<f32>; 2],
    /// Soft ink as displaced, and its slopes across and down.
    warped: Vec<f32>,
    slope: [Vec<f32>; 2],
    d_warped: Vec<f32>,
    straight: Straight,
}

/// Where strokes are straight and which way they run, as planes that can be gone through side by side. For a stroke of
/// unit direction t and normal n, the second derivative of n·d along t is Σ n(c) f(k) ∂²d(c) over the three second
/// derivatives.
struct Straight {
    weight: Vec<f32>,
    /// n, across and down.
    normal: [Vec<f32>; 2],
    /// f: t(x)², 2 t(x) t(y), t(y)².
    factor: [Vec<f32>; 3],
}

struct Search {
    options: BendOptions,
    lattice: Lattice,
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
        Search { options, lattice: Lattice::new(SIDE, CONTROLS), sheets: sheets.collect() }
    }

    fn step(&mut self, step: usize) {
        let done = step as f32 / self.options.steps as f32;
        // From a blur that bridges most gaps down to the drawing itself.
        let sigma = 2.5 * (1.0 - done) + 0.6;
        for sheet in &mut self.sheets {
            if step.is_multiple_of(20) {
                sheet.soften(sigma);
            }
            sheet.warp(&mut self.lattice);
        }
        agreement_gradient(&mut self.sheets);
        let rate = 0.12 * (1.0 - 0.8 * done);
        for sheet in &mut self.sheets {
            sheet.descend(&mut self.lattice, &self.options, rate, step + 1);
            sheet.warp(&mut self.lattice);
            sheet.keep_size();
            sheet.keep_near(self.options.max_mean_px * SIDE as f32 / 256.0);
        }
    }

    fn finished(self, targets: &[Target]) -> Bent {
        let mut bent = Bent { targets: Vec::new(), mean_px: Vec::new(), max_px: Vec::new(), note: None };
        for (v, (sheet, target)) in self.sheets.iter().zip(targets).enumerate() {
            let size = target.ink.width;
            let mut fine = Lattice::new(size, CONTROLS);
            let scale = size as f32 / SIDE as f32;
            let mut shift = [vec![0.0; size * size], vec![0.0; size * size]];
            for (shift, lattice) in shift.iter_mut().zip(&sheet.lattice) {
                fine.evaluate(lattice, 0, 0, shift);
                shift.iter_mut().for_each(|s| *s *= scale);
            }
            let (mut sum, mut count, mut most) = (0.0, 0.0, 0.0f32);
            let mut ink = Image::new(size, size);
            for y in 0..size {
                for x in 0..size {
                    // The side's field was found in its mirror image.
                    let column = if v == 1 { size - 1 - x } else { x };
                    let at = y * size + column;
                    let (across, down) = (if v == 1 { -shift[0][at] } else { shift[0][at] }, shift[1][at]);
                    let value = target.ink.sample(x as f32 + 0.5 + across, y as f32 + 0.5 + down);
                    ink.data[y * size + x] = value;
                    if value > 0.5 {
                        let far = across.hypot(down) * 256.0 / size as f32;
                        (sum, count, most) = (sum + far, count + 1.0, most.max(far));
                    }
                }
            }
            bent.targets.push(Target { view: target.view.clone(), ink });
            bent.mean_px.push(if count > 0.0 { sum / count } else { 0.0 });
            bent.max_px.push(most);
        }
        bent
    }
}

impl Sheet {
    fn new(ink: Image) -> Sheet {
        let zeros = || [vec![0.0; CONTROLS * CONTROLS], vec![0.0; CONTROLS * CONTROLS]];
        let plane = || vec![0.0; SIDE * SIDE];
        Sheet {
            straight: straightness(&ink),
            soft: ink.clone(),
            ink,
            lattice: zeros(),
            momentum: zeros(),
            spread: zeros(),
            shift: [plane(), plane()],
            warped: plane(),
            slope: [plane(), plane()],
            d_warped: plane(),
        }
    }

    fn soften(&mut self, sigma: f32) {
        self.soft = self.ink.blurred(f64::from(sigma));
        // Saturated, so that a blurred line is as dark in its middle as before.
        self.soft.data.iter_mut().for_each(|v| *v = (*v * (1.0 + 0.9 * sigma)).min(1.0));
    }

    fn warp(&mut self, lattice: &mut Lattice) {
        for c in 0..2 {
            lattice.evaluate(&self.lattice[c], 0, 0, &mut self.shift[c]);
        }
        for y in 0..SIDE {
            for x in 0..SIDE {
                let i = y * SIDE + x;
                let (value, slope) =
                    sample_with_slope(&self.soft, x as f32 + self.shift[0][i], y as f32 + self.shift[1][i]);
                self.warped[i] = value;
                (self.slope[0][i], self.slope[1][i]) = (slope[0], slope[1]);
            }
        }
    }

    /// One Adam step down the gradient left in `d_warped` plus the prices of bending.
    fn descend(&mut self, lattice: &mut Lattice, options: &BendOptions, rate: f32, step: usize) {
        const K: usize = CONTROLS;
        let mut gradient = [vec![0.0f32; K * K], vec![0.0f32; K * K]];
        let mut product = vec![0.0f32; SIDE * SIDE];
        for c in 0..2 {
            for (i, value) in product.iter_mut().enumerate() {
                *value = self.d_warped[i] * self.slope[c][i];
            }
            lattice.evaluate_vjp(&product, 0, 0, &mut gradient[c]);
            let per_control = 1.0 / (K * K) as f32;
            add_difference_gradient(&self.lattice[c], options.stiffness * per_control, &mut gradient[c]);
            for (g, d) in gradient[c].iter_mut().zip(&self.lattice[c]) {
                *g += 2.0 * options.stay * per_control * d;
            }
        }
        self.add_straightness_gradient(lattice, options.straightness, &mut gradient);
        let (bias_m, bias_v) = (1.0 - 0.9f32.powi(step as i32), 1.0 - 0.98f32.powi(step as i32));
        for c in 0..2 {
            for i in 0..K * K {
                let g = gradient[c][i];
                self.momentum[c][i] = 0.9 * self.momentum[c][i] + 0.1 * g;
                self.spread[c][i] = 0.98 * self.spread[c][i] + 0.02 * g * g;
                self.lattice[c][i] -=
                    rate * (self.momentum[c][i] / bias_m) / ((self.spread[c][i] / bias_v).sqrt() + 1e-9);
            }
        }
    }

    /// Takes out how much the displacement stretches the ink as a whole, across and down: shrinking always agrees
    /// better, for what is small strays little, but shows nobody's drawing better.
    fn keep_size(&mut self) {
        const K: usize = CONTROLS;
        let total: f32 = self.warped.iter().sum::<f32>().max(1e-6);
        for c in 0..2 {
            let place = |i: usize| (if c == 0 { i % SIDE } else { i / SIDE }) as f32 + 0.5;
            let ink = || self.warped.iter().enumerate();
            let middle = ink().map(|(i, w)| w * place(i)).sum::<f32>() / total;
            let stretch = ink().map(|(i, w)| w * (place(i) - middle) * self.shift[c][i]).sum::<f32>();
            let size = ink().map(|(i, w)| w * (place(i) - middle).powi(2)).sum::<f32>();
            let share = stretch / size.max(1e-6);
            // Control k of a uniform cubic B-spline stands at (k - 1) steps: a linear function's own controls.
            let spacing = SIDE as f32 / (K - 3) as f32;
            for (i, d) in self.lattice[c].iter_mut().enumerate() {
                let k = if c == 0 { i % K } else { i / K };
                *d -= share * ((k as f32 - 1.0) * spacing - middle);
            }
            for i in 0..SIDE * SIDE {
                self.shift[c][i] -= share * (place(i) - middle);
            }
        }
    }

    /// Scales the displacement down where the ink would move farther than `most_px` on average.
    fn keep_near(&mut self, most_px: f32) {
        let total: f32 = self.warped.iter().sum::<f32>().max(1e-6);
        let far = |(i, w): (usize, &f32)| w * self.shift[0][i].hypot(self.shift[1][i]);
        let mean = self.warped.iter().enumerate().map(far).sum::<f32>() / total;
        if mean > most_px {
            let share = most_px / mean;
            self.lattice.iter_mut().flatten().for_each(|d| *d *= share);
        }
    }

    /// Gradient of mean w (∂²(n·d)/∂t²)² over straight strokes with direction t and normal n: how much a straight
    /// stroke would curve.
    fn add_straightness_gradient(&self, lattice: &mut Lattice, weight: f32, gradient: &mut [Vec<f32>; 2]) {
        let Straight { weight: strength, normal, factor } = &self.straight;
        let total: f32 = strength.iter().sum();
        if weight <= 0.0 || total <= 0.0 {
            return;
        }
        let orders = [(2, 0), (1, 1), (0, 2)];
        let mut curving = vec![0.0f32; SIDE * SIDE];
        let mut part = vec![0.0f32; SIDE * SIDE];
        for c in 0..2 {
            for (k, &(along_x, along_y)) in orders.iter().enumerate() {
                lattice.evaluate(&self.lattice[c], along_x, along_y, &mut part);
                for (((sum, n), f), d) in curving.iter_mut().zip(&normal[c]).zip(&factor[k]).zip(&part) {
                    *sum += n * f * d;
                }
            }
        }
        // Scaled to the size of lattice differences, (SIDE / CONTROLS)², so that its weight compares with stiffness.
        let scale = (SIDE as f32 / CONTROLS as f32).powi(4) * weight / total / CONTROLS as f32;
        for c in 0..2 {
            for (k, &(along_x, along_y)) in orders.iter().enumerate() {
                let directions = normal[c].iter().zip(&factor[k]);
                for (((d, w), curving), (n, f)) in part.iter_mut().zip(strength).zip(&curving).zip(directions) {
                    *d = 2.0 * scale * w * curving * n * f;
                }
                lattice.evaluate_vjp(&part, along_x, along_y, &mut gradient[c]);
            }
        }
    }
}

/// Gradient of the squared second differences, and half the squared first ones, along both axes of a lattice.
fn add_difference_gradient(lattice: &[f32], weight: f32, gradient: &mut [f32]) {
    const K: usize = CONTROLS;
    for stride in [1, K] {
        for line in 0..K {
            let start = if stride == 1 { line * K } else { line };
            for i in 0..K - 1 {
                let (a, b) = (start + i * stride, start + (i + 1) * stride);
                let first = weight * (lattice[b] - lattice[a]);
                gradient[a] -= first;
                gradient[b] += first;
                if i + 2 < K {
                    let c = b + stride;
                    let second = 2.0 * weight * (lattice[a] - 2.0 * lattice[b] + lattice[c]);
                    gradient[a] += second;
                    gradient[b] -= 2.0 * second;
                    gradient[c] += second;
                }
            }
        }
    }
}

/// Where the picture's edges run straight: weight 0 to 1 and direction, from the structure tensor (Bigün & Granlund
/// 1987) over a window of a tenth of the picture.
fn straightness(ink: &Image) -> Straight {
    let soft = ink.blurred(0.7);
    let mut tensor = [Image::new(SIDE, SIDE), Image::new(SIDE, SIDE), Image::new(SIDE, SIDE)];
    for y in 1..SIDE - 1 {
        for x in 1..SIDE - 1 {
            let gx = 0.5 * (soft.at(x + 1, y) - soft.at(x - 1, y));
            let gy = 0.5 * (soft.at(x, y + 1) - soft.at(x, y - 1));
            let i = y * SIDE + x;
            for (image, value) in tensor.iter_mut().zip([gx * gx, gx * gy, gy * gy]) {
                image.data[i] = value;
            }
        }
    }
    let tensor = tensor.map(|image| image.blurred(SIDE as f64 / 20.0));
    let mut straight = Straight { weight: Vec::new(), normal: Default::default(), factor: Default::default() };
    for i in 0..SIDE * SIDE {
        let [xx, xy, yy] = [0, 1, 2].map(|k| tensor[k].data[i]);
        let (sum, spread) = (xx + yy, (xx - yy).hypot(2.0 * xy));
        let coherence = if sum > 1e-6 { spread / sum } else { 0.0 };
        // The stroke runs across the strongest gradient.
        let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
        let [tx, ty] = [-angle.sin(), angle.cos()];
        straight.weight.push(coherence.powi(4) * soft.data[i].min(1.0));
        for (plane, value) in straight.normal.iter_mut().zip([-ty, tx]) {
            plane.push(value);
        }
        for (plane, value) in straight.factor.iter_mut().zip([tx * tx, 2.0 * tx * ty, ty * ty]) {
            plane.push(value);
        }
    }
    straight
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

/// Bilinear value and its slopes at a place in pixels (centres at whole numbers); the nearest value outside.
fn sample_with_slope(image: &Image, x: f32, y: f32) -> (f32, [f32; 2]) {
    let last = (SIDE - 1) as f32;
    let (x, y) = (x.clamp(0.0, last - 1e-3), y.clamp(0.0, last - 1e-3));
    let (column, row) = (x as usize, y as usize);
    let (u, v) = (x - column as f32, y - row as f32);
    let i = row * SIDE + column;
    let (a, b, c, d) = (image.data[i], image.data[i + 1], image.data[i + SIDE], image.data[i + SIDE + 1]);
    let (upper, lower) = (a + u * (b - a), c + u * (d - c));
    (upper + v * (lower - upper), [(b - a) + v * ((d - c) - (b - a)), lower - upper])
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
            assert!(bent.mean_px[v] > 0.5 && bent.mean_px[v] < 20.0 && bent.max_px[v] < 40.0);
        }
        let stiff = BendOptions { stiffness: 10.0, stay: 10.0, ..BendOptions::default() };
        let kept = bend(&drawings, &stiff, &mut |_| true).unwrap();
        assert!(kept.max_px.iter().all(|&px| px < 1.0), "{:?}", kept.max_px);
        assert_eq!(bent, bend(&drawings, &BendOptions::default(), &mut |_| true).unwrap());
    }

    #[test]
    fn agreement_gradient_is_that_of_finite_differences() {
        let mut sheets: Vec<Sheet> = Search::new(&letters(), BendOptions::default()).sheets;
        let mut lattice = Lattice::new(SIDE, CONTROLS);
        for (v, sheet) in sheets.iter_mut().enumerate() {
            sheet.soften(1.5);
            for i in 0..CONTROLS * CONTROLS {
                sheet.lattice[0][i] = ((i * 7 + v) % 5) as f32 * 0.2;
            }
            sheet.warp(&mut lattice);
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
        let moved = |max_mean_px: f32| {
            let options = BendOptions { max_mean_px, ..BendOptions::default() };
            let bent = bend(&drawings, &options, &mut |_| true).unwrap();
            for (after, before) in bent.targets.iter().zip(&drawings) {
                assert!(keeps_size(&before.ink, &after.ink), "{} {}", spread(&before.ink), spread(&after.ink));
            }
            bent.mean_px.iter().fold(0.0f32, |most, &mean| most.max(mean))
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
