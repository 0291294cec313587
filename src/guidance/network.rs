//! Networks from guidance-v1 files. The contract is in `tools/guidance/README.md`.

use crate::graph::{Graph, Port};
use crate::sidecar::{Facts, Kind, Sidecar, is_vector, size_fault, unit};
use serde::Deserialize;
use std::path::Path;
use std::sync::Arc;
use wire4d_core::Result;
use wire4d_core::objective::{Answer, Batch, Network};
use wire4d_core::work::Work;

/// A guidance-v1 file, checked and ready to run on the processor. Clones share it.
#[derive(Clone)]
pub struct OnnxNetwork {
    graph: Arc<Graph>,
    size: usize,
    embed: usize,
    facts: Arc<Facts>,
    words: Arc<Vec<(String, Vec<f32>)>>,
}

/// What its sidecar says.
#[derive(Deserialize)]
struct Own {
    size: usize,
    embed: usize,
    #[serde(default)]
    embeddings: Vec<Embedding>,
}

/// Words and their vector.
#[derive(Deserialize)]
struct Embedding {
    prompt: String,
    vector: Vec<f32>,
}

impl Kind for Own {
    const NAME: &str = "guidance-v1";

    fn fault(&self) -> Option<String> {
        let odd = || self.embeddings.iter().find(|entry| !is_vector(&entry.vector, self.embed));
        size_fault("size", self.size, 1024).or_else(|| size_fault("embed", self.embed, 16_384)).or_else(|| {
            odd().map(|odd| format!("what it has for {:?} is no vector of {} numbers", odd.prompt, self.embed))
        })
    }
}

impl OnnxNetwork {
    /// Opens `file` with the sidecar beside it (`NAME.onnx` and `NAME.json`): reads both, compares size and checksum, names
    /// and shapes, and runs the self-test.
    ///
    /// # Errors
    /// [`wire4d_core::Error::Input`] for a file that is missing, damaged or of another kind, [`wire4d_core::Error::Guidance`]
    /// for one that is not computed rightly here.
    pub fn open(file: &Path) -> Result<OnnxNetwork> {
        let (Sidecar { facts, selftest, own }, bytes) = Sidecar::<Own>::with_file(file)?;
        let (size, embed) = (Some(own.size), Some(own.embed));
        let image = [None, Some(3), size, size];
        let inputs = vec![
            Port::new("image", image),
            Port::new("source", [None, embed]),
            Port::new("target", [None, embed]),
            Port::new("weight", [None]),
        ];
        let outputs = vec![
            Port::new("loss", []),
            Port::new("grad", image),
            Port::new("cos", [None]),
            Port::new("embedding", [None, embed]),
        ];
        let graph = Graph::open(&file.display().to_string(), &bytes, inputs, outputs)?;
        selftest.check(&graph)?;
        let Own { size, embed, embeddings } = own;
        let words = embeddings.into_iter().map(|entry| (entry.prompt, unit(&entry.vector))).collect();
        Ok(OnnxNetwork { graph: Arc::new(graph), size, embed, facts: Arc::new(facts), words: Arc::new(words) })
    }

    /// Words it came with, and their unit vectors.
    pub fn words(&self) -> &[(String, Vec<f32>)] {
        &self.words
    }

    /// What a person should know of it.
    pub fn facts(&self) -> &Facts {
        &self.facts
    }

    fn answer(&self, batch: Batch) -> Result<Answer> {
        let feeds = [batch.images, batch.source, batch.target, batch.weight].map(Into::into);
        let mut answers = self.graph.run(feeds.into(), batch.weight.len())?.into_iter();
        let mut next = || answers.next().unwrap_or_default();
        Ok(Answer { loss: next()[0], gradient: next(), cos: next(), embedding: next() })
    }
}

impl Network for OnnxNetwork {
    fn size(&self) -> usize {
        self.size
    }

    fn embed(&self) -> usize {
        self.embed
    }

