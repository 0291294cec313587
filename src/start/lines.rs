//! What a wire can draw of a picture: lines. A wire is there or not, so shades become the widths of lines that run along
//! the outline, one inside the other; strong inner edges and strokes too thin for that get a line of their own.
//!
//! The same lines are the picture's target and, walked, the first wire: there on the solid's front, back on its back.

use super::Path;
use super::envelope::{FAR, lower_envelope};
use super::solid::Solid;
use super::trail::smooth;
use crate::view::{Image, Mask};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Which lines, lengths in pixels of a 256 px picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineOptions {
    /// From line to line where areas are filled.
    pub spacing_px: f64,
    /// Width of the outline and of inner edges.
    pub outline_px: f64,
    /// How readily inner edges are drawn: 0 not at all, 1 the clear ones, more the faint ones too.
    pub edges: f64,
    /// How much darker parts get wider lines: 0 not at all, 1 from hair lines to filled.
    pub tone: f64,
    /// Narrowest and widest line.
    pub width_px: [f64; 2],
}

/// Lines one pixel wide, each with its half width.
#[derive(Debug, Clone)]
pub struct Lines {
    side: usize,
    on: Mask,
    /// Half width at each pixel of a line, pixels of this picture.
    half_width_px: Vec<f32>,
    /// Lines that belong to the side that is seen: on the way back they are walked there too.
    seen: Mask,
    mask: Image,
    /// What share of ink each pixel's shade asks for.
    shade: Image,
}

/// Share of the full width in the lightest parts.
const LIGHTEST: f64 = 0.12;
/// The same everywhere, where the tone does not count.
const EVEN: f64 = 0.4;
/// Lines farther apart than this do not get wider to fill what is between them, px at 256: they are an abstraction.
const WIDEST_FILLING_PX: f64 = 13.0;
/// Shades this close together are one shade.
const LEAST_RANGE: f32 = 0.25;
/// Standard deviation of the blur before edges are looked for, px at 256.
const EDGE_BLUR_PX: f64 = 1.5;
/// Slope of the tone, per pixel at 256, of a clear edge.
const EDGE_SLOPE: f64 = 0.05;
/// Shorter edges are texture, px at 256.
const SHORTEST_EDGE_PX: f64 = 10.0;
/// What a link between lines costs on ground, times its length in the object.
const GROUND_PRICE: f32 = 6.0;
/// Branches shorter than this are stairs of the pixels, px.
const STUB_PX: u32 = 5;
/// Steps of a change of side, so that smoothing keeps it thin.
const SIDE_STEPS: u32 = 16;
/// Standard deviation of the smoothing along the walk, px at 256.
const SMOOTHING_PX: f64 = 1.5;

