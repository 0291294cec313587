//! From a scene to the bytes of the buffers that stay the same until the next one.

use super::banded::Map;
use super::device::Device;
use super::fault::{Answer, Fault, FaultKind};
use super::layout::{self, Level, MOST_LEVELS, MOST_VIEWS, RINGS, View};
use super::stage::{NODES, outline_groups};
use super::strand::StrandUpload;
use super::texture::TextureUpload;
use crate::objective::{Pyramid, STANDSTILL, level_sizes};
use crate::optimize::{Scene, SceneView, Step};
use crate::raster::{CELL_PX, rings};
use crate::view::Occluder;
use crate::wire::Stroke;

/// No such sample.
const NONE: u32 = u32::MAX;
/// Cell entries there is room for at first. Most polygons touch one to four cells.
const ENTRIES_A_POLYGON: usize = 6;
/// The depth of the ground: not every device knows infinity.
const GROUND_DEPTH: f32 = 1e9;
/// Values a workgroup of the loss sums up.
pub(super) const LOSS_GROUP: usize = 256;
/// The largest level of a pyramid that is left to a single workgroup: 64 x 64 take it about as long as a pass more.
const COARSE: usize = 4096;

/// What shaders know of a scene, and how much room its buffers take.
pub(super) struct Upload {
    pub scene: layout::Scene,
    pub sampling: Map,
    pub jerk: Map,
    pub links: Vec<[u32; 2]>,
    pub levels: Vec<Level>,
    pub circles: Vec<[f32; 2]>,
    pub target_ink: Vec<f32>,
    /// Empty where nothing hides anything.
    pub occluder_depth: Vec<f32>,
    pub planes: Vec<[f32; 4]>,
    pub texture: TextureUpload,
    pub strand: StrandUpload,
    /// Entries of the pyramid, the loss's partial sums, the rows of all pictures.
    pub pyramid: usize,
    pub partials: usize,
    pub rows: usize,
    /// The most levels of any view that take a pass each.
    pub depth: usize,
}

/// Previous and next sample of each; both itself where it is in no stroke.
fn links(strokes: &[Stroke], count: usize) -> Vec<[u32; 2]> {
    let mut links: Vec<[u32; 2]> = (0..count as u32).map(|k| [k, k]).collect();
    for stroke in strokes {
        let (start, end) = (stroke.start, (stroke.start + stroke.count).min(count));
        let closed = stroke.closed && end > start + 1;
        for k in start..end {
            let around = |inside: bool, next: usize, other: usize| match (inside, closed) {
                (true, _) => next as u32,
                (false, true) => other as u32,
                (false, false) => NONE,
            };
            links[k] = [around(k > start, k.wrapping_sub(1), end - 1), around(k + 1 < end, k + 1, start)];
        }
    }
    links
}

impl Upload {
    /// # Errors
    /// A fault of limits if the scene has more views, pixels or samples than shaders take.
    pub fn new(from: &Scene, device: &Device) -> Answer<Upload> {
        let refuse = |what: &str, wanted: usize, most: usize| -> Fault {
            device.fault(FaultKind::Limits, format!("the fit takes {wanted} {what} and this device {most}"))
        };
        let count = from.views.len();
        if count > MOST_VIEWS {
            return Err(refuse("views", count, MOST_VIEWS));
        }
        let mut scene: layout::Scene = bytemuck::Zeroable::zeroed();
        let mut levels = vec![Level::default(); MOST_LEVELS * count.max(1)];
        let (mut pixels, mut rows, mut cells) = (0, 0, 0);
        let most_groups = device.device.limits().max_compute_workgroups_per_dimension as usize;
        for (v, view) in from.views.iter().enumerate() {
            let (width, height) = (view.target.width, view.target.height);
            let groups = (width * height).div_ceil(LOSS_GROUP).max(height);
            if groups > most_groups {
                return Err(refuse("pixels a view", width * height, most_groups * LOSS_GROUP));
            }
            let (columns, cell_rows) = (width.div_ceil(CELL_PX as usize), height.div_ceil(CELL_PX as usize));
            scene.view[v] = View {
                width: width as u32,
                height: height as u32,
                first_pixel: pixels as u32,
                first_row: rows as u32,
                first_cell: cells as u32,
                columns: columns as u32,
                rows: cell_rows as u32,
                ..View::default()
            };
            pixels += width * height;
            rows += height;
            cells += columns * cell_rows;
        }
        // Level 0 of all views first, so that it is indexed as their pictures are.
        let (mut offset, mut partials, mut depth) = (pixels, count, 0);
        for (v, view) in from.views.iter().enumerate() {
            let sizes = level_sizes(view.target.width, view.target.height);
            let fine = sizes.iter().skip(1).take_while(|(width, height)| width * height > COARSE).count() + 1;
            let packed = &mut scene.view[v];
            (packed.levels, packed.fine_levels) = (sizes.len() as u32, fine as u32);
            (packed.first_partial, packed.partials) = (v as u32, 1);
            for (l, &(width, height)) in sizes.iter().enumerate() {
                let at = if l == 0 { packed.first_pixel as usize } else { offset };
                levels[v * MOST_LEVELS + l] = Level {
                    offset: at as u32,
                    width: width as u32,
                    height: height as u32,
                    first_partial: partials as u32,
                };
                offset += if l == 0 { 0 } else { width * height };
                partials += if l < fine { (width * height).div_ceil(LOSS_GROUP) } else { 0 };
            }
            depth = depth.max(fine);
        }
        scene.surface_partial = partials as u32;
        let samples = from.sampling.rows().len();
        // The widest dispatches: the outline's, and a workgroup a control point.
        if outline_groups(samples, rows) > most_groups {
            return Err(refuse("samples", samples, most_groups / outline_groups(NODES, 0) * NODES));
        }
        if from.sampling.columns() > most_groups {
            return Err(refuse("control points", from.sampling.columns(), most_groups));
        }
        let mut circles: Vec<[f32; 2]> = Vec::new();
        for (packed, ring) in scene.rings.iter_mut().zip(rings()) {
            *packed = [circles.len() as f32, ring.normals.len() as f32, ring.stretch, ring.half_side];
            circles.extend(ring.normals);
        }
        debug_assert_eq!(rings().count(), RINGS);
        scene.points = from.sampling.columns() as u32;
        scene.samples = samples as u32;
        scene.views = count as u32;
        scene.spans = from.jerk.spans() as u32;
        scene.pixels = pixels as u32;
        scene.cells = cells as u32;
        scene.entries = (ENTRIES_A_POLYGON * 2 * samples * count + cells) as u32;
        scene.gaussian = u32::from(from.pyramid == Pyramid::Gaussian);
        scene.planes = from.planes.len() as u32;
        let texture = TextureUpload::new(from);
        scene.texture_partial = partials as u32 + 1;
        scene.texture_levels = texture.a_view as u32;
        let partials = partials + 1 + texture.levels.len();
        let strand = StrandUpload::new(from);
        scene.node_partial = partials as u32;
        scene.nodes = strand.nodes.len() as u32;
        let partials = partials + 4 * strand.nodes.len().div_ceil(LOSS_GROUP);
        let mut upload = Upload {
            scene,
            sampling: Map::new(&from.sampling),
            jerk: Map::new(from.jerk.rows()),
            links: links(&from.strokes, samples),
            levels,
            circles,
            target_ink: Vec::new(),
            occluder_depth: Vec::new(),
            planes: from.planes.clone(),
            texture,
            strand,
            pyramid: offset,
            partials,
            rows,
            depth,
        };
        upload.set_views(&from.views);
        Ok(upload)
    }

