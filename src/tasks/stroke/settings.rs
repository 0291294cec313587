//! Settings for one picture.

use crate::settings::{OnOff, Preset, Settings, Shading, Start};
use crate::tasks::settings::{TaskSettings, one_thing};

pub(in crate::tasks) const OWN: TaskSettings = TaskSettings { preset, check: |_| Ok(()) };

/// The preset, with the wire kept smooth or not.
fn preset(preset: Preset, smooth: OnOff) -> Settings {
    let several = Settings { start: Start::Contour, ..one_thing(preset, smooth) };
    // The first wire lies along the lines already: small steps keep it there, but for the ends of lines that must open.
    let (iterations, position_rate) = if smooth == OnOff::On { (400, 0.5) } else { (320, 0.2) };
    let best =
        Settings { iterations, spacing: 4.0, position_rate, width_rate: 0.08, coarse_share: 0.3, ..several.clone() };
    match preset {
        Preset::Best => best,
        Preset::Fast => Settings { iterations: 120, spacing: 6.0, hatch: 16.0, side_views: 4, ..best },
        // Refined once, 120 control points become 220.
        Preset::Paper => Settings { control_points: 120, start: Start::Hull, shading: Shading::Grey, ..several },
    }
}
