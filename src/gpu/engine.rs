//! The engine on a device, and what happens when the device fails.

use super::calls::{Lookers, Views, advance, evaluate, fetch};
use super::fault::{Fault, FaultKind};
use super::pipeline::Pipeline;
use super::stage::Slot;
use super::{Absence, Device};
use crate::Error;
use crate::objective::{Neighbours, Rendered};
use crate::optimize::{CpuEngine, Engine, Picture, Place, Scene, SceneView, State, Step, Tally, Work, term_count};

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
    /// The views of the coming iterations, where they are others than the scene's.
    ahead: Vec<Vec<SceneView>>,
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
            ahead: Vec::new(),
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
                    let ahead = std::mem::take(&mut self.ahead);
                    if !ahead.is_empty() {
                        let sets = std::iter::once(scene.views.clone()).chain(ahead).collect();
                        cpu.set_views(sets).done().await;
                    }
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

/// The views of a scene that something looks at, blank; none where nothing does.
fn shown(scene: Option<&Scene>) -> Vec<Rendered> {
    let Some(scene) = scene.filter(|scene| !scene.guides.is_empty()) else { return Vec::new() };
    let blank = |SceneView { camera, target, weight, texture_mask, .. }: &SceneView| {
        let mut blank = Rendered::new(*camera, target.width, target.height, *weight);
        blank.count(texture_mask.as_ref());
        blank
    };
    scene.views.iter().map(blank).collect()
}

/// Who looks at those.
fn lookers<'a>(scene: Option<&'a Scene>, shown: &'a mut [Rendered]) -> Option<Lookers<'a>> {
    let guides = &scene?.guides;
    (!shown.is_empty()).then_some(Lookers { guides, shown })
}

impl Engine for GpuEngine {
    fn load(&mut self, scene: Scene) -> Work<'_> {
        let blank = || scene.views.iter().map(|view| vec![0.0; view.target.data.len()]).collect();
        (self.coverage, self.d_coverage, self.evaluated) = (blank(), blank(), None);
        self.ahead.clear();
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
                // If that fails the next call does too, and starts from the scene.
                let _ = pipeline.set_target(view, ink);
            }
        }
    }

    fn set_views(&mut self, mut sets: Vec<Vec<SceneView>>) -> Work<'_> {
        match &mut self.now {
            Now::Processor(cpu) => cpu.set_views(sets),
            Now::Device(pipeline) => {
                if sets.is_empty() {
                    return Work::Done(());
                }
                let views = sets.remove(0);
                // Likewise.
                let _ = pipeline.set_views(&views);
                if let Some(scene) = &mut self.scene {
                    scene.views = views;
                }
                self.ahead = sets;
                Work::Done(())
            }
        }
    }

    fn set_planes(&mut self, planes: Vec<[f32; 4]>) {
        match &mut self.now {
            Now::Processor(cpu) => cpu.set_planes(planes),
            Now::Device(pipeline) => {
                // Likewise.
                let _ = pipeline.set_planes(&planes);
                if let Some(scene) = &mut self.scene {
                    scene.planes = planes;
                }
            }
        }
    }

    fn set_neighbours(&mut self, neighbours: Neighbours) {
        match &mut self.now {
            Now::Processor(cpu) => cpu.set_neighbours(neighbours),
            Now::Device(pipeline) => {
                // Likewise.
                let _ = pipeline.set_neighbours(&neighbours);
                if let Some(scene) = &mut self.scene {
                    scene.neighbours = neighbours;
                }
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
                    Now::Device(pipeline) => {
                        let mut shown = shown(self.scene.as_ref());
                        let lookers = lookers(self.scene.as_ref(), &mut shown);
                        evaluate(pipeline, points, step, lookers, terms, d_points).await
                    }
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
                        let mut shown = shown(self.scene.as_ref());
                        let lookers = lookers(self.scene.as_ref(), &mut shown);
                        let most = if lookers.is_some() { 1 } else { pipeline.batch() };
                        let count = steps.len().min(most);
                        let ahead = &self.ahead[..count.min(self.ahead.len())];
                        let steps = &steps[..count];
                        let advanced = match &self.scene {
                            Some(scene) => {
                                let views = Views { now: &scene.views, ahead };
                                let terms = &mut terms[..row * count];
                                advance(pipeline, state, tally, steps, views, lookers, terms).await
                            }
                            None => Err(pipeline.no_scene()),
                        };
                        advanced.map(|()| count)
                    }
                };
                match advanced {
                    Ok(count) => {
                        done += count;
                        let seen = self.ahead.drain(..count.min(self.ahead.len())).next_back();
                        if let Some((views, scene)) = seen.zip(self.scene.as_mut()) {
                            scene.views = views;
                        }
                    }
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
