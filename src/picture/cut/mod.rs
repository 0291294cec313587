//! The object of a photograph, cut out by what a person points at: a box round it, strokes on it and beside it.
//!
//! Cuts are iterated between the colours of object and ground (GrabCut; Rother, Kolmogorov and Blake 2004): first small,
//! then once more at full size in a band along the border. Without a hint it is looked for, and how sure that is is said.

mod bars;
mod level;
mod place;
mod region;
mod saliency;
mod strokes;
mod tidy;

use super::photo::Photo;
use super::spread::quantile;
use crate::picture::Ink;
use crate::view::Image;
use crate::{Error, Result};
use region::{Guess, Region};

/// A line drawn on a photograph, px of [`Photo`].
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Its corners; one is a dot.
    pub points: Vec<[f32; 2]>,
    /// Half its width.
    pub radius_px: f32,
}

/// What a person pointed at. All places are px of the [`Photo`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Hints {
    /// A box round the object: left, top, right, bottom. What is outside is ground.
    pub bounds: Option<[f32; 4]>,
    /// Strokes on the object.
    pub object: Vec<Stroke>,
    /// Strokes on the ground.
    pub ground: Vec<Stroke>,
}

/// An object cut out.
#[derive(Debug, Clone, PartialEq)]
pub struct Cut {
    /// 1 where the object is, 0 elsewhere; as large as the photograph.
    pub mask: Image,
    /// How likely that is to be the object as a person would cut it, 0 to 1. Below [`SURE`] better ask.
    pub sure: f32,
    /// What a person should know, in plain words.
    pub notes: Vec<String>,
}

/// Cuts that are surer than this may be taken without asking: found on scenes of known truth.
pub const SURE: f32 = 0.75;

/// Colours that spread less than this, in units of [`Photo::lab`], show nothing.
const LEAST_SPREAD: f32 = 4.0;
/// Edges that are nowhere steeper than this, in units of colour a pixel, are blurred.
const BLURRED: f32 = 1.2;
/// A picture whose usual slope is this share of its steepest is texture all over.
const TEXTURE: f32 = 0.3;

/// A box of more than this share of the picture is about all of it.
const NEARLY_ALL: f64 = 0.7;

/// Cuts one photograph, again and again as hints come in. What it finds depends on the hints alone, not on what was
/// asked before.
pub struct Cutter {
    photo: Photo,
    /// What of it is no black bar.
    frame: [usize; 4],
    /// What is wrong with the picture as a whole, once that was looked at.
    faults: Option<Result<Vec<String>>>,
    /// What was found in the whole picture, and inside the last box, before any stroke.
    whole: Option<Found>,
    boxed: Option<([usize; 4], Found)>,
}

struct Found {
    region: Region,
    guess: Guess,
}

impl Cutter {
    /// For one photograph.
    pub fn new(photo: Photo) -> Cutter {
        Cutter { frame: bars::without_bars(&photo), photo, faults: None, whole: None, boxed: None }
    }

    /// The photograph.
    pub fn photo(&self) -> &Photo {
        &self.photo
    }

    /// Cuts out what the hints point at, or what catches the eye without any.
    ///
    /// # Errors
    /// [`Error::Setting`] named `box` for one outside the picture or of no area, named `strokes` for strokes that lie
    /// outside the picture or the box, or contradict each other; [`Error::Picture`] where there is nothing to see, and
    /// where nothing is found.
    pub fn cut(&mut self, hints: &Hints) -> Result<Cut> {
        let bounds = self.bounds(hints)?;
        self.check_strokes(hints, bounds.unwrap_or(self.frame))?;
        if self.faults.is_none() {
            self.faults = Some(self.looked_over());
        }
        let mut notes = self.faults.clone().unwrap_or(Ok(Vec::new()))?;
        let Found { region, guess } = self.found(bounds);
        let (mask, guessed) = (region.cut(guess, &hints.object, &hints.ground), guess.sure);
        let share = mask.data.iter().filter(|&&value| value > 0.5).count() as f64 / mask.data.len() as f64;
        let name = &self.photo.name;
        if share < 1e-4 {
            return Err(Error::picture(name, "no object was found", "draw a stroke on it, or a box close round it"));
        }
        let stroked = !hints.object.is_empty() || !hints.ground.is_empty();
        if !stroked && guessed < SURE {
            let note = match hints.bounds {
                None => "it is not clear which thing is meant",
                Some(_) => "the object may be cut out badly; strokes on what is missing or too much help",
            };
            notes.push(format!("{name}: {note}"));
        }
        // Whoever drew strokes looked at what they did.
        Ok(Cut { mask, sure: if stroked { 1.0 } else { guessed }, notes })
    }

    /// What is found inside a box before any stroke. What is surely found without it is meant if it fills the box.
    fn found(&mut self, bounds: Option<[usize; 4]>) -> &Found {
        let (photo, frame) = (&self.photo, self.frame);
        let whole = || {
            let region = Region::new(photo, None, frame);
            Found { guess: region.guess(), region }
        };
        let Some(bounds) = bounds else { return self.whole.get_or_insert_with(whole) };
        if self.boxed.as_ref().is_none_or(|(of, _)| *of != bounds) {
            let region = Region::new(photo, Some(bounds), frame);
            let area = |[left, top, right, bottom]: [usize; 4]| ((right - left) * (bottom - top)) as f64;
            // A box round nearly everything says that the object is that large, and costs as much as everything.
            let is_part = area(bounds) < NEARLY_ALL * area(frame);
            let whole = is_part.then(|| &*self.whole.get_or_insert_with(whole));
            let sure = whole.filter(|whole| whole.guess.sure >= SURE);
            let seen = sure.map(|whole| (whole.region.cut(&whole.guess, &[], &[]), whole.guess.sure));
            let guess = match seen.filter(|(mask, _)| fills(mask, bounds)) {
                Some((mask, sure)) => Guess { object: region.cut_from(&mask), sure },
                None => region.guess(),
            };
            self.boxed = Some((bounds, Found { region, guess }));
        }
        &self.boxed.as_ref().expect("it was just made").1
    }

