//! Settings for drawings.

use crate::settings::{Bend, NewPoint, OnOff, Preset, Pyramid, Settings, Start};
use crate::tasks::settings::TaskSettings;

pub(in crate::tasks) const OWN: TaskSettings = TaskSettings { preset, check: |_| Ok(()) };

/// The preset, with the wire kept smooth or not.
fn preset(preset: Preset, smooth: OnOff) -> Settings {
    let best = match smooth {
        OnOff::On => Settings::default(),
        OnOff::Off => Settings {
            smooth,
            start: Start::Tree,
            iterations: 1100,
            spacing: 2.0,
            min_width: 1.0,
            max_width: 20.0,
            position_rate: 0.8,
            width_rate: 0.24,
            coarse_share: 0.55,
            samples: 2,
            ..Settings::default()
        },
    };
    match (preset, smooth) {
        (Preset::Best, _) => best,
        (Preset::Fast, OnOff::On) => Settings { preset, iterations: 200, coarse_share: 0.8, grid: 64, ..best },
        (Preset::Fast, OnOff::Off) => {
            Settings { preset, iterations: 220, coarse_share: 0.8, grid: 64, spacing: 3.5, ..best }
        }
        (Preset::Paper, _) => Settings {
            preset,
            smooth,
            iterations: 900,
            control_points: 220,
            arrange: OnOff::Off,
            min_stroke: 0.0,
            min_width: 0.0,
            max_width: 5.0,
            start: Start::Ball,
            bend: Bend::None,
            reinit: true,
            refine: true,
            samples: 8,
            pyramid: Pyramid::Gaussian,
            level_weight: 1.0,
            position_rate: 0.25,
            width_rate: 0.03,
            coarse_share: 0.0,
            new_point: NewPoint::Random,
            ..self::preset(Preset::Best, OnOff::Off)
        },
    }
}
