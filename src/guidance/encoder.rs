//! Encoders of latent diffusion models from vjp-v1 files. The contract is in `tools/guidance/README.md`.

use crate::graph::{Graph, Port};
use crate::sidecar::{Facts, Kind, Sidecar, size_fault};
use serde::Deserialize;
use std::path::Path;
use std::sync::Arc;
use wire4d_core::Result;
use wire4d_core::objective::{Encoder, Latent};
use wire4d_core::work::Work;

/// A vjp-v1 file, checked and ready to run on the processor. Clones share it.
#[derive(Clone)]
pub struct OnnxEncoder {
    graph: Arc<Graph>,
    size: usize,
    latent: [usize; 3],
    facts: Arc<Facts>,
}

/// What its sidecar says.
#[derive(Deserialize)]
struct Own {
    /// Rows and columns.
    image: [usize; 2],
    /// Channels, rows, columns.
    latent: [usize; 3],
}

impl Kind for Own {
    const NAME: &str = "vjp-v1";

    fn fault(&self) -> Option<String> {
        let [rows, columns] = self.image;
        let square =
            (rows != columns).then(|| format!("says pictures of {rows} x {columns}, and square ones are needed"));
        size_fault("image", rows, 1024).or(square).or_else(|| latent_fault(self.latent))
    }
}

/// Says so if a latent's sizes are no network's.
pub fn latent_fault([channels, rows, columns]: [usize; 3]) -> Option<String> {
    let sizes = [(channels, 64), (rows, 1024), (columns, 1024)];
    sizes.into_iter().find_map(|(size, most)| size_fault("latent", size, most))
}

impl OnnxEncoder {
    /// Opens `file` with the sidecar beside it, as [`OnnxNetwork::open`](crate::OnnxNetwork::open) does.
    ///
    /// # Errors
    /// Likewise.
    pub fn open(file: &Path) -> Result<OnnxEncoder> {
        let (Sidecar { facts, selftest, own: Own { image, latent } }, bytes) = Sidecar::<Own>::with_file(file)?;
        let pixels = [Some(1), Some(3), Some(image[0]), Some(image[1])];
        let code = [Some(1), Some(latent[0]), Some(latent[1]), Some(latent[2])];
        let inputs = vec![Port::new("image", pixels), Port::new("cotangent", code)];
        let outputs = vec![Port::new("latent", code), Port::new("grad", pixels)];
        let graph = Graph::open(&file.display().to_string(), &bytes, inputs, outputs)?;
        selftest.check(&graph)?;
        Ok(OnnxEncoder { graph: Arc::new(graph), size: image[0], latent, facts: Arc::new(facts) })
    }

    /// What a person should know of it.
    pub fn facts(&self) -> &Facts {
        &self.facts
    }

    /// Channels, rows and columns of its latents.
    pub fn latent(&self) -> [usize; 3] {
        self.latent
    }

    fn answer(&self, image: &[f32], cotangent: &[f32]) -> Result<Latent> {
        let mut answers = self.graph.run(vec![image.into(), cotangent.into()], 1)?.into_iter();
        let mut next = || answers.next().unwrap_or_default();
        Ok(Latent { latent: next(), gradient: next() })
    }
}

impl Encoder for OnnxEncoder {
    fn size(&self) -> usize {
        self.size
    }

    fn run<'a>(&'a mut self, image: &'a [f32], cotangent: &'a [f32]) -> Work<'a, Result<Latent>> {
        Work::Done(self.answer(image, cotangent))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::noise;
    use crate::testing::{fixture, spoilt};

    #[test]
    fn the_tiny_encoder_answers_as_torch_did_and_its_gradient_is_that_of_finite_differences() {
        let encoder = OnnxEncoder::open(&fixture("vjp-tiny.onnx")).unwrap();
        let image = noise::uniform(1, 3 * encoder.size * encoder.size);
        let cotangent = noise::signed(4, encoder.latent.iter().product());
        let found = encoder.answer(&image, &cotangent).unwrap();
        let expected: serde_json::Value =
            serde_json::from_slice(&std::fs::read(fixture("vjp-tiny.expected.json")).unwrap()).unwrap();
        for (name, answer) in [("latent", &found.latent), ("grad", &found.gradient)] {
            let meant: Vec<f32> =
                expected[name].as_array().unwrap().iter().map(|value| value.as_f64().unwrap() as f32).collect();
            let off: Vec<f32> = answer.iter().zip(&meant).map(|(a, b)| a - b).collect();
            assert!(off.len() == meant.len() && noise::length(&off) < 1e-4 * noise::length(&meant), "{name}");
        }
        let length = noise::length(&found.gradient);
        let along = |by: f64| {
            let moved: Vec<f32> =
                image.iter().zip(&found.gradient).map(|(x, d)| x + (by * f64::from(*d) / length) as f32).collect();
            let latent = encoder.answer(&moved, &cotangent).unwrap().latent;
            latent.iter().zip(&cotangent).map(|(x, d)| f64::from(x * d)).sum::<f64>()
        };
        let slope = (along(0.05) - along(-0.05)) / 0.1;
        assert!((slope / length - 1.0).abs() < 5e-3, "{slope} and {length}");
    }

    #[test]
    fn spoilt_files_are_refused_in_a_sentence() {
        type Change = fn(&mut Vec<u8>, &mut String);
        let cases: [(&str, Change); 3] = [
            ("eps-v1", |_, json| *json = json.replace("\"vjp-v1\"", "\"eps-v1\"")),
            ("square", |_, json| *json = json.replacen("\"image\": [", "\"image\": [7, 9], \"before\": [", 1)),
            ("SHA-256", |onnx, _| onnx[9000] ^= 1),
        ];
        for (said, change) in cases {
            let error = spoilt("vjp-tiny", OnnxEncoder::open, change).to_string();
            assert!(error.contains(said) && error.contains("vjp-tiny."), "{said}: {error}");
        }
    }
}
