//! A shape on its way in, and how a wire would run over it.

use crate::made::WireData;
use crate::pictures::Ink;
use crate::{json, parse_settings};
use wasm_bindgen::prelude::*;
use wire4d::mesh::{Mesh, Shape};
use wire4d::picture::{Pattern, Picture, Polarity, Reading};
use wire4d::settings::{Affects, Flow, Settings, Task};
use wire4d::start::Filling;
use wire4d::tasks::fill::{self, Given, Plan, Style};
use wire4d::wire::Wire;
use wire4d::{Error, Result};

/// Width of the line that shows how a wire would run, as a share of the lines' distance.
const THIN: f64 = 0.12;
/// Most control points of that line.
const MOST_POINTS: usize = 20_000;

/// A shape that a wire covers, and the style that it takes on. Keeps its last curve.
#[wasm_bindgen]
pub struct Surface {
    given: Given,
    filled: Option<(Course, Filling)>,
}

/// All that the way of a curve depends on, but the shape.
#[derive(PartialEq)]
struct Course {
    settings: Vec<String>,
    style: Option<(Style, Vec<String>)>,
}

impl Course {
    fn of(given: &Given, settings: &Settings) -> Course {
        let follows = settings.flow == Flow::Style;
        let style = given.style.as_ref().filter(|_| follows);
        Course {
            settings: settings.texts_affecting(Affects::Curve),
            style: style.map(|style| (style.clone(), settings.texts_affecting(Affects::StyledCurve))),
        }
    }
}

#[wasm_bindgen]
impl Surface {
    /// One by formula: a word of [`shape_names`].
    pub fn built_in(word: &str) -> Result<Surface, JsError> {
        let shape = Shape::named(word).ok_or_else(|| unknown("shape", word, &Shape::ALL.map(Shape::name)))?;
        Ok(Surface { given: Given::shape(shape), filled: None })
    }

    /// A mesh as the module for files hands it over: x, y, z of each corner, three corners a triangle, and a JSON list of
    /// sentences. `name` is what the person calls it.
    pub fn mesh(name: &str, positions: &[f64], triangles: &[u32], notes: &str) -> Result<Surface, JsError> {
        let (positions, triangles) = (positions.as_chunks().0.to_vec(), triangles.as_chunks().0.to_vec());
        let mesh = Mesh::new(name, positions, triangles)?;
        let notes = serde_json::from_str(notes).unwrap_or_default();
        Ok(Surface { given: Given::mesh(name, mesh, notes), filled: None })
    }

    /// What was mended about it, as a JSON list of sentences.
    pub fn notes(&self) -> String {
        json(&self.given.notes)
    }

    /// Number of its triangles.
    #[wasm_bindgen(getter)]
    pub fn triangle_count(&self) -> usize {
        self.given.mesh.triangles().len()
    }

    /// x, y, z of each corner, world units, again and again.
    pub fn positions(&self) -> Vec<f32> {
        self.given.mesh.positions().iter().flatten().map(|&c| c as f32).collect()
    }

    /// Three corners a triangle, counter-clockwise from outside.
    pub fn indices(&self) -> Vec<u32> {
        self.given.mesh.triangles().as_flattened().to_vec()
    }

    /// Takes on a style by formula: a word of [`pattern_names`].
    pub fn set_pattern(&mut self, word: &str) -> Result<(), JsError> {
        if self.given.style.as_ref().is_none_or(|style| style.name != word || !style.tiles) {
            self.given.style = Some(Style::pattern(named(word)?));
        }
        Ok(())
    }

    /// Takes on the look of a picture of straight (not premultiplied) RGBA, rows from the top.
    pub fn set_style(&mut self, name: &str, width: usize, height: usize, rgba: Vec<u8>) -> Result<(), JsError> {
        let reading = Reading { polarity: Polarity::from(Settings::default().ink), threshold: 0.0 };
        let (ink, _) = reading.of(&Picture::new(name, width, height, rgba)?)?;
        self.given.style = Some(Style { name: name.to_owned(), ink, tiles: false });
        Ok(())
    }

    /// Takes on no style.
    pub fn clear_style(&mut self) {
        self.given.style = None;
    }

    /// How a wire would run over it, before anything is fitted: a thin one. `tell(share)` hears how much is done, and
    /// gives it up by returning false.
    pub fn curve(&mut self, settings: &str, tell: &js_sys::Function) -> Result<WireData, JsError> {
        let settings = parse_settings(Task::Fill, settings)?;
        let heard = |share: f32| tell.call1(&JsValue::NULL, &share.into());
        let filling = self.filling(&settings, &mut |share| heard(share) != Ok(JsValue::FALSE))?;
        let width = THIN * settings.curve_spacing;
        let stride = filling.path.points.len().div_ceil(MOST_POINTS).max(2);
        let points = filling.path.points.iter().step_by(stride).map(|&[x, y, z, _]| [x, y, z, width]).collect();
        Ok(WireData(Wire::closed_uniform(points)?))
    }
}

impl Surface {
    /// The curve, made anew only where it would be another. `progress` gives it up by returning false.
    fn filling(&mut self, settings: &Settings, progress: &mut dyn FnMut(f32) -> bool) -> Result<Filling> {
        let course = Course::of(&self.given, settings);
        if let Some((known, filling)) = &self.filled
            && *known == course
        {
            return Ok(filling.clone());
        }
        let given_up = || Error::setting("curve_spacing", "the lines were given up", "change something, or try again");
        let filling = fill::cover(&self.given, settings, progress)?.ok_or_else(given_up)?;
        self.filled = Some((course, filling.clone()));
        Ok(filling)
    }

    /// All that a fit needs.
    pub(crate) fn plan(&mut self, settings: &Settings, progress: &mut dyn FnMut(f32) -> bool) -> Result<Plan> {
        let filling = self.filling(settings, progress)?;
        fill::plan_over(&self.given, filling, settings)
    }
}

/// The shapes by formula, as a JSON list of words.
#[wasm_bindgen]
pub fn shape_names() -> String {
    json(&Shape::ALL.map(Shape::name))
}

/// The styles by formula, as a JSON list of words.
#[wasm_bindgen]
pub fn pattern_names() -> String {
    json(&Pattern::ALL.map(Pattern::name))
}

/// The picture of a style by formula, `size` px a side.
#[wasm_bindgen]
pub fn pattern(word: &str, size: usize) -> Result<Ink, JsError> {
    Ok(Ink::new(&named(word)?.picture(size)))
}

fn named(word: &str) -> Result<Pattern> {
    Pattern::named(word).ok_or_else(|| unknown("style", word, &Pattern::ALL.map(Pattern::name)))
}

fn unknown(what: &str, word: &str, known: &[&str]) -> Error {
    Error::setting(what, format!("there is none called {word:?}"), format!("give one of {}", known.join(", ")))
}
