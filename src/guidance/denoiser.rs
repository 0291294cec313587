//! Diffusion models from eps-v1 files, and the contexts that say what they are asked for. The contract is in
//! `tools/guidance/README.md`.

use crate::encoder::latent_fault;
use crate::graph::{Graph, Port};
use crate::sidecar::{Facts, Kind, Sidecar, json, size_fault};
use crate::text::TextEncoder;
use crate::words::{Dictionary, WordTable};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::Deserialize;
use std::path::Path;
use std::sync::Arc;
use wire4d_core::objective::{Denoiser, Diffusion, Prompt};
use wire4d_core::work::Work;
use wire4d_core::{Error, Result};

/// An eps-v1 file, checked and ready to run on the processor. Clones share it.
#[derive(Clone)]
pub struct OnnxDenoiser {
    graph: Arc<Graph>,
    latent: [usize; 3],
    context: [usize; 2],
    /// Whether it sees a latent of a reference beside the noise.
    has_beside: bool,
    diffusion: Diffusion,
    nothing: Option<Vec<f32>>,
    facts: Arc<Facts>,
}

/// What its sidecar says.
#[derive(Deserialize)]
struct Own {
    /// Channels, rows, columns.
    latent: [usize; 3],
    /// Tokens, and numbers a token.
    context: [usize; 2],
    /// What else it sees, of a reference; like its latent.
    #[serde(default)]
    beside: Option<[usize; 3]>,
    #[serde(default)]
    schedule: Schedule,
    /// The context of no words.
    #[serde(default)]
    nothing: Option<Vec<f32>>,
}

/// How noise grows with time. Where a file does not say, as in Stable Diffusion.
#[derive(Deserialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
enum Schedule {
    Cosine { steps: usize },
    Linear { from: f64, to: f64, steps: usize },
    ScaledLinear { from: f64, to: f64, steps: usize },
}

impl Default for Schedule {
    fn default() -> Self {
        Schedule::ScaledLinear { from: 0.00085, to: 0.012, steps: 1000 }
    }
}

impl Schedule {
    fn fault(&self) -> Option<String> {
        let (Schedule::Cosine { steps } | Schedule::Linear { steps, .. } | Schedule::ScaledLinear { steps, .. }) = self;
        let betas = match *self {
            Schedule::Cosine { .. } => None,
            Schedule::Linear { from, to, .. } | Schedule::ScaledLinear { from, to, .. } => {
                (!(0.0 < from && from <= to && to < 1.0)).then(|| format!("says betas from {from} to {to}"))
            }
        };
        size_fault("schedule's steps", *steps, 10_000).or(betas)
    }

    fn diffusion(&self) -> Diffusion {
        match *self {
            Schedule::Cosine { steps } => Diffusion::cosine(steps),
            Schedule::Linear { from, to, steps } => Diffusion::linear(from, to, steps),
            Schedule::ScaledLinear { from, to, steps } => Diffusion::scaled_linear(from, to, steps),
        }
    }
}

/// Most numbers of a context.
const MOST_CONTEXT: usize = 1 << 22;

impl Kind for Own {
    const NAME: &str = "eps-v1";

    fn fault(&self) -> Option<String> {
        let [tokens, width] = self.context;
        let wrong = |nothing: &&Vec<f32>| nothing.len() != tokens * width || !nothing.iter().all(|x| x.is_finite());
        let nothing = || self.nothing.as_ref().filter(wrong);
        latent_fault(self.latent)
            .or_else(|| size_fault("context", tokens, 4096))
            .or_else(|| size_fault("context", width, MOST_CONTEXT / tokens))
            .or_else(|| self.schedule.fault())
            .or_else(|| {
                self.beside.filter(|beside| *beside != self.latent).map(|_| "its 'beside' is unlike its latent".into())
            })
            .or_else(|| nothing().map(|_| format!("its 'nothing' is no list of {} numbers", tokens * width)))
    }
}

