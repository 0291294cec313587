//! What catches the eye, to begin with: regions that differ from those that hang together with the border.
//!
//! Zhu, Liang, Wei and Sun 2014, without their optimisation over neighbours, on superpixels (Achanta et al. 2012).

/// Superpixels, about, and how round they are kept, in units of colour.
const REGIONS: usize = 250;
const ROUND: f32 = 15.0;
const PASSES: usize = 6;
/// How far colours may be apart along a path that joins regions to one area, in units of colour.
const ONE_AREA: f64 = 10.0;
/// How far regions compare themselves with others, share of the picture's longer side.
const NEARBY: f64 = 0.4;

/// 0 (ground) to 1 a pixel. `is_border` tells what is surely ground: the picture's rim, or what is outside a box.
pub fn saliency(width: usize, height: usize, lab: &[[f32; 3]], is_border: impl Fn(usize) -> bool) -> Vec<f32> {
    let label = superpixels(width, height, lab);
    let count = label.iter().max().map_or(0, |&most| most as usize + 1);
    let (mut sums, mut border) = (vec![[0.0f64; 6]; count], vec![false; count]);
    for (i, &l) in label.iter().enumerate() {
        let sum = &mut sums[l as usize];
        (0..3).for_each(|c| sum[c] += f64::from(lab[i][c]));
        sum[3] += (i % width) as f64;
        sum[4] += (i / width) as f64;
        sum[5] += 1.0;
        border[l as usize] |= is_border(i);
    }
    let side = width.max(height) as f64;
    let mean: Vec<[f64; 5]> = sums
        .iter()
        .map(|s| {
            let n = s[5].max(1.0);
            [s[0] / n, s[1] / n, s[2] / n, s[3] / n / side, s[4] / n / side]
        })
        .collect();
    let colour = |a: usize, b: usize| (0..3).map(|c| (mean[a][c] - mean[b][c]).powi(2)).sum::<f64>().sqrt();
    let place = |a: usize, b: usize| (3..5).map(|c| (mean[a][c] - mean[b][c]).powi(2)).sum::<f64>();
    // Neighbours; all of the border counts as joined.
    let mut joined = vec![false; count * count];
    for i in 0..label.len() {
        let (x, y) = (i % width, i / width);
        for (n, inside) in [(i + 1, x + 1 < width), (i + width, y + 1 < height)] {
            if inside && label[i] != label[n] {
                let (a, b) = (label[i] as usize, label[n] as usize);
                joined[a * count + b] = true;
                joined[b * count + a] = true;
            }
        }
    }
    for a in (0..count).filter(|&a| border[a]) {
        for b in (0..count).filter(|&b| b != a && border[b]) {
            joined[a * count + b] = true;
        }
    }
    // Steps that all regions have are none.
    let nearest =
        |a: usize| (0..count).filter(|&b| joined[a * count + b]).map(|b| colour(a, b)).fold(f64::MAX, f64::min);
    let usual = (0..count).map(nearest).filter(|&d| d < f64::MAX).sum::<f64>() / count.max(1) as f64;
    let paths: Vec<Vec<f64>> = (0..count)
        .map(|from| geodesic(from, count, |a, b| joined[a * count + b].then(|| (colour(a, b) - usual).max(0.0))))
        .collect();
    let ground: Vec<f64> = (0..count)
        .map(|a| {
            let (mut area, mut rim) = (0.0, 0.0);
            for b in 0..count {
                let same = (-paths[a][b].powi(2) / (2.0 * ONE_AREA * ONE_AREA)).exp();
                area += same;
                rim += if border[b] { same } else { 0.0 };
            }
            1.0 - (-0.5 * (rim * rim / area)).exp()
        })
        .collect();
    let contrast: Vec<f64> = (0..count)
        .map(|a| {
            let term = |b: usize| colour(a, b) * (-place(a, b) / (2.0 * NEARBY * NEARBY)).exp() * ground[b];
            (1.0 - ground[a]) * (0..count).map(term).sum::<f64>()
        })
        .collect();
    let most = contrast.iter().fold(1e-9f64, |most, &value| most.max(value));
    label.iter().map(|&l| (contrast[l as usize] / most) as f32).collect()
}

/// Lengths of the shortest paths from one region to all (Dijkstra 1959); few enough for a plain search.
fn geodesic(from: usize, count: usize, step: impl Fn(usize, usize) -> Option<f64>) -> Vec<f64> {
    let (mut best, mut done) = (vec![f64::INFINITY; count], vec![false; count]);
    best[from] = 0.0;
    loop {
        let open = (0..count).filter(|&a| !done[a] && best[a] < 4.0 * ONE_AREA);
        let Some(a) = open.min_by(|&a, &b| best[a].total_cmp(&best[b])) else { return best };
        done[a] = true;
        for b in 0..count {
            if let Some(length) = step(a, b).filter(|_| !done[b]) {
                best[b] = best[b].min(best[a] + length);
            }
        }
    }
}

/// Small regions of like colour: means of colour and place, moved a few times from a regular grid.
fn superpixels(width: usize, height: usize, lab: &[[f32; 3]]) -> Vec<u32> {
    let step = ((width * height) as f64 / REGIONS as f64).sqrt().max(1.0);
    let counts = [width, height].map(|side| ((side as f64 / step).round() as usize).max(1));
    let mut centres: Vec<[f32; 5]> = Vec::new();
    for j in 0..counts[1] {
        for i in 0..counts[0] {
            let x = ((i as f64 + 0.5) * width as f64 / counts[0] as f64) as usize;
            let y = ((j as f64 + 0.5) * height as f64 / counts[1] as f64) as usize;
            let [l, a, b] = lab[y * width + x];
            centres.push([l, a, b, x as f32, y as f32]);
        }
    }
    let pull = (ROUND / step as f32).powi(2);
    let mut label = vec![0u32; lab.len()];
    let mut nearest = vec![f32::INFINITY; lab.len()];
    for _ in 0..PASSES {
        nearest.fill(f32::INFINITY);
        for (k, centre) in centres.iter().enumerate() {
            let reach = 1.5 * step as f32;
            let range = |middle: f32, side: usize| {
                (middle - reach).max(0.0) as usize..((middle + reach) as usize + 1).min(side)
            };
            for y in range(centre[4], height) {
                for x in range(centre[3], width) {
                    let i = y * width + x;
                    let colour: f32 = (0..3).map(|c| (lab[i][c] - centre[c]).powi(2)).sum();
                    let away = (x as f32 - centre[3]).powi(2) + (y as f32 - centre[4]).powi(2);
                    let distance = colour + pull * away;
                    if distance < nearest[i] {
                        nearest[i] = distance;
                        label[i] = k as u32;
                    }
                }
            }
        }
        let mut sums = vec![[0.0f64; 6]; centres.len()];
        for (i, &l) in label.iter().enumerate() {
            let sum = &mut sums[l as usize];
            (0..3).for_each(|c| sum[c] += f64::from(lab[i][c]));
            sum[3] += (i % width) as f64;
            sum[4] += (i / width) as f64;
            sum[5] += 1.0;
        }
        for (centre, sum) in centres.iter_mut().zip(&sums) {
            if sum[5] > 0.0 {
                *centre = [0, 1, 2, 3, 4].map(|c| (sum[c] / sum[5]) as f32);
            }
        }
    }
    label
}
