//! Diffusion models: what they would take from noisy views.

use super::{Asked, array, list, member, numbers, object, size, wrong};
use wasm_bindgen::prelude::*;
use wire4d::Result;
use wire4d::objective::{Annealing, Denoiser, Diffusion, Distilled, Encoder, Latent, Look, Prompt};
use wire4d::optimize::Work;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = r#"
/** A diffusion model after the contract eps-v1 of tools/guidance: n rows of what it sees, and of `context` numbers each. */
export interface GuidanceDenoiser {
  /** Channels, rows and columns of what it sees: a picture's own, grey or coloured, from -1 to 1, or a latent of it. */
  readonly shape: readonly [number, number, number];
  readonly context: number;
  /** At one time `t` for all rows. */
  run(batch: { x_t: Float32Array<ArrayBuffer>; t: number; contexts: Float32Array<ArrayBuffer> }): Promise<{ readonly eps: Float32Array }>;
}

/** What makes latents of pictures of `size` px, and gradients to them back: the contract vjp-v1. */
export interface GuidanceEncoder {
  readonly size: number;
  run(given: { image: Float32Array<ArrayBuffer>; cotangent: Float32Array<ArrayBuffer> }): Promise<{ readonly latent: Float32Array; readonly grad: Float32Array }>;
}

/** What a view is to show, as the model was told it: its context with words and without. */
export interface GuidanceContext {
  readonly context: Float32Array;
  readonly nothing: Float32Array;
}

export interface DiffusionOptions {
  /** How noise grows, of times 1 to `steps`; `from` and `to` are betas and mean nothing to a cosine. */
  readonly schedule: { readonly kind: "linear" | "scaled-linear" | "cosine"; readonly steps: number; readonly from: number; readonly to: number };
  /** How much of the difference between words and nothing counts. */
  readonly scale: number;
}
"#;

#[wasm_bindgen]
extern "C" {
    /// A `GuidanceDenoiser`.
    #[wasm_bindgen(typescript_type = "GuidanceDenoiser")]
    pub type DenoiserObject;
    /// A `GuidanceEncoder`, or null where the model sees pixels.
    #[wasm_bindgen(typescript_type = "GuidanceEncoder | null")]
    pub type EncoderObject;
    /// A `GuidanceContext` for each view, or null where a view has no words.
    #[wasm_bindgen(typescript_type = "readonly (GuidanceContext | null)[]")]
    pub type Contexts;
    /// `DiffusionOptions`.
    #[wasm_bindgen(typescript_type = "DiffusionOptions")]
    pub type DiffusionOptions;
}

/// A diffusion model that a function runs.
struct AskedDenoiser {
    model: Asked,
    shape: [usize; 3],
}

impl Denoiser for AskedDenoiser {
    fn shape(&self) -> [usize; 3] {
        self.shape
    }

    fn run<'a>(&'a mut self, x_t: &'a [f32], t: usize, contexts: &'a [f32]) -> Work<'a, Result<Vec<f32>>> {
        let given = object([("x_t", array(x_t)), ("t", (t as u32).into()), ("contexts", array(contexts))]);
        Work::later(async move { numbers(&self.model.run(given).await?, "eps", x_t.len()) })
    }
}

/// An encoder that a function runs.
struct AskedEncoder {
    encoder: Asked,
    size: usize,
}

impl Encoder for AskedEncoder {
    fn size(&self) -> usize {
        self.size
    }

    fn run<'a>(&'a mut self, image: &'a [f32], cotangent: &'a [f32]) -> Work<'a, Result<Latent>> {
        let given = object([("image", array(image)), ("cotangent", array(cotangent))]);
        Work::later(async move {
            let answer = self.encoder.run(given).await?;
            let latent = numbers(&answer, "latent", cotangent.len())?;
            Ok(Latent { latent, gradient: numbers(&answer, "grad", image.len())? })
        })
    }
}

/// Views become what a diffusion model thinks that their contexts are of.
///
/// # Errors
/// [`wire4d::Error::Guidance`] where these are no such things, or contexts of other sizes.
pub fn by_diffusion(
    denoiser: DenoiserObject,
    encoder: EncoderObject,
    contexts: Contexts,
    options: DiffusionOptions,
    seed: u64,
) -> Result<Distilled> {
    let (denoiser, encoder, options): (JsValue, JsValue, JsValue) = (denoiser.into(), encoder.into(), options.into());
    let shape = member(&denoiser, "shape");
    let shape = [("0", 64.0), ("1", 512.0), ("2", 512.0)].map(|(index, most)| size(&shape, index, most));
    let [channels, rows, columns] = shape;
    let shape = [channels?, rows?, columns?];
    let wide = size(&denoiser, "context", 4_194_304.0)?;
    let prompt = |context: JsValue| match context.is_object() {
        false => Ok(None),
        true => Ok(Some(Prompt {
            context: numbers(&context, "context", wide)?,
            nothing: numbers(&context, "nothing", wide)?,
        })),
    };
    let prompts: Result<Vec<_>> = list(contexts, "contexts")?.iter().map(prompt).collect();
    // Each look costs two runs of an encoder.
    let (look, annealing) = match encoder.is_object() {
        true => (Look::Whole, Annealing::FALLING),
        false => (Look::WORDS, Annealing::OF_PIXELS),
    };
    let encoder = match encoder.is_object() {
        false if !matches!(shape, [1 | 3, rows, columns] if rows == columns) => {
            return Err(wrong("it sees no square pictures, and there is no encoder"));
        }
        false => None,
        true => {
            Some(Box::new(AskedEncoder { size: size(&encoder, "size", 1024.0)?, encoder: Asked::new(encoder)? }) as _)
        }
    };
    Ok(Distilled {
        denoiser: Box::new(AskedDenoiser { model: Asked::new(denoiser)?, shape }),
        encoder,
        diffusion: schedule(&member(&options, "schedule"))?,
        annealing,
        look,
        prompts: Box::new(prompts?),
        scale: member(&options, "scale").as_f64().unwrap_or(100.0) as f32,
        clamp: f32::INFINITY,
        seed,
    })
}

fn schedule(given: &JsValue) -> Result<Diffusion> {
    let steps = size(given, "steps", 10_000.0)?;
    let beta = |name: &str| match member(given, name).as_f64() {
        Some(beta) if beta > 0.0 && beta < 1.0 => Ok(beta),
        _ => Err(wrong(&format!("the {name} of its schedule is no number between 0 and 1"))),
    };
    match member(given, "kind").as_string().as_deref() {
        Some("cosine") => Ok(Diffusion::cosine(steps)),
        Some("linear") => Ok(Diffusion::linear(beta("from")?, beta("to")?, steps)),
        Some("scaled-linear") => Ok(Diffusion::scaled_linear(beta("from")?, beta("to")?, steps)),
        _ => Err(wrong("its schedule is none of linear, scaled-linear and cosine")),
    }
}
