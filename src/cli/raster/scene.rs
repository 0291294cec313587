//! One 2D scene, as JSON: a polynomial cubic Bézier stroke in pixels, for measuring accuracy and speed.

use wire4d::raster::flatten::{FlatStroke, Subdivision};
use wire4d::raster::{ExactRaster, Raster};
use wire4d::view::Image;
use wire4d::{Error, Result};

/// Chords leave their Bézier by at most this many pixels.
const TOLERANCE_PX: f32 = 0.02;
/// With fewer pieces a Bézier (on average) vertices see too little of the inner control values; moments do.
const LEAST_PIECES_FOR_VERTICES: f32 = 4.0;
/// Largest side of a scene.
pub const MOST_PIXELS_A_SIDE: usize = 8192;
const MOST_CONTROL_VALUES: usize = 100_000;
const FARTHEST_PX: f64 = 1e6;

/// A stroke and the size of the square picture it is drawn in; ink 1 on ground 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Side of the picture in pixels.
    pub size: usize,
    /// Whether the last Bézier ends where the first begins.
    pub closed: bool,
    /// `[x_px, y_px, radius_px]`: 3 a Bézier, and one more at the end if open.
    pub control: Vec<[f32; 3]>,
}

#[derive(serde::Deserialize)]
struct SceneFile {
    bezier_points: Vec<[f64; 2]>,
    bezier_radius: Vec<f64>,
    size: usize,
    #[serde(default)]
    closed: bool,
}

impl Scene {
    /// Reads the JSON of a scene; `name` is for messages.
    ///
    /// # Errors
    /// [`Error::Input`] if it is not such a scene, or its numbers make no sense.
    pub fn from_json(name: &str, json: &[u8]) -> Result<Self> {
        let fail = |problem: String| {
            let remedy =
                "give bezier_points, bezier_radius (3 values a Bézier if closed, 3 n + 1 if open), closed and size";
            Error::input(name, problem, remedy)
        };
        let file: SceneFile =
            serde_json::from_slice(json).map_err(|problem| fail(format!("is no scene ({problem})")))?;
        let SceneFile { bezier_points: points, bezier_radius: radii, size, closed } = file;
        if !(1..=MOST_PIXELS_A_SIDE).contains(&size) {
            return Err(fail(format!("a size of {size} px is not between 1 and {MOST_PIXELS_A_SIDE}")));
        }
        if points.len() != radii.len() {
            return Err(fail(format!("{} points but {} radii", points.len(), radii.len())));
        }
        let whole = if closed { points.len() % 3 == 0 } else { points.len() % 3 == 1 };
        if !whole || points.len() < 3 || points.len() > MOST_CONTROL_VALUES {
            let kind = if closed { "a closed" } else { "an open" };
            return Err(fail(format!("{} points do not make {kind} stroke of cubic Béziers", points.len())));
        }
        if points.iter().flatten().chain(&radii).any(|value| value.abs() > FARTHEST_PX) {
            return Err(fail(format!("a value lies beyond {FARTHEST_PX} px")));
        }
        if radii.iter().any(|&radius| radius < 0.0) {
            return Err(fail("a radius is negative".into()));
        }
        let control = points.iter().zip(&radii).map(|(p, r)| [p[0] as f32, p[1] as f32, *r as f32]).collect();
        Ok(Scene { size, closed, control })
    }
}

/// Draws one scene over and over, with buffers that live across runs.
#[derive(Default)]
pub struct SceneRaster<'a> {
    exact: ExactRaster,
    /// What draws in its place.
    other: Option<&'a mut dyn Raster>,
    flat: FlatStroke,
    d_vertices: Vec<[f32; 3]>,
}

impl<'a> SceneRaster<'a> {
    /// With empty buffers, which grow on the first call.
    pub fn new() -> Self {
        Self::default()
    }

    /// With another rasteriser than the processor's.
    pub fn on(other: &'a mut dyn Raster) -> Self {
        SceneRaster { other: Some(other), ..Self::default() }
    }

    /// Coverage, row by row.
    pub fn forward(&mut self, scene: &Scene) -> &[f32] {
        let SceneRaster { exact, other, flat, .. } = self;
        flat.flatten(&scene.control, scene.closed, Subdivision::Tolerance(TOLERANCE_PX));
        if other.is_some() && flat.pieces_a_bezier() < LEAST_PIECES_FOR_VERTICES {
            // Moments are for the processor alone.
            flat.flatten(&scene.control, scene.closed, Subdivision::Fixed(LEAST_PIECES_FOR_VERTICES as usize));
        }
        let raster = other.as_deref_mut().unwrap_or(exact);
        raster.forward(scene.size, scene.size, flat.vertices(), &flat.strokes())
    }

