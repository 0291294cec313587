//! A look into a fit: which term pulls where, and how like its target each view is at every scale.

use super::engine::{Engine, Picture, Scene, Step};
use super::{CpuEngine, Session};
use crate::objective::MultiscaleMse;
use crate::view::Image;
use crate::wire::Wire;
use crate::work::wait;

/// A fit at one moment, taken apart.
#[derive(Debug, Clone, PartialEq)]
pub struct Insight {
    /// The wire whose control points are pulled.
    pub wire: Wire,
    /// What pulls: a term for each view, then those of [`Term::ALL`](super::Term::ALL); those that are off do not pull at all.
    pub pulls: Vec<Pull>,
    /// Each view as it is compared, finest first.
    pub views: Vec<Vec<Level>>,
}

/// A term of the loss and what it wants.
#[derive(Debug, Clone, PartialEq)]
pub struct Pull {
    /// The view's name or the term's: a column of [`History`](super::History).
    pub name: String,
    /// The weighted loss.
    pub loss: f32,
    /// Its gradient to each control point's `[x, y, z, width]`, a world unit: the wire is pulled the other way.
    pub gradient: Vec<[f32; 4]>,
}

/// A view at one scale of the loss.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// The wire, 0 (ground) to 1 (ink).
    pub seen: Image,
    /// What it should be like, bent where it bends.
    pub wanted: Image,
    /// This scale's share of the view's weighted loss.
    pub loss: f32,
}

impl Session {
    /// What the next iteration would see and be pulled by, were there no edit of the topology first. It is computed aside, by the
    /// processor: neither this session nor what computes it notices. What guides from outside, see [`Session::guide_by`], is
    /// left out.
    pub fn insight(&self) -> Insight {
        let (scene, step) = self.next_iteration();
        let (pyramid, ratio) = (scene.pyramid, step.level_ratio);
        let wanted: Vec<(Image, f32)> = scene.views.iter().map(|view| (view.target.clone(), view.weight)).collect();
        let mut engine = CpuEngine::new();
        wait(engine.load(scene).done());
        let (terms, gradients) = engine.take_apart(&self.state.points, &step);
        let named = self.history.columns[1..].iter().zip(&terms[1..]);
        let pull = |((name, &loss), gradient): ((&String, &f32), _)| Pull { name: name.clone(), loss, gradient };
        let pulls = named.zip(gradients).map(pull).collect();
        let levels = |(v, (wanted, weight)): (usize, &(Image, f32))| {
            let seen = engine.picture(Picture::Coverage, v);
            Level::all(MultiscaleMse::new(pyramid, wanted.width, wanted.height), seen, &wanted.data, *weight, ratio)
        };
        let views = wanted.iter().enumerate().map(levels).collect();
        Insight { wire: self.wire(), pulls, views }
    }

    /// The next iteration's scene and numbers, or the last one's where all are done.
    fn next_iteration(&self) -> (Scene, Step) {
        let now = &self.state.points;
        let [planes, strands] = self.looks_round();
        let strand_points = if strands { now } else { &self.strand_points };
        let mut step = self.numbers(self.iteration.min(self.total().saturating_sub(1)));
        if strands || self.speed == 0.0 {
            step.elastic.speed = self.measured_speed(strand_points);
            step.clearance.speed = step.elastic.speed;
        }
        let mut inks = self.fitted_inks(&self.problem.targets);
        self.bend_inks(&mut inks);
        (self.scene(inks, if planes { now } else { &self.plane_points }, strand_points), step)
    }
}

