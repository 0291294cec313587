//! Photographs as the page's worker takes them: a module of its own, which takes wires as wire.json files.

use serde::Deserialize;
use wasm_bindgen::prelude::*;
use wire4d::sculpture::Sculpture;
use wire4d::{Error, Result};
use wire4d_photograph::{Arrangement, Develop, Film, Finish, Lens, Place, Setting, Sky, Vec3};

/// What somebody wants of it; lengths in world units, angles in degrees, see [`Arrangement`] and [`Lens`].
#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
struct Wishes {
    /// Width and height, px.
    size: [usize; 2],
    seed: u32,
    /// `room`, `screens`, `studio`, or what fits the wire's views.
    place: Option<String>,
    matte: bool,
    /// Linear, 0 to 1.
    colour: [f32; 3],
    roughness: f32,
    lamp_radius: f32,
    surround: f32,
    /// Whether that light comes as on a grey day.
    overcast: bool,
    azimuth: f32,
    elevation: f32,
    aperture: f32,
    /// Stops.
    exposure: f32,
}

/// A photograph that gets better with every pass.
#[wasm_bindgen]
pub struct Photograph {
    setting: Setting,
    film: Film,
    exposure: f32,
}

#[wasm_bindgen]
impl Photograph {
    /// Of the wire of a wire.json; nothing is exposed yet.
    #[wasm_bindgen(constructor)]
    pub fn new(file: &[u8], wishes: &str) -> Result<Photograph, JsError> {
        Ok(opened(file, wishes)?)
    }

    /// One more sample of every pixel.
    pub fn expose(&mut self) {
        self.film.expose(&self.setting);
    }

    /// Samples of each pixel so far.
    pub fn passes(&self) -> u32 {
        self.film.passes()
    }

    /// RGBA, 4 bytes a pixel, rows from the top; `calmed` takes the noise out of indirect light, which takes its time.
    pub fn picture(&self, calmed: bool) -> Vec<u8> {
        let developed = self.film.developed(Develop { exposure: self.exposure, calmed });
        developed.as_chunks().0.iter().flat_map(|&[r, g, b]: &[u8; 3]| [r, g, b, 255]).collect()
    }
}

fn opened(file: &[u8], wishes: &str) -> Result<Photograph> {
    let sculpture = Sculpture::from_json("wire.json", file)?;
    let wishes: Wishes = serde_json::from_str(wishes)
        .map_err(|problem| Error::setting("photograph", problem.to_string(), "reload the page"))?;
    let place = match wishes.place.as_deref() {
        Some("room") => Place::Room,
        Some("studio") => Place::Studio,
        Some("screens") if !sculpture.views.is_empty() => Place::Screens,
        _ => Place::fitting(&sculpture.views),
    };
    let arrangement = Arrangement {
        place,
        finish: if wishes.matte { Finish::Matte } else { Finish::Metal },
        colour: Vec3::from_array(wishes.colour),
        roughness: wishes.roughness,
        lamp_radius: wishes.lamp_radius,
        surround: wishes.surround,
        sky: if wishes.overcast { Sky::Overcast } else { Sky::Soft },
        ..Arrangement::default()
    };
    let [width, height] = wishes.size;
    let usual = Lens::of(place, place.away(&sculpture.views));
    // As much to the sides as from top to bottom: a tall picture is taken from farther away.
    let narrow = (height as f32 / width.max(1) as f32).max(1.0);
    let lens = Lens {
        azimuth: wishes.azimuth,
        elevation: wishes.elevation,
        aperture: wishes.aperture,
        distance: usual.distance * narrow,
        ..usual
    };
    Ok(Photograph {
        setting: Setting::new(&sculpture.wire, &sculpture.views, &arrangement)?,
        film: Film::new(&lens, wishes.size, wishes.seed)?,
        exposure: wishes.exposure,
    })
}
