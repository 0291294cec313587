//! What a call of the engine comes to on one device: write, submit many iterations, read back once.

use super::clock::now_ms;
use super::fault::Answer;
use super::pipeline::Pipeline;
use super::stage::Slot;
use crate::objective::{Guides, Rendered};
use crate::optimize::{Scene, SceneView, State, Step, Tally, Term};
use std::ops::Range;

/// Runs stages up to `last` for each of `steps` from the state in the buffers on and hands over the terms and what else
/// was asked for; None if there was not room enough, which there is now.
async fn run(
    pipeline: &mut Pipeline,
    first: &str,
    last: &str,
    count: u32,
    steps: &[Step],
    ahead: &[Vec<SceneView>],
    terms: &mut [f32],
    wanted: &[(Slot, Range<usize>)],
) -> Answer<Option<Vec<Vec<u8>>>> {
    let row = terms.len() / steps.len().max(1) + 1;
    let begin_ms = now_ms();
    pipeline.run_looking(first, last, steps, count, ahead)?;
    let mut ranges = vec![(Slot::Terms, 0..size_of::<f32>() * row * steps.len())];
    ranges.extend_from_slice(wanted);
    let mut bytes = pipeline.read_bytes(&ranges).await?.into_iter();
    pipeline.keep_pace((now_ms() - begin_ms) / steps.len() as f64);
    let found: Vec<f32> = bytes.next().map(|bytes| bytemuck::pod_collect_to_vec(&bytes)).unwrap_or_default();
    // The last entry of a row says how many cell entries were wanted.
    let entries = found.chunks_exact(row).map(|row| row[row.len() - 1] as usize).max().unwrap_or(0);
    if !has_room(pipeline, entries).await? {
        return Ok(None);
    }
    for (terms, found) in terms.chunks_exact_mut(row - 1).zip(found.chunks_exact(row)) {
        terms.copy_from_slice(&found[..row - 1]);
    }
    Ok(Some(bytes.collect()))
}

/// The first stages of an iteration, up to where the loss's gradient to the pictures is complete, and the others.
const DRAWN: [&str; 2] = ["sample", "texture_add"];
const PULLED: &str = "pull_back";

/// Who looks at the pictures between the two.
pub(super) struct Lookers<'a> {
    pub guides: &'a Guides,
    /// The views as they are now; what they show is written here.
    pub shown: &'a mut [Rendered],
}

impl Lookers<'_> {
    /// The same, to look once more.
    fn again(&mut self) -> Lookers<'_> {
        Lookers { guides: self.guides, shown: &mut *self.shown }
    }

    /// Draws the state in the buffers, shows it round and leaves the gradient in the buffers: the rest of the iteration can
    /// go on from there. Returns the weighted loss; None if there was not room enough, which there is now.
    async fn look(&mut self, pipeline: &mut Pipeline, count: u32, step: &Step) -> Answer<Option<f32>> {
        let begin_ms = now_ms();
        pipeline.run(DRAWN[0], DRAWN[1], std::slice::from_ref(step), count)?;
        let bytes = |view: &Rendered| size_of_val(&*view.coverage);
        let all = 0..self.shown.iter().map(bytes).sum();
        let wanted = [(Slot::Cells, 0..size_of::<u32>()), (Slot::Coverage, all.clone()), (Slot::Pyramid, all)];
        let parts = pipeline.read_bytes(&wanted).await?;
        pipeline.keep_pace(now_ms() - begin_ms);
        let [entries, coverage, d_coverage] = &parts[..] else { return Ok(None) };
        if !has_room(pipeline, bytemuck::pod_read_unaligned::<u32>(entries) as usize).await? {
            return Ok(None);
        }
        let mut first = 0;
        for view in &mut *self.shown {
            let range = first..first + bytes(view);
            view.coverage = bytemuck::pod_collect_to_vec(&coverage[range.clone()]);
            view.d_coverage = bytemuck::pod_collect_to_vec(&d_coverage[range.clone()]);
            first = range.end;
        }
        let loss = self.guides.guide(self.shown, step.progress).await;
        let d_coverage: Vec<f32> = self.shown.iter().flat_map(|view| &view.d_coverage).copied().collect();
        pipeline.write(Slot::Pyramid, &d_coverage)?;
        Ok(Some(loss))
    }
}

/// Whether there was room for so many cell entries. If not there is now, and all has to be done again.
async fn has_room(pipeline: &mut Pipeline, entries: usize) -> Answer<bool> {
    if entries <= pipeline.room() {
        return Ok(true);
    }
    pipeline.make_room(entries + entries / 4).await?;
    Ok(false)
}

