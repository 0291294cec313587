//! Edges and dark lines in part of a photograph, as scored lines.

use super::grid::Grid;
use super::join::joined;
use super::line::{is_closed, length, smooth, turning};
use super::trace::chains;
use crate::picture::Mask;
use crate::picture::photo::Photo;
use crate::view::{Image, PixelBox, StructureTensor};

/// Smoothing before tangents are taken, and of the tensor that gives them, px.
const BEFORE: f64 = 1.0;
const TENSOR: f64 = 3.0;
/// Widths of dark lines: the narrow Gaussian's sigma, px; how much wider the other one is; how strong a response counts.
const SCALES: [f32; 2] = [1.2, 2.4];
const WIDER: f32 = 1.6;
const DARK: f32 = 9.0;
/// Smoothing before steps are looked for, px, and how strong a step counts.
const STEP: f64 = 1.5;
const STEEP: f32 = 3.75;
/// How far along the flow responses are gathered: sigma and reach, px.
const ALONG: f32 = 4.0;
const REACH: usize = 10;
/// Surround that holds texture back: outer and inner sigma, px, and the inner one's share.
const SURROUND: [f64; 2] = [16.0, 4.0];
const CENTRE: f32 = 0.25;
/// Least response of dark lines and of steps.
const LEAST: [f32; 2] = [3.0, 4.0];
/// How far outside the mask lines may lie, px.
const BEYOND: f32 = 3.0;
/// Gaps that are closed and lines that are dropped, px where the object is 512 px large.
const GAP: f32 = 14.0;
const SHORT: f32 = 14.0;
/// Smoothing of lines, px.
const SMOOTH: f32 = 2.5;
/// Scale at which a line stands alone or among others, px.
const AMONG: f64 = 14.0;
/// How much more a dark line says than a step.
const DARK_SAYS: f32 = 1.25;

/// A line with what is known of it; places px of the part.
pub struct Scored {
    pub points: Vec<[f32; 2]>,
    pub length: f32,
    /// Mean response along it.
    pub contrast: f32,
    /// How much the flow goes one way along it, 0 to 1.
    pub coherence: f32,
    /// How much stronger it is than what is round it, 0 to 1.
    pub isolation: f32,
    /// See [`turning`].
    pub turning: f32,
    pub closed: bool,
}

/// Responses in a part of a photograph.
pub struct Edges {
    /// Dark lines, steps, texture held back.
    responses: [Image; 2],
    /// Steps as they are, smoothed.
    among: Image,
    /// Unit vector across the flow, and how much the flow goes one way.
    across: Grid<3>,
    within: Mask,
}

impl Edges {
    pub fn of(photo: &Photo, solid: &Mask, part: PixelBox) -> Edges {
        let (w, h) = (part.width(), part.height());
        let cropped = |channel: usize| {
            let rows = (part.top..part.bottom).flat_map(|y| &photo.lab[y * photo.width + part.left..][..w]);
            Image { width: w, height: h, data: rows.map(|lab| lab[channel]).collect() }
        };
        let channels = [0, 1, 2].map(cropped);
        let near = solid.dilated(BEYOND);
        let rows = (part.top..part.bottom).flat_map(|y| &near.data[y * photo.width + part.left..][..w]);
        let mut within = Mask { width: w, height: h, data: rows.copied().collect() };
        for i in 0..w * h {
            let (x, y) = (i % w, i / w);
            within.data[i] &= x >= 2 && y >= 2 && x + 2 < w && y + 2 < h;
        }
        // What lines are gathered from reaches a little farther than the lines.
        let across = flow(&channels);
        let steps = steepness(&channels);
        let lightness = Grid { width: w, height: h, data: channels[0].data.iter().map(|&l| [l]).collect() };
        let wide = within.dilated(REACH as f32);
        let raw = Grid {
            width: w,
            height: h,
            data: (0..w * h)
                .map(|i| {
                    if !wide.data[i] {
                        return [0.0; 3];
                    }
                    let [narrow, broad] = dark(&lightness, &across, i);
                    [narrow, broad, steps.data[i]]
                })
                .collect(),
        };
        let (mut lines, mut edges) = (Image::new(w, h), Image::new(w, h));
        for i in (0..w * h).filter(|&i| wide.data[i]) {
            let [narrow, broad, step] = gathered(&raw, &across, i);
            lines.data[i] = DARK * narrow.max(broad).max(0.0);
            edges.data[i] = STEEP * step;
        }
        let among = blurred(&edges, AMONG);
        let responses = [lines, edges].map(|response| held_back(&response));
        Edges { responses, among, across, within }
    }