    /// From the adjoint of the last coverage to that of the control values; overwrites.
    pub fn backward(&mut self, d_coverage: &[f32], d_control: &mut Vec<[f32; 3]>) {
        let SceneRaster { exact, other, flat, d_vertices } = self;
        if other.is_none() && flat.pieces_a_bezier() < LEAST_PIECES_FOR_VERTICES {
            flat.pull_back_moments(exact, d_coverage, d_control);
        } else {
            other.as_deref_mut().unwrap_or(exact).backward(d_coverage, d_vertices);
            flat.pull_back(d_vertices, d_control);
        }
    }
}

/// Mean squared error of `coverage` against `target`, and its adjoint `2 (coverage - target) / pixels` in
/// `d_coverage`.
pub fn mean_squared_error(coverage: &[f32], target: &Image, d_coverage: &mut Vec<f32>) -> f64 {
    let count = coverage.len().max(1) as f64;
    d_coverage.clear();
    d_coverage.extend(coverage.iter().zip(&target.data).map(|(c, t)| (2.0 / count) as f32 * (c - t)));
    coverage.iter().zip(&target.data).map(|(c, t)| f64::from(c - t) * f64::from(c - t)).sum::<f64>() / count
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::few_cases::few_cases;
    use proptest::prelude::*;

    const ARC: &str = r#"{"bezier_points": [[4, 20], [4, 4], [28, 4], [28, 20]], "bezier_radius": [1, 2, 2, 0.5],
        "closed": false, "size": 32, "note": "unknown fields are fine"}"#;

    #[test]
    fn draws_a_scene_and_its_gradient_points_downhill() {
        let mut scene = Scene::from_json("arc.json", ARC.as_bytes()).unwrap();
        let (mut raster, mut d_coverage, mut d_control) = (SceneRaster::new(), Vec::new(), Vec::new());
        let mut shifted = scene.clone();
        shifted.control.iter_mut().for_each(|p| p[1] += 0.4);
        let target = Image { width: 32, height: 32, data: raster.forward(&shifted).to_vec() };
        let loss = mean_squared_error(raster.forward(&scene), &target, &mut d_coverage);
        raster.backward(&d_coverage, &mut d_control);
        let total: f32 = d_control.iter().map(|d| d[1]).sum();
        assert!(loss > 0.0 && total < 0.0, "{loss} {total}");
        for (p, d) in scene.control.iter_mut().zip(&d_control) {
            (0..3).for_each(|c| p[c] -= 5.0 * d[c]);
        }
        assert!(mean_squared_error(raster.forward(&scene), &target, &mut d_coverage) < loss);
    }

    #[test]
    fn bad_scenes_are_named() {
        let broken = [
            "",
            "[]",
            "{}",
            &ARC.replace("32", "0"),
            &ARC.replace("32", "99999"),
            &ARC.replace("32", "-3"),
            &ARC.replace("false", "true"),
            &ARC.replace("[4, 20], ", ""),
            &ARC.replace("0.5]", "-0.5]"),
            &ARC.replace("0.5]", "1e300]"),
            &ARC.replace("[4, 20]", "[4, null]"),
        ];
        for text in broken {
            let error = Scene::from_json("bad.json", text.as_bytes()).unwrap_err();
            assert!(error.is_bad_input() && error.to_string().starts_with("bad.json: "), "{error}");
        }
        assert!(Scene::from_json("arc.json", ARC.as_bytes()).is_ok());
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 500, ..few_cases() })]

        #[test]
        fn any_bytes_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
            prop_assert!(Scene::from_json("any.json", &bytes).unwrap_err().is_bad_input());
        }

        #[test]
        fn damaged_scenes_are_refused_or_can_be_drawn(
            damage in prop::collection::vec((0..ARC.len(), prop::sample::select(b"0123456789-+.eE[]{},: ".to_vec())), 1..4),
        ) {
            let mut bytes = ARC.as_bytes().to_vec();
            for (at, byte) in damage {
                bytes[at] = byte;
            }
            match Scene::from_json("any.json", &bytes) {
                Ok(scene) if scene.size <= 512 => {
                    let mut raster = SceneRaster::new();
                    prop_assert!(raster.forward(&scene).iter().all(|c| (0.0..=1.0).contains(c)));
                }
                Ok(_) => {}
                Err(error) => prop_assert!(error.is_bad_input()),
            }
        }
    }
}
