//! Whole fits of sets of drawings with the preset `fast`: their figures must not fall below floors that lie a little under
//! what was measured, with the wire kept smooth and without.
use std::path::Path;
use wire4d::picture::read_picture;
use wire4d::settings::{Bend, OnOff, Preset, Settings, Start, Task};
use wire4d::tasks::Run;
use wire4d::tasks::multiview::{Drawing, plan};

/// Means over the views, each 0 to 1, and the number of parts the wire falls into.
#[derive(Debug, Clone, Copy)]
struct Figures {
    kinks: usize,
    tight_share: f64,
    penetrating_share: f64,
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
            && self.kinks <= floors.kinks
            && self.tight_share <= floors.tight_share
            && self.penetrating_share <= floors.penetrating_share
    }
}

fn fit(set: &str, settings: &Settings) -> Figures {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/drawings").join(set);
    let files = ["front", "side", "top"].map(|view| folder.join(view).with_extension("png"));
    let drawings: Vec<Drawing> = files
        .iter()
        .filter(|file| file.is_file())
        .map(|file| Drawing::new(&read_picture(file).unwrap(), None, settings).unwrap().0)
        .collect();
    let mut run = Run::start(plan(&drawings, settings).unwrap(), &mut |_| true).unwrap();
    run.step(settings.iterations).unwrap();
    let result = run.result();
    let mean = |figure: fn(&wire4d::metrics::ViewReport) -> Option<f64>| {
        result.views.iter().map(|view| figure(view).unwrap()).sum::<f64>() / result.views.len() as f64
    };
    let runs = result.shape.elegance;
    let found = Figures {
        kinks: runs.kinks,
        tight_share: runs.tight_share,
        penetrating_share: runs.penetrating_share,
        soft_iou: mean(|view| view.soft_iou),
        precision_2px: mean(|view| view.precision_2px),
        recall_2px: mean(|view| view.recall_2px),
        components: result.shape.components,
    };
    println!("{set}, bend {:?}, start {:?}: {found:.4?}", settings.bend, settings.start);
    found
}

const PAIR: &str = "p02-garden";
/// Floors of pictures alone: no bars for how the wire runs.
const fn floors(soft_iou: f64, precision_2px: f64, recall_2px: f64) -> Figures {
    let anything = 1.0;
    Figures {
        kinks: usize::MAX,
        tight_share: anything,
        penetrating_share: anything,
        soft_iou,
        precision_2px,
        recall_2px,
        components: 1,
    }
}

const PAIR_FLOORS: Figures = floors(0.91, 0.96, 0.98);

/// The preset that follows every line.
fn fast_lines(bend: Bend) -> Settings {
    Settings { bend, ..Task::Multiview.preset_with(Preset::Fast, OnOff::Off) }
}

#[test]
fn fast_fits_are_as_good_as_they_were() {
    for (set, bend, floors) in [
        ("t02-bold-letters", Bend::None, floors(0.96, 0.975, 0.98)),
        ("t05-hair-lines", Bend::Little, floors(0.63, 0.91, 0.98)),
        ("t07-outlines", Bend::None, floors(0.63, 0.77, 0.98)),
        (PAIR, Bend::None, PAIR_FLOORS),
    ] {
        let found = fit(set, &fast_lines(bend));
        assert!(found.reach(&floors), "{set}: {found:.4?} falls short of {floors:?}");
    }
}

#[test]
fn fast_wires_are_wires_and_still_recognised() {
    let fast = Settings { bend: Bend::None, ..Task::Multiview.preset(Preset::Fast) };
    for (set, least) in [(PAIR, floors(0.76, 0.92, 0.95)), ("t10-thin-letters", floors(0.7, 0.85, 0.93))] {
        let bars = Figures { kinks: 3, tight_share: 0.006, penetrating_share: 0.02, ..least };
        let found = fit(set, &fast);
        assert!(found.reach(&bars), "{set}: {found:.4?} falls short of {bars:?}");
        // Without what keeps it a wire it is none.
        let found = fit(set, &Settings { tightness: 0.0, clearance: 0.0, smoothness: 0.01, ..fast.clone() });
        assert!(!found.reach(&bars), "{set}: the bars would accept {found:.4?}");
    }
}

#[test]
fn crippled_fits_fall_short() {
    let fast = fast_lines(Bend::None);
    for (what, settings) in [
        ("hardly fitted", Settings { iterations: 2, ..fast.clone() }),
        ("started from a ball", Settings { start: Start::Ball, iterations: 40, ..fast.clone() }),
        ("on a grid too coarse", Settings { grid: 16, iterations: 60, ..fast.clone() }),
    ] {
        let found = fit(PAIR, &settings);
        assert!(!found.reach(&PAIR_FLOORS), "{what}: the floors would accept {found:.4?}");
    }
}
