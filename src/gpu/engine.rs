//! The engine on a device: many iterations a call, one read back at the end of each, and what happens when it fails.

use super::fault::{Answer, Fault, FaultKind};
use super::pipeline::Pipeline;
use super::stage::Slot;
use super::{Absence, Device, now_ms};
use crate::Error;
use crate::optimize::{CpuEngine, Engine, Picture, Place, Scene, State, Step, Tally, Work, term_count};
use std::ops::Range;

/// Iterations a call, at most.
const BATCH: usize = 64;

/// Where another device comes from when one is lost.
pub type Another = Box<dyn Fn() -> Work<'static, Result<Device, Absence>> + Send>;

/// Computes on a device, every stage with the exact rasteriser: the band only saves time on a processor.
///
/// A device can be lost, or turn out too small, in the middle of a fit. Then the fit goes on from the state before that
/// call: on another device, or, the second time, on the processor. [`Engine::place`] says so.
pub struct GpuEngine {
    now: Now,
    scene: Option<Scene>,
    another: Another,
    losses: u32,
    why: String,
    trouble: Option<Error>,
    /// What was last evaluated, to draw it again on another device.
    evaluated: Option<(Vec<[f32; 4]>, Step)>,
    /// Pictures as last fetched, view by view.
    coverage: Vec<Vec<f32>>,
    d_coverage: Vec<Vec<f32>>,
}

/// Where it computes.
enum Now {
    Device(Box<Pipeline>),
    Processor(Box<CpuEngine>),
}

impl GpuEngine {
    /// On a device that has passed its check, and on another of the same kind should it be lost. `why` is a sentence for
    /// people.
    pub fn new(device: &Device, why: impl Into<String>) -> GpuEngine {
        let kind = device.kind();
        let another = move || Work::later(Device::acquire_async(kind));
        GpuEngine::with_another(device, BATCH, why.into(), Box::new(another))
    }

    /// With up to `batch` iterations a call and a source of devices of one's choice.
    pub fn with_another(device: &Device, batch: usize, why: String, another: Another) -> GpuEngine {
        GpuEngine {
            now: Now::Device(Box::new(Pipeline::new(device, batch))),
            scene: None,
            another,
            losses: 0,
            why,
            trouble: None,
            evaluated: None,
            coverage: Vec::new(),
            d_coverage: Vec::new(),
        }
    }

    /// Finds a place to go on in after a fault.
    async fn recover(&mut self, fault: Fault) {
        let Now::Device(pipeline) = &self.now else { return };
        let smaller = pipeline.batch() / 8;
        let next = match fault.kind {
            FaultKind::Limits => None,
            FaultKind::Memory if smaller > 0 => {
                pipeline.device().forgive();
                Some(Pipeline::new(pipeline.device(), smaller))
            }
            FaultKind::Memory => None,
            FaultKind::Lost => {
                self.losses += 1;
                match self.losses {
                    1 => self.renewed(pipeline.batch()).await,
                    _ => None,
                }
            }
        };
        self.why = match (fault.kind, &next) {
            (FaultKind::Lost, Some(_)) => "The graphics card was lost for a moment; the fit went on from where it was.",
            (FaultKind::Lost, None) => "The graphics card was lost; the processor has taken over from where it was.",
            (FaultKind::Memory, Some(_)) => "The graphics card is short of memory and does the work in smaller pieces.",
            (FaultKind::Memory | FaultKind::Limits, _) => {
                "This fit is more than the graphics card takes, so the processor does the work."
            }
        }
        .into();
        if next.is_none() && fault.kind != FaultKind::Lost {
            self.why = format!("{} ({}.)", self.why, fault.problem);
        }
        self.now = match next {
            Some(pipeline) => Now::Device(Box::new(pipeline)),
            None => {
                let mut cpu = CpuEngine::because(&*self.why);
                if let Some(scene) = &self.scene {
                    cpu.load(scene.clone()).done().await;
                }
                Now::Processor(Box::new(cpu))
            }
        };
        self.trouble.get_or_insert(fault.into());
        if let (Now::Device(pipeline), Some(scene)) = (&mut self.now, &self.scene)
            && let Err(fault) = pipeline.load_async(scene).await
        {
            Box::pin(self.recover(fault)).await;
        }
    }