/// [`run`] from the state in the buffers on, past whoever looks.
async fn run_guided(
    pipeline: &mut Pipeline,
    last: &str,
    count: u32,
    steps: &[Step],
    ahead: &[Vec<SceneView>],
    lookers: Option<Lookers<'_>>,
    terms: &mut [f32],
    wanted: &[(Slot, Range<usize>)],
) -> Answer<Option<Vec<Vec<u8>>>> {
    let Some(mut lookers) = lookers else {
        return run(pipeline, DRAWN[0], last, count, steps, ahead, terms, wanted).await;
    };
    let Some(loss) = lookers.look(pipeline, count, &steps[0]).await? else { return Ok(None) };
    let parts = run(pipeline, PULLED, last, count, steps, ahead, terms, wanted).await?;
    terms[0] += loss;
    terms[Term::Guidance.at(lookers.shown.len())] = loss;
    Ok(parts)
}

/// Terms and gradient at `points`.
pub(super) async fn evaluate(
    pipeline: &mut Pipeline,
    points: &[[f32; 4]],
    step: &Step,
    mut lookers: Option<Lookers<'_>>,
    terms: &mut [f32],
    d_points: &mut Vec<[f32; 4]>,
) -> Answer<()> {
    loop {
        pipeline.write(Slot::State, points)?;
        pipeline.write(Slot::Best, &[[f32::MAX, 0.0, 0.0, 0.0]])?;
        let wanted = [(Slot::DPoints, 0..size_of_val(points))];
        let (steps, lookers) = (std::slice::from_ref(step), lookers.as_mut().map(Lookers::again));
        if let Some(parts) = run_guided(pipeline, "add_terms", 0, steps, &[], lookers, terms, &wanted).await? {
            *d_points = bytemuck::pod_collect_to_vec(&parts[0]);
            return Ok(());
        }
    }
}

/// What iterations look at.
pub(super) struct Views<'a> {
    /// The scene's views.
    pub now: &'a [SceneView],
    /// Those after each iteration, as far as they are others.
    pub ahead: &'a [Vec<SceneView>],
}

/// Iterations from `state` on, one where somebody looks, and what they leave behind; neither changes if the device fails.
pub(super) async fn advance(
    pipeline: &mut Pipeline,
    state: &mut State,
    tally: &mut Tally,
    steps: &[Step],
    views: Views<'_>,
    mut lookers: Option<Lookers<'_>>,
    terms: &mut [f32],
) -> Answer<()> {
    let State { points, adam } = state;
    let count = points.len();
    loop {
        pipeline.write(Slot::State, &[&**points, &*adam.first, &*adam.second].concat())?;
        // Not every device knows infinity.
        pipeline.write(Slot::Best, &[[tally.best_loss.min(f32::MAX), 0.0, 0.0, 0.0]])?;
        pipeline.write(Slot::GradientNorms, &tally.gradient_norms)?;
        let vec4s = size_of::<[f32; 4]>();
        let wanted = [
            (Slot::State, 0..3 * count * vec4s),
            (Slot::Best, 0..(1 + count) * vec4s),
            (Slot::GradientNorms, 0..count * size_of::<f32>()),
        ];
        let (ahead, looking) = (views.ahead, lookers.as_mut().map(Lookers::again));
        let parts = run_guided(pipeline, "adam", adam.count, steps, ahead, looking, terms, &wanted).await?;
        let Some(parts) = parts else {
            if !views.ahead.is_empty() {
                pipeline.set_views(views.now)?;
            }
            continue;
        };
        let packed: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&parts[0]);
        points.copy_from_slice(&packed[..count]);
        adam.first.copy_from_slice(&packed[count..2 * count]);
        adam.second.copy_from_slice(&packed[2 * count..]);
        adam.count += steps.len() as u32;
        let best: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&parts[1]);
        if best[0][0] < tally.best_loss || steps.iter().any(Step::keeps_last) {
            tally.best_loss = best[0][0];
            tally.best_points.clear();
            tally.best_points.extend_from_slice(&best[1..]);
        }
        tally.gradient_norms = bytemuck::pod_collect_to_vec(&parts[2]);
        return Ok(());
    }
}

/// All views' shares of a buffer that has an entry a pixel.
pub(super) async fn fetch(pipeline: &mut Pipeline, slot: Slot, scene: &Scene) -> Answer<Vec<Vec<f32>>> {
    let mut first = 0;
    let views = scene.views.iter().map(|view| {
        let range = first..first + size_of_val(&*view.target.data);
        first = range.end;
        (slot, range)
    });
    let parts = pipeline.read_bytes(&views.collect::<Vec<_>>()).await?;
    Ok(parts.iter().map(|bytes| bytemuck::pod_collect_to_vec(bytes)).collect())
}
