//! The objects in a picture: one of them is chosen.

use super::super::{Components, Mask};
use crate::picture::Ink;
use crate::sorting::sort_by_key;
use crate::view::Image;
use crate::{Error, Result};

/// The objects in a picture, the largest first, so that a person can choose one.
#[derive(Debug, Clone, PartialEq)]
pub struct Parts {
    /// Pixels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// For each pixel which object it shows, counted from 1; 0 is ground.
    pub labels: Vec<u32>,
    /// What share of the picture each object covers, 0 to 1.
    pub shares: Vec<f64>,
    /// Which of them is taken, counted from 1.
    pub chosen: usize,
}

impl Parts {
    /// One object's pixels; none if there is no such object.
    pub fn mask(&self, object: usize) -> Mask {
        let data = self.labels.iter().map(|&label| label > 0 && label as usize == object).collect();
        Mask { width: self.width, height: self.height, data }
    }
}

/// Parts nearer to each other than this share of the picture's side are one object.
pub const JOINED_WITHIN: f32 = 0.04;
/// Parts of at least this share of the largest are objects.
const WORTH_CHOOSING: f64 = 0.05;
/// Objects of at least this share of the chosen, left out, are worth a word.
const WORTH_A_WORD: f64 = 0.15;
/// Holes and specks smaller than this share of the object are noise.
const SPECK: f64 = 5e-4;
/// Share of the border that an object may cover.
const MOST_BORDER: f64 = 0.75;
/// Fewest pixels of an object.
const FEWEST_PIXELS: usize = 12;

/// One object with all that lies close to it, specks and pinholes removed; `given`: the picture is a mask that says what
/// the object is.
pub fn chosen_part(
    whole: &Image,
    object: usize,
    name: &str,
    given: bool,
    notes: &mut Vec<String>,
) -> Result<(Mask, Parts)> {
    let (width, height) = (whole.width, whole.height);
    let solid = whole.threshold(0.5);
    if solid.count() < FEWEST_PIXELS {
        let remedy =
            if given { "paint more of the object" } else { "use a picture with a larger object, or paint a mask" };
        return Err(Error::picture(name, format!("shows no object: {} pixels stand out", solid.count()), remedy));
    }
    let group = near(&solid).components();
    let mut parts = parts(&solid, &group);
    if given {
        // A mask says what the object is: all of it but crumbs.
        parts.labels.iter_mut().for_each(|label| *label = (*label).min(1));
        parts.shares = vec![parts.shares.iter().sum()];
    }
    let count = parts.shares.len();
    if object == 0 || object > count {
        let (are, objects) = if count == 1 { ("is", "object") } else { ("are", "objects") };
        let problem = format!("there {are} {count} {objects} in {name}, so there is no number {object}");
        let remedy = if count == 1 { "give 1".to_owned() } else { format!("give 1 to {count}, the largest is 1") };
        return Err(Error::setting("object", problem, remedy));
    }
    let pixels = |k: usize| parts.shares[k] * (width * height) as f64;
    let size = pixels(object - 1);
    let others = (0..count).filter(|&k| k + 1 != object && pixels(k) >= WORTH_A_WORD * size).count();
    if others > 0 {
        let taken = if object == 1 { "the largest is taken".to_owned() } else { format!("number {object} is taken") };
        notes.push(format!("{name}: {} objects stand out, {taken}; choose another or paint a mask", others + 1));
    }
    let chosen = Parts { chosen: object, ..parts };
    let of_it = chosen.mask(object);
    let border: Vec<usize> = (0..width * height).filter(|&i| on_rim(i, width, height)).collect();
    let covered = border.iter().filter(|&&i| of_it.data[i]).count();
    if covered as f64 > MOST_BORDER * border.len() as f64 {
        let problem = "its object covers the border all round, so there is no ground to tell it from";
        let remedy = if given {
            "give a mask that is white on the object and black all round"
        } else {
            "use a picture with some ground all round, or paint a mask"
        };
        return Err(Error::picture(name, problem, remedy));
    }
    if covered > 0 {
        notes.push(format!("{name}: the object reaches the picture's border and is cut off there"));
    }
    let least = (SPECK * size).max(1.0) as usize;
    let pieces = solid.components();
    // Soft pixels beside the object are its edge.
    let mut is_its = vec![false; group.sizes.len() + 1];
    let inside = of_it.data.iter().zip(&group.labels).filter(|(of_it, _)| **of_it);
    inside.for_each(|(_, &label)| is_its[label as usize] = label > 0);
    let kept = (0..width * height).map(|i| {
        let piece = pieces.labels[i] as usize;
        is_its[group.labels[i] as usize] && (piece == 0 || pieces.sizes[piece - 1] > least)
    });
    Ok((Mask { data: kept.collect(), ..solid }, chosen))
}

/// What lies close to a mask. What an outline encloses belongs to it.
fn near(solid: &Mask) -> Mask {
    let close = (JOINED_WITHIN * solid.width.max(solid.height) as f32).max(1.5) / 2.0;
    filled(solid).dilated(close)
}

fn parts(solid: &Mask, groups: &Components) -> Parts {
    let mut inked = vec![0usize; groups.sizes.len()];
    for (&label, _) in groups.labels.iter().zip(&solid.data).filter(|(_, solid)| **solid) {
        inked[label as usize - 1] += 1;
    }
    let mut order: Vec<usize> = (0..inked.len()).collect();
    sort_by_key(&mut order, |&k| (std::cmp::Reverse(inked[k]), k));
    let least = WORTH_CHOOSING * inked[order[0]] as f64;
    order.retain(|&k| inked[k] as f64 >= least);
    let mut rank = vec![0u32; inked.len()];
    order.iter().zip(1..).for_each(|(&k, number)| rank[k] = number);
    let label = |(&label, &solid): (&u32, &bool)| if solid && label > 0 { rank[label as usize - 1] } else { 0 };
    Parts {
        width: solid.width,
        height: solid.height,
        labels: groups.labels.iter().zip(&solid.data).map(label).collect(),
        shares: order.iter().map(|&k| inked[k] as f64 / solid.data.len() as f64).collect(),
        chosen: 1,
    }
}

/// Whether a pixel is one of the outermost.
fn on_rim(i: usize, width: usize, height: usize) -> bool {
    let (x, y) = (i % width, i / width);
    x == 0 || y == 0 || x + 1 == width || y + 1 == height
}

/// The mask with everything that it encloses. Ground joins across sides only: lines that meet at corners are closed.
pub fn filled(mask: &Mask) -> Mask {
    let (width, height) = (mask.width, mask.height);
    let mut outside = vec![false; mask.data.len()];
    let mut front: Vec<usize> = (0..mask.data.len()).filter(|&i| on_rim(i, width, height)).collect();
    while let Some(i) = front.pop() {
        if mask.data[i] || std::mem::replace(&mut outside[i], true) {
            continue;
        }
        let (x, y) = (i % width, i / width);
        front.extend([(x > 0, i.wrapping_sub(1)), (x + 1 < width, i + 1)].iter().filter(|n| n.0).map(|n| n.1));
        front.extend([(y > 0, i.wrapping_sub(width)), (y + 1 < height, i + width)].iter().filter(|n| n.0).map(|n| n.1));
    }
    Mask { width, height, data: outside.iter().map(|outside| !outside).collect() }
}