    /// A pipeline on another device, if there is one.
    async fn renewed(&self, batch: usize) -> Option<Pipeline> {
        (self.another)().done().await.ok().map(|device| Pipeline::new(&device, batch))
    }

    /// Draws again what another device does not know.
    async fn evaluate_again(&mut self) {
        let Some((points, step)) = self.evaluated.clone() else { return };
        let views = self.scene.as_ref().map_or(0, |scene| scene.views.len());
        self.evaluate(&points, &step, &mut vec![0.0; term_count(views)], &mut Vec::new()).done().await;
    }
}

/// Runs stages up to `last` for each of `steps` from the state in the buffers on and hands over the terms and what else
/// was asked for; None if there was not room enough, which there is now.
async fn run(
    pipeline: &mut Pipeline,
    last: &str,
    count: u32,
    steps: &[Step],
    terms: &mut [f32],
    wanted: &[(Slot, Range<usize>)],
) -> Answer<Option<Vec<Vec<u8>>>> {
    let row = terms.len() / steps.len().max(1) + 1;
    let begin_ms = now_ms();
    pipeline.run("sample", last, steps, count)?;
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

async fn evaluate(
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
        if let Some(parts) = run(pipeline, "add_terms", 0, std::slice::from_ref(step), terms, &wanted).await? {
            *d_points = bytemuck::pod_collect_to_vec(&parts[0]);
            return Ok(());
        }
    }
}

async fn advance(
    pipeline: &mut Pipeline,
    state: &mut State,
    tally: &mut Tally,
    steps: &[Step],
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
        let Some(parts) = run(pipeline, "adam", adam.count, steps, terms, &wanted).await? else { continue };
        let packed: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&parts[0]);
        points.copy_from_slice(&packed[..count]);
        adam.first.copy_from_slice(&packed[count..2 * count]);
        adam.second.copy_from_slice(&packed[2 * count..]);
        adam.count += steps.len() as u32;
        let best: Vec<[f32; 4]> = bytemuck::pod_collect_to_vec(&parts[1]);
        if best[0][0] < tally.best_loss {
            tally.best_loss = best[0][0];
            tally.best_points.clear();
            tally.best_points.extend_from_slice(&best[1..]);
        }
        tally.gradient_norms = bytemuck::pod_collect_to_vec(&parts[2]);
        return Ok(());
    }
}

/// All views' shares of a buffer that has an entry a pixel.
async fn fetch(pipeline: &mut Pipeline, slot: Slot, scene: &Scene) -> Answer<Vec<Vec<f32>>> {
    let mut first = 0;
    let views = scene.views.iter().map(|view| {
        let range = first..first + size_of_val(&*view.target.data);
        first = range.end;
        (slot, range)
    });
    let parts = pipeline.read_bytes(&views.collect::<Vec<_>>()).await?;
    Ok(parts.iter().map(|bytes| bytemuck::pod_collect_to_vec(bytes)).collect())
}

