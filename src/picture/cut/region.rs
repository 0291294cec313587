//! What is looked at for one box: the part of the photograph in and round it, small and at full size.

use super::Stroke;
use super::level::{Known, Level, Weights};
use super::place::Place;
use super::saliency::saliency;
use super::strokes::{reach, under};
use super::tidy::{grown, tidy};
use crate::picture::photo::Photo;
use crate::picture::sheet::is_rim;
use crate::picture::spread::{otsu, quantile};
use crate::picture::{Ink, Mask};
use crate::view::Image;

/// Longest side of the small size, px.
const SMALL_PX: usize = 256;
/// What is seen round a box, share of its longer side.
const RING: f64 = 0.15;
/// Half the band that is cut anew at full size, px of the small one.
const BAND: f64 = 2.5;
/// Most rounds of colours and cuts.
const ROUNDS: usize = 6;
/// How much pixels at a stroke lean to its side, in the units of surprise.
const LEAN: f32 = 8.0;

/// How often what places say counts in the first cuts of a box: that starts with what is solid, and only then asks
/// colours whether there are holes.
const FIRST: f32 = 2.0;
const FIRST_ROUNDS: usize = 2;
/// An object that fills less of its box than this share is part of one, and how much that counts against a cut.
const LEAST_FILL: f32 = 0.45;
const UNFILLED: f32 = 4.0;

/// How much better a cut begun from what catches the eye must fit to be taken.
const WORSE: f32 = 0.1;
/// Share of a box's width and height that an object in it has at least.
pub const FILLS: f32 = 0.72;

/// Part of a photograph, twice.
pub struct Region {
    /// Size of the photograph.
    size: [usize; 2],
    /// Where the part begins.
    corner: [usize; 2],
    small: Level,
    full: Level,
    /// What the box says of the small part's places; nothing without one.
    places: Vec<f32>,
    /// Where the box is in the small part; all but the picture's rim without one.
    inside: Vec<bool>,
}

/// What is found before any stroke, at the small size.
pub struct Guess {
    pub object: Vec<bool>,
    pub sure: f32,
}

impl Region {
    /// For a box, or all of the picture that is in `frame`: columns and rows of the first and after the last pixel.
    pub fn new(photo: &Photo, bounds: Option<[usize; 4]>, frame: [usize; 4]) -> Region {
        let [left, top, right, bottom] = bounds.unwrap_or(frame);
        let ring = (RING * (right - left).max(bottom - top) as f64).round() as usize;
        let [x0, y0] = [left.saturating_sub(ring).max(frame[0]), top.saturating_sub(ring).max(frame[1])];
        let [x1, y1] = [(right + ring).min(frame[2]), (bottom + ring).min(frame[3])];
        let (width, height) = (x1 - x0, y1 - y0);
        let lab: Vec<[f32; 3]> = (y0..y1).flat_map(|y| &photo.lab[y * photo.width + x0..][..width]).copied().collect();
        let scale = (SMALL_PX as f64 / width.max(height) as f64).min(1.0);
        let [w, h] = [width, height].map(|side| ((side as f64 * scale).round() as usize).max(1));
        let channel =
            |c: usize| Image { width, height, data: lab.iter().map(|lab| lab[c]).collect() }.resized(w, h).data;
        let [l, a, b] = [0, 1, 2].map(channel);
        let weights = if bounds.is_some() { Weights::BOX } else { Weights::ANYWHERE };
        let small = Level::new(w, h, (0..l.len()).map(|i| [l[i], a[i], b[i]]).collect(), weights);
        let at = |i: usize| [(i % w, x0), (i / w, y0)].map(|(v, from)| from as f64 + (v as f64 + 0.5) / scale);
        let in_box =
            |[x, y]: [f64; 2]| (left as f64..right as f64).contains(&x) && (top as f64..bottom as f64).contains(&y);
        let mut inside: Vec<bool> = (0..w * h).map(|i| in_box(at(i))).collect();
        let mut places = Vec::new();
        if bounds.is_some() {
            let place = Place::new([left, top, right, bottom], frame);
            places = (0..w * h).map(|i| place.lean(at(i))).collect();
        } else {
            for (i, inside) in inside.iter_mut().enumerate() {
                let (x, y) = (i % w, i / w);
                *inside &= x >= 2 && y >= 2 && x + 2 < w && y + 2 < h;
            }
        }
        let full = Level::new(width, height, lab, weights);
        Region { size: [photo.width, photo.height], corner: [x0, y0], small, full, places, inside }
    }

    fn is_boxed(&self) -> bool {
        !self.places.is_empty()
    }