impl Lines {
    /// The lines of an object in a square picture. `all_seen`: it is a line drawing, so all of it faces the viewer.
    pub fn draw(mask: &Image, tone: &Image, all_seen: bool, options: &LineOptions) -> Lines {
        let side = mask.width;
        let scale = side as f32 / 256.0;
        let px = |at_256: f64| at_256 as f32 * scale;
        let (spacing, outline) = (px(options.spacing_px), px(options.outline_px));
        let solid = mask.threshold(0.5);
        let depth: Vec<f32> = solid.inverted().distance_px().data.iter().map(|d| (d - 0.5).max(0.0)).collect();
        let tone = stretched(tone, &solid, 0.25 * f64::from(spacing));

        // Strokes too thin for two outlines and something in between get their middle line.
        let filling = spacing.min(px(WIDEST_FILLING_PX));
        let thinnest = outline + 0.25 * filling;
        let core = Mask { data: depth.iter().map(|&d| d >= thinnest).collect(), ..solid };
        let to_core = core.distance_px().data;
        let fat: Vec<bool> = to_core.iter().map(|&d| d < thinnest + 1.0).collect();
        let level = |i: usize| match depth[i] {
            _ if !fat[i] => 0,
            d if d < 0.5 * outline => 0,
            d if d < outline + 0.5 * spacing => 1,
            d => 2 + ((d - outline - 0.5 * spacing) / spacing) as usize,
        };
        let mut on = Mask::new(side, side);
        let mut rank = vec![0usize; side * side];
        for i in (0..side * side).filter(|&i| level(i) > 0) {
            let lowest = sides(i, side).map(level).min().unwrap_or(0);
            on.data[i] = level(i) > lowest && fat[i];
            rank[i] = level(i);
        }
        let covered = on.distance_px().data;
        // Between sparse lines nothing is filled, so nothing there is left over.
        let left_over = |i: usize| spacing <= filling && covered[i] > 0.5 * spacing + 1.0;
        let bare = |i: usize| solid.data[i] && (!fat[i] || left_over(i));
        let middle = Mask { data: (0..side * side).map(bare).collect(), ..solid }.thin();
        let edges = edges(&tone, &depth, scale, options);

        let [least, most] = options.width_px.map(|width| 0.5 * px(width));
        let mut half_width_px = vec![0.0; side * side];
        let mut shade = Image::new(side, side);
        for i in 0..side * side {
            let toned = LIGHTEST + (1.0 - LIGHTEST) * f64::from(tone.data[i]);
            let shaded = ((1.0 - options.tone) * EVEN + options.tone * toned) as f32;
            shade.data[i] = shaded * mask.data[i];
            let wanted = if edges.data[i] || on.data[i] && rank[i] == 1 {
                0.5 * outline
            } else if middle.data[i] {
                // A drawn stroke is as wide as it is, as far as its shade allows.
                (depth[i] + 0.5).min((0.5 * filling).max(thinnest)) * shaded.max(0.6)
            } else {
                0.5 * filling * shaded + if shaded > 0.9 { 0.5 } else { 0.0 }
            };
            let drawn = edges.data[i] || middle.data[i] || on.data[i] && (rank[i] == 1 || wanted >= 0.35 * least);
            on.data[i] = drawn;
            half_width_px[i] = if drawn { wanted.clamp(least, most) } else { 0.0 };
        }
        // Where an edge crosses a contour, the contour goes on.
        let crossing = |i: usize| edges.data[i] && rank[i] > 0 && sides(i, side).any(|n| level(n) < rank[i]);
        let seen = match all_seen {
            true => on.clone(),
            false => Mask { data: (0..side * side).map(|i| edges.data[i] && !crossing(i)).collect(), ..solid },
        };
        Lines { side, on, half_width_px, seen, mask: mask.clone(), shade }
    }

    /// The ink of the lines as a square picture of `size_px`, 0 to 1: the union of discs along them.
    pub fn ink(&self, size_px: usize) -> Image {
        let side = self.side;
        // Squared distance minus squared half width, the least over all lines: 0 on their borders.
        let mut power: Vec<f32> = self
            .half_width_px
            .iter()
            .zip(&self.on.data)
            .map(|(half, on)| if *on { -half * half } else { FAR })
            .collect();
        lower_envelope(&mut power, side);
        let ink = |i: usize| {
            let (x, y) = (i % side, i / side);
            let across = power[y * side + (x + 1).min(side - 1)] - power[y * side + x.saturating_sub(1)];
            let down = power[(y + 1).min(side - 1) * side + x] - power[y.saturating_sub(1) * side + x];
            // Divided by its slope, it is the distance to the border.
            let inside = -power[i] / (0.5 * across.hypot(down)).max(1.0);
            (inside + 0.5).clamp(0.0, 1.0) * self.mask.data[i]
        };
        let data = (0..self.mask.data.len()).map(ink).collect();
        Image { width: side, height: side, data }.resized(size_px, size_px)
    }

    /// The shades the lines stand for, as a square picture of `size_px`, 0 to 1: what a wire can meet only on average.
    pub fn grey(&self, size_px: usize) -> Image {
        self.shade.resized(size_px, size_px)
    }

