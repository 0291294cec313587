//! Settings for a mesh to be covered.

use crate::settings::{Flow, Motif, OnOff, Preset, Settings, Start};
use crate::tasks::settings::{TaskSettings, one_thing};
use crate::{Error, Result};

pub(in crate::tasks) const OWN: TaskSettings = TaskSettings { preset, check };

/// The preset, with the wire kept smooth or not.
fn preset(preset: Preset, smooth: OnOff) -> Settings {
    let several = Settings { start: Start::Stripes, ..one_thing(preset, smooth) };
    // Lines lie evenly on the surface already; they are to be bent a little and made thicker and thinner.
    let best = Settings {
        iterations: 300,
        min_width: 0.6,
        max_width: 7.0,
        position_rate: 0.2,
        width_rate: 0.1,
        smoothness: if smooth == OnOff::On { 1.0 } else { 6.0 },
        coarse_share: 0.0,
        level_weight: 1.0,
        ..several.clone()
    };
    match preset {
        Preset::Best => best,
        Preset::Fast => Settings { iterations: 100, size: 192, ..best },
        Preset::Paper => Settings {
            iterations: 251,
            control_points: 1100,
            density: 0.6,
            min_width: 0.0,
            max_width: 8.7,
            motif: Motif::Off,
            flow: Flow::Smooth,
            position_rate: 0.25,
            reinit: false,
            refine: false,
            ..several
        },
    }
}

/// Refuses strands that do not fit side by side.
fn check(settings: &Settings) -> Result<()> {
    if settings.smooth == OnOff::Off {
        return Ok(());
    }
    // World units a pixel: the ball of radius 1 fills about 200 px of 256.
    let spacing_px = settings.curve_spacing * 100.0;
    if settings.min_width > spacing_px {
        let problem = format!("strands at least {} px wide do not fit side by side", settings.min_width);
        let remedy = format!("give at most {spacing_px:.1}, a wider curve_spacing, or --smooth off");
        return Err(Error::setting("min_width", problem, remedy));
    }
    Ok(())
}
