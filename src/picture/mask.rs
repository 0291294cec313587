//! Yes-or-no pictures and what can be asked of their shape: distance, skeleton, connected parts, bounding box.

use crate::view::{Image, PixelBox};

/// A picture of yes (ink) and no (ground), row by row from the top left.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Mask {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// `width * height` values.
    pub data: Vec<bool>,
}

/// Connected parts of a [`Mask`], pixels joined across sides and corners.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Components {
    /// A pixel's part, counted from 1 in reading order; 0 on ground.
    pub labels: Vec<u32>,
    /// Pixels of each part, `sizes[label - 1]`.
    pub sizes: Vec<usize>,
}

/// In [`Mask::nearest`]: there is no ink at all.
pub const NOWHERE: u32 = u32::MAX;

impl Mask {
    /// All ground.
    pub fn new(width: usize, height: usize) -> Self {
        Mask { width, height, data: vec![false; width * height] }
    }

    /// Whether column `x`, row `y` is ink.
    pub fn at(&self, x: usize, y: usize) -> bool {
        self.data[y * self.width + x]
    }

    /// Number of ink pixels.
    pub fn count(&self) -> usize {
        self.data.iter().filter(|&&ink| ink).count()
    }

    /// Ground where there was ink and the reverse.
    pub fn inverted(&self) -> Mask {
        Mask { data: self.data.iter().map(|ink| !ink).collect(), ..*self }
    }

    /// Ink 1, ground 0.
    pub fn to_image(&self) -> Image {
        let data = self.data.iter().map(|&ink| f32::from(u8::from(ink))).collect();
        Image { width: self.width, height: self.height, data }
    }

    /// The smallest rectangle round all ink; `None` without ink.
    pub fn bounding_box(&self) -> Option<PixelBox> {
        let mut ink: Option<PixelBox> = None;
        for (i, _) in self.data.iter().enumerate().filter(|(_, ink)| **ink) {
            let (x, y) = (i % self.width, i / self.width);
            let known = ink.unwrap_or(PixelBox { left: x, top: y, right: x + 1, bottom: y + 1 });
            ink = Some(PixelBox {
                left: known.left.min(x),
                top: known.top.min(y),
                right: known.right.max(x + 1),
                bottom: known.bottom.max(y + 1),
            });
        }
        ink
    }

    /// For every pixel the index (`y * width + x`) of the ink pixel nearest to it, centre to centre; exact.
    /// [`NOWHERE`] without ink. Lower envelope of parabolas (Felzenszwalb and Huttenlocher 2012), linear in the area.
    pub fn nearest(&self) -> Vec<u32> {
        let (width, height) = (self.width, self.height);
        let mut nearest = vec![NOWHERE; width * height];
        let mut take_nearer = |i: usize, y: usize, candidate: u32| {
            let far = |from: u32| if from == NOWHERE { usize::MAX } else { y.abs_diff(from as usize / width) };
            if far(candidate) < far(nearest[i]) {
                nearest[i] = candidate;
            }
        };
        // Down each column: the nearest ink in the same column, from above and then from below.
        for x in 0..width {
            for upwards in [false, true] {
                let mut last = NOWHERE;
                for step in 0..height {
                    let y = if upwards { height - 1 - step } else { step };
                    let i = y * width + x;
                    if self.data[i] {
                        last = i as u32;
                    }
                    take_nearer(i, y, last);
                }
            }
        }
        // Along each row: column c offers (x - c)² + g(c)²; keep the lower envelope of these parabolas.
        let mut hull: Vec<(usize, u32, i64)> = Vec::with_capacity(width); // column, its ink, g²
        let mut starts: Vec<f64> = Vec::with_capacity(width); // where each parabola of the hull takes over
        for y in 0..height {
            hull.clear();
            starts.clear();
            let row = &mut nearest[y * width..][..width];
            for (c, &ink) in row.iter().enumerate().filter(|(_, ink)| **ink != NOWHERE) {
                let g = y.abs_diff(ink as usize / width) as i64;
                let mut start = f64::NEG_INFINITY;
                while let Some(&(b, _, gb)) = hull.last() {
                    let (cc, bb) = ((c * c) as i64, (b * b) as i64);
                    start = (cc + g * g - bb - gb) as f64 / (2 * (c - b)) as f64;
                    if starts.last().is_none_or(|&last| start > last) {
                        break;
                    }
                    hull.pop();
                    starts.pop();
                    start = f64::NEG_INFINITY;
                }
                hull.push((c, ink, g * g));
                starts.push(start);
            }
            if hull.is_empty() {
                continue;
            }
            let mut k = 0;
            for (x, out) in row.iter_mut().enumerate() {
                while k + 1 < hull.len() && starts[k + 1] < x as f64 {
                    k += 1;
                }
                *out = hull[k].1;
            }
        }
        nearest
    }