    /// One walk along all lines on the solid they came from: each line on its front and, on the way back, on its back.
    /// From the front that shows the lines alone, from elsewhere the solid. The back, links between lines and changes of
    /// side take `thin_world`, so that the front stands out from what is behind it.
    pub fn walk(&self, solid: &Solid, thin_world: f64) -> Path {
        let Joined { lines, link, seen } = self.joined();
        let world_per_px = solid.height_world() / self.side as f64;
        let walk = there_and_back(&lines, &seen);
        let mut points: Vec<[f64; 4]> = Vec::with_capacity(walk.len());
        for (k, &(i, back)) in walk.iter().enumerate() {
            let centred = |p: usize| (p as f64 + 0.5 - 0.5 * self.side as f64) * world_per_px;
            let (x, y) = (centred(i % self.side), -centred(i / self.side));
            let behind = back && !seen.data[i];
            let width = 2.0 * world_per_px * f64::from(self.half_width_px[i]);
            let width = if link[i] || behind { thin_world.min(width.max(world_per_px)) } else { width };
            let [rear, front] = solid.depths(x, y);
            // Round wire that touches the surface from inside.
            let inset = (0.5 * width).min(0.5 * (front - rear));
            let z = if behind { rear + inset } else { front - inset };
            if k > 0 && walk[k - 1].0 == i {
                let before = points[points.len() - 1][2];
                let steps = (1..SIDE_STEPS).map(|k| f64::from(k) / f64::from(SIDE_STEPS));
                points.extend(steps.map(|t| [x, y, before + t * (z - before), thin_world]));
            }
            points.push([x, y, z, width]);
        }
        smooth(&mut points, SMOOTHING_PX * self.side as f64 / 256.0);
        Path { points, closed: false }
    }

    /// The lines with links that join them, each at its nearest place to those joined before (Prim 1957).
    fn joined(&self) -> Joined {
        let mut seen = self.seen.clone();
        let parts = self.on.components();
        let mut pixels: Vec<Vec<usize>> = vec![Vec::new(); parts.sizes.len()];
        for (i, &part) in parts.labels.iter().enumerate().filter(|(_, part)| **part > 0) {
            pixels[part as usize - 1].push(i);
        }
        let largest = (0..pixels.len()).max_by_key(|&k| (pixels[k].len(), Reverse(k)));
        let mut joined = Mask::new(self.side, self.side);
        let mut price = vec![f32::INFINITY; joined.data.len()];
        let mut parent = vec![0usize; joined.data.len()];
        let mut queue = BinaryHeap::new();
        let mut new: Vec<usize> = largest.map_or(Vec::new(), |k| pixels[k].clone());
        loop {
            for i in new.drain(..) {
                joined.data[i] = true;
                price[i] = 0.0;
                queue.push((Reverse(0u32), Reverse(i)));
            }
            let Some((Reverse(bits), Reverse(i))) = queue.pop() else { break };
            if f32::from_bits(bits) > price[i] {
                continue;
            }
            if self.on.data[i] && !joined.data[i] {
                let mut link = parent[i];
                while !joined.data[link] {
                    seen.data[link] = self.seen.data[i];
                    new.push(link);
                    link = parent[link];
                }
                new.extend(&pixels[parts.labels[i] as usize - 1]);
                continue;
            }
            for (n, length) in around(i, self.side) {
                let ground = if self.mask.data[n] > 0.5 { 1.0 } else { GROUND_PRICE };
                let to = price[i] + length * ground;
                if to < price[n] {
                    price[n] = to;
                    parent[n] = i;
                    // Positive floats order as their bits do.
                    queue.push((Reverse(to.to_bits()), Reverse(n)));
                }
            }
        }
        let lines = joined.thin();
        let link = lines.data.iter().zip(&self.on.data).map(|(line, on)| *line && !on).collect();
        Joined { lines, link, seen }
    }
}

/// Lines that hang together.
struct Joined {
    lines: Mask,
    /// Pixels that only join lines.
    link: Vec<bool>,
    /// Lines and links that belong to the side that is seen.
    seen: Mask,
}

