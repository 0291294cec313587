//! What a call of the engine comes to on one device: write, submit many iterations, read back once.

use super::clock::now_ms;
use super::fault::Answer;
use super::pipeline::Pipeline;
use super::stage::Slot;
use crate::optimize::{Scene, SceneView, State, Step, Tally};
use std::ops::Range;

/// Runs stages up to `last` for each of `steps` from the state in the buffers on and hands over the terms and what else
/// was asked for; None if there was not room enough, which there is now.
async fn run(
    pipeline: &mut Pipeline,
    last: &str,
    count: u32,
    steps: &[Step],
    ahead: &[Vec<SceneView>],
    terms: &mut [f32],
    wanted: &[(Slot, Range<usize>)],
) -> Answer<Option<Vec<Vec<u8>>>> {
    let row = terms.len() / steps.len().max(1) + 1;
    let begin_ms = now_ms();
    pipeline.run_looking("sample", last, steps, count, ahead)?;
    let mut ranges = vec![(Slot::Terms, 0..size_of::<f32>() * row * steps.len())];
    ranges.extend_from_slice(wanted);
    let mut bytes = pipeline.read_bytes(&ranges).await?.into_iter();
    pipeline.keep_pace((now_ms() - begin_ms) / steps.len() as f64);
    let found: Vec<f32> = bytes.next().map(|bytes| bytemuck::pod_collect_to_vec(&bytes)).unwrap_or_default();
    // The last entry of a row says how many cell entries were wanted.
    let entries = found.chunks_exact(row).map(|row| row[row.len() - 1] as usize).max().unwrap_or(0);
    if entries > pipeline.room() {
        pipeline.make_room(entries + entries / 4).await?;
        return Ok(None);
    }
    for (terms, found) in terms.chunks_exact_mut(row - 1).zip(found.chunks_exact(row)) {
        terms.copy_from_slice(&found[..row - 1]);
    }
    Ok(Some(bytes.collect()))
}

/// Terms and gradient at `points`.
pub(super) async fn evaluate(
    pipeline: &mut Pipeline,
    points: &[[f32; 4]],
    step: &Step,
    terms: &mut [f32],
    d_points: &mut Vec<[f32; 4]>,
) -> Answer<()> {
    loop {
        pipeline.write(Slot::State, points)?;
        pipeline.write(Slot::Best, &[[f32::MAX, 0.0, 0.0, 0.0]])?;
        let wanted = [(Slot::DPoints, 0..size_of_val(points))];
        if let Some(parts) = run(pipeline, "add_terms", 0, std::slice::from_ref(step), &[], terms, &wanted).await? {
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

/// Iterations from `state` on, and what they leave behind; neither changes if the device fails.
pub(super) async fn advance(
    pipeline: &mut Pipeline,
    state: &mut State,
    tally: &mut Tally,
    steps: &[Step],
    views: Views<'_>,
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
        let Some(parts) = run(pipeline, "adam", adam.count, steps, views.ahead, terms, &wanted).await? else {
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
