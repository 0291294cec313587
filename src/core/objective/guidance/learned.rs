//! Guidance by networks: views become like words, or like pictures, or differ from a picture as one word from another.
//!
//! With cos as in [`Answer`](super::Answer), the loss is the mean of 1 - cos over networks, views (by their weights) and patches. Against
//! the pictures' own loss the paper's code weighs it [`WORDS_WEIGHT`] or [`PICTURE_WEIGHT`].

use super::{Batch, Guidance, Look, Network, Patch, Progress, Rendered};
use crate::view::Image;
use crate::work::Work;
use crate::{Error, Result};

/// Weight of what words say, where the comparison of pictures weighs 1: .5 to 1 in the paper's code. That sums its levels up;
/// a picture's own loss is some .05 here, so that with this weight words win over pictures.
pub const WORDS_WEIGHT: f32 = 2.0;
/// Weight of what a picture says, likewise: .2 to 1.
pub const PICTURE_WEIGHT: f32 = 5.0;

/// Rows a network is given at once: its memory grows with them, and its speed hardly.
const MOST_ROWS: usize = 8;

/// What one network should see in a view.
#[derive(Debug, Clone, PartialEq)]
pub enum Aim {
    /// What has this unit vector: words, or a picture. CLIP's plain loss.
    Like(Vec<f32>),
    /// In each patch what the same patch of this ink shows, whatever its size.
    LikePicture(Image),
    /// Each patch differs from the same patch of `from`, whatever its size, in the direction of the unit vector `towards`, such
    /// as from "a wire" to "a flower". The directional loss of StyleGAN-NADA (Gal et al. 2022), by patches as CLIPstyler's
    /// (Kwon and Ye 2022), without its threshold.
    Towards {
        /// The direction.
        towards: Vec<f32>,
        /// What is departed from.
        from: Image,
    },
}

impl Aim {
    /// The aim to depart from `from` as the words of one unit vector differ from those of another.
    ///
    /// # Errors
    /// [`Error::Setting`] where both are the same.
    pub fn between(neutral: &[f32], words: &[f32], from: Image) -> Result<Aim> {
        let mut towards: Vec<f32> = words.iter().zip(neutral).map(|(words, neutral)| words - neutral).collect();
        let length = towards.iter().map(|value| value * value).sum::<f32>().sqrt();
        if length.is_nan() || length <= 1e-4 {
            return Err(Error::setting("words", "are where the neutral words are", "give other words"));
        }
        towards.iter_mut().for_each(|value| *value /= length);
        Ok(Aim::Towards { towards, from })
    }

    fn picture(&self) -> Option<&Image> {
        match self {
            Aim::Like(_) => None,
            Aim::LikePicture(picture) | Aim::Towards { from: picture, .. } => Some(picture),
        }
    }
}

/// One network of an ensemble.
pub struct Member {
    network: Box<dyn Network>,
    aims: Vec<Option<Aim>>,
    /// What the network saw last in each view's reference: whoever looks at the whole sees the same every time.
    references: Vec<Option<(Vec<Patch>, Vec<f32>)>>,
}

impl Member {
    /// `network` with its aim for each view, in the problem's order; it says nothing of a view without.
    ///
    /// # Errors
    /// [`Error::Guidance`] for vectors that are not of the network's size.
    pub fn new(network: Box<dyn Network>, aims: Vec<Option<Aim>>) -> Result<Member> {
        for aim in aims.iter().flatten() {
            if let Aim::Like(vector) | Aim::Towards { towards: vector, .. } = aim
                && vector.len() != network.embed()
            {
                let problem = format!("has {} numbers, and the network's have {}", vector.len(), network.embed());
                return Err(Error::guidance("a vector of words", problem, "take one of the same model's text encoder"));
            }
        }
        let references = vec![None; aims.len()];
        Ok(Member { network, aims, references })
    }

    fn aim(&self, view: usize) -> Option<&Aim> {
        self.aims.get(view).and_then(Option::as_ref)
    }

