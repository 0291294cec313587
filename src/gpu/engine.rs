//! The engine on a graphics card: many iterations a submission, one read back at the end of each.

use super::pipeline::Pipeline;
use super::stage::Slot;
use super::{Device, check};
use crate::optimize::{CpuEngine, Engine, Place, Scene, State, Step, term_count};
use crate::{Error, Result};
use std::cell::OnceCell;
use std::ops::Range;

/// Iterations a submission: few enough that a card shared with a screen stays responsive.
const BATCH: usize = 16;

/// Computes on a device, every stage with the exact rasteriser: the band only saves time on a processor.
///
/// A device can be lost, or turn out too small, in the middle of a fit. Then the fit goes on where it was, on the
/// processor, and [`Engine::trouble`] says so.
pub struct GpuEngine {
    pipeline: Pipeline,
    scene: Option<Scene>,
    /// Entries of `coverage` and of the gradient to it that have been asked for since the last iteration.
    coverage: Vec<OnceCell<Vec<f32>>>,
    d_coverage: Vec<OnceCell<Vec<f32>>>,
    d_points_image: Vec<[f32; 4]>,
    instead: Option<(CpuEngine, Error)>,
}

impl GpuEngine {
    /// Compiles all stages and checks that the device computes what the processor does.
    ///
    /// # Errors
    /// [`Error::Device`] if it takes a stage badly or computes something else.
    pub fn new(device: &Device) -> Result<GpuEngine> {
        let mut engine = GpuEngine::unchecked(device, BATCH)?;
        check::self_check(&mut engine)?;
        Ok(engine)
    }

    /// Without the check, with up to `batch` iterations a submission.
    ///
    /// # Errors
    /// [`Error::Device`] if it takes a stage badly.
    pub fn unchecked(device: &Device, batch: usize) -> Result<GpuEngine> {
        Ok(GpuEngine {
            pipeline: Pipeline::new(device, batch)?,
            scene: None,
            coverage: Vec::new(),
            d_coverage: Vec::new(),
            d_points_image: Vec::new(),
            instead: None,
        })
    }

    /// The device it was made for.
    pub fn device(&self) -> &Device {
        self.pipeline.device()
    }

    /// Goes on on the processor.
    fn leave(&mut self, error: Error) -> &mut CpuEngine {
        let mut cpu = CpuEngine::new();
        if let Some(scene) = self.scene.take() {
            cpu.load(scene);
        }
        &mut self.instead.insert((cpu, error)).0
    }

    /// Runs stages up to `last` for each of `steps` from `state` on and hands over what was asked for; once more if
    /// there was not room enough.
    fn run(
        &mut self,
        last: &str,
        state: &[&[[f32; 4]]],
        count: u32,
        steps: &[Step],
        terms: &mut [f32],
        wanted: &[Slot],
    ) -> Result<Vec<Vec<[f32; 4]>>> {
        let views = self.scene.as_ref().map_or(0, |scene| scene.views.len());
        let points = state[0].len();
        let row = term_count(views) + 1;
        loop {
            self.pipeline.write(Slot::State, &state.concat())?;
            self.pipeline.run("sample", last, steps, count)?;
            let mut ranges: Vec<(Slot, Range<usize>)> = vec![(Slot::Terms, 0..4 * row * steps.len())];
            ranges.extend(wanted.iter().map(|&slot| {
                let values = if slot == Slot::State { 3 * points } else { points };
                (slot, 0..16 * values)
            }));
            let mut bytes = self.pipeline.read_bytes(&ranges)?.into_iter();
            let found: Vec<f32> = bytes.next().map(|bytes| bytemuck::pod_collect_to_vec(&bytes)).unwrap_or_default();
            // The last entry of a row says how many cell entries were wanted.
            let entries = found.chunks_exact(row).map(|row| row[row.len() - 1] as usize).max().unwrap_or(0);
            if entries > self.pipeline.room() {
                self.pipeline.make_room(entries + entries / 4)?;
                continue;
            }
            for (terms, found) in terms.chunks_exact_mut(row - 1).zip(found.chunks_exact(row)) {
                terms.copy_from_slice(&found[..row - 1]);
            }
            for cell in self.coverage.iter_mut().chain(&mut self.d_coverage) {
                cell.take();
            }
            return Ok(bytes.map(|bytes| bytemuck::pod_collect_to_vec(&bytes)).collect());
        }
    }

    fn try_evaluate(
        &mut self,
        points: &[[f32; 4]],
        step: &Step,
        terms: &mut [f32],
        d_points: &mut Vec<[f32; 4]>,
    ) -> Result<()> {
        let wanted = [Slot::DPoints, Slot::DPointsImage];
        let mut parts = self.run("add_terms", &[points], 0, std::slice::from_ref(step), terms, &wanted)?.into_iter();
        *d_points = parts.next().unwrap_or_default();
        self.d_points_image = parts.next().unwrap_or_default();
        Ok(())
    }