    /// What views bring along, where each begins being known.
    pub fn set_views(&mut self, views: &[SceneView]) {
        self.texture.set_views(views);
        self.target_ink.clear();
        self.occluder_depth.clear();
        for (packed, view) in self.scene.view.iter_mut().zip(views) {
            let SceneView { camera, target, weight, occluder, .. } = view;
            (packed.right, packed.down, packed.forward) = (camera.right, camera.down, camera.forward);
            (packed.centre_px, packed.scale) = (camera.centre_px, camera.scale);
            (packed.perspective, packed.weight) = (u32::from(camera.perspective), *weight);
            self.target_ink.extend_from_slice(&target.data);
            (packed.steepness, packed.bias_world) = (0.0, 0.0);
            if let Some(Occluder { depth, steepness, bias_world }) = occluder {
                (packed.steepness, packed.bias_world) = (*steepness, *bias_world);
                // Views before this one may have none.
                self.occluder_depth.resize(packed.first_pixel as usize, GROUND_DEPTH);
                self.occluder_depth.extend(depth.data.iter().map(|z| z.min(GROUND_DEPTH)));
            }
        }
    }
}

/// The numbers of an iteration that has seen `count` steps of Adam, itself included, and writes row `row` of terms.
pub(super) fn pack(step: &Step, count: u32, row: usize) -> layout::Step {
    let Step { elastic, clearance, .. } = step;
    let correction = |beta: f64| (1.0 - beta.powi(count as i32)) as f32;
    layout::Step {
        rates: step.rates,
        width_bounds: step.width_bounds,
        level_ratio: step.level_ratio,
        jerk_position: step.jerk_position,
        jerk_width: step.jerk_width,
        length: step.length,
        beta1: step.adam.beta1 as f32,
        beta2: step.adam.beta2 as f32,
        correction1: correction(step.adam.beta1),
        correction2: correction(step.adam.beta2),
        epsilon: step.adam.epsilon as f32,
        per_point: u32::from(step.adam.second_moment == crate::optimize::SecondMoment::PerPoint),
        row: row as u32,
        loss_scale: step.loss_scale,
        gradient_share: step.gradient_share,
        surface: step.surface,
        texture: step.texture,
        bending: elastic.bending,
        cusp_radius: elastic.cusp_radius,
        tightness: elastic.tightness,
        least_radius: elastic.least_radius,
        least_diameters: elastic.least_diameters,
        evenness: elastic.evenness,
        even_speed: elastic.speed,
        standstill: STANDSTILL as f32 * elastic.speed,
        clearance: clearance.weight,
        clearance_diameters: clearance.diameters,
        least_clearance: clearance.least_world,
        mean_speed: clearance.speed,
        keeps_last: u32::from(step.keeps_last()),
        ..Default::default()
    }
}
