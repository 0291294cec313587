//! New views of a thing, as models after Zero-1-to-3 are asked for them, from pose-v1 files. The contract is in
//! `tools/guidance/README.md`.

use crate::denoiser::OnnxDenoiser;
use crate::encoder::OnnxEncoder;
use crate::graph::{Graph, Port};
use crate::sidecar::{Facts, Kind, Sidecar, size_fault};
use serde::Deserialize;
use std::path::Path;
use std::sync::Arc;
use wire4d_core::objective::{Encoder, Patch, Prompt, Prompts, relative_pose};
use wire4d_core::view::{Camera, Image};
use wire4d_core::work::{Work, wait};
use wire4d_core::{Error, Result};

/// A pose-v1 file, checked and ready to run on the processor. Clones share it.
#[derive(Clone)]
pub struct OnnxPoses {
    graph: Arc<Graph>,
    size: usize,
    fourth: Fourth,
    facts: Arc<Facts>,
}

/// What its sidecar says.
#[derive(Deserialize)]
struct Own {
    /// Side of a picture, px.
    size: usize,
    /// Tokens, and numbers a token.
    context: [usize; 2],
    #[serde(default)]
    fourth: Fourth,
}

/// A pose's fourth number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Fourth {
    /// The change of distance, as in Zero-1-to-3: none, as views here have one distance.
    #[default]
    Distance,
    /// The reference's polar angle, as in Stable Zero123.
    Polar,
}

impl Kind for Own {
    const NAME: &str = "pose-v1";

    fn fault(&self) -> Option<String> {
        let [tokens, width] = self.context;
        let context = || size_fault("context", tokens, 4096).or_else(|| size_fault("context", width, 4096));
        size_fault("size", self.size, 1024).or_else(context)
    }
}

impl OnnxPoses {
    /// Opens `file` with the sidecar beside it, for `denoiser`, which sees what `encoder` makes of pictures.
    ///
    /// # Errors
    /// As [`OnnxNetwork::open`](crate::OnnxNetwork::open); and for models that do not belong together.
    pub fn open(file: &Path, denoiser: &OnnxDenoiser) -> Result<OnnxPoses> {
        let (Sidecar { facts, selftest, own }, bytes) = Sidecar::<Own>::with_file(file)?;
        let Own { size, context, fourth } = own;
        if !denoiser.is_of_views() || denoiser.context() != context {
            let problem =
                format!("makes contexts of {context:?} of new views, which {} does not take", denoiser.facts().name);
            return Err(Error::input(file.display().to_string(), problem, "give the pose-v1 file of the same model"));
        }
        let inputs =
            vec![Port::new("image", [Some(1), Some(3), Some(size), Some(size)]), Port::new("pose", [None, Some(4)])];
        let outputs = vec![Port::new("context", [None, Some(context[0]), Some(context[1])])];
        let graph = Graph::open(&file.display().to_string(), &bytes, inputs, outputs)?;
        selftest.check(&graph)?;
        Ok(OnnxPoses { graph: Arc::new(graph), size, fourth, facts: Arc::new(facts) })
    }

    /// What a person should know of it.
    pub fn facts(&self) -> &Facts {
        &self.facts
    }

    /// New views of what `picture`, ink, shows from `reference`, for all views but the first, which shows that.
    ///
    /// # Errors
    /// [`Error::Guidance`] where the encoder fails.
    pub fn of(&self, picture: &Image, reference: Camera<f32>, encoder: &OnnxEncoder) -> Result<NewViews> {
        let drawn = |size: usize| {
            let mut image = vec![0.0; 3 * size * size];
            Patch::whole(picture.width, picture.height).draw(&picture.data, picture.width, size, &mut image);
            image
        };
        let mut encoder = encoder.clone();
        let nil = vec![0.0; encoder.latent().iter().product()];
        let beside = wait(encoder.run(&drawn(encoder.size()), &nil).done())?.latent;
        Ok(NewViews { poses: self.clone(), image: drawn(self.size), beside, reference })
    }

    fn context(&self, image: &[f32], pose: [f32; 4]) -> Result<Vec<f32>> {
        let [polar, sin, cos, of_reference] = pose;
        let fourth = if self.fourth == Fourth::Polar { of_reference } else { 0.0 };
        Ok(self.graph.run(vec![image.into(), vec![polar, sin, cos, fourth].into()], 1)?.remove(0))
    }
}

/// Asks for the views of one thing, wherever they are seen from.
pub struct NewViews {
    poses: OnnxPoses,
    image: Vec<f32>,
    beside: Vec<f32>,
    reference: Camera<f32>,
}