    fn try_advance(&mut self, state: &mut State, steps: &[Step], terms: &mut [f32]) -> Result<()> {
        let points = state.points.len();
        let mut ahead = state.clone();
        let row = terms.len() / steps.len().max(1);
        for (steps, terms) in steps.chunks(self.pipeline.batch()).zip(terms.chunks_mut(row * self.pipeline.batch())) {
            let before = [&*ahead.points, &*ahead.adam.first, &*ahead.adam.second];
            let wanted = [Slot::State, Slot::DPointsImage];
            let mut parts = self.run("adam", &before, ahead.adam.count, steps, terms, &wanted)?.into_iter();
            let packed = parts.next().unwrap_or_default();
            ahead.points.copy_from_slice(&packed[..points]);
            ahead.adam.first.copy_from_slice(&packed[points..2 * points]);
            ahead.adam.second.copy_from_slice(&packed[2 * points..]);
            ahead.adam.count += steps.len() as u32;
            self.d_points_image = parts.next().unwrap_or_default();
        }
        *state = ahead;
        Ok(())
    }

    /// One view's share of a buffer that has an entry a pixel, read when it is asked for.
    fn picture<'a>(&self, slot: Slot, view: usize, kept: &'a [OnceCell<Vec<f32>>]) -> &'a [f32] {
        kept[view].get_or_init(|| {
            let views = self.scene.as_ref().map_or(&[][..], |scene| &scene.views);
            let size = |v: usize| views[v].target.data.len();
            let first: usize = (0..view).map(size).sum();
            let range = 4 * first..4 * (first + size(view));
            match self.pipeline.read_bytes(&[(slot, range)]) {
                Ok(bytes) => bytemuck::pod_collect_to_vec(&bytes[0]),
                // A lost device: the next iteration meets it too, and says so.
                Err(_) => vec![0.0; size(view)],
            }
        })
    }
}

impl Engine for GpuEngine {
    fn load(&mut self, scene: Scene) {
        if let Some((cpu, _)) = &mut self.instead {
            cpu.load(scene);
            return;
        }
        self.coverage = scene.views.iter().map(|_| OnceCell::new()).collect();
        self.d_coverage = self.coverage.clone();
        let loaded = self.pipeline.load(&scene);
        self.scene = Some(scene);
        if let Err(error) = loaded {
            self.leave(error);
        }
    }

    fn set_target(&mut self, view: usize, ink: &[f32]) {
        if let Some((cpu, _)) = &mut self.instead {
            return cpu.set_target(view, ink);
        }
        let Some(scene) = &mut self.scene else { return };
        scene.views[view].target.data.copy_from_slice(ink);
        let first = scene.views[..view].iter().map(|view| view.target.data.len()).sum();
        if let Err(error) = self.pipeline.write_at(Slot::TargetInk, first, ink) {
            self.leave(error);
        }
    }

    fn evaluate(&mut self, points: &[[f32; 4]], step: &Step, terms: &mut [f32], d_points: &mut Vec<[f32; 4]>) {
        if let Some((cpu, _)) = &mut self.instead {
            return cpu.evaluate(points, step, terms, d_points);
        }
        if let Err(error) = self.try_evaluate(points, step, terms, d_points) {
            self.leave(error).evaluate(points, step, terms, d_points);
        }
    }

    fn coverage(&self, view: usize) -> &[f32] {
        match &self.instead {
            Some((cpu, _)) => cpu.coverage(view),
            None => self.picture(Slot::Coverage, view, &self.coverage),
        }
    }

    fn d_coverage(&self, view: usize) -> &[f32] {
        match &self.instead {
            Some((cpu, _)) => cpu.d_coverage(view),
            None => self.picture(Slot::Pyramid, view, &self.d_coverage),
        }
    }

    fn d_points_image(&self) -> &[[f32; 4]] {
        match &self.instead {
            Some((cpu, _)) => cpu.d_points_image(),
            None => &self.d_points_image,
        }
    }

    fn batch(&self) -> usize {
        if self.instead.is_some() { 1 } else { self.pipeline.batch() }
    }

    fn advance(&mut self, state: &mut State, steps: &[Step], terms: &mut [f32], d_points: &mut Vec<[f32; 4]>) {
        if let Some((cpu, _)) = &mut self.instead {
            return cpu.advance(state, steps, terms, d_points);
        }
        if let Err(error) = self.try_advance(state, steps, terms) {
            self.leave(error).advance(state, steps, terms, d_points);
        }
    }

    fn place(&self) -> Place {
        match &self.instead {
            Some((cpu, _)) => cpu.place(),
            None => Place {
                backend: "gpu",
                device: self.device().info().to_string(),
                why: "The graphics card does the work.".into(),
            },
        }
    }

    fn trouble(&self) -> Option<&Error> {
        self.instead.as_ref().map(|(_, error)| error)
    }
}