impl OnnxDenoiser {
    /// Opens `file` with the sidecar beside it, as [`OnnxNetwork::open`](crate::OnnxNetwork::open) does.
    ///
    /// # Errors
    /// Likewise.
    pub fn open(file: &Path) -> Result<OnnxDenoiser> {
        let (Sidecar { facts, selftest, own }, bytes) = Sidecar::<Own>::with_file(file)?;
        let Own { latent, context, beside, schedule, nothing } = own;
        let code = [None, Some(latent[0]), Some(latent[1]), Some(latent[2])];
        let context_port = Port::new("context", [None, Some(context[0]), Some(context[1])]);
        let mut inputs = vec![Port::new("x_t", code), Port::new("t", [None]), context_port];
        inputs.extend(beside.map(|_| Port::new("beside", code)));
        let graph = Graph::open(&file.display().to_string(), &bytes, inputs, vec![Port::new("eps", code)])?;
        selftest.check(&graph)?;
        let diffusion = schedule.diffusion();
        let (graph, facts, has_beside) = (Arc::new(graph), Arc::new(facts), beside.is_some());
        Ok(OnnxDenoiser { graph, latent, context, has_beside, diffusion, nothing, facts })
    }

    /// What a person should know of it.
    pub fn facts(&self) -> &Facts {
        &self.facts
    }

    /// How noise grows.
    pub fn diffusion(&self) -> &Diffusion {
        &self.diffusion
    }

    /// Whether it knows new views of a thing: then a context is what [`NewViews`](crate::NewViews) makes, with the reference's
    /// latent behind it.
    pub fn is_of_views(&self) -> bool {
        self.has_beside
    }

    fn knows_words(&self) -> Result<()> {
        match self.has_beside {
            true => Err(Error::input(
                &self.facts.name,
                "knows new views of a thing and no words",
                "give --pose FILE with it",
            )),
            false => Ok(()),
        }
    }

    /// Tokens, and numbers a token, of a context.
    pub(crate) fn context(&self) -> [usize; 2] {
        self.context
    }

    fn answer(&self, x_t: &[f32], t: usize, contexts: &[f32]) -> Result<Vec<f32>> {
        let size = self.latent.iter().product::<usize>();
        let rows = x_t.len() / size;
        // Times are counted from 1 here, and from 0 in files.
        let times = vec![t.saturating_sub(1) as f32; rows];
        if !self.has_beside {
            return Ok(self.graph.run(vec![x_t.into(), times.into(), contexts.into()], rows)?.remove(0));
        }
        let own: usize = self.context.iter().product();
        let (mut asked, mut beside) = (Vec::new(), Vec::new());
        for row in contexts.chunks(own + size) {
            asked.extend_from_slice(&row[..own]);
            beside.extend_from_slice(&row[own..]);
        }
        Ok(self.graph.run(vec![x_t.into(), times.into(), asked.into(), beside.into()], rows)?.remove(0))
    }
}

impl Denoiser for OnnxDenoiser {
    fn shape(&self) -> [usize; 3] {
        self.latent
    }

    fn run<'a>(&'a mut self, x_t: &'a [f32], t: usize, contexts: &'a [f32]) -> Work<'a, Result<Vec<f32>>> {
        Work::Done(self.answer(x_t, t, contexts))
    }
}

/// What a denoiser takes for words.
pub struct Contexts {
    dictionary: Dictionary,
    nothing: Vec<f32>,
}

/// A contexts-v1 file: prompts with their contexts, as a model's own text encoder made them elsewhere.
#[derive(Deserialize)]
struct ContextsFile {
    kind: String,
    shape: [usize; 2],
    contexts: Vec<Entry>,
}

#[derive(Deserialize)]
struct Entry {
    prompt: String,
    /// float32, little-endian, row by row, as base64.
    values: String,
}

