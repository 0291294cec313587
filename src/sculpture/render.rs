//! What a view shows of a wire: coverage as metrics, pictures and the page use it.

use crate::raster::{ExactRaster, Raster};
use crate::view::{Image, Occluder, View, drop_hidden};
use crate::wire::Wire;

/// Samples a knot span for reported pictures and figures: chords are within 0.2 px of the curve at 512 px.
pub const SAMPLES_PER_SPAN: usize = 16;

/// Coverage (0 to 1) of the wire in `view`, at the view's own size ([`View::with_size`] gives others).
pub fn render(wire: &Wire, view: &View) -> Image {
    render_sampled(wire, view, SAMPLES_PER_SPAN)
}

/// [`render`] with another number of samples a knot span: fewer are faster, and enough where spans are short.
pub fn render_sampled(wire: &Wire, view: &View, samples_per_span: usize) -> Image {
    drawn(wire, view, None, samples_per_span)
}

/// [`render`] without what an occluder of the view's size hides.
pub fn render_seen(wire: &Wire, view: &View, occluder: &Occluder) -> Image {
    drawn(wire, view, Some(occluder), SAMPLES_PER_SPAN)
}

fn drawn(wire: &Wire, view: &View, occluder: Option<&Occluder>, samples_per_span: usize) -> Image {
    let (map, strokes) = wire.sampling_map::<f64>(samples_per_span, true);
    let mut points = Vec::new();
    map.apply(wire.control_points(), &mut points);
    let camera = view.camera::<f64>();
    let mut vertices: Vec<[f32; 3]> = points.iter().map(|point| camera.project(point).map(|c| c as f32)).collect();
    if let Some(occluder) = occluder {
        let seen = |point, [x, y, _]: [f32; 3]| occluder.visibility([x, y], camera.depth(point) as f32);
        let visibilities: Vec<f32> = points.iter().zip(&vertices).map(|(point, vertex)| seen(point, *vertex)).collect();
        vertices.iter_mut().zip(&visibilities).for_each(|([_, _, radius], visibility)| *radius *= visibility);
        drop_hidden(&visibilities, &strokes, &mut vertices);
    }
    let mut raster = ExactRaster::default();
    let data = raster.forward(view.width_px, view.height_px, &vertices, &strokes).to_vec();
    Image { width: view.width_px, height: view.height_px, data }
}
