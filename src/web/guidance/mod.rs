//! Guidance that JavaScript computes: a function of the pictures, or networks that it runs.

mod diffusion;
mod networks;

pub use diffusion::{Contexts, DenoiserObject, DiffusionOptions, EncoderObject, by_diffusion};
pub use networks::{Networks, Vectors, WordsOptions, by_words};

use js_sys::{Array, Float32Array, Function, Object, Promise, Reflect};
use send_wrapper::SendWrapper;
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::JsFuture;
use wire4d::objective::{Guidance, Progress, Rendered};
use wire4d::optimize::Work;
use wire4d::{Error, Result};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** What one view shows now. */
export interface GuidedImage {
  readonly width: number;
  readonly height: number;
  /** The wire's ink, 0 to 1, row by row from the top. */
  readonly ink: Float32Array;
  /** World to right, down and depth: each `[x, y, z, offset]`, in world units. */
  readonly right: Float32Array;
  readonly down: Float32Array;
  readonly forward: Float32Array;
}

/** How far the fit is: what schedules and random choices go by, so that a resumed run makes the same ones. */
export interface GuidanceInfo {
  readonly iteration: number;
  readonly iterations: number;
}

export interface GuidanceAnswer {
  readonly loss: number;
  /** One a view: d loss / d ink, a value a pixel. */
  readonly grad: readonly Float32Array[];
}

export type GuidanceFunction = (images: readonly GuidedImage[], info: GuidanceInfo) => GuidanceAnswer | Promise<GuidanceAnswer>;
"#;

#[wasm_bindgen]
extern "C" {
    /// A function after `GuidanceFunction`.
    #[wasm_bindgen(typescript_type = "GuidanceFunction")]
    pub type GuidanceFunction;
}

/// Asks a function. A page's worker is one thread: what it made stays there.
pub struct Asks(SendWrapper<Function>);

impl Asks {
    /// One that asks `function`.
    pub fn new(function: GuidanceFunction) -> Asks {
        Asks(SendWrapper::new(JsValue::from(function).unchecked_into()))
    }
}

impl Guidance for Asks {
    fn guide<'a>(&'a mut self, views: &'a mut [Rendered], progress: Progress) -> Work<'a, Result<f32>> {
        let images: Array = views.iter().map(image).collect();
        Work::later(async move {
            let answer = self.0.call2(&JsValue::NULL, &images, &info(progress)).map_err(thrown)?;
            // What is no promise is an answer.
            let answer = JsFuture::from(Promise::resolve(&answer)).await.map_err(thrown)?;
            let loss = member(&answer, "loss").as_f64().ok_or_else(|| wrong("its loss is no number"))?;
            let gradients = member(&answer, "grad").dyn_into::<Array>().map_err(|_| wrong("its grad is no list"))?;
            if gradients.length() as usize != views.len() {
                return Err(wrong("its grad has not one entry for each view"));
            }
            for (view, gradient) in views.iter_mut().zip(gradients) {
                let gradient = gradient.dyn_into::<Float32Array>();
                let gradient = gradient.map_err(|_| wrong("an entry of its grad is no Float32Array"))?;
                if gradient.length() as usize != view.coverage.len() {
                    return Err(wrong("an entry of its grad has not one value for each pixel"));
                }
                gradient.copy_to(&mut view.gradient);
            }
            Ok(loss as f32)
        })
    }
}

fn object<const N: usize>(members: [(&str, JsValue); N]) -> JsValue {
    let object = Object::new();
    for (name, value) in members {
        // Setting a member of a fresh object cannot fail.
        let _ = Reflect::set(&object, &name.into(), &value);
    }
    object.into()
}

fn image(view: &Rendered) -> JsValue {
    let axis = |axis: &[f32; 4]| JsValue::from(Float32Array::from(&axis[..]));
    object([
        ("width", (view.width as u32).into()),
        ("height", (view.height as u32).into()),
        ("ink", Float32Array::from(&view.coverage[..]).into()),
        ("right", axis(&view.camera.right)),
        ("down", axis(&view.camera.down)),
        ("forward", axis(&view.camera.forward)),
    ])
}

fn info(progress: Progress) -> JsValue {
    let Progress { iteration, iterations } = progress;
    object([("iteration", (iteration as u32).into()), ("iterations", (iterations as u32).into())])
}

fn member(of: &JsValue, name: &str) -> JsValue {
    Reflect::get(of, &name.into()).unwrap_or(JsValue::UNDEFINED)
}

fn wrong(problem: &str) -> Error {
    Error::guidance("", problem, "the wire goes on without it")
}

/// In the words of what was thrown, as far as it has some.
fn thrown(value: JsValue) -> Error {
    let words = member(&value, "message").as_string().or_else(|| value.as_string());
    let words: String = words.unwrap_or_else(|| "it failed".into()).chars().take(300).collect();
    wrong(words.trim_end_matches(['.', ';', ' ']))
}

/// A list of JavaScript's.
fn list(value: impl Into<JsValue>, of: &str) -> Result<Array> {
    value.into().dyn_into::<Array>().map_err(|_| wrong(&format!("it is no list of {of}")))
}

/// A size that `of` says it has.
fn size(of: &JsValue, name: &str, most: f64) -> Result<usize> {
    match member(of, name).as_f64() {
        Some(count) if (1.0..=most).contains(&count) && count.fract() == 0.0 => Ok(count as usize),
        _ => Err(wrong(&format!("its {name} is no number from 1 to {most}"))),
    }
}

/// What JavaScript runs: an object with a function `run` that takes one object and answers with another, now or later.
struct Asked {
    object: SendWrapper<JsValue>,
    run: SendWrapper<Function>,
}

impl Asked {
    fn new(object: JsValue) -> Result<Asked> {
        let run = member(&object, "run").dyn_into().map_err(|_| wrong("its run is no function"))?;
        Ok(Asked { object: SendWrapper::new(object), run: SendWrapper::new(run) })
    }

    async fn run(&self, given: JsValue) -> Result<JsValue> {
        let answer = self.run.call1(&self.object, &given).map_err(thrown)?;
        JsFuture::from(Promise::resolve(&answer)).await.map_err(thrown)
    }
}

fn array(values: &[f32]) -> JsValue {
    Float32Array::from(values).into()
}

/// So many numbers of an answer.
fn numbers(answer: &JsValue, name: &str, count: usize) -> Result<Vec<f32>> {
    let list = member(answer, name).dyn_into::<Float32Array>();
    let list = list.map_err(|_| wrong(&format!("its {name} is no Float32Array")))?;
    match list.length() as usize == count {
        true => Ok(list.to_vec()),
        false => Err(wrong(&format!("its {name} has {} numbers, not {count}", list.length()))),
    }
}