impl Level {
    /// Every scale of a view of this weight, each coarser one weighted `ratio` times the finer one.
    fn all(mut pyramid: MultiscaleMse<f32>, seen: &[f32], wanted: &[f32], mut weight: f32, ratio: f32) -> Vec<Level> {
        let mut levels = |picture| -> Vec<Image> {
            let image = |(width, height, data): (usize, usize, &[f32])| Image { width, height, data: data.to_vec() };
            pyramid.levels_of(picture).map(image).collect()
        };
        let (seen, wanted) = (levels(seen), levels(wanted));
        let level = |(seen, wanted): (Image, Image)| {
            let squares = seen.data.iter().zip(&wanted.data).map(|(a, b)| (a - b) * (a - b));
            let loss = weight * squares.sum::<f32>() / seen.data.len() as f32;
            weight *= ratio;
            Level { seen, wanted, loss }
        };
        seen.into_iter().zip(wanted).map(level).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Bending, Problem, Recipe, Schedule, Smooth, SurfacePull, Term, term_count};
    use super::*;
    use crate::mesh::{Nearest, Shape};
    use crate::objective::{Texture, TextureOptions};
    use crate::rng::Rng;
    use crate::view::{Target, View};
    use std::sync::Arc;

    /// 48 px pictures of stripes, a tangled wire that passes itself, and every term that there is on from the start.
    fn everything() -> Problem {
        let mut rng = Rng::new(5, 0);
        let point = |_| {
            let [x, y, z] = rng.in_ball(0.7);
            [x, y, z, rng.range(0.05, 0.09)]
        };
        let wire = Wire::open_uniform((0..24).map(point).collect()).unwrap();
        let stripes = |period: usize| Image {
            width: 48,
            height: 48,
            data: (0..48 * 48).map(|i| if (i % 48 + i / 96) % period < 2 { 1.0 } else { 0.0 }).collect(),
        };
        let views = View::canonical(2.2, 48);
        let targets = views.into_iter().zip(6..).map(|(view, period)| Target { view, ink: stripes(period) }).collect();
        let smooth = Smooth::default();
        let mut recipe = Recipe {
            smooth: Some(Smooth {
                tightness: Schedule::Constant(smooth.tightness.at(1.0)),
                clearance: Schedule::Constant(smooth.clearance.at(1.0)),
                ..smooth
            }),
            length: Schedule::Constant(0.01),
            bending: Some(Bending { from: 0.0, every: 2, ..Bending::default() }),
            ..Recipe::best()
        };
        recipe
            .stages
            .iter_mut()
            .for_each(|stage| (stage.size_px, stage.raster) = (48, super::super::RasterKind::Exact));
        recipe.set_iterations(12, 0.5);
        let mut problem = Problem::for_drawings(wire, targets, recipe);
        problem.view_weights = vec![1.0, 0.5, 2.0];
        problem.width.min_world = 0.01;
        problem.surface = Some(SurfacePull::new(Arc::new(Nearest::new(&Shape::Sphere.mesh())), 0.3));
        let options = TextureOptions { finest: 0, ..TextureOptions::default() };
        problem.texture = Some(Arc::new(Texture::of("stripes", &stripes(5), &options).unwrap()));
        problem.texture_weight = 0.05;
        problem
    }

    fn at_step(count: usize) -> Session {
        let mut session = Session::new(everything()).unwrap();
        session.step(count);
        session
    }

    fn dot(a: &[[f32; 4]], b: &[[f32; 4]]) -> f64 {
        a.iter().flatten().zip(b.iter().flatten()).map(|(&a, &b)| f64::from(a) * f64::from(b)).sum()
    }