    /// The object without strokes: begun once with all that is inside, once with what catches the eye.
    pub fn guess(&self) -> Guess {
        let known = self.outside_is_ground();
        let whole = self.small.cut(&known, &self.likely(&known), &self.places, ROUNDS);
        let salient = self.salient();
        let eye = self.small.cut(&known, &salient, &self.places, ROUNDS);
        let (same, seen) = (overlap(&whole, &eye), overlap(&salient, &eye));
        let object = if self.score(&eye) > self.score(&whole) + WORSE { eye } else { whole };
        // A box says where it is, so that what catches the eye need not be it; but it fills the box.
        let sure = if self.is_boxed() {
            same * (1.0 - 2.0 * self.shortfall(&object)).max(0.0)
        } else {
            seen.powf(1.5) * same.sqrt()
        };
        Guess { object, sure }
    }

    /// What the object may be from its place: in a box what is round and solid, else all.
    fn likely(&self, known: &[Known]) -> Vec<bool> {
        if !self.is_boxed() {
            return self.inside.clone();
        }
        let round: Vec<bool> = (0..known.len()).map(|i| self.inside[i] && self.places[i] >= 0.0).collect();
        let lean: Vec<f32> = self.places.iter().map(|lean| FIRST * lean).collect();
        self.small.cut(known, &round, &lean, FIRST_ROUNDS)
    }

    fn outside_is_ground(&self) -> Vec<Known> {
        self.inside.iter().map(|&inside| if inside { Known::Open } else { Known::Ground }).collect()
    }

    /// By how much a cut is narrower and lower than most of what it was looked for in, shares of that added up.
    fn shortfall(&self, object: &[bool]) -> f32 {
        let (w, h) = (self.small.width, self.small.height);
        let frame = |data: &[bool]| Mask { width: w, height: h, data: data.to_vec() }.bounding_box();
        let (Some(found), Some(frame)) = (frame(object), frame(&self.inside)) else { return 2.0 };
        let short = |found: usize, frame: usize| (FILLS - found as f32 / frame as f32).max(0.0);
        short(found.width(), frame.width()) + short(found.height(), frame.height())
    }

    /// How well a cut fits its box: its border runs along edges, it fills the box's middle and does not touch its sides.
    fn score(&self, object: &[bool]) -> f32 {
        let (w, h) = (self.small.width, self.small.height);
        let mask = Mask { width: w, height: h, data: object.to_vec() };
        if mask.count() == 0 {
            return f32::MIN;
        }
        let slope = self.small.slope();
        let is_border = |i: &usize| {
            let (x, y) = (i % w, i / w);
            object[*i]
                && self.inside[*i]
                && x > 0
                && y > 0
                && x + 1 < w
                && y + 1 < h
                && [i - 1, i + 1, i - w, i + w].iter().any(|&n| !object[n])
        };
        let mut border: Vec<f32> = (0..w * h).filter(is_border).map(|i| slope[i]).collect();
        let along = quantile(&mut border, 0.5) / (quantile(&mut slope.clone(), 0.9) + 2.0);
        // A box's own sides, not the picture's.
        let sides: Vec<usize> = (0..w * h)
            .filter(|&i| {
                let (x, y) = (i % w, i / w);
                let open = |n: usize| !self.inside[n];
                self.inside[i]
                    && (x > 2 && open(i - 1)
                        || x + 3 < w && open(i + 1)
                        || y > 2 && open(i - w)
                        || y + 3 < h && open(i + w))
            })
            .collect();
        let touching = sides.iter().filter(|&&i| object[i]).count() as f32 / sides.len().max(1) as f32;
        let fill = mask.count() as f32 / self.inside.iter().filter(|&&inside| inside).count().max(1) as f32;
        let unfilled = if self.is_boxed() { UNFILLED * (LEAST_FILL - fill).max(0.0) } else { 0.0 };
        0.5 * (along - 2.0 * unfilled).min(2.5) - 6.0 * self.shortfall(object) - 4.0 * touching
    }

    /// The object at the small size, begun with a mask as large as the photograph.
    pub fn cut_from(&self, mask: &Image) -> Vec<bool> {
        let known = self.outside_is_ground();
        let [left, top] = self.corner.map(|c| c as f64);
        let window = [left, top, left + self.full.width as f64, top + self.full.height as f64];
        let start = mask.window(window, self.small.width, self.small.height).threshold(0.5);
        self.small.cut(&known, &start.data, &self.places, 2)
    }

