//! From a photograph to the wire: what was pointed at, in lines, in one piece and in the round.

use crate::scenes::{SIDE, Scene, photograph, twelve};
use wire4d::Error;
use wire4d::picture::cut::{SURE, Stroke};
use wire4d::picture::{Ink, Mask, Picture};
use wire4d::settings::{Settings, Task};
use wire4d::tasks::Run;
use wire4d::tasks::stroke::{Given, Kept, Plan, find, look, plan, plan_with};
use wire4d::view::Image;

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
    assert!(near - far > 0.5, "in the round: {far} to {near}");
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

/// A photograph in the middle of one `times` as large, whose border goes on outward.
fn framed(scene: &Scene, times: usize) -> (Given, Given) {
    let made = photograph(scene);
    let size = times * SIDE;
    let inner = |at: usize| at.saturating_sub((size - SIDE) / 2).min(SIDE - 1);
    let places = || (0..size * size).map(|i| inner(i / size) * SIDE + inner(i % size));
    let rgba = places().flat_map(|i| [made.rgb[3 * i], made.rgb[3 * i + 1], made.rgb[3 * i + 2], 255]).collect();
    let whole = |on: &bool| f32::from(*on);
    let mask = Image { width: SIDE, height: SIDE, data: made.mask.iter().map(whole).collect() };
    let large = Image { width: size, height: size, data: places().map(|i| mask.data[i]).collect() };
    let framed = Picture::new(made.name, size, size, rgba).unwrap();
    (
        Given { mask: Some(mask), ..Given::picture(picture(scene)) },
        Given { mask: Some(large), ..Given::picture(framed) },
    )
}

#[test]
fn a_small_object_in_a_large_photograph_is_drawn_as_closely_as_a_large_one() {
    let (alone, framed) = framed(&twelve()[5], 3);
    let settings = settings(&[("read", "lines")]);
    let [near, far] = [alone, framed].map(|given| plan(&given, &settings).unwrap());
    let ink = |plan: &Plan| plan.targets[0].ink.threshold(0.5);
    let (near, far) = (ink(&near), ink(&far));
    let missed = |some: &Mask, of: &Mask| {
        let away = some.distance_px().data;
        let far = of.data.iter().zip(&away).filter(|(on, away)| **on && **away > 4.0).count();
        far as f64 / of.count() as f64
    };
    assert!(missed(&near, &far) < 0.1 && missed(&far, &near) < 0.1, "{} {}", missed(&near, &far), missed(&far, &near));
    assert!((near.count() as f64 / far.count() as f64 - 1.0).abs() < 0.15, "lines as wide");
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

/// A stroke through some places, thin.
fn stroke(points: &[[f32; 2]]) -> Stroke {
    Stroke { points: points.to_vec(), radius_px: 3.0 }
}

#[test]
fn strokes_add_and_take_away_and_nobody_is_asked_then() {
    let area = |given: &Given| find(given, &settings(&[])).unwrap().object.mask.threshold(0.5).count();
    let boxed = area(&mug());
    // The handle is left of the cup's right side.
    let without = Given { ground: vec![stroke(&[[60.0, 20.0], [460.0, 20.0]])], ..mug() };
    assert!(area(&without).abs_diff(boxed) < boxed / 20, "what is ground anyway changes little");
    let body = [[200.0, 220.0], [200.0, 330.0]];
    let less = Given { ground: vec![stroke(&body)], ..mug() };
    let found = find(&less, &settings(&[])).unwrap();
    assert!(found.object.mask.at(200, 280) < 0.5, "a stroke rules");
    assert!(found.sure >= SURE && found.unseen.is_none());
    assert!(area(&less) < boxed);
}

#[test]
fn strokes_alone_say_which_thing_it_is() {
    let taken = photograph(&twelve()[5]);
    let alone = Given::picture(picture(&twelve()[5]));
    let inside = (0..SIDE * SIDE).filter(|&i| taken.mask[i]).map(|i| [(i % SIDE) as f32, (i / SIDE) as f32]);
    let places: Vec<[f32; 2]> = inside.collect();
    let middle = places[places.len() / 2];
    let given = Given { object: vec![stroke(&[middle])], ..alone };
    let found = find(&given, &settings(&[])).unwrap();
    assert!(found.object.mask.at(middle[0] as usize, middle[1] as usize) > 0.5);
    assert_eq!(found.sure, 1.0);
}

#[test]
fn strokes_on_two_things_take_the_one_they_are_on() {
    let rgba = (0..200 * 100).flat_map(|i| {
        let (x, y) = ((i % 200) as f32, (i / 200) as f32);
        let on = |cx: f32, r: f32| (x - cx).hypot(y - 50.0) < r;
        if on(60.0, 30.0) || on(160.0, 12.0) { [30, 60, 90, 255] } else { [240, 240, 236, 255] }
    });
    let two = Given::picture(Picture::new("two.png", 200, 100, rgba.collect()).unwrap());
    let mask = |given: &Given| find(given, &settings(&[])).unwrap().object.mask;
    assert!(mask(&two).at(60, 50) > 0.5 && mask(&two).at(160, 50) < 0.5, "the largest");
    let small = mask(&Given { object: vec![stroke(&[[158.0, 50.0], [162.0, 50.0]])], ..two.clone() });
    assert!(small.at(160, 50) > 0.5 && small.at(60, 50) < 0.5, "the marked one");
    // A quick look sees the same, whatever was looked at before.
    let mut kept = Kept::default();
    for given in [two.clone(), Given { object: vec![stroke(&[[160.0, 50.0]])], ..two.clone() }, two.clone()] {
        let seen = look(&given, &settings(&[]), &mut kept).unwrap();
        let found = find(&given, &settings(&[])).unwrap();
        assert_eq!((seen.outlined.mask, seen.sure), (found.object.mask, found.sure));
    }
}

#[test]
fn a_plan_is_the_same_whatever_was_looked_at_before() {
    let mut kept = Kept::default();
    let mug = mug();
    for shade in ["accent", "full"] {
        let settings = settings(&[("shade", shade)]);
        look(&Given::picture(mug.picture.clone()), &settings, &mut kept).unwrap();
        let [fresh, again] = [plan(&mug, &settings), plan_with(&mug, &settings, &mut kept)].map(Result::unwrap);
        assert_eq!((&fresh.object, &fresh.targets, fresh.notes()), (&again.object, &again.targets, again.notes()));
    }
}

#[test]
fn strokes_that_contradict_each_other_and_empty_masks_are_refused_with_a_way_on() {
    let both = stroke(&[[200.0, 220.0], [200.0, 330.0]]);
    let given = Given { object: vec![both.clone()], ground: vec![both], ..mug() };
    let refused = find(&given, &settings(&[])).err().unwrap();
    assert!(matches!(&refused, Error::Setting { name, .. } if name == "strokes"), "{refused}");
    let empty = Given { mask: Some(Image::new(64, 64)), ..mug() };
    let refused = plan(&empty, &settings(&[])).err().unwrap().to_string();
    assert!(refused.contains("no object") && refused.contains("paint more"), "{refused}");
}