    #[test]
    fn the_terms_are_the_iterations_and_add_up_to_the_gradient_that_moves_the_wire() {
        for done in [0, 3, 4, 6, 11] {
            let mut session = at_step(done);
            let insight = session.insight();
            assert_eq!(insight.wire, session.wire());
            // Also of one that has not begun to go on yet.
            let resumed = Session::resume(session.problem.clone(), session.checkpoint()).unwrap();
            assert_eq!(resumed.insight(), insight);
            let beta1 = session.numbers(done).adam.beta1 as f32;
            let before = session.state.adam.first.clone();
            session.step(1);
            let row = session.history().row(done).unwrap();
            let names: Vec<_> = insight.pulls.iter().map(|pull| pull.name.as_str()).collect();
            assert_eq!(names, session.history().columns[1..]);
            for (pull, term) in insight.pulls.iter().zip(&row[1..]) {
                assert_eq!(pull.loss.to_bits(), term.to_bits(), "{} at {done}", pull.name);
                assert!(pull.loss > 0.0 || pull.name == Term::Guidance.name(), "{} at {done}", pull.name);
            }
            // What Adam's mean says that the gradient was.
            let used = |(after, before): (f32, f32)| (after - beta1 * before) / (1.0 - beta1);
            let largest =
                insight.pulls.iter().flat_map(|pull| &pull.gradient).flatten().fold(0.0, |m: f32, g| m.max(g.abs()));
            for (k, (after, before)) in session.state.adam.first.iter().zip(&before).enumerate() {
                for c in 0..4 {
                    let sum: f32 = insight.pulls.iter().map(|pull| pull.gradient[k][c]).sum();
                    let used = used((after[c], before[c]));
                    assert!((sum - used).abs() < 1e-5 * largest, "{sum}, not {used}, at point {k} after {done}");
                }
            }
        }
    }

    #[test]
    fn each_gradient_is_its_own_terms() {
        let session = at_step(5);
        let insight = session.insight();
        let (scene, step) = session.next_iteration();
        let mut engine = CpuEngine::new();
        wait(engine.load(scene).done());
        for (number, pull) in insight.pulls.iter().enumerate() {
            let squared = dot(&pull.gradient, &pull.gradient);
            if pull.name == Term::Guidance.name() {
                assert_eq!(squared, 0.0);
                continue;
            }
            // Along its own gradient the term falls as fast as that is long.
            let mut loss_at = |offset: f64| {
                let along = (offset / squared.sqrt()) as f32;
                let moved = |(point, g): (&[f32; 4], &[f32; 4])| std::array::from_fn(|c| point[c] + along * g[c]);
                let points: Vec<[f32; 4]> = session.state.points.iter().zip(&pull.gradient).map(moved).collect();
                let mut terms = vec![0.0; term_count(3)];
                engine.evaluate_now(&points, &step, &mut terms, &mut Vec::new());
                f64::from(terms[1 + number])
            };
            let h = 2e-3;
            let slope = (loss_at(h) - loss_at(-h)) / (2.0 * h);
            let expected = squared.sqrt();
            assert!((slope - expected).abs() < 0.02 * expected, "{}: {slope}, not {expected}", pull.name);
        }
    }

    #[test]
    fn asking_changes_no_bit_of_the_run() {
        let (mut asked, mut unasked) = (at_step(0), at_step(0));
        while !asked.is_done() {
            let before = asked.checkpoint();
            asked.insight();
            assert_eq!(asked.checkpoint(), before);
            asked.step(1);
        }
        unasked.step(usize::MAX);
        assert_eq!(asked.checkpoint(), unasked.checkpoint());
        assert_eq!(asked.insight(), unasked.insight(), "of a run that is done");
    }

    #[test]
    fn the_levels_are_those_of_the_loss() {
        let session = at_step(6);
        let insight = session.insight();
        for (levels, pull) in insight.views.iter().zip(&insight.pulls) {
            let sizes: Vec<_> = levels.iter().map(|level| (level.seen.width, level.seen.height)).collect();
            assert_eq!(sizes, crate::objective::level_sizes(48, 48));
            let sum: f32 = levels.iter().map(|level| level.loss).sum();
            assert!((sum - pull.loss).abs() < 1e-4 * pull.loss, "{}: {sum}, not {}", pull.name, pull.loss);
            for pair in levels.windows(2) {
                let mean = |image: &Image| image.data.iter().sum::<f32>() / image.data.len() as f32;
                assert!((mean(&pair[0].wanted) - mean(&pair[1].wanted)).abs() < 1e-3, "halving keeps the ink");
                assert!(mean(&pair[1].seen) > 0.01, "the wire is to be seen");
            }
        }
    }
}
