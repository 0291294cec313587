//! The lines that a draughtsman would draw of an object in a photograph: its outline, then what says most.
//!
//! Coherent line drawing (Kang, Lee and Chui 2007): edges and dark lines are looked for across, and gathered along, a
//! smooth flow of tangents; what is only texture is held back by what surrounds it (Grigorescu, Petkov and Westenberg 2003).

mod choose;
mod edges;
mod grid;
mod ink;
mod join;
mod line;
mod outline;
mod trace;

use super::photo::Photo;
use crate::picture::{Ink, Mask};
use crate::view::{Image, PixelBox};
use edges::Edges;

pub use ink::ink;

/// Pixels round an object that are looked at too.
const MARGIN: usize = 12;

/// What a line is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// The border of the object or of a hole in it.
    Outline,
    /// Anything within.
    Inner,
}

/// One line of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// About a pixel apart, px of the [`Photo`]; the first is the last again where the line is closed.
    pub points: Vec<[f32; 2]>,
    /// Width that it asks for, px of the [`Photo`]: 3 to 5 of 256.
    pub width_px: f32,
    /// How much it says that the lines before it do not, 0 to 1; outlines 1.
    pub importance: f32,
    /// What it is of.
    pub kind: Kind,
}

impl Line {
    /// Its length, px.
    pub fn length(&self) -> f32 {
        line::length(&self.points)
    }
}

/// How much is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Budget {
    /// At most so many lines, outlines with them.
    Lines(usize),
    /// Lines up to so many times the object's longer side, outlines with them.
    Length(f32),
    /// What says at least so much, 0 to 1 ([`Line::importance`]).
    Importance(f32),
}

impl Default for Budget {
    fn default() -> Budget {
        Budget::Importance(0.04)
    }
}

/// Draws the object that `mask` says (0 to 1, as large as the photograph): its outlines, longest first, then what says
/// most that is not said yet, as far as the budget goes. An outline is drawn whatever the budget. Without an object there
/// is nothing to draw.
///
/// # Panics
/// If the mask has another size than the photograph.
pub fn draw(photo: &Photo, mask: &Image, budget: Budget) -> Vec<Line> {
    assert_eq!((photo.width, photo.height), (mask.width, mask.height), "a mask is as large as its photograph");
    let solid = mask.threshold(0.5);
    let outlines = outline::outlines(&solid);
    drawn(photo, &solid, outlines, budget)
}

/// Draws all that is in a box (left, top, right, bottom, px of the photograph), where no mask can be trusted: lines
/// without an outline.
pub fn draw_in_box(photo: &Photo, [left, top, right, bottom]: [f32; 4], budget: Budget) -> Vec<Line> {
    let (width, height) = (photo.width, photo.height);
    let inside = |i: usize| {
        let (x, y) = ((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
        x >= left && x < right && y >= top && y < bottom
    };
    let all = Mask { width, height, data: (0..width * height).map(inside).collect() };
    drawn(photo, &all, Vec::new(), budget)
}

fn drawn(photo: &Photo, solid: &Mask, outlines: Vec<Vec<[f32; 2]>>, budget: Budget) -> Vec<Line> {
    let Some(frame) = solid.bounding_box() else { return Vec::new() };
    let size = frame.width().max(frame.height()) as f32;
    let part = PixelBox {
        left: frame.left.saturating_sub(MARGIN),
        top: frame.top.saturating_sub(MARGIN),
        right: (frame.right + MARGIN).min(photo.width),
        bottom: (frame.bottom + MARGIN).min(photo.height),
    };
    let mut inner = Edges::of(photo, solid, part).lines(size);
    for p in inner.iter_mut().flat_map(|line| &mut line.points) {
        *p = [p[0] + part.left as f32, p[1] + part.top as f32];
    }
    let at_256 = photo.width.max(photo.height) as f32 / 256.0;
    let width_px = |contrast: f32| (3.0 + 2.0 * (contrast / 40.0).min(1.0)) * at_256;
    choose::chosen(outlines, inner, part, size, budget)
        .into_iter()
        .map(|line| Line { width_px: width_px(line.width_px), ..line })
        .collect()
}