    /// Exact Euclidean distance in pixels from each pixel's centre to the nearest ink pixel's centre; 0 on ink,
    /// infinite without ink.
    pub fn distance_px(&self) -> Image {
        let width = self.width;
        let distance = |(i, ink): (usize, u32)| {
            if ink == NOWHERE {
                return f32::INFINITY;
            }
            let dx = (i % width).abs_diff(ink as usize % width) as f64;
            let dy = (i / width).abs_diff(ink as usize / width) as f64;
            (dx * dx + dy * dy).sqrt() as f32
        };
        let data = self.nearest().into_iter().enumerate().map(distance).collect();
        Image { width, height: self.height, data }
    }

    /// Parts that hang together across sides and corners.
    pub fn components(&self) -> Components {
        let (width, height) = (self.width, self.height);
        let mut labels = vec![0u32; width * height];
        let mut sizes = Vec::new();
        let mut front = Vec::new();
        for seed in 0..labels.len() {
            if !self.data[seed] || labels[seed] != 0 {
                continue;
            }
            let label = sizes.len() as u32 + 1;
            let mut size = 0;
            labels[seed] = label;
            front.push(seed);
            while let Some(i) = front.pop() {
                size += 1;
                let (x, y) = (i % width, i / width);
                for ny in y.saturating_sub(1)..height.min(y + 2) {
                    for nx in x.saturating_sub(1)..width.min(x + 2) {
                        let n = ny * width + nx;
                        if self.data[n] && labels[n] == 0 {
                            labels[n] = label;
                            front.push(n);
                        }
                    }
                }
            }
            sizes.push(size);
        }
        Components { labels, sizes }
    }

    /// The skeleton: ink thinned from all sides to lines one pixel wide, with the same parts and the same holes.
    ///
    /// Peels north, south, east and west borders in turn (Rosenfeld 1975). Pixels go one by one while that is
    /// safe, so that nothing vanishes or falls apart, which parallel schemes such as Zhang and Suen's do to
    /// 2 x 2 squares and to stairs.
    pub fn thin(&self) -> Mask {
        let mut grid = Padded::new(self);
        // Pixels that may go, in reading order: at first all on a border, then those beside pixels that went.
        let mut active: Vec<usize> =
            (0..grid.data.len()).filter(|&i| grid.data[i] && grid.ring(i).contains(&false)).collect();
        let mut is_active = vec![false; grid.data.len()];
        active.iter().for_each(|&i| is_active[i] = true);
        let mut touched = vec![false; grid.data.len()];
        let mut going = Vec::new();
        while !active.is_empty() {
            for side in [N, S, E, W] {
                // Tips are judged before the side is peeled (or each row's last pixel would look like one), the rest after.
                going.clear();
                going.extend(active.iter().copied().filter(|&i| !grid.ring(i)[side] && !is_end(grid.ring(i))));
                for &i in &going {
                    if is_simple(grid.ring(i)) {
                        grid.data[i] = false;
                        for n in grid.around(i) {
                            touched[n] = true;
                            if grid.data[n] && !std::mem::replace(&mut is_active[n], true) {
                                active.push(n);
                            }
                        }
                    }
                }
                active.retain(|&i| grid.data[i]);
                active.sort_unstable();
            }
            active.retain(|&i| {
                let stays = std::mem::take(&mut touched[i]);
                is_active[i] = stays;
                stays
            });
        }
        grid.inner()
    }