impl Contexts {
    /// Of a contexts-v1 `file`; an empty prompt in it is nothing.
    ///
    /// # Errors
    /// [`Error::Input`] for a file that is missing, damaged, none or of another shape, and where nobody says what nothing is.
    pub fn open(denoiser: &OnnxDenoiser, file: &Path) -> Result<Contexts> {
        let remedy = "give the contexts of the model's own text encoder, a contexts-v1 file";
        let ContextsFile { kind, shape, contexts } = json(file, remedy)?;
        let fault = |problem: String| Error::input(file.display().to_string(), problem, remedy);
        if kind != "contexts-v1" {
            return Err(fault(format!("is of kind {kind}, and a contexts-v1 file is needed")));
        }
        let [tokens, width] = denoiser.context;
        if shape != denoiser.context {
            let [its_tokens, its_width] = shape;
            let name = &denoiser.facts.name;
            return Err(fault(format!(
                "has contexts of {its_tokens} x {its_width}, and {name} takes {tokens} x {width}"
            )));
        }
        let read = |Entry { prompt, values }: Entry| {
            let bytes = STANDARD.decode(&values).unwrap_or_default();
            let values: Vec<f32> = bytes.as_chunks::<4>().0.iter().map(|&four| f32::from_le_bytes(four)).collect();
            match bytes.len() == 4 * tokens * width && values.iter().all(|value| value.is_finite()) {
                true => Ok((prompt, values)),
                false => Err(fault(format!("what it has for {prompt:?} is no base64 of {tokens} x {width} float32"))),
            }
        };
        denoiser.knows_words()?;
        let own = contexts.into_iter().map(read).collect::<Result<Vec<_>>>()?;
        let empty = own.iter().find(|(prompt, _)| prompt.trim().is_empty()).map(|(_, values)| values.clone());
        let nothing = empty.or_else(|| denoiser.nothing.clone());
        let nothing = nothing.ok_or_else(|| fault("has no context for an empty prompt".into()))?;
        Ok(Contexts { dictionary: Dictionary::of(&denoiser.facts.name, own, width, None, None)?, nothing })
    }

    /// Of a table of words or a text encoder, for a model that takes one vector of theirs.
    ///
    /// # Errors
    /// [`Error::Input`] for a model that takes more, vectors of another size, and where it does not say what nothing is.
    pub fn of_words(denoiser: &OnnxDenoiser, table: Option<WordTable>, text: Option<TextEncoder>) -> Result<Contexts> {
        let name = &denoiser.facts.name;
        let [tokens, width] = denoiser.context;
        let fault =
            |problem: String| Error::input(name, problem, "give its contexts, a contexts-v1 file, as --contexts");
        denoiser.knows_words()?;
        if tokens != 1 {
            return Err(fault(format!("takes contexts of {tokens} x {width} numbers, which no word has")));
        }
        let nothing = denoiser.nothing.clone();
        let nothing =
            nothing.ok_or_else(|| fault("does not say in its sidecar what the context of no words is".into()))?;
        Ok(Contexts { dictionary: Dictionary::of(name, Vec::new(), width, table, text)?, nothing })
    }

