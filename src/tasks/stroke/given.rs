//! What a person gives: a picture, and what they know of it.

use crate::picture::Picture;
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
    /// How near each of its pixels is, light is near; of the picture's size. `None` guesses.
    pub depth: Option<Picture>,
    /// The same object from other sides.
    pub others: Vec<(Picture, ViewSpec)>,
}

impl Given {
    /// One picture and nothing else.
    pub fn picture(picture: Picture) -> Given {
        Given { picture, mask: None, bounds: None, depth: None, others: Vec::new() }
    }
}
