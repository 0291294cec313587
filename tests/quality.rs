//! Whole fits of four sets of drawings with the preset `fast`: their figures must not fall below floors that lie a
//! little under what was measured.
#![cfg(feature = "cli")]

use std::path::Path;
use wire4d::picture::read_picture;
use wire4d::settings::{Bend, Preset, Settings, Start};
use wire4d::tasks::multiview::{Drawing, Run, plan};

/// Means over the views, each 0 to 1, and the number of parts the wire falls into.
#[derive(Debug, Clone, Copy)]
struct Figures {
    soft_iou: f64,
    precision_2px: f64,
    recall_2px: f64,
    components: usize,
}

impl Figures {
    fn reach(&self, floors: &Figures) -> bool {
        self.soft_iou >= floors.soft_iou
            && self.precision_2px >= floors.precision_2px
            && self.recall_2px >= floors.recall_2px
            && self.components <= floors.components
    }
}

fn fit(set: &str, settings: &Settings) -> Figures {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/drawings").join(set);
    let files = ["front", "side", "top"].map(|view| folder.join(view).with_extension("png"));
    let drawings: Vec<Drawing> = files
        .iter()
        .filter(|file| file.is_file())
        .map(|file| Drawing::new(&read_picture(file).unwrap(), None, settings).unwrap())
        .collect();
    let mut run = Run::start(plan(&drawings, settings).unwrap(), settings, &mut |_| true).unwrap();
    run.step(settings.iterations);
    let result = run.result();
    let mean = |figure: fn(&wire4d::metrics::ViewReport) -> Option<f64>| {
        result.views.iter().map(|view| figure(view).unwrap()).sum::<f64>() / result.views.len() as f64
    };
    let found = Figures {
        soft_iou: mean(|view| view.soft_iou),
        precision_2px: mean(|view| view.precision_2px),
        recall_2px: mean(|view| view.recall_2px),
        components: result.shape.components,
    };
    println!("{set}, bend {:?}, start {:?}: {found:.4?}", settings.bend, settings.start);
    found
}

const PAIR: &str = "p02-garden";
const PAIR_FLOORS: Figures = Figures { soft_iou: 0.91, precision_2px: 0.96, recall_2px: 0.98, components: 1 };

#[test]
fn fast_fits_are_as_good_as_they_were() {
    let floors = |soft_iou, precision_2px, recall_2px| Figures { soft_iou, precision_2px, recall_2px, components: 1 };
    for (set, bend, floors) in [
        ("t02-bold-letters", Bend::None, floors(0.96, 0.975, 0.98)),
        ("t05-hair-lines", Bend::Little, floors(0.63, 0.91, 0.98)),
        ("t07-outlines", Bend::None, floors(0.63, 0.77, 0.98)),
        (PAIR, Bend::None, PAIR_FLOORS),
    ] {
        let found = fit(set, &Settings { bend, ..Settings::preset(Preset::Fast) });
        assert!(found.reach(&floors), "{set}: {found:.4?} falls short of {floors:?}");
    }
}

#[test]
fn crippled_fits_fall_short() {
    let fast = Settings { bend: Bend::None, ..Settings::preset(Preset::Fast) };
    for (what, settings) in [
        ("hardly fitted", Settings { iterations: 2, ..fast.clone() }),
        ("started from a ball", Settings { start: Start::Ball, iterations: 40, ..fast.clone() }),
        ("on a grid too coarse", Settings { grid: 16, iterations: 60, ..fast.clone() }),
    ] {
        let found = fit(PAIR, &settings);
        assert!(!found.reach(&PAIR_FLOORS), "{what}: the floors would accept {found:.4?}");
    }
}
