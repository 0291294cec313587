//! Bundles of defaults, for each task its own.

use super::Settings;
use super::words::*;

impl Preset {
    /// Whether its wire is kept smooth unless one says otherwise.
    pub fn smooth(self) -> OnOff {
        if self == Preset::Paper { OnOff::Off } else { OnOff::On }
    }
}

impl Settings {
    /// The settings of a preset.
    pub fn preset(preset: Preset) -> Settings {
        Settings::drawings(preset, preset.smooth())
    }

    /// The settings of a preset for drawings, with the wire kept smooth or not.
    pub(super) fn drawings(preset: Preset, smooth: OnOff) -> Settings {
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
                ..Settings::drawings(Preset::Best, OnOff::Off)
            },
        }
    }

    /// What one picture and one mesh share: there is nothing to agree with.
    fn one_thing(preset: Preset, smooth: OnOff) -> Settings {
        Settings { smooth, bend: Bend::None, arrange: OnOff::Off, ..Settings::drawings(preset, OnOff::Off) }
    }

    /// The settings of a preset for one picture.
    pub fn stroke_preset(preset: Preset) -> Settings {
        Settings::picture(preset, preset.smooth())
    }

    pub(super) fn picture(preset: Preset, smooth: OnOff) -> Settings {
        let several = Settings { start: Start::Contour, ..Settings::one_thing(preset, smooth) };
        // The first wire lies along the lines already: small steps keep it there, but for the ends of lines that must open.
        let (iterations, position_rate) = if smooth == OnOff::On { (400, 0.5) } else { (320, 0.2) };
        let best = Settings {
            iterations,
            spacing: 4.0,
            position_rate,
            width_rate: 0.08,
            coarse_share: 0.3,
            ..several.clone()
        };
        match preset {
            Preset::Best => best,
            Preset::Fast => Settings { iterations: 120, spacing: 6.0, hatch: 16.0, side_views: 4, ..best },
            // Refined once, 120 control points become 220.
            Preset::Paper => Settings { control_points: 120, start: Start::Hull, shading: Shading::Grey, ..several },
        }
    }

    /// The settings of a preset for covering a mesh.
    pub fn fill_preset(preset: Preset) -> Settings {
        Settings::mesh(preset, preset.smooth())
    }

    pub(super) fn mesh(preset: Preset, smooth: OnOff) -> Settings {
        let several = Settings { start: Start::Stripes, ..Settings::one_thing(preset, smooth) };
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
}