    /// Ink grown by discs of `radius_px`: every pixel at most that far from ink, centre to centre.
    pub fn dilated(&self, radius_px: f32) -> Mask {
        let (width, height) = (self.width, self.height);
        if radius_px > MOST_SCATTERED {
            let data = self.distance_px().data.iter().map(|&distance| distance <= radius_px).collect();
            return Mask { width, height, data };
        }
        // Nothing is nearer to blank pixels than ink beside blank ones.
        let reach = radius_px as usize;
        let half_widths: Vec<usize> =
            (0..=reach).map(|dy| (radius_px * radius_px - (dy * dy) as f32).max(0.0).sqrt() as usize).collect();
        let mut grown = self.clone();
        for i in (0..self.data.len()).filter(|&i| self.data[i]) {
            let (x, y) = (i % width, i / width);
            let is_inner = (x == 0 || self.data[i - 1])
                && (x + 1 == width || self.data[i + 1])
                && (y == 0 || self.data[i - width])
                && (y + 1 == height || self.data[i + width]);
            if is_inner {
                continue;
            }
            for v in y.saturating_sub(reach)..height.min(y + reach + 1) {
                let half = half_widths[v.abs_diff(y)];
                let (left, right) = (x.saturating_sub(half), width.min(x + half + 1));
                grown.data[v * width + left..v * width + right].fill(true);
            }
        }
        grown
    }
}

/// Up to this radius growing disc by disc is quicker than knowing all distances, px.
const MOST_SCATTERED: f32 = 16.0;

/// A mask with one pixel of ground all round, so that every pixel has eight neighbours.
struct Padded {
    stride: usize,
    data: Vec<bool>,
}

impl Padded {
    fn new(mask: &Mask) -> Self {
        let stride = mask.width + 2;
        let mut data = vec![false; stride * (mask.height + 2)];
        for y in 0..mask.height {
            data[(y + 1) * stride + 1..][..mask.width].copy_from_slice(&mask.data[y * mask.width..][..mask.width]);
        }
        Padded { stride, data }
    }

    fn inner(&self) -> Mask {
        let (width, height) = (self.stride - 2, self.data.len() / self.stride - 2);
        let rows = (0..height).flat_map(|y| &self.data[(y + 1) * self.stride + 1..][..width]);
        Mask { width, height, data: rows.copied().collect() }
    }

    /// The places of the eight neighbours, clockwise from north.
    fn around(&self, i: usize) -> [usize; 8] {
        let s = self.stride;
        [i - s, i - s + 1, i + 1, i + s + 1, i + s, i + s - 1, i - 1, i - s - 1]
    }

    /// The eight neighbours, in the same order.
    fn ring(&self, i: usize) -> [bool; 8] {
        self.around(i).map(|n| self.data[n])
    }
}

// Places in the ring.
const N: usize = 0;
const E: usize = 2;
const S: usize = 4;
const W: usize = 6;

/// The pixel's neighbours stay joined without it and no hole opens: its 8-connectivity number is 1 (Yokoi 1975).
fn is_simple(ring: [bool; 8]) -> bool {
    [N, E, S, W].into_iter().filter(|&k| !ring[k] && (ring[k + 1] || ring[(k + 2) % 8])).count() == 1
}

