//! Part of a photograph at one size, and its least cut by colours and edges.

use crate::picture::spread::quantile;
use crate::segment::{GridFlow, Mixture, NEIGHBOURS, Palette};

/// What setting a sure pixel free would cost.
const SURE: f64 = 1000.0;
/// Steps of a whole number that the cuts are computed in.
const STEPS: f64 = 16.0;
/// A cut that moves fewer pixels than this share is the last.
const SETTLED: f64 = 5e-4;
/// Half of the directions: each pair of neighbours once.
const FORWARD: [usize; 4] = [0, 2, 4, 6];

/// What is known of a pixel before a cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Known {
    Object,
    Ground,
    Open,
}

/// What counts how much in a cut.
#[derive(Debug, Clone, Copy)]
pub struct Weights {
    /// What parting two pixels of one colour costs, against what a colour's surprise costs.
    pub edge: f64,
    /// Most that colours say for or against the object.
    pub colours: f64,
}

impl Weights {
    /// Where nothing is said of places, long borders alone hold a cut together (Rother et al. 2004).
    pub const ANYWHERE: Weights = Weights { edge: 50.0, colours: f64::MAX };
    /// In a box places count too: what looks like the ground outside cannot be ruled out by its colour alone, nor do short
    /// borders, which shrink a cut to its brightest part. Found on scenes and on real photographs.
    pub const BOX: Weights = Weights { edge: 10.0, colours: 3.0 };
}

/// Colours of part of a photograph, and what it costs to part neighbours.
pub struct Level {
    pub width: usize,
    pub height: usize,
    pub lab: Vec<[f32; 3]>,
    palette: Palette,
    /// Most that colours say.
    most: f64,
    /// For each of [`FORWARD`]; 0 towards outside.
    links: Vec<[i32; 4]>,
    /// Median difference between neighbours, in units of colour.
    step: f32,
}

impl Level {
    pub fn new(width: usize, height: usize, lab: Vec<[f32; 3]>, weights: Weights) -> Level {
        let neighbour = |i: usize, direction: usize| {
            let [dx, dy] = NEIGHBOURS[direction];
            let x = (i % width).checked_add_signed(dx).filter(|&x| x < width)?;
            let y = (i / width).checked_add_signed(dy).filter(|&y| y < height)?;
            Some(y * width + x)
        };
        let squared = |a: usize, b: usize| (0..3).map(|c| (lab[a][c] - lab[b][c]).powi(2)).sum::<f32>();
        let mut steps = vec![[-1.0f32; 4]; lab.len()];
        let (mut sum, mut count) = (0.0, 0usize);
        for i in 0..lab.len() {
            for (k, &direction) in FORWARD.iter().enumerate() {
                if let Some(next) = neighbour(i, direction) {
                    steps[i][k] = squared(i, next);
                    sum += f64::from(steps[i][k]);
                    count += 1;
                }
            }
        }
        // A picture without any step has no edges to follow.
        let mean = sum / count.max(1) as f64;
        let scale = -1.0 / (2.0 * mean).max(1e-3);
        let cost = |squared: f32, k: usize| {
            let apart = if FORWARD[k] >= 4 { std::f64::consts::SQRT_2 } else { 1.0 };
            if squared < 0.0 {
                0
            } else {
                (STEPS * weights.edge / apart * (scale * f64::from(squared)).exp()).round() as i32
            }
        };
        let links = steps.iter().map(|steps| [0, 1, 2, 3].map(|k| cost(steps[k], k))).collect();
        let palette = Palette::of(&lab);
        let mut sample: Vec<f32> = steps.iter().step_by(7).map(|step| step[0].max(0.0)).collect();
        let step = quantile(&mut sample, 0.5).sqrt();
        Level { width, height, lab, palette, most: weights.colours, links, step }
    }

    /// The usual difference between neighbours, in units of colour.
    pub fn usual_step(&self) -> f32 {
        self.step
    }

    /// How steeply colours change at each pixel, in units of colour a pixel: central differences.
    pub fn slope(&self) -> Vec<f32> {
        let (w, h) = (self.width, self.height);
        let slope = |i: usize| {
            let (x, y) = (i % w, i / w);
            let (l, r) = (self.lab[y * w + x.saturating_sub(1)], self.lab[y * w + (x + 1).min(w - 1)]);
            let (t, b) = (self.lab[y.saturating_sub(1) * w + x], self.lab[(y + 1).min(h - 1) * w + x]);
            (0..3).map(|c| 0.25 * ((r[c] - l[c]).powi(2) + (b[c] - t[c]).powi(2))).sum::<f32>().sqrt()
        };
        (0..w * h).map(slope).collect()
    }

    /// Iterates cuts and what they say of both sides' colours, from `start`, at most `rounds` times. `lean` adds to what
    /// colours say: above 0 towards the object, in the units of surprise.
    pub fn cut(&self, known: &[Known], start: &[bool], lean: &[f32], rounds: usize) -> Vec<bool> {
        let mut flow = GridFlow::new(self.width, self.height);
        let is_open = |i: usize| known[i] == Known::Open;
        for i in 0..self.lab.len() {
            for (k, &direction) in FORWARD.iter().enumerate() {
                let [dx, dy] = NEIGHBOURS[direction];
                // What is known on both sides needs no link.
                if self.links[i][k] > 0 {
                    let next = i.wrapping_add_signed(dx + dy * self.width as isize);
                    if is_open(i) || is_open(next) {
                        flow.set_between(i, direction, self.links[i][k]);
                    }
                }
            }
        }
        let mut object: Vec<bool> = (0..start.len())
            .map(|i| match known[i] {
                Known::Object => true,
                Known::Ground => false,
                Known::Open => start[i],
            })
            .collect();
        for _ in 0..rounds {
            let of = |side: bool| {
                Mixture::fit(&self.palette, &self.palette.histogram(|i| f64::from(u8::from(object[i] == side))))
            };
            let (Some(inside), Some(outside)) = (of(true), of(false)) else { break };
            let outside = outside.with_shadows();
            let pull = |&c: &[f64; 3]| (outside.surprise(c) - inside.surprise(c)).clamp(-self.most, self.most);
            let pull: Vec<f64> = self.palette.colours.iter().map(pull).collect();
            for i in 0..object.len() {
                let cost = match known[i] {
                    Known::Object => SURE,
                    Known::Ground => -SURE,
                    Known::Open => {
                        pull[self.palette.entry[i] as usize] + f64::from(lean.get(i).copied().unwrap_or(0.0))
                    }
                };
                flow.set_terminal(i, (STEPS * cost.clamp(-SURE, SURE)).round() as i32);
            }
            flow.cut();
            let next: Vec<bool> = (0..object.len()).map(|i| flow.is_object(i)).collect();
            let moved = next.iter().zip(&object).filter(|(a, b)| a != b).count();
            object = next;
            if moved as f64 <= SETTLED * object.len() as f64 {
                break;
            }
        }
        object
    }
}
