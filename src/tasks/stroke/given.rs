//! What a person gives: a picture, and what they know of it.

use crate::picture::Picture;
use crate::picture::cut::{Hints, Stroke};
use crate::view::{Image, ViewSpec};

/// What a person gives.
#[derive(Debug, Clone)]
pub struct Given {
    /// The picture.
    pub picture: Picture,
    /// What of it is the object, 0 to 1, any size; `None` finds it.
    pub mask: Option<Image>,
    /// A box round the object, px of the picture: left, top, right, bottom. Counts where there is no mask.
    pub bounds: Option<[f64; 4]>,
    /// Strokes on the object, px of the picture. Count where there is no mask.
    pub object: Vec<Stroke>,
    /// Strokes on what is not the object, likewise.
    pub ground: Vec<Stroke>,
    /// How near each of its pixels is, light is near; of the picture's size. `None` guesses.
    pub depth: Option<Picture>,
    /// The same object from other sides.
    pub others: Vec<(Picture, ViewSpec)>,
}

impl Given {
    /// One picture and nothing else.
    pub fn picture(picture: Picture) -> Given {
        let (object, ground) = (Vec::new(), Vec::new());
        Given { picture, mask: None, bounds: None, object, ground, depth: None, others: Vec::new() }
    }

    /// Whether there are strokes on the object or beside it.
    pub(super) fn has_strokes(&self) -> bool {
        !(self.object.is_empty() && self.ground.is_empty())
    }

    /// What is pointed at, px of the picture.
    pub(super) fn hints(&self) -> Hints {
        let bounds = self.bounds.map(|bounds| bounds.map(|side| side as f32));
        Hints { bounds, object: self.object.clone(), ground: self.ground.clone() }
    }
}
