//! From a photograph to the wire: what was pointed at, in lines, in one piece and in the round.

use crate::scenes::{SIDE, Scene, photograph, twelve};
use wire4d::Error;
use wire4d::picture::Picture;
use wire4d::settings::{Settings, Task};
use wire4d::tasks::Run;
use wire4d::tasks::stroke::{Given, find, plan};

fn picture(scene: &Scene) -> Picture {
    let made = photograph(scene);
    let rgba = made.rgb.chunks_exact(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
    Picture::new(made.name, SIDE, SIDE, rgba).unwrap()
}

fn settings(more: &[(&str, &str)]) -> Settings {
    let small = [("preset", "fast"), ("backend", "cpu"), ("iterations", "60")];
    Task::Stroke.settings(small.iter().chain(more).copied().collect::<Vec<_>>()).unwrap()
}

/// The mug, with a box round it.
fn mug() -> Given {
    Given { bounds: Some([90.0, 100.0, 460.0, 440.0]), ..Given::picture(picture(&twelve()[5])) }
}

#[test]
fn a_mug_becomes_a_wire_of_its_lines_in_one_piece() {
    let plan = plan(&mug(), &settings(&[])).unwrap();
    assert!(plan.notes().iter().any(|note| note.contains("photograph")), "{:?}", plan.notes());
    let mut run = Run::start(plan, &mut |_| true).unwrap();
    run.step(usize::MAX).unwrap();
    let result = run.result();
    let front = &result.views[0];
    assert!(front.precision_2px.unwrap() > 0.95 && front.recall_2px.unwrap() > 0.95, "{front:?}");
    assert_eq!(result.shape.components, 1);
    let depths: Vec<f64> = run.sculpture().wire.control_points().iter().map(|point| point[2]).collect();
    let [near, far] = [f64::max, f64::min].map(|of| depths.iter().copied().reduce(of).unwrap());
    assert!(near - far > 0.1, "in the round: {far} to {near}");
}

#[test]
fn more_lines_are_more_ink_and_tone_fills() {
    let ink = |more: &[(&str, &str)]| -> f32 {
        let plan = plan(&mug(), &settings(more)).unwrap();
        plan.targets[0].ink.data.iter().sum()
    };
    let (three, ten, tone) = (ink(&[("lines", "3")]), ink(&[("lines", "10")]), ink(&[("read", "tone")]));
    assert!(three < ten && ten < tone, "{three} {ten} {tone}");
    assert_eq!(ink(&[("shade", "full")]), tone);
    assert!(ink(&[("shade", "none"), ("lines", "10"), ("outline", "1.5")]) < ten, "thinner lines are less");
}

#[test]
fn a_box_says_which_thing_and_one_that_cannot_be_is_refused() {
    let found = find(&mug(), &settings(&[])).unwrap();
    assert!(found.is_drawn && found.unseen.is_none(), "{}", found.sure);
    let inside = |x: usize, y: usize| found.object.mask.at(x, y) > 0.5;
    assert!(inside(250, 300) && !inside(40, 40));
    for bounds in [[600.0, 0.0, 700.0, 90.0], [200.0, 200.0, 200.0, 300.0], [f64::NAN, 0.0, 9.0, 9.0]] {
        let refused = find(&Given { bounds: Some(bounds), ..mug() }, &settings(&[]));
        assert!(matches!(refused.err(), Some(Error::Setting { name, .. }) if name == "box"), "{bounds:?}");
    }
}