/// Tones of the object blurred and stretched to 0..1: its lightest shades become 0 and its darkest 1.
fn stretched(tone: &Image, solid: &Mask, sigma_px: f64) -> Image {
    let inside: Vec<usize> = (0..tone.data.len()).filter(|&i| solid.data[i]).collect();
    let mut shades: Vec<f32> = inside.iter().map(|&i| tone.data[i]).collect();
    shades.sort_by(f32::total_cmp);
    let at = |share: f64| shades.get((share * shades.len() as f64) as usize).copied().unwrap_or(0.0);
    let (low, high) = (at(0.02), at(0.98));
    let low = low.min(high - LEAST_RANGE);
    let mut out = Image::new(tone.width, tone.height);
    inside.iter().for_each(|&i| out.data[i] = ((tone.data[i] - low) / (high - low)).clamp(0.0, 1.0));
    // Weighted by the mask, so that the ground does not lighten the rim.
    let sigma_px = sigma_px.min(2.0);
    let (blurred, weight) = (out.blurred(sigma_px), solid.to_image().blurred(sigma_px));
    inside.iter().for_each(|&i| out.data[i] = (blurred.data[i] / weight.data[i].max(1e-3)).min(1.0));
    out
}

/// Strong edges of the tone inside the object, one pixel wide (Canny 1986).
fn edges(tone: &Image, depth: &[f32], scale: f32, options: &LineOptions) -> Mask {
    let side = tone.width;
    let mut strong = Mask::new(side, side);
    if options.edges <= 0.0 {
        return strong;
    }
    let tone = tone.blurred(EDGE_BLUR_PX * f64::from(scale));
    let slope = |i: usize| {
        let (x, y) = (i % side, i / side);
        if x == 0 || y == 0 || x + 1 == side || y + 1 == side {
            return [0.0; 2];
        }
        [0.5 * (tone.data[i + 1] - tone.data[i - 1]), 0.5 * (tone.data[i + side] - tone.data[i - side])]
    };
    let steep = Image { data: (0..side * side).map(|i| slope(i)[0].hypot(slope(i)[1])).collect(), ..tone };
    let wanted = (EDGE_SLOPE / options.edges) as f32 / scale;
    // The outline draws what lies close to it.
    let inner = 1.5 * options.outline_px as f32 * scale + 3.0 * EDGE_BLUR_PX as f32 * scale;
    let mut weak = Mask::new(side, side);
    for i in (0..side * side).filter(|&i| depth[i] > inner && steep.data[i] > 0.4 * wanted) {
        let [gx, gy] = slope(i).map(|g| g / steep.data[i]);
        let (x, y) = ((i % side) as f32 + 0.5, (i / side) as f32 + 0.5);
        weak.data[i] = steep.data[i] >= steep.sample(x + gx, y + gy) && steep.data[i] > steep.sample(x - gx, y - gy);
    }
    let parts = weak.components();
    let mut highest = vec![0.0f32; parts.sizes.len()];
    for (i, &part) in parts.labels.iter().enumerate().filter(|(_, part)| **part > 0) {
        highest[part as usize - 1] = highest[part as usize - 1].max(steep.data[i]);
    }
    let shortest = SHORTEST_EDGE_PX * f64::from(scale);
    for (i, &part) in parts.labels.iter().enumerate().filter(|(_, part)| **part > 0) {
        let part = part as usize - 1;
        strong.data[i] = highest[part] > wanted && parts.sizes[part] as f64 >= shortest;
    }
    strong.thin()
}