/// The tip of a line: one neighbour, or two that touch each other.
fn is_end(ring: [bool; 8]) -> bool {
    match ring.iter().filter(|&&ink| ink).count() {
        0 | 1 => true,
        2 => (0..8).any(|k| ring[k] && ring[(k + 1) % 8]),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::Ink;
    use crate::rng::Rng;

    fn parse(rows: &[&str]) -> Mask {
        let data = rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
        Mask { width: rows[0].len(), height: rows.len(), data }
    }

    fn random(width: usize, height: usize, share: f64, rng: &mut Rng) -> Mask {
        Mask { width, height, data: (0..width * height).map(|_| rng.unit() < share).collect() }
    }

    fn brute_distance(mask: &Mask, x: usize, y: usize) -> f32 {
        let each = (0..mask.data.len()).filter(|&i| mask.data[i]);
        let squared = each.map(|i| (i % mask.width).abs_diff(x).pow(2) + (i / mask.width).abs_diff(y).pow(2));
        squared.min().map_or(f32::INFINITY, |d| (d as f64).sqrt() as f32)
    }

    #[test]
    fn distance_is_exact() {
        let mut rng = Rng::new(1, 0);
        for share in [0.0, 0.005, 0.05, 0.5, 1.0] {
            let mask = random(37, 23, share, &mut rng);
            let distance = mask.distance_px();
            for y in 0..mask.height {
                for x in 0..mask.width {
                    assert_eq!(distance.at(x, y), brute_distance(&mask, x, y), "at {x},{y} of share {share}");
                }
            }
        }
        // Sibling: a city-block distance would not pass.
        let mut one = Mask::new(5, 5);
        one.data[0] = true;
        assert_ne!(brute_distance(&one, 2, 2), 4.0);
    }

    #[test]
    fn nearest_names_ink_at_that_distance() {
        let mask = random(40, 31, 0.01, &mut Rng::new(2, 0));
        let (nearest, distance) = (mask.nearest(), mask.distance_px());
        for (i, &ink) in nearest.iter().enumerate() {
            assert!(mask.data[ink as usize]);
            if mask.data[i] {
                assert_eq!((ink as usize, distance.data[i]), (i, 0.0));
            }
        }
        assert!(Mask::new(3, 3).nearest().iter().all(|&ink| ink == NOWHERE));
    }

    #[test]
    fn thinning_keeps_parts_and_holes_and_is_thin() {
        let mut rng = Rng::new(3, 0);
        for round in 0..40 {
            // Blobs: noise blurred and cut, so that shapes have body, holes and bridges.
            let noise = random(48, 40, 0.5, &mut rng).to_image().blurred(1.0 + f64::from(round % 3));
            let mask = noise.threshold(0.5);
            let thin = mask.thin();
            assert!(thin.data.iter().zip(&mask.data).all(|(thin, ink)| !thin || *ink), "skeleton stays in the ink");
            assert_eq!(thin.components().sizes.len(), mask.components().sizes.len(), "parts, round {round}");
            assert_eq!(holes(&thin), holes(&mask), "holes, round {round}");
            let squares = (1..40).flat_map(|y| (1..48).map(move |x| (x, y)));
            let full = |&(x, y): &(usize, usize)| {
                thin.at(x, y) && thin.at(x - 1, y) && thin.at(x, y - 1) && thin.at(x - 1, y - 1)
            };
            assert!(squares.filter(full).count() <= 1, "one pixel wide");
        }
    }

    /// Ground parts joined across sides only, the dual of ink joined across corners too.
    fn holes(mask: &Mask) -> usize {
        // At double size (with a margin) ink corners become ink bridges, so that corner-joined flooding cannot leak.
        let (w, h) = (2 * mask.width + 3, 2 * mask.height + 3);
        let mut ground = Mask { width: w, height: h, data: vec![true; w * h] };
        let ink = |x: i64, y: i64| {
            (0..mask.width as i64).contains(&x)
                && (0..mask.height as i64).contains(&y)
                && mask.at(x as usize, y as usize)
        };
        for y in 0..h as i64 {
            for x in 0..w as i64 {
                let (cx, cy) = ((x - 1).div_euclid(2), (y - 1).div_euclid(2));
                let (ex, ey) = ((x % 2 == 0) as i64, (y % 2 == 0) as i64);
                // Even coordinates lie on pixel borders; a border is ink if its pixels on both sides are.
                let filled = match (ex, ey) {
                    (0, 0) => ink(cx, cy),
                    (1, 0) => ink(cx, cy) && ink(cx + 1, cy),
                    (0, 1) => ink(cx, cy) && ink(cx, cy + 1),
                    _ => (ink(cx, cy) && ink(cx + 1, cy + 1)) || (ink(cx + 1, cy) && ink(cx, cy + 1)),
                };
                ground.data[y as usize * w + x as usize] = !filled;
            }
        }
        // Thin ink lines now separate ground even for corner-joined flooding except through their corners: use sides.
        let mut seen = vec![false; w * h];
        let mut parts = 0;
        for seed in 0..w * h {
            if seen[seed] || !ground.data[seed] {
                continue;
            }
            parts += 1;
            let mut front = vec![seed];
            seen[seed] = true;
            while let Some(i) = front.pop() {
                let (x, y) = (i % w, i / w);
                let sides = [(x.wrapping_sub(1), y), (x + 1, y), (x, y.wrapping_sub(1)), (x, y + 1)];
                for (nx, ny) in sides.into_iter().filter(|&(nx, ny)| nx < w && ny < h) {
                    let n = ny * w + nx;
                    if ground.data[n] && !seen[n] {
                        seen[n] = true;
                        front.push(n);
                    }
                }
            }
        }
        parts - 1
    }

    #[test]
    fn thinning_small_things() {
        let square = parse(&["....", ".##.", ".##.", "...."]);
        assert!(square.thin().count() >= 1, "a square does not vanish");
        let bar = parse(&["........", ".######.", ".######.", ".######.", "........"]);
        let thin = bar.thin();
        assert!(thin.count() >= 3 && (1..7).all(|x| !thin.at(x, 1) && !thin.at(x, 3)), "a bar becomes its middle line");
        let stairs = parse(&["#....", "##...", ".##..", "..##.", "...##"]);
        let thin = stairs.thin();
        assert!(thin.count() <= 6 && thin.at(4, 4) && thin.at(0, 0), "stairs become a diagonal, tips and all");
        assert_eq!(Mask::new(0, 0).thin(), Mask::new(0, 0));
    }

    #[test]
    fn parts_and_box() {
        let mask = parse(&["#..#.", ".#...", "...##", "....."]);
        let parts = mask.components();
        assert_eq!(parts.sizes, [2, 1, 2]);
        assert_eq!((parts.labels[0], parts.labels[6], parts.labels[3]), (1, 1, 2));
        let ink = mask.bounding_box().unwrap();
        assert_eq!(ink, PixelBox { left: 0, top: 0, right: 5, bottom: 3 });
        assert_eq!((ink.width(), ink.height()), (5, 3));
        assert_eq!(Mask::new(4, 4).bounding_box(), None);
        assert_eq!(mask.inverted().count(), 15);
    }

    #[test]
    fn letterboxes_keep_the_aspect_unless_squashed() {
        let mut image = Image::new(50, 40);
        let part = PixelBox { left: 10, top: 5, right: 40, bottom: 15 };
        for y in part.top..part.bottom {
            image.data[y * 50 + part.left..y * 50 + part.right].fill(1.0);
        }
        let found = |squash| image.letterboxed(part, 64, 64, 4.0, squash).threshold(0.5).bounding_box().unwrap();
        let kept = found(false);
        assert_eq!((kept.left, kept.right), (4, 60));
        assert!(kept.height().abs_diff(56 / 3) <= 1 && kept.top.abs_diff(64 - kept.bottom) <= 1, "{kept:?}");
        assert_eq!(found(true), PixelBox { left: 4, top: 4, right: 60, bottom: 60 });
    }

    #[test]
    fn growing_reaches_as_far_as_asked() {
        let mut dot = Mask::new(21, 21);
        dot.data[10 * 21 + 10] = true;
        let disc = dot.dilated(5.0);
        assert!(disc.at(15, 10) && disc.at(13, 14) && !disc.at(14, 14) && !disc.at(16, 10));
        let blots = Mask { width: 30, height: 20, data: (0..600).map(|i| (i * i) % 97 < 3 || i < 4).collect() };
        for radius in [0.0, 0.5, 1.5, 3.2, 7.0, 15.9, 17.0] {
            let far = blots.distance_px();
            let near: Vec<bool> = far.data.iter().map(|&far| far <= radius).collect();
            assert_eq!(blots.dilated(radius).data, near, "{radius}");
        }
    }
}