impl Engine for GpuEngine {
    fn load(&mut self, scene: Scene) -> Work<'_> {
        let blank = || scene.views.iter().map(|view| vec![0.0; view.target.data.len()]).collect();
        (self.coverage, self.d_coverage, self.evaluated) = (blank(), blank(), None);
        Work::later(async {
            let loaded = match &mut self.now {
                Now::Processor(cpu) => return cpu.load(scene).done().await,
                Now::Device(pipeline) => pipeline.load_async(&scene).await,
            };
            self.scene = Some(scene);
            if let Err(fault) = loaded {
                self.recover(fault).await;
            }
        })
    }

    fn set_target(&mut self, view: usize, ink: &[f32]) {
        match &mut self.now {
            Now::Processor(cpu) => cpu.set_target(view, ink),
            Now::Device(pipeline) => {
                let Some(scene) = &mut self.scene else { return };
                scene.views[view].target.data.copy_from_slice(ink);
                let first = scene.views[..view].iter().map(|view| view.target.data.len()).sum();
                // If that fails the next call does too, and starts from the scene.
                let _ = pipeline.write_at(Slot::TargetInk, first, ink);
            }
        }
    }

    fn evaluate<'a>(
        &'a mut self,
        points: &'a [[f32; 4]],
        step: &'a Step,
        terms: &'a mut [f32],
        d_points: &'a mut Vec<[f32; 4]>,
    ) -> Work<'a> {
        Work::later(async move {
            self.evaluated = Some((points.to_vec(), *step));
            loop {
                let evaluated = match &mut self.now {
                    Now::Processor(cpu) => return cpu.evaluate(points, step, terms, d_points).done().await,
                    Now::Device(pipeline) => evaluate(pipeline, points, step, terms, d_points).await,
                };
                match evaluated {
                    Ok(()) => return,
                    Err(fault) => self.recover(fault).await,
                }
            }
        })
    }

    fn advance<'a>(
        &'a mut self,
        state: &'a mut State,
        tally: &'a mut Tally,
        steps: &'a [Step],
        terms: &'a mut [f32],
    ) -> Work<'a> {
        Work::later(async move {
            self.evaluated = None;
            let row = terms.len() / steps.len().max(1);
            let mut done = 0;
            while done < steps.len() {
                let (steps, terms) = (&steps[done..], &mut terms[row * done..]);
                let advanced = match &mut self.now {
                    Now::Processor(cpu) => return cpu.advance(state, tally, steps, terms).done().await,
                    Now::Device(pipeline) => {
                        let count = steps.len().min(pipeline.batch());
                        let advanced =
                            advance(pipeline, state, tally, &steps[..count], &mut terms[..row * count]).await;
                        advanced.map(|()| count)
                    }
                };
                match advanced {
                    Ok(count) => done += count,
                    Err(fault) => self.recover(fault).await,
                }
            }
        })
    }

    fn fetch(&mut self, picture: Picture) -> Work<'_> {
        Work::later(async move {
            let slot = match picture {
                Picture::Coverage => Slot::Coverage,
                Picture::DCoverage => Slot::Pyramid,
            };
            let (Now::Device(pipeline), Some(scene)) = (&mut self.now, &self.scene) else { return };
            let fetched = match fetch(pipeline, slot, scene).await {
                Ok(fetched) => fetched,
                Err(fault) => {
                    self.recover(fault).await;
                    // Of iterations that have moved on nothing is left: blank pictures, which pull at nothing.
                    self.evaluate_again().await;
                    let (Now::Device(pipeline), Some(scene), true) =
                        (&mut self.now, &self.scene, self.evaluated.is_some())
                    else {
                        let blank = |view: &Vec<f32>| vec![0.0; view.len()];
                        self.coverage = self.coverage.iter().map(blank).collect();
                        self.d_coverage = self.coverage.clone();
                        return;
                    };
                    fetch(pipeline, slot, scene).await.unwrap_or_else(|_| self.coverage.clone())
                }
            };
            match picture {
                Picture::Coverage => self.coverage = fetched,
                Picture::DCoverage => self.d_coverage = fetched,
            }
        })
    }

    fn picture(&self, picture: Picture, view: usize) -> &[f32] {
        match (&self.now, picture) {
            (Now::Processor(cpu), _) => cpu.picture(picture, view),
            (Now::Device(_), Picture::Coverage) => &self.coverage[view],
            (Now::Device(_), Picture::DCoverage) => &self.d_coverage[view],
        }
    }

    fn batch(&self) -> usize {
        match &self.now {
            Now::Processor(cpu) => cpu.batch(),
            Now::Device(_) => BATCH,
        }
    }

    fn place(&self) -> Place {
        match &self.now {
            Now::Processor(cpu) => cpu.place(),
            Now::Device(pipeline) => {
                Place { backend: "gpu", device: pipeline.device().info().to_string(), why: self.why.clone() }
            }
        }
    }

    fn trouble(&self) -> Option<&Error> {
        self.trouble.as_ref()
    }
}