    /// Adds `scale` times the losses of all views to the result, and their gradients to the views'.
    async fn guide(&mut self, views: &mut [Rendered], looks: &[Vec<Patch>], scale: f32) -> Result<f32> {
        let (size, embed) = (self.network.size(), self.network.embed());
        let mut loss = 0.0;
        for (index, view) in views.iter_mut().enumerate() {
            let (Some(_), Some(patches)) = (self.aim(index), looks.get(index)) else { continue };
            let seen = self.reference(index, view, patches).await?;
            let Some(aim) = self.aim(index) else { continue };
            let targets = match aim {
                Aim::Like(target) | Aim::Towards { towards: target, .. } => target.repeat(patches.len()),
                Aim::LikePicture(_) => seen.clone(),
            };
            let sources = if matches!(aim, Aim::Towards { .. }) { seen } else { vec![0.0; targets.len()] };
            let ink: Vec<f32> = view.coverage.iter().zip(&view.counts).map(|(ink, counts)| ink * counts).collect();
            let mut d_ink = vec![0.0; ink.len()];
            let rows = patches.chunks(MOST_ROWS).zip(sources.chunks(MOST_ROWS * embed));
            for ((patches, source), target) in rows.zip(targets.chunks(MOST_ROWS * embed)) {
                let images = images(patches, &ink, view.width, size);
                let weight = vec![scale * view.guided_weight() / looks[index].len() as f32; patches.len()];
                let answer =
                    self.network.run(Batch { images: &images, source, target, weight: &weight }).done().await?;
                loss += answer.loss;
                for (patch, d_image) in patches.iter().zip(answer.gradient.chunks_exact(3 * size * size)) {
                    patch.pull(d_image, size, view.width, &mut d_ink);
                }
            }
            let pulls = d_ink.iter().zip(&view.counts).map(|(d, counts)| d * counts);
            view.gradient.iter_mut().zip(pulls).for_each(|(gradient, pull)| *gradient += pull);
        }
        Ok(loss)
    }

    /// What the network sees in the same patches of a view's reference; nothing of a view without. Asked of the network
    /// itself, since another precision's answer would turn the gradient.
    async fn reference(&mut self, index: usize, view: &Rendered, patches: &[Patch]) -> Result<Vec<f32>> {
        let Some(picture) = self.aims[index].as_ref().and_then(Aim::picture) else { return Ok(Vec::new()) };
        let across = picture.width as f32 / view.width as f32;
        let patches: Vec<Patch> = patches.iter().map(|patch| patch.scaled(across)).collect();
        if let Some((seen, embeddings)) = &self.references[index]
            && *seen == patches
        {
            return Ok(embeddings.clone());
        }
        let (size, embed) = (self.network.size(), self.network.embed());
        let mut embeddings = Vec::new();
        for patches in patches.chunks(MOST_ROWS) {
            let images = images(patches, &picture.data, picture.width, size);
            let source = vec![0.0; patches.len() * embed];
            // Any unit vectors: nothing comes back of them.
            let target: Vec<f32> = (0..source.len()).map(|i| f32::from(i % embed == 0)).collect();
            let weight = vec![0.0; patches.len()];
            let batch = Batch { images: &images, source: &source, target: &target, weight: &weight };
            embeddings.extend(self.network.run(batch).done().await?.embedding);
        }
        self.references[index] = Some((patches, embeddings.clone()));
        Ok(embeddings)
    }
}

/// `[n, 3, size, size]`: what a network of that size sees in patches of `ink`.
fn images(patches: &[Patch], ink: &[f32], width: usize, size: usize) -> Vec<f32> {
    let mut images = vec![0.0; patches.len() * 3 * size * size];
    for (patch, image) in patches.iter().zip(images.chunks_exact_mut(3 * size * size)) {
        patch.draw(ink, width, size, image);
    }
    images
}

/// A [`Guidance`] by one network, or by several that agree better with people than one.
pub struct Learned {
    members: Vec<Member>,
    look: Look,
    seed: u64,
}

impl Learned {
    /// All `members` look at the same patches, which follow from `look`, `seed` and the iteration.
    pub fn new(members: Vec<Member>, look: Look, seed: u64) -> Learned {
        Learned { members, look, seed }
    }
}

