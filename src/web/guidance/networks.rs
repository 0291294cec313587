//! Networks that see pictures where words lie too.

use super::{Asked, array, list, member, numbers, object, size, wrong};
use js_sys::{Float32Array, Float64Array};
use wasm_bindgen::prelude::*;
use wire4d::Result;
use wire4d::objective::{Aim, Answer, Batch, Learned, Look, Member, Network};
use wire4d::optimize::Work;
use wire4d::sculpture::render;
use wire4d::tasks::Run;
use wire4d::wire::{Form, Wire};

#[wasm_bindgen(typescript_custom_section)]
const NETWORK_TYPES: &str = r#"
/** A network after the contract guidance-v1 of tools/guidance: n rows of pictures of `size` px, `embed` numbers each. */
export interface GuidanceNetwork {
  readonly size: number;
  readonly embed: number;
  run(batch: { images: Float32Array<ArrayBuffer>; source: Float32Array<ArrayBuffer>; target: Float32Array<ArrayBuffer>; weight: Float32Array<ArrayBuffer> }): Promise<{
    readonly loss: number;
    readonly grad: Float32Array;
    readonly cos: Float32Array;
    readonly embedding: Float32Array;
  }>;
}

export interface WordsOptions {
  /** What of a view they look at: all of it, turned and shifted (`views`), or sixteen squares of it. */
  readonly look?: "views" | "patches";
  /**
   * For each network a unit vector of neutral words, such as "a wire": what each patch shows is to differ from what `from`
   * shows there as the words differ from these. Without, each patch becomes like the words.
   */
  readonly neutral?: readonly Float32Array[];
  /** The wire that is departed from: the run's first one, also where the run is resumed. */
  readonly from?: { readonly closed: boolean; readonly knots: Float64Array; readonly controlPoints: Float32Array };
  /** Whether views beside the first, and without words, are to be like what that one should show. */
  readonly likePicture?: boolean;
}
"#;

#[wasm_bindgen]
extern "C" {
    /// A list of `GuidanceNetwork`.
    #[wasm_bindgen(typescript_type = "readonly GuidanceNetwork[]")]
    pub type Networks;
    /// A list for each network, with a unit vector for each view, or null where a view has no words.
    #[wasm_bindgen(typescript_type = "readonly (readonly (Float32Array | null)[])[]")]
    pub type Vectors;
    /// A `WordsOptions`.
    #[wasm_bindgen(typescript_type = "WordsOptions")]
    pub type WordsOptions;
}

/// A network that a function runs.
struct AskedNetwork {
    network: Asked,
    size: usize,
    embed: usize,
}

impl AskedNetwork {
    /// # Errors
    /// [`wire4d::Error::Guidance`] where it is no `GuidanceNetwork`.
    fn new(network: JsValue) -> Result<AskedNetwork> {
        let (size, embed) = (size(&network, "size", 1024.0)?, size(&network, "embed", 4096.0)?);
        Ok(AskedNetwork { network: Asked::new(network)?, size, embed })
    }
}

impl Network for AskedNetwork {
    fn size(&self) -> usize {
        self.size
    }

    fn embed(&self) -> usize {
        self.embed
    }

    fn run<'a>(&'a mut self, batch: Batch<'a>) -> Work<'a, Result<Answer>> {
        let rows = batch.weight.len();
        let given = object([
            ("images", array(batch.images)),
            ("source", array(batch.source)),
            ("target", array(batch.target)),
            ("weight", array(batch.weight)),
        ]);
        Work::later(async move {
            let answer = self.network.run(given).await?;
            Ok(Answer {
                loss: member(&answer, "loss").as_f64().ok_or_else(|| wrong("its loss is no number"))? as f32,
                gradient: numbers(&answer, "grad", batch.images.len())?,
                cos: numbers(&answer, "cos", rows)?,
                embedding: numbers(&answer, "embedding", rows * self.embed)?,
            })
        })
    }
}

/// Views of `run` become like words, as `networks` see both, or depart from a wire as words differ from neutral ones, or
/// become like the first one's picture.
///
/// # Errors
/// [`wire4d::Error::Guidance`] where these are no networks, or vectors of other sizes, and where no view could be like the picture.
pub fn by_words(networks: Networks, vectors: Vectors, options: &JsValue, run: &Run) -> Result<Learned> {
    let views = &run.session().problem().targets;
    let (networks, vectors) = (list(networks, "networks")?, list(vectors, "vectors")?);
    if networks.length() == 0 || networks.length() != vectors.length() {
        return Err(wrong("there is not one list of vectors for each network"));
    }
    let neutral = member(options, "neutral");
    let from = (!neutral.is_undefined())
        .then(|| departed(&member(options, "from"), run.session().wire().form()))
        .transpose()?;
    let mut members = Vec::new();
    for (index, (network, vectors)) in networks.iter().zip(vectors.iter()).enumerate() {
        let vector = |value: JsValue| value.dyn_into::<Float32Array>().ok().map(|vector| vector.to_vec());
        let from = match &from {
            None => None,
            Some(wire) => {
                let neutral = vector(list(neutral.clone(), "neutral vectors")?.get(index as u32));
                Some((wire, neutral.ok_or_else(|| wrong("there is not a neutral vector for each network"))?))
            }
        };
        let aim = |(view, words): (usize, JsValue)| match (vector(words), &from) {
            (None, _) => Ok(None),
            (Some(words), None) => Ok(Some(Aim::Like(words))),
            (Some(words), Some((wire, neutral))) => {
                let view = views.get(view).ok_or_else(|| wrong("there are more vectors than views"))?;
                Aim::between(neutral, &words, render(wire, &view.view)).map(Some)
            }
        };
        let mut aims = list(vectors, "vectors")?.iter().enumerate().map(aim).collect::<Result<Vec<_>>>()?;
        if member(options, "likePicture").is_truthy() {
            if views.len() < 2 {
                return Err(wrong("there is no turned view that could be like the picture"));
            }
            aims.resize(views.len(), None);
            let sides = aims[1..].iter_mut().filter(|aim| aim.is_none());
            sides.for_each(|aim| *aim = Some(Aim::LikePicture(run.targets()[0].ink.clone())));
        }
        members.push(Member::new(Box::new(AskedNetwork::new(network)?), aims)?);
    }
    let look = match member(options, "look").as_string().as_deref() {
        Some("patches") => Look::Grid { cells: 4 },
        _ => Look::WORDS,
    };
    Ok(Learned::new(members, look, run.settings().seed))
}

/// The wire that is departed from.
fn departed(from: &JsValue, form: Form) -> Result<Wire> {
    let knots = member(from, "knots").dyn_into::<Float64Array>();
    let points = member(from, "controlPoints").dyn_into::<Float32Array>();
    let (Ok(knots), Ok(points)) = (knots, points) else {
        return Err(wrong("there is no wire that the neutral words stand for"));
    };
    let points = points.to_vec().chunks_exact(4).map(|point| [0, 1, 2, 3].map(|i| f64::from(point[i]))).collect();
    Wire::new(form, member(from, "closed").is_truthy(), knots.to_vec(), points)
}