    /// The box as whole pixels: first columns and rows, and one past the last.
    fn bounds(&self, hints: &Hints) -> Result<Option<[usize; 4]>> {
        let Some([left, top, right, bottom]) = hints.bounds else { return Ok(None) };
        let refuse = |problem: &str| Err(Error::setting("box", problem, "drag it round the object"));
        if ![left, top, right, bottom].iter().all(|v| v.is_finite()) || right <= left || bottom <= top {
            return refuse("has no area");
        }
        let inside = |v: f32, from: usize, to: usize| v.clamp(from as f32, to as f32);
        let [x0, y0, x1, y1] = self.frame;
        let [l, r] = [inside(left, x0, x1).floor(), inside(right, x0, x1).ceil()].map(|v| v as usize);
        let [t, b] = [inside(top, y0, y1).floor(), inside(bottom, y0, y1).ceil()].map(|v| v as usize);
        if r <= l || b <= t {
            let [width, height] = [self.photo.width as f32, self.photo.height as f32];
            let is_outside = right <= 0.0 || bottom <= 0.0 || left >= width || top >= height;
            return refuse(if is_outside {
                "lies outside the picture"
            } else {
                "lies in the black bar of the picture"
            });
        }
        if (r - l).min(b - t) < 4 {
            return refuse("is too small to hold anything");
        }
        Ok(Some([l, t, r, b]))
    }

    fn check_strokes(&self, hints: &Hints, [left, top, right, bottom]: [usize; 4]) -> Result<()> {
        let (width, height) = (self.photo.width, self.photo.height);
        let refuse = |problem: &str, remedy: &str| Err(Error::setting("strokes", problem, remedy));
        let all = || hints.object.iter().chain(&hints.ground);
        if all().any(|stroke| {
            stroke.points.is_empty()
                || !stroke.radius_px.is_finite()
                || stroke.points.iter().flatten().any(|v| !v.is_finite())
        }) {
            return refuse("have a place that is no number", "draw them again");
        }
        if hints.object.is_empty() {
            return Ok(());
        }
        let marks = |strokes: &[Stroke]| strokes::under(strokes, width, height, [0.0; 2], 1.0);
        let ground = marks(&hints.ground);
        for stroke in &hints.object {
            let on = marks(std::slice::from_ref(stroke));
            let count = |keep: &dyn Fn(usize) -> bool| (0..on.len()).filter(|&i| on[i] && keep(i)).count();
            let drawn = count(&|_| true);
            if drawn == 0 {
                return refuse("lie outside the picture", "draw them on the object");
            }
            let boxed = |i: usize| (left..right).contains(&(i % width)) && (top..bottom).contains(&(i / width));
            if 2 * count(&boxed) < drawn {
                return refuse("mark as object what is outside the box", "drag the box larger, or undo the stroke");
            }
            if 2 * count(&|i| ground[i]) > drawn {
                return refuse("mark the same place as object and as ground", "undo one of them");
            }
        }
        Ok(())
    }

    /// What is wrong with the picture as a whole.
    fn looked_over(&self) -> Result<Vec<String>> {
        let Photo { name, lab, width, height, .. } = &self.photo;
        let sampled = |c: usize| lab.iter().step_by(5).map(|lab| lab[c]).collect::<Vec<f32>>();
        let spread = |c: usize| quantile(&mut sampled(c), 0.998) - quantile(&mut sampled(c), 0.002);
        let widest = (0..3).map(spread).fold(0.0, f32::max);
        if widest < LEAST_SPREAD {
            let dark = quantile(&mut sampled(0), 0.5) < 25.0;
            let problem = if dark { "is dark all over" } else { "is of one colour all over" };
            return Err(Error::picture(name, problem, "take one in which an object stands out"));
        }
        let step = |i: usize| {
            let n = if i % width + 1 < *width { i + 1 } else { i };
            let m = if i / width + 1 < *height { i + width } else { i };
            (0..3).map(|c| (lab[n][c] - lab[i][c]).powi(2) + (lab[m][c] - lab[i][c]).powi(2)).sum::<f32>().sqrt()
        };
        let mut steps: Vec<f32> = (0..lab.len()).step_by(3).map(step).collect();
        let (usual, steepest) = (quantile(&mut steps, 0.5), quantile(&mut steps, 0.995));
        let mut notes = Vec::new();
        if steepest < BLURRED {
            notes.push(format!("{name}: is blurred all over, so borders may be found badly; a sharper picture helps"));
        } else if usual > TEXTURE * steepest {
            notes.push(format!("{name}: is texture all over, so borders may be found badly; strokes help"));
        }
        Ok(notes)
    }
}

/// Whether an object lies in a box and is most of its width and height.
fn fills(mask: &Image, [left, top, right, bottom]: [usize; 4]) -> bool {
    let Some(frame) = mask.threshold(0.5).bounding_box() else { return false };
    let inside = frame.left >= left && frame.top >= top && frame.right <= right && frame.bottom <= bottom;
    let most = |found: usize, side: usize| found as f32 >= region::FILLS * side as f32;
    inside && most(frame.width(), right - left) && most(frame.height(), bottom - top)
}