impl Guidance for Learned {
    fn guide<'a>(&'a mut self, views: &'a mut [Rendered], progress: Progress) -> Work<'a, Result<f32>> {
        Work::later(async move {
            let patches = |(index, view): (usize, &Rendered)| {
                self.look.patches(view.width, view.height, self.seed, progress.iteration, index)
            };
            let looks: Vec<_> = views.iter().enumerate().map(patches).collect();
            let mut loss = 0.0;
            let members = self.members.len() as f32;
            for member in &mut self.members {
                let weights = views.iter().enumerate().filter(|&(i, _)| member.aim(i).is_some());
                let weights: f32 = weights.map(|(_, view)| view.guided_weight()).sum();
                if weights > 0.0 {
                    loss += member.guide(views, &looks, 1.0 / (weights * members)).await?;
                }
            }
            Ok(loss)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Answer, similarity};
    use super::*;
    use crate::rng::Rng;
    use crate::view::Camera;
    use crate::work::wait;

    const SIZE: usize = 6;
    const EMBED: usize = 5;
    const SIDE: usize = 20;

    /// A smooth network with all of the contract: tanh of a matrix, made unit, in double precision.
    struct Small(Vec<f64>);

    impl Small {
        fn new(seed: u64) -> Small {
            let mut rng = Rng::new(seed, 0);
            Small((0..EMBED * 3 * SIZE * SIZE).map(|_| rng.range(-0.3, 0.3)).collect())
        }

        fn row(&self, image: &[f32], source: &[f32], target: &[f32], weight: f64, answer: &mut Answer) {
            let pixels = image.len();
            let activations: Vec<f64> = (0..EMBED)
                .map(|e| (0..pixels).map(|p| self.0[e * pixels + p] * f64::from(image[p])).sum::<f64>().tanh())
                .collect();
            let length = activations.iter().map(|a| a * a).sum::<f64>().sqrt();
            let unit: Vec<f64> = activations.iter().map(|a| a / length).collect();
            let away: Vec<f64> = unit.iter().zip(source).map(|(u, &s)| u - f64::from(s)).collect();
            let far = (away.iter().map(|d| d * d).sum::<f64>() + 1e-6).sqrt();
            let along = away.iter().zip(target).map(|(d, &t)| d * f64::from(t)).sum::<f64>();
            let cos = along / far;
            // Back: through the quotient, the unit length, tanh and the matrix.
            let d_unit: Vec<f64> =
                (0..EMBED).map(|e| -weight * (f64::from(target[e]) / far - along * away[e] / far.powi(3))).collect();
            let radial: f64 = (0..EMBED).map(|e| d_unit[e] * unit[e]).sum();
            let d_sum: Vec<f64> = (0..EMBED)
                .map(|e| (d_unit[e] - radial * unit[e]) / length * (1.0 - activations[e] * activations[e]))
                .collect();
            answer.loss += (weight * (1.0 - cos)) as f32;
            answer.cos.push(cos as f32);
            answer.embedding.extend(unit.iter().map(|&u| u as f32));
            let pull = |p: usize| (0..EMBED).map(|e| d_sum[e] * self.0[e * pixels + p]).sum::<f64>() as f32;
            answer.gradient.extend((0..pixels).map(pull));
        }
    }

    impl Network for Small {
        fn size(&self) -> usize {
            SIZE
        }

        fn embed(&self) -> usize {
            EMBED
        }

        fn run<'a>(&'a mut self, batch: Batch<'a>) -> Work<'a, Result<Answer>> {
            assert!(batch.weight.len() <= MOST_ROWS);
            let mut answer = Answer::default();
            for (row, &weight) in batch.weight.iter().enumerate() {
                let image = &batch.images[row * 3 * SIZE * SIZE..][..3 * SIZE * SIZE];
                let [source, target] = [batch.source, batch.target].map(|rows| &rows[row * EMBED..][..EMBED]);
                self.row(image, source, target, f64::from(weight), &mut answer);
            }
            Work::Done(Ok(answer))
        }
    }

    /// Fails after so many runs.
    struct Failing(usize);

    impl Network for Failing {
        fn size(&self) -> usize {
            SIZE
        }

        fn embed(&self) -> usize {
            EMBED
        }

        fn run<'a>(&'a mut self, batch: Batch<'a>) -> Work<'a, Result<Answer>> {
            if self.0 == 0 {
                return Work::Done(Err(Error::guidance("failing", "fails", "mend it")));
            }
            self.0 -= 1;
            Work::Done(wait(Small::new(1).run(batch).done()))
        }
    }

    fn noise(count: usize, seed: u64) -> Vec<f32> {
        let mut rng = Rng::new(seed, 0);
        (0..count).map(|_| rng.range(0.1, 0.9) as f32).collect()
    }

    fn unit(seed: u64) -> Vec<f32> {
        let mut vector: Vec<f32> = noise(EMBED, seed).iter().map(|value| value - 0.5).collect();
        let length = vector.iter().map(|value| value * value).sum::<f32>().sqrt();
        vector.iter_mut().for_each(|value| *value /= length);
        vector
    }

    fn views() -> Vec<Rendered> {
        let view = |(seed, weight)| {
            let mut view = Rendered::new(Camera::default(), SIDE, SIDE, weight);
            view.coverage = noise(SIDE * SIDE, seed);
            view.counts = noise(SIDE * SIDE, seed + 10);
            view.gradient = vec![0.0; SIDE * SIDE];
            view
        };
        [(1, 1.0), (2, 0.5), (3, 1.0)].map(view).into()
    }

    fn picture(side: usize, seed: u64) -> Image {
        Image { width: side, height: side, data: noise(side * side, seed) }
    }

    fn member(network: u64, aims: Vec<Option<Aim>>) -> Member {
        Member::new(Box::new(Small::new(network)), aims).unwrap()
    }

    const NOW: Progress = Progress { iteration: 4, iterations: 10 };

    #[test]
    fn the_gradient_is_that_of_finite_differences() {
        let towards = || Aim::between(&unit(1), &unit(2), picture(30, 7)).unwrap();
        // Views with words, with none, and with directions from pictures of another size; two networks that disagree.
        let like = || Some(Aim::Like(unit(5)));
        let cases: [(Look, Vec<Option<Aim>>); 4] = [
            (Look::Whole, vec![like(), None, like()]),
            (Look::Grid { cells: 4 }, vec![Some(towards()), like()]),
            (Look::Affine { count: 9, turn: 0.3, scale: 0.5, shift: 0.1 }, vec![like(), Some(towards())]),
            (Look::Grid { cells: 2 }, vec![None, None, Some(Aim::LikePicture(picture(SIDE, 8)))]),
        ];
        for (look, aims) in cases {
            let make = || Learned::new(vec![member(1, aims.clone()), member(2, aims.clone())], look, 9);
            let loss_of = |views: &mut Vec<Rendered>| wait(make().guide(views, NOW).done()).unwrap();
            let mut at = views();
            let loss = loss_of(&mut at);
            assert!((0.0..2.0).contains(&loss));
            for view in 0..3 {
                // Along the gradient itself, in which a view's many small numbers add up; and none without an aim.
                let gradient = at[view].gradient.clone();
                let length = gradient.iter().map(|d| d * d).sum::<f32>().sqrt();
                assert_eq!(length > 0.0, aims.get(view).is_some_and(Option::is_some));
                if length == 0.0 {
                    continue;
                }
                let moved = |by: f32| {
                    let mut views = views();
                    views[view].coverage.iter_mut().zip(&gradient).for_each(|(ink, d)| *ink += by * d / length);
                    f64::from(loss_of(&mut views))
                };
                let slope = (moved(0.004) - moved(-0.004)) / 0.008;
                let off = (slope / f64::from(length) - 1.0).abs();
                assert!(off < 1e-3, "{look:?}, view {view}: {slope} and {length}");
            }
        }
    }

    #[test]
    fn a_view_that_is_its_picture_has_no_loss_and_one_at_its_words_little() {
        let mut views = views();
        views.truncate(1);
        views[0].counts.fill(1.0);
        let same = Image { width: SIDE, height: SIDE, data: views[0].coverage.clone() };
        let mut like = Learned::new(vec![member(1, vec![Some(Aim::LikePicture(same.clone()))])], Look::Whole, 0);
        assert!(wait(like.guide(&mut views, NOW).done()).unwrap() < 1e-5);
        let mut network = Small::new(1);
        let seen = wait(similarity(&mut network, &same, &unit(4))).unwrap();
        let mut words = Learned::new(vec![member(1, vec![Some(Aim::Like(unit(4)))])], Look::Whole, 0);
        assert!((wait(words.guide(&mut views, NOW).done()).unwrap() + seen - 1.0).abs() < 1e-5);
    }

    #[test]
    fn steps_against_the_gradient_lead_to_the_words() {
        let mut views = views();
        let mut words = Learned::new(vec![member(3, vec![Some(Aim::Like(unit(4)))])], Look::Whole, 1);
        let mut losses = Vec::new();
        for iteration in 0..200 {
            views[0].gradient.fill(0.0);
            losses.push(wait(words.guide(&mut views, Progress { iteration, iterations: 200 }).done()).unwrap());
            let Rendered { coverage, gradient, .. } = &mut views[0];
            let most = gradient.iter().fold(0.0f32, |most, d| most.max(d.abs()));
            coverage.iter_mut().zip(gradient).for_each(|(ink, d)| *ink = (*ink - 0.05 * *d / most).clamp(0.0, 1.0));
        }
        assert!(losses[199] < 0.8 * losses[0], "{losses:?}");
    }

    #[test]
    fn a_network_that_fails_says_so_and_wrong_vectors_are_refused() {
        let aims = vec![Some(Aim::Like(unit(4)))];
        let mut learned = Learned::new(vec![Member::new(Box::new(Failing(1)), aims).unwrap()], Look::Whole, 0);
        assert!(wait(learned.guide(&mut views(), NOW).done()).is_ok());
        assert!(matches!(wait(learned.guide(&mut views(), NOW).done()), Err(Error::Guidance { .. })));
        assert!(Member::new(Box::new(Failing(1)), vec![None, Some(Aim::Like(vec![1.0; 4]))]).is_err());
        assert!(Aim::between(&unit(1), &unit(1), picture(4, 1)).is_err());
    }
}