    fn salient(&self) -> Vec<bool> {
        let Level { width, height, lab, .. } = &self.small;
        let values = saliency(*width, *height, lab, |i| !self.inside[i] || is_rim(i, *width, *height, 1));
        let at: Vec<usize> = (0..values.len()).filter(|&i| self.inside[i]).collect();
        let range = |place: &dyn Fn(usize) -> usize| {
            let [low, high] =
                [at.iter().map(|&i| place(i)).min(), at.iter().map(|&i| place(i)).max()].map(|v| v.unwrap_or(0));
            (0.5 * (low + high) as f64, (0.5 * (high - low) as f64).max(1.0))
        };
        let ((cx, rx), (cy, ry)) = (range(&|i| i % width), range(&|i| i / width));
        let weighted: Vec<f32> = (0..values.len())
            .map(|i| {
                let [u, v] = [((i % width) as f64 - cx) / rx, ((i / width) as f64 - cy) / ry];
                if self.inside[i] { values[i] * (-(u * u + v * v) / (2.0 * 0.75 * 0.75)).exp() as f32 } else { 0.0 }
            })
            .collect();
        let most = weighted.iter().fold(1e-9f32, |most, &v| most.max(v));
        let level = otsu(at.iter().map(|&i| weighted[i] / most)) * most;
        weighted.iter().map(|&v| v > level).collect()
    }

    /// The object, as large as the photograph.
    pub fn cut(&self, guess: &Guess, object: &[Stroke], ground: &[Stroke]) -> Image {
        let (small, full) = (&self.small, &self.full);
        let corner = self.corner.map(|c| c as f64);
        let scale = small.width as f64 / full.width as f64;
        let known = |level: &Level, scale: f64| {
            let [on, off] = [object, ground].map(|s| under(s, level.width, level.height, corner, scale));
            let known = |i: usize| match (on[i], off[i]) {
                (_, true) => Known::Ground,
                (true, false) => Known::Object,
                _ => Known::Open,
            };
            (0..level.lab.len()).map(known).collect::<Vec<_>>()
        };
        let mut found = guess.object.clone();
        if !object.is_empty() || !ground.is_empty() {
            let stroked = known(small, scale);
            let [near, off] = [Known::Object, Known::Ground]
                .map(|side| reach(small, &stroked.iter().map(|&known| known == side).collect::<Vec<_>>()));
            let place = |i: usize| self.places.get(i).copied().unwrap_or(0.0);
            let lean: Vec<f32> = (0..near.len()).map(|i| LEAN * (near[i] - off[i]) + place(i)).collect();
            let start: Vec<bool> =
                (0..found.len()).map(|i| if near[i] == off[i] { found[i] } else { near[i] > off[i] }).collect();
            let known: Vec<Known> =
                (0..found.len()).map(|i| if self.inside[i] { stroked[i] } else { Known::Ground }).collect();
            found = small.cut(&known, &start, &lean, 3);
        }
        let stroked = known(full, 1.0);
        let cut = self.at_full_size(&found, &stroked);
        let is_marked = |i: usize| stroked[i] == Known::Object;
        let tidied = tidy(&Mask { width: full.width, height: full.height, data: cut }, is_marked);
        let mut mask = Image::new(self.size[0], self.size[1]);
        for (i, _) in tidied.data.iter().enumerate().filter(|(_, on)| **on) {
            let (x, y) = (i % tidied.width + self.corner[0], i / tidied.width + self.corner[1]);
            mask.data[y * self.size[0] + x] = 1.0;
        }
        mask
    }

    /// A cut at the small size made one at full size: only a band along its border is open.
    fn at_full_size(&self, object: &[bool], stroked: &[Known]) -> Vec<bool> {
        let (width, height) = (self.full.width, self.full.height);
        let small = Mask { width: self.small.width, height: self.small.height, data: object.to_vec() };
        let near = small.to_image().window([0.0, 0.0, small.width as f64, small.height as f64], width, height);
        let start = near.threshold(0.5);
        let reach = (BAND * width as f64 / self.small.width as f64).max(2.0) as f32;
        let (outer, inner) = (grown(&start, reach), grown(&start.inverted(), reach));
        let known: Vec<Known> = (0..start.data.len())
            .map(|i| match (stroked[i], outer.data[i], inner.data[i]) {
                (Known::Open, true, false) => Known::Object,
                (Known::Open, false, _) => Known::Ground,
                (stroked, ..) => stroked,
            })
            .collect();
        self.full.cut(&known, &start.data, &[], 1)
    }
}

/// Intersection over union.
pub fn overlap(a: &[bool], b: &[bool]) -> f32 {
    let (mut both, mut any) = (0usize, 0usize);
    for (&a, &b) in a.iter().zip(b) {
        both += usize::from(a && b);
        any += usize::from(a || b);
    }
    both as f32 / any.max(1) as f32
}