/// A walk over all pixels of a connected mask, depth first: each pixel with whether it is met on the back. Pixels that are
/// `seen` are walked on the front both ways, and first, so that the wire need not change sides for them.
fn there_and_back(mask: &Mask, seen: &Mask) -> Vec<(usize, bool)> {
    let side = mask.width;
    let Some(root) = mask.data.iter().position(|&on| on) else { return Vec::new() };
    let mut parent = vec![usize::MAX; mask.data.len()];
    let mut children: Vec<Vec<usize>> = vec![Vec::new(); mask.data.len()];
    let mut order = vec![root];
    let mut trail = vec![root];
    parent[root] = root;
    while let Some(&i) = trail.last() {
        let place = |i: usize| [(i % side) as i64, (i / side) as i64];
        let (here, from) = (place(i), place(parent[i]));
        // On along the same kind of line and straight on, where possible.
        let ahead = |n: usize| {
            let [dx, dy] = [place(n)[0] - here[0], place(n)[1] - here[1]];
            (seen.data[n] == seen.data[i], (here[0] - from[0]) * dx + (here[1] - from[1]) * dy)
        };
        let free = around(i, side).filter(|&(n, _)| mask.data[n] && parent[n] == usize::MAX);
        match free.map(|(n, _)| n).max_by_key(|&n| (ahead(n), Reverse(n))) {
            Some(next) => {
                parent[next] = i;
                children[i].push(next);
                order.push(next);
                trail.push(next);
            }
            None => {
                trail.pop();
            }
        }
    }
    let mut reach = vec![1u32; mask.data.len()];
    for &i in order.iter().skip(1).rev() {
        reach[parent[i]] = reach[parent[i]].max(reach[i] + 1);
    }
    for branches in children.iter_mut().filter(|branches| branches.len() > 1) {
        let longest = branches.iter().map(|&child| reach[child]).max().unwrap_or(0);
        branches.retain(|&child| reach[child] >= STUB_PX.min(longest));
        branches.sort_by_key(|&child| !seen.data[child]);
    }
    let mut walk = vec![(root, false)];
    let mut trail = vec![(root, 0)];
    while let Some((i, next)) = trail.pop() {
        match children[i].get(next) {
            Some(&child) => {
                trail.push((i, next + 1));
                if walk.last() == Some(&(i, true)) {
                    // Through the solid to the front again.
                    walk.push((i, false));
                }
                walk.push((child, false));
                trail.push((child, 0));
            }
            None => {
                if walk.last() == Some(&(i, false)) {
                    // The end of a branch: through the solid to the back.
                    walk.push((i, true));
                }
                if let Some(&(above, next)) = trail.last() {
                    let stays = seen.data[i] && next < children[above].len();
                    walk.push((above, !stays));
                }
            }
        }
    }
    walk
}

/// The pixels beside a pixel.
fn sides(i: usize, side: usize) -> impl Iterator<Item = usize> {
    around(i, side).filter(|&(_, length)| length == 1.0).map(|(n, _)| n)
}