    /// All lines, for an object of `size` px.
    pub fn lines(&self, size: f32) -> Vec<Scored> {
        let scale = (size / 512.0).clamp(0.5, 1.0);
        let mut found = Vec::new();
        for (kind, response) in self.responses.iter().enumerate() {
            let thin = self.ridges(response, LEAST[kind]);
            let says = if kind == 0 { DARK_SAYS } else { 1.0 };
            for line in joined(chains(&thin), GAP * scale) {
                if length(&line) >= SHORT * scale {
                    found.push(self.scored(smooth(&line, SMOOTH), response, says));
                }
            }
        }
        found
    }

    /// Where a response is the greatest across the flow.
    fn ridges(&self, response: &Image, least: f32) -> Mask {
        let (w, h) = (response.width, response.height);
        let grid = Grid { width: w, height: h, data: response.data.iter().map(|&v| [v]).collect() };
        let is_ridge = |i: usize| {
            let here = response.data[i];
            if !self.within.data[i] || here <= least {
                return false;
            }
            let [nx, ny, _] = self.across.data[i];
            let (x, y) = ((i % w) as f32, (i / w) as f32);
            here >= grid.at(x + nx, y + ny)[0] && here >= grid.at(x - nx, y - ny)[0]
        };
        Mask { width: w, height: h, data: (0..w * h).map(is_ridge).collect() }
    }

    fn scored(&self, points: Vec<[f32; 2]>, response: &Image, says: f32) -> Scored {
        let w = response.width;
        let at = |p: &[f32; 2]| {
            let x = (p[0].round().max(0.0) as usize).min(w - 1);
            let y = (p[1].round().max(0.0) as usize).min(response.height - 1);
            y * w + x
        };
        let mean = |of: &dyn Fn(usize) -> f32| points.iter().map(|p| of(at(p))).sum::<f32>() / points.len() as f32;
        let strength = mean(&|i| response.data[i]);
        let round = mean(&|i| self.among.data[i]);
        Scored {
            length: length(&points),
            contrast: says * strength,
            coherence: mean(&|i| self.across.data[i][2]),
            isolation: strength / (strength + round).max(1e-6),
            turning: turning(&points),
            closed: is_closed(&points),
            // Middles of pixels are at halves.
            points: points.into_iter().map(|p| p.map(|c| c + 0.5)).collect(),
        }
    }
}

/// A Gaussian blur; wide ones at half the size, which is no different.
fn blurred(image: &Image, sigma_px: f64) -> Image {
    if sigma_px < 6.0 || image.width < 8 || image.height < 8 {
        return image.blurred(sigma_px);
    }
    let (w, h) = (image.width.div_ceil(4), image.height.div_ceil(4));
    let small = image.resized(w, h).blurred(sigma_px / 4.0);
    small.window([0.0, 0.0, w as f64, h as f64], image.width, image.height)
}

/// Slopes of each channel, in units of colour a pixel (Scharr's weights).
fn slopes(image: &Image) -> Vec<[f32; 2]> {
    let (w, h) = (image.width, image.height);
    let mut out = Vec::with_capacity(w * h);
    for y in 0..h {
        let rows = [y.saturating_sub(1), y, (y + 1).min(h - 1)].map(|row| &image.data[row * w..][..w]);
        for x in 0..w {
            let columns = [x.saturating_sub(1), x, (x + 1).min(w - 1)];
            let [left, right] =
                [columns[0], columns[2]].map(|x| 3.0 * rows[0][x] + 10.0 * rows[1][x] + 3.0 * rows[2][x]);
            let across = |row: &[f32]| 3.0 * row[columns[0]] + 10.0 * row[x] + 3.0 * row[columns[2]];
            out.push([(right - left) / 32.0, (across(rows[2]) - across(rows[0])) / 32.0]);
        }
    }
    out
}

/// The structure tensor of all channels, smoothed by `before` px first and over a window of `window` px.
fn tensor(channels: &[Image; 3], before: f64, window: f64) -> StructureTensor {
    let (w, h) = (channels[0].width, channels[0].height);
    let gradients = channels.each_ref().map(|channel| slopes(&channel.blurred(before)));
    StructureTensor::new([w, h], window, |x, y| gradients.each_ref().map(|slopes| slopes[y * w + x].map(f64::from)))
}