    /// What asks for `words`.
    ///
    /// # Errors
    /// As [`Dictionary::vector`].
    pub fn prompt(&self, words: &str) -> Result<Prompt> {
        Ok(Prompt { context: self.dictionary.vector(words)?, nothing: self.nothing.clone() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::noise;
    use crate::testing::{fixture, opened, spoilt};
    use std::fs;

    fn tiny(name: &str) -> OnnxDenoiser {
        OnnxDenoiser::open(&fixture(&format!("{name}.onnx"))).unwrap()
    }

    #[test]
    fn tiny_models_answer_as_torch_did() {
        for name in ["eps-tiny", "eps-pixels-tiny"] {
            let denoiser = tiny(name);
            let count = 2 * denoiser.latent.iter().product::<usize>();
            let context = noise::signed(6, 2 * denoiser.context.iter().product::<usize>());
            // Time 500 of a file is the 501st.
            let answer = denoiser.answer(&noise::signed(5, count), 501, &context).unwrap();
            let expected: serde_json::Value =
                serde_json::from_slice(&fs::read(fixture(&format!("{name}.expected.json"))).unwrap()).unwrap();
            let meant: Vec<f32> =
                expected["eps"].as_array().unwrap().iter().map(|value| value.as_f64().unwrap() as f32).collect();
            let off: Vec<f32> = answer.iter().zip(&meant).map(|(a, b)| a - b).collect();
            assert!(answer.len() == count && meant.len() == count);
            assert!(noise::length(&off) < 1e-4 * noise::length(&meant), "{name}: {:e}", noise::length(&off));
            let other = denoiser.answer(&noise::signed(5, count), 500, &context).unwrap();
            assert_ne!(answer, other);
        }
    }

    #[test]
    fn noise_grows_as_the_sidecar_says() {
        assert_eq!(*tiny("eps-tiny").diffusion(), Diffusion::scaled_linear(0.00085, 0.012, 1000));
        assert_eq!(*tiny("eps-pixels-tiny").diffusion(), Diffusion::cosine(1000));
        let silent =
            opened("eps-tiny", OnnxDenoiser::open, |_, json| *json = json.replace("\"schedule\"", "\"other\""));
        assert_eq!(*silent.unwrap().diffusion(), Diffusion::scaled_linear(0.00085, 0.012, 1000));
    }

    #[test]
    fn spoilt_files_are_refused_in_a_sentence() {
        type Change = fn(&mut Vec<u8>, &mut String);
        let cases: [(&str, Change); 8] = [
            ("SHA-256", |onnx, _| onnx[9000] ^= 1),
            ("guidance-v1", |_, json| *json = json.replace("\"eps-v1\"", "\"guidance-v1\"")),
            ("a latent of 0", |_, json| *json = json.replace("\"latent\": [4, 8, 8]", "\"latent\": [4, 0, 8]")),
            ("x_t[batch,4,8,9]", |_, json| *json = json.replace("\"latent\": [4, 8, 8]", "\"latent\": [4, 8, 9]")),
            ("a context of", |_, json| *json = json.replace("\"context\": [5, 16]", "\"context\": [5, 99999999]")),
            ("no list of 80 numbers", |_, json| *json = json.replace("\"nothing\": [", "\"nothing\": [1.0, ")),
            ("betas", |_, json| *json = json.replace("\"to\": 0.012", "\"to\": 1.5")),
            ("steps", |_, json| *json = json.replace("\"steps\": 1000", "\"steps\": 0")),
        ];
        for (said, change) in cases {
            let error = spoilt("eps-tiny", OnnxDenoiser::open, change).to_string();
            assert!(error.contains(said) && error.contains("eps-tiny."), "{said}: {error}");
        }
    }

    #[test]
    fn contexts_come_from_a_file_or_of_single_vectors() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("contexts.json");
        let latents = tiny("eps-tiny");
        let values =
            |first: f32| STANDARD.encode((0..80).flat_map(|i| (first + i as f32).to_le_bytes()).collect::<Vec<u8>>());
        let read = |contexts: serde_json::Value| {
            let file = serde_json::json!({ "kind": "contexts-v1", "shape": [5, 16], "contexts": contexts });
            fs::write(&path, file.to_string()).unwrap();
            Contexts::open(&latents, &path)
        };
        let cat = serde_json::json!({ "prompt": "a cat", "values": values(3.0) });
        let own_nothing = read(serde_json::json!([cat])).unwrap().prompt(" A cat").unwrap();
        assert!(own_nothing.context[79] == 82.0 && Some(own_nothing.nothing) == latents.nothing);
        let both = read(serde_json::json!([cat, { "prompt": "", "values": values(0.0) }])).unwrap();
        assert_eq!(both.prompt("a cat").unwrap().nothing[1], 1.0);
        assert!(both.prompt("a dog").unwrap_err().is_bad_input());
        let short = read(serde_json::json!([{ "prompt": "a cat", "values": "AAAA" }])).map(|_| ()).unwrap_err();
        assert!(short.to_string().contains("contexts.json") && short.to_string().contains("\"a cat\""), "{short}");

        let refused = Contexts::of_words(&latents, None, None).map(|_| ()).unwrap_err().to_string();
        assert!(refused.contains("5 x 16"), "{refused}");
        let pixels = tiny("eps-pixels-tiny");
        let table = fixture("../../../tools/iconnet/weights/words.json");
        let words = Contexts::of_words(&pixels, Some(WordTable::open(&table).unwrap()), None).unwrap();
        let fish = words.prompt("fish").unwrap();
        assert!((noise::length(&fish.context) - 1.0).abs() < 1e-6 && fish.context.len() == 96);
        assert!(fish.nothing[95] == 1.0 && fish.nothing[..95].iter().all(|&value| value == 0.0));
    }
}