    fn run<'a>(&'a mut self, batch: Batch<'a>) -> Work<'a, Result<Answer>> {
        Work::Done(self.answer(batch))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::fixture;
    use std::fs;
    use wire4d_core::Error;
    use wire4d_core::objective::{Aim, Guidance, Learned, Look, Member, Progress, Rendered};
    use wire4d_core::rng::Rng;
    use wire4d_core::view::Camera;
    use wire4d_core::work::wait;

    type Change = fn(&mut Vec<u8>, &mut String);

    fn tiny() -> OnnxNetwork {
        OnnxNetwork::open(&fixture("vit-tiny.onnx")).unwrap()
    }

    fn spoilt(change: impl FnOnce(&mut Vec<u8>, &mut String)) -> Error {
        crate::testing::spoilt("vit-tiny", OnnxNetwork::open, change)
    }

    #[test]
    fn the_tiny_network_answers_as_torch_did() {
        let expected = fs::read(fixture("vit-tiny.expected.bin")).unwrap();
        let mut expected = expected.as_chunks::<4>().0.iter().map(|&bytes| f32::from_le_bytes(bytes));
        let network = tiny();
        let images = crate::noise::uniform(1, 2 * 3 * 32 * 32);
        let target = crate::noise::unit_rows(2, 32, 16);
        for source in [vec![0.0; 32], crate::noise::unit_rows(3, 32, 16)] {
            let batch = Batch { images: &images, source: &source, target: &target, weight: &[0.5, 0.5] };
            let answer = network.answer(batch).unwrap();
            for found in [vec![answer.loss], answer.gradient, answer.cos, answer.embedding] {
                let meant: Vec<f32> = expected.by_ref().take(found.len()).collect();
                let off: Vec<f32> = found.iter().zip(&meant).map(|(a, b)| a - b).collect();
                let off = crate::noise::length(&off) / crate::noise::length(&meant);
                assert!(off < 1e-5, "{off:e} over {} numbers", found.len());
            }
        }
        assert_eq!(expected.next(), None);
    }

    #[test]
    fn a_batch_is_its_rows_and_rows_of_no_weight_do_not_pull() {
        let network = tiny();
        let images = crate::noise::uniform(5, 3 * 3 * 32 * 32);
        let target = crate::noise::unit_rows(6, 3 * 16, 16);
        let source = vec![0.0; 48];
        let weight = [0.5, 0.0, 2.0];
        let all = network.answer(Batch { images: &images, source: &source, target: &target, weight: &weight }).unwrap();
        for row in 0..3 {
            let (image, target) = (&images[row * 3072..][..3072], &target[row * 16..][..16]);
            let weight = &weight[row..=row];
            let one = network.answer(Batch { images: image, source: &source[..16], target, weight }).unwrap();
            assert!((one.cos[0] - all.cos[row]).abs() < 1e-5);
            let together = &all.gradient[row * 3072..][..3072];
            let off: Vec<f32> = one.gradient.iter().zip(together).map(|(a, b)| a - b).collect();
            assert!(crate::noise::length(&off) <= 1e-4 * crate::noise::length(together));
            assert_eq!(row == 1, together.iter().all(|&d| d == 0.0));
        }
    }

    #[test]
    fn gradients_through_patches_and_network_are_those_of_finite_differences() {
        let mut rng = Rng::new(1, 0);
        let mut view = Rendered::new(Camera::default(), 64, 64, 1.0);
        view.coverage = (0..64 * 64).map(|_| rng.unit() as f32).collect();
        let aim = Aim::Like(crate::noise::unit_rows(2, 16, 16));
        let network: Box<dyn Network> = Box::new(tiny());
        let mut learned =
            Learned::new(vec![Member::new(network, vec![Some(aim)]).unwrap()], Look::Grid { cells: 2 }, 3);
        let mut loss = |coverage: &[f32]| {
            let mut views = [Rendered { coverage: coverage.to_vec(), gradient: vec![0.0; 64 * 64], ..view.clone() }];
            let loss = wait(learned.guide(&mut views, Progress::default()).done()).unwrap();
            (f64::from(loss), views[0].gradient.clone())
        };
        let (_, gradient) = loss(&view.coverage);
        let length = crate::noise::length(&gradient);
        let mut moved = |by: f64| {
            let along = gradient.iter().map(|&d| (by * f64::from(d) / length) as f32);
            loss(&view.coverage.iter().zip(along).map(|(ink, step)| ink + step).collect::<Vec<_>>()).0
        };
        // Fourth order: the step must be long for a loss of float32.
        let step = 0.15;
        let slope = (8.0 * (moved(step) - moved(-step)) - (moved(2.0 * step) - moved(-2.0 * step))) / (12.0 * step);
        assert!((slope / length - 1.0).abs() < 1e-3, "{slope} and {length}");
    }

    #[test]
    fn spoilt_files_are_refused_in_a_sentence() {
        let cases: [(&str, Change); 9] = [
            ("SHA-256", |onnx, _| onnx[90_000] ^= 1),
            ("SHA-256", |onnx, _| onnx.truncate(1000)),
            ("at most", |onnx, _| onnx.push(0)),
            ("does not say", |_, json| json.truncate(2000)),
            ("text-v1", |_, json| *json = json.replace("\"guidance-v1\"", "\"text-v1\"")),
            ("size", |_, json| *json = json.replace("\"size\": 32", "\"size\": 0")),
            ("image[batch,3,48,48]", |_, json| *json = json.replace("\"size\": 32", "\"size\": 48")),
            ("source[batch,8]", |_, json| *json = json.replace("\"embed\": 16", "\"embed\": 8")),
            ("not computed rightly", |_, json| *json = json.replacen("\"l2\": 0.0472", "\"l2\": 0.0572", 1)),
        ];
        for (said, change) in cases {
            let error = spoilt(change).to_string();
            let names = error.contains("vit-tiny.onnx") || error.contains("vit-tiny.json");
            assert!(error.contains(said) && names, "{said}: {error}");
        }
        let missing = OnnxNetwork::open(&fixture("nothing.onnx")).map(|_| ()).unwrap_err().to_string();
        assert!(missing.contains("nothing.json"), "{missing}");
        let picture = spoilt(|onnx, _| *onnx = b"\x89PNG\r\n\x1a\n and so on".to_vec()).to_string();
        assert!(picture.contains("vit-tiny.onnx: is a picture"), "{picture}");
        let vector = spoilt(|_, json| {
            *json = json.replacen('{', "{\"embeddings\": [{\"prompt\": \"cat\", \"vector\": [1]}],", 1)
        });
        assert!(vector.to_string().contains("\"cat\""), "{vector}");
    }
}