/// The up to eight pixels round a pixel with their distances.
fn around(i: usize, side: usize) -> impl Iterator<Item = (usize, f32)> {
    let (x, y) = (i % side, i / side);
    (0..9).filter(|&k| k != 4).filter_map(move |k| {
        let (u, v) = ((x + k % 3).checked_sub(1)?, (y + k / 3).checked_sub(1)?);
        let length = if k % 2 == 1 { 1.0 } else { std::f32::consts::SQRT_2 };
        (u < side && v < side).then_some((v * side + u, length))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::soft_iou;
    use crate::start::{SolidOptions, length};

    const OPTIONS: LineOptions =
        LineOptions { spacing_px: 12.0, outline_px: 3.0, edges: 1.0, tone: 1.0, width_px: [1.0, 20.0] };

    fn picture(value: impl Fn(f32, f32) -> f32) -> Image {
        let mut image = Image::new(256, 256);
        for i in 0..256 * 256 {
            image.data[i] = value((i % 256) as f32 + 0.5 - 128.0, (i / 256) as f32 + 0.5 - 128.0);
        }
        image
    }

    fn disc(radius: f32) -> Image {
        picture(|x, y| f32::from(x.hypot(y) < radius))
    }

    fn mean(image: &Image, on: impl Fn(f32, f32) -> bool) -> f32 {
        let on = picture(|x, y| f32::from(on(x, y)));
        let sum: f32 = image.data.iter().zip(&on.data).map(|(a, b)| a * b).sum();
        sum / on.data.iter().sum::<f32>()
    }

    #[test]
    fn darker_parts_get_more_ink_and_a_dark_shape_is_filled() {
        let mask = disc(100.0);
        let shaded = picture(|x, y| if x.hypot(y) < 100.0 { 0.5 + x / 220.0 } else { 0.0 });
        let ink = Lines::draw(&mask, &shaded, false, &OPTIONS).ink(256);
        let (dark, light) =
            (mean(&ink, |x, y| x > 30.0 && x.hypot(y) < 90.0), mean(&ink, |x, y| x < -30.0 && x.hypot(y) < 90.0));
        assert!(dark > 0.6 && light < 0.4, "{dark} {light}");
        let even = Lines::draw(&mask, &shaded, false, &LineOptions { tone: 0.0, ..OPTIONS }).ink(256);
        assert!(
            (mean(&even, |x, y| x > 30.0 && x.hypot(y) < 90.0) - mean(&even, |x, y| x < -30.0 && x.hypot(y) < 90.0))
                .abs()
                < 0.1
        );
        let full = Lines::draw(&mask, &mask, false, &OPTIONS).ink(256);
        assert!(soft_iou(&full, &mask) > 0.93, "{}", soft_iou(&full, &mask));
    }

    #[test]
    fn edges_are_drawn_as_asked() {
        let mask = disc(110.0);
        let eye = picture(|x, y| if (x - 20.0).hypot(y) < 30.0 { 0.8 } else { 0.1 } * f32::from(x.hypot(y) < 110.0));
        let near_eye = |ink: &Image| mean(ink, |x, y| ((x - 20.0).hypot(y) - 30.0).abs() < 1.0);
        let wide = LineOptions { spacing_px: 60.0, tone: 0.0, ..OPTIONS };
        let with = Lines::draw(&mask, &eye, false, &wide).ink(256);
        let without = Lines::draw(&mask, &eye, false, &LineOptions { edges: 0.0, ..wide }).ink(256);
        assert!(near_eye(&with) > 0.8 && near_eye(&without) < 0.5, "{} {}", near_eye(&with), near_eye(&without));
    }

    #[test]
    fn the_walk_is_one_line_over_all_lines_front_and_back() {
        let shapes = [
            disc(100.0),
            picture(|x, y| f32::from((x.hypot(y) - 70.0).abs() < 22.0)),
            picture(|x, y| f32::from((x.hypot(y) - 70.0).abs() < 2.0 || (x - 20.0).hypot(y) < 6.0)),
        ];
        for mask in shapes {
            let lines = Lines::draw(&mask, &mask, false, &OPTIONS);
            let solid = Solid::inflated("thing", &mask, &SolidOptions::default()).unwrap();
            let path = lines.walk(&solid, 0.005);
            let px = solid.height_world() / 256.0;
            let mut met = Mask::new(256, 256);
            let (mut before, mut behind) = (0, 0);
            for point in &path.points {
                let [u, v] = [128.0 + point[0] / px, 128.0 - point[1] / px];
                met.data[v as usize * 256 + u as usize] = true;
                // Thick wire in a thin part lies in its middle.
                before += usize::from(point[2] > -0.1 * px);
                behind += usize::from(point[2] < -0.1 * px);
            }
            let away = met.distance_px();
            let missed = (0..256 * 256).filter(|&i| lines.on.data[i] && away.data[i] > 4.0).count();
            assert!(missed as f64 <= 0.01 * lines.on.count() as f64, "{missed} of {} pixels missed", lines.on.count());
            assert!(4 * before.min(behind) > path.points.len(), "{before} {behind}");
            let step = |pair: &[[f64; 4]]| (pair[0][0] - pair[1][0]).hypot(pair[0][1] - pair[1][1]);
            assert!(path.points.windows(2).all(|pair| step(pair) < 2.0 * px), "no jumps across");
            assert!(length(&path) > 0.0);
        }
    }
}
