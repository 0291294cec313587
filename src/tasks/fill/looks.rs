//! From where a mesh is looked at: five sides for the report, and during the fit sides a little turned every time.

use crate::rng::Rng;
use crate::settings::{Looks, Settings};
use crate::view::{Projection, View};

/// Name, azimuth and elevation in degrees. Eyes a little above the middle; the top's a little off the pole, where "up"
/// would be undecided.
const SIDES: [(&str, f64, f64); 5] =
    [("front", 0.0, 5.7), ("right", 90.0, 5.7), ("back", 180.0, 5.7), ("left", 270.0, 5.7), ("top", 0.0, 88.0)];
const FOV_Y_DEG: f64 = 45.0;

/// A perspective view of the origin, three units away.
fn view(name: &str, azimuth_deg: f64, elevation_deg: f64, size_px: usize) -> View {
    let parallel = View::orthographic(name, azimuth_deg.to_radians(), elevation_deg.to_radians(), 1.0, size_px);
    View { projection: Projection::Perspective { fov_y_rad: FOV_Y_DEG.to_radians() }, ..parallel }
}

/// The sides that are reported.
pub(super) fn sides(size_px: usize) -> Vec<View> {
    SIDES.iter().map(|&(name, azimuth, elevation)| view(name, azimuth, elevation, size_px)).collect()
}

/// The views of iteration `iteration`, drawn from the seed. Sides come in turn, in another order every round, so that
/// each is seen equally often.
pub(super) fn drawn(iteration: usize, settings: &Settings) -> Vec<View> {
    let count = settings.views_at_once;
    (0..count).map(|k| one(iteration * count + k, &format!("view {}", k + 1), settings)).collect()
}

fn one(index: usize, name: &str, settings: &Settings) -> View {
    let mut rng = Rng::new(settings.seed, 0x6c6f_6f6b_0000_0000 + index as u64);
    if settings.looks == Looks::Sphere {
        let elevation = rng.range(-1.0, 1.0).asin().to_degrees();
        return view(name, rng.range(0.0, 360.0), elevation.clamp(-88.0, 88.0), settings.size);
    }
    let (_, azimuth, elevation) = SIDES[order(index / SIDES.len(), settings.seed)[index % SIDES.len()]];
    let mut turned = |angle: f64| angle + settings.jitter * rng.range(-1.0, 1.0);
    view(name, turned(azimuth), turned(elevation).min(88.0), settings.size)
}

/// The order of the sides in round `round`.
fn order(round: usize, seed: u64) -> [usize; SIDES.len()] {
    let mut rng = Rng::new(seed, 0x726f_756e_0000_0000 + round as u64);
    let mut order = std::array::from_fn(|k| k);
    for k in (1..order.len()).rev() {
        order.swap(k, (rng.unit() * (k + 1) as f64) as usize);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::{Preset, Task};

    #[test]
    fn every_side_is_seen_equally_often_and_never_twice_alike() {
        let settings = Settings { views_at_once: 2, ..Task::Fill.preset(Preset::Best) };
        let views: Vec<View> = (0..50).flat_map(|iteration| drawn(iteration, &settings)).collect();
        let cosine = |a: &View, b: &View| (0..3).map(|c| a.eye[c] * b.eye[c]).sum::<f64>() / 9.0;
        for side in sides(64) {
            let near = views.iter().filter(|view| cosine(&side, view) > 0.8).count();
            assert_eq!(near, 20, "{}", side.name);
        }
        for (i, view) in views.iter().enumerate() {
            assert!(view.check().is_ok() && views[..i].iter().all(|other| other.eye != view.eye));
        }
        assert_eq!(drawn(7, &settings), drawn(7, &settings));
        assert_ne!(drawn(7, &settings)[0].eye, drawn(7, &Settings { seed: 1, ..settings })[0].eye);
    }

    #[test]
    fn from_anywhere_means_from_anywhere() {
        let settings = Settings { looks: Looks::Sphere, views_at_once: 4, ..Task::Fill.preset(Preset::Best) };
        let eyes: Vec<[f64; 3]> =
            (0..200).flat_map(|iteration| drawn(iteration, &settings)).map(|view| view.eye).collect();
        for c in 0..3 {
            let mean = eyes.iter().map(|eye| eye[c]).sum::<f64>() / eyes.len() as f64;
            let square = eyes.iter().map(|eye| eye[c].powi(2)).sum::<f64>() / eyes.len() as f64;
            assert!(mean.abs() < 0.25 && (square - 3.0).abs() < 0.4, "{mean} {square}");
        }
    }
}