/// Unit vectors across the flow, and how much it goes one way.
fn flow(channels: &[Image; 3]) -> Grid<3> {
    let StructureTensor { xx, xy, yy } = tensor(channels, BEFORE, TENSOR);
    let across = |i: usize| {
        let (a, b, c) = (xx.data[i], xy.data[i], yy.data[i]);
        let angle = 0.5 * (2.0 * b).atan2(a - c);
        let difference = (a - c).hypot(2.0 * b);
        [angle.cos(), angle.sin(), difference / (a + c + 1e-6)]
    };
    Grid { width: xx.width, height: xx.height, data: (0..xx.data.len()).map(across).collect() }
}

/// How steeply colours change, in units of colour a pixel: the root of the tensor's larger eigenvalue.
fn steepness(channels: &[Image; 3]) -> Image {
    let StructureTensor { xx, xy, yy } = tensor(channels, STEP, 0.0);
    let steep = |i: usize| {
        let (a, b, c) = (xx.data[i], xy.data[i], yy.data[i]);
        (0.5 * (a + c + (a - c).hypot(2.0 * b))).max(0.0).sqrt()
    };
    Image { width: xx.width, height: xx.height, data: (0..xx.data.len()).map(steep).collect() }
}

/// How much darker a place is than what is beside it across the flow, at two scales: a difference of Gaussians.
fn dark(lightness: &Grid<1>, across: &Grid<3>, i: usize) -> [f32; 2] {
    const HALF: isize = 11;
    static KERNELS: std::sync::OnceLock<[[f32; 2 * HALF as usize + 1]; 2]> = std::sync::OnceLock::new();
    let kernels = KERNELS.get_or_init(|| {
        SCALES.map(|sigma| {
            let bell = |sigma: f32, k: isize| {
                if k.abs() as f32 <= 3.0 * SCALES[1] * WIDER { (-0.5 * (k as f32 / sigma).powi(2)).exp() } else { 0.0 }
            };
            let sum = |sigma: f32| (-HALF..=HALF).map(|k| bell(sigma, k)).sum::<f32>();
            let (narrow, wide) = (sum(sigma), sum(WIDER * sigma));
            std::array::from_fn(|at| {
                let k = at as isize - HALF;
                bell(WIDER * sigma, k) / wide - bell(sigma, k) / narrow
            })
        })
    });
    let [nx, ny, _] = across.data[i];
    let (x, y) = ((i % lightness.width) as f32, (i / lightness.width) as f32);
    let mut sums = [0.0; 2];
    for at in 0..kernels[0].len() {
        let k = (at as isize - HALF) as f32;
        let [value] = lightness.at(x + k * nx, y + k * ny);
        sums[0] += kernels[0][at] * value;
        sums[1] += kernels[1][at] * value;
    }
    sums
}

/// Responses gathered along the flow, both ways from a place.
fn gathered(raw: &Grid<3>, across: &Grid<3>, i: usize) -> [f32; 3] {
    let (w, h) = (raw.width, raw.height);
    let mut sums = raw.data[i];
    let mut mass = 1.0;
    for way in [1.0, -1.0] {
        let (mut x, mut y) = ((i % w) as f32, (i / w) as f32);
        let [nx, ny, _] = across.data[i];
        let mut direction = [-way * ny, way * nx];
        for k in 1..=REACH {
            x += direction[0];
            y += direction[1];
            if x < 0.0 || y < 0.0 || x > (w - 1) as f32 || y > (h - 1) as f32 {
                break;
            }
            let weight = (-0.5 * (k as f32 / ALONG).powi(2)).exp();
            let value = raw.at(x, y);
            (0..3).for_each(|c| sums[c] += weight * value[c]);
            mass += weight;
            let [nx, ny, _] = across.data[(y + 0.5) as usize * w + (x + 0.5) as usize];
            let next = [-ny, nx];
            let turned = if next[0] * direction[0] + next[1] * direction[1] < 0.0 { -1.0 } else { 1.0 };
            direction = next.map(|c| turned * c);
        }
    }
    sums.map(|sum| sum / mass)
}

/// A response less what surrounds it.
fn held_back(response: &Image) -> Image {
    let [outer, inner] = SURROUND.map(|sigma| blurred(response, sigma));
    let mut out = response.clone();
    for i in 0..out.data.len() {
        let surround = (outer.data[i] - CENTRE * inner.data[i]).max(0.0);
        out.data[i] = (out.data[i] - surround).max(0.0);
    }
    out
}