impl Prompts for NewViews {
    fn of<'a>(&'a mut self, view: usize, camera: &'a Camera<f32>) -> Work<'a, Result<Option<Prompt>>> {
        if view == 0 {
            return Work::Done(Ok(None));
        }
        let prompt = |asked: Vec<f32>| {
            // No picture, and no pose: what these models were trained with for guidance without a classifier.
            let nothing = vec![0.0; asked.len() + self.beside.len()];
            Some(Prompt { context: [&asked[..], &self.beside].concat(), nothing })
        };
        Work::Done(self.poses.context(&self.image, relative_pose(&self.reference, camera)).map(prompt))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::noise;
    use crate::testing::fixture;
    use wire4d_core::objective::Denoiser;
    use wire4d_core::view::View;

    fn opened() -> (OnnxDenoiser, OnnxEncoder, OnnxPoses) {
        let denoiser = OnnxDenoiser::open(&fixture("eps-views-tiny.onnx")).unwrap();
        let poses = OnnxPoses::open(&fixture("pose-tiny.onnx"), &denoiser).unwrap();
        (denoiser, OnnxEncoder::open(&fixture("vjp-tiny.onnx")).unwrap(), poses)
    }

    fn expected(name: &str, output: &str) -> Vec<f32> {
        let text = std::fs::read(fixture(&format!("{name}.expected.json"))).unwrap();
        let expected: serde_json::Value = serde_json::from_slice(&text).unwrap();
        expected[output].as_array().unwrap().iter().map(|value| value.as_f64().unwrap() as f32).collect()
    }

    fn is_near(found: &[f32], meant: &[f32]) -> bool {
        let off: Vec<f32> = found.iter().zip(meant).map(|(a, b)| a - b).collect();
        found.len() == meant.len() && noise::length(&off) < 1e-4 * noise::length(meant)
    }

    fn camera(azimuth: f64) -> Camera<f32> {
        View::orthographic("v", azimuth.to_radians(), 0.0, 2.2, 32).camera()
    }

    #[test]
    fn poses_and_what_lies_beside_the_noise_are_as_torch_has_them() {
        let (mut denoiser, _, poses) = opened();
        let pose = noise::signed(7, 8);
        let image = noise::uniform(1, 3 * 32 * 32);
        let found = poses.graph.run(vec![image.as_slice().into(), pose.into()], 2).unwrap().remove(0);
        assert!(is_near(&found, &expected("pose-tiny", "context")));

        let (contexts, beside) = (noise::signed(6, 32), noise::signed(8, 512));
        let both = [&contexts[..16], &beside[..256], &contexts[16..], &beside[256..]].concat();
        let x_t = noise::signed(5, 512);
        // Times are counted from 1 here.
        let found = wait(denoiser.run(&x_t, 501, &both).done()).unwrap();
        assert!(is_near(&found, &expected("eps-views-tiny", "eps")));
    }

    #[test]
    fn other_views_are_asked_for_by_where_they_are_seen_from_and_the_first_is_left_alone() {
        let (denoiser, encoder, poses) = opened();
        let picture = Image { width: 32, height: 32, data: noise::uniform(3, 32 * 32) };
        let mut views = poses.of(&picture, camera(0.0), &encoder).unwrap();
        let mut asked = |view, azimuth| wait(views.of(view, &camera(azimuth)).done()).unwrap();
        assert_eq!(asked(0, 0.0), None);
        let (near, far) = (asked(1, 35.0).unwrap(), asked(1, 90.0).unwrap());
        assert_eq!(near.context.len(), 16 + denoiser.shape().iter().product::<usize>());
        assert!(near.context[..16] != far.context[..16] && near.context[16..] == far.context[16..]);
        assert!(near.context[16..].iter().any(|value| *value != 0.0) && near.nothing.iter().all(|value| *value == 0.0));
        assert_eq!(asked(2, 35.0).unwrap(), near);
    }

    #[test]
    fn models_that_do_not_belong_together_are_told() {
        let words = OnnxDenoiser::open(&fixture("eps-tiny.onnx")).unwrap();
        let said = OnnxPoses::open(&fixture("pose-tiny.onnx"), &words).map(|_| ()).unwrap_err().to_string();
        assert!(said.contains("pose-tiny.onnx") && said.contains("eps-tiny"), "{said}");
        let (views, ..) = opened();
        let said = crate::Contexts::of_words(&views, None, None).map(|_| ()).unwrap_err().to_string();
        assert!(said.contains("eps-views-tiny") && said.contains("--pose"), "{said}");
    }
}
