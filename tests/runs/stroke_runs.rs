//! One picture to a stroke, end to end on small generated pictures.

use wire4d::metrics::{ResultReport, TimeReport};
use wire4d::picture::Picture;
use wire4d::settings::{Settings, Task};
use wire4d::tasks::Run;
use wire4d::tasks::stroke::{Given, Plan, plan};
use wire4d::view::{Image, ViewSpec};

const SIDE: usize = 96;

/// From a shade (0 to 255) for each place, both coordinates from -1 to 1, y up.
fn picture(name: &str, shade: impl Fn(f64, f64) -> f64) -> Picture {
    let place = |p: usize| 2.0 * (p as f64 + 0.5) / SIDE as f64 - 1.0;
    let pixel = |i: usize| {
        let shade = shade(place(i % SIDE), -place(i / SIDE)).clamp(0.0, 255.0) as u8;
        [shade, shade, shade, 255]
    };
    Picture::new(name, SIDE, SIDE, (0..SIDE * SIDE).flat_map(pixel).collect()).unwrap()
}

/// A ball lit from the upper left.
fn ball() -> Picture {
    picture("ball.png", |x, y| match 0.5 - x * x - y * y {
        z if z > 0.0 => 40.0 + 160.0 * (0.6 * z.sqrt() - 0.5 * x + 0.5 * y).max(0.0),
        _ => 250.0,
    })
}

/// The letter T, black on white.
fn letter() -> Picture {
    picture("t.png", |x, y| {
        if x.abs() < 0.15 && y < 0.7 && y > -0.7 || x.abs() < 0.6 && (y - 0.6).abs() < 0.15 { 0.0 } else { 255.0 }
    })
}

fn quick(pairs: &[(&str, &str)]) -> Settings {
    let quick = [("backend", "cpu"), ("preset", "fast"), ("iterations", "60"), ("size", "128"), ("side-views", "3")];
    let pairs: Vec<_> = quick.iter().chain(pairs).copied().collect();
    Task::Stroke.settings(pairs).unwrap()
}

fn planned(picture: Picture, settings: &Settings) -> Plan {
    plan(&Given::picture(picture), settings).unwrap()
}

fn finished(plan: Plan) -> Run {
    let mut run = Run::start(plan, &mut |_| true).unwrap();
    run.step(usize::MAX).unwrap();
    run
}

fn result(picture: Picture, settings: &Settings) -> ResultReport {
    finished(planned(picture, settings)).result()
}

#[test]
fn pictures_are_shown_from_the_front_and_solids_from_the_sides() {
    let settings = quick(&[]);
    for picture in [ball(), letter()] {
        let name = picture.name().to_owned();
        let run = finished(planned(picture, &settings));
        let report = run.report(TimeReport::default(), false);
        assert_eq!((report.task.as_str(), report.stopped), ("stroke", false));
        assert_eq!((report.arrangement.len(), report.arrangement[0].source.as_str()), (1, name.as_str()));
        let [front, sides @ ..] = &report.result.views[..] else { panic!("no views") };
        assert!(front.soft_iou > Some(0.8), "{name}: {:?}", front.soft_iou);
        assert_eq!(sides.len(), 3);
        for side in sides {
            assert!(side.precision_2px > Some(0.9), "{name} {}: {:?}", side.name, side.precision_2px);
        }
        assert_eq!(report.result.shape.components, 1, "{name} is one wire");
        assert!(report.events.iter().any(|event| event.kind == "done"));
        assert!(run.loss_csv().lines().count() == 61);
    }
}

#[test]
fn the_seed_decides_and_a_checkpoint_goes_on() {
    let settings = quick(&[("iterations", "24")]);
    let whole = finished(planned(ball(), &settings)).sculpture();
    let mut half = Run::start(planned(ball(), &settings), &mut |_| true).unwrap();
    half.step(11).unwrap();
    let mut resumed = Run::resume(planned(ball(), &settings), &half.checkpoint(), &mut |_| true).unwrap();
    resumed.step(usize::MAX).unwrap();
    assert_eq!(resumed.sculpture(), whole);
    assert!(Run::resume(planned(letter(), &settings), &half.checkpoint(), &mut |_| true).is_err());
    let other = quick(&[("iterations", "24"), ("seed", "1")]);
    assert_ne!(finished(planned(ball(), &other)).sculpture().views, whole.views, "other sides");
}

#[test]
fn settings_visibly_work() {
    let ink = |settings: &Settings| planned(ball(), settings).targets[0].ink.data.iter().sum::<f32>();
    assert!(ink(&quick(&[("hatch", "30")])) < 0.8 * ink(&quick(&[("hatch", "10")])));
    assert!(ink(&quick(&[("outline", "8")])) > 1.05 * ink(&quick(&[("outline", "2")])));
    let thickness = |settings: &Settings| planned(ball(), settings).solid.depths(0.0, 0.0)[1];
    assert!(thickness(&quick(&[("roundness", "0.3")])) < 0.6 * thickness(&quick(&[])));
    let few = result(ball(), &quick(&[("control-points", "120")]));
    assert_eq!(few.control_points, 120);
    assert!(few.shape.length < result(ball(), &quick(&[])).shape.length);
    let even = finished(planned(letter(), &quick(&[("min-width", "3"), ("max-width", "3")]))).sculpture();
    let widths = || even.wire.control_points().iter().map(|point| point[3]);
    let [least, most] = [widths().fold(f64::MAX, f64::min), widths().fold(0.0, f64::max)];
    assert!(most - least < 1e-6 * most, "one width: {least} to {most}");
}

/// Two balls, the smaller lighter.
fn pair() -> Picture {
    picture("pair.png", |x, y| match () {
        () if (x + 0.4).hypot(y) < 0.4 => 40.0,
        () if (x - 0.55).hypot(y) < 0.25 => 120.0,
        () => 250.0,
    })
}

#[test]
fn effects_show_in_what_the_front_should_show() {
    // A ball with a dark eye and a highlight.
    let eyed = || {
        picture("eyed.png", |x, y| match x.hypot(y) {
            _ if (x - 0.25).hypot(y) < 0.12 => 20.0,
            _ if (x + 0.25).hypot(y - 0.2) < 0.14 => 255.0,
            r if r < 0.7 => 150.0,
            _ => 225.0,
        })
    };
    let ink = |pairs: &[(&str, &str)], [x, y]: [f64; 2], radius: f64| {
        let pairs: Vec<_> = [("hatch", "10")].iter().chain(pairs).copied().collect();
        let ink = planned(eyed(), &quick(&pairs)).targets[0].ink.clone();
        // The object's box fills the picture but for a margin.
        let place = |p: usize| (2.0 * (p as f64 + 0.5) / 128.0 - 1.0) / (1.0 - 2.0 * 0.08) * 0.7;
        let near = |i: &usize| (place(i % 128) - x).hypot(-place(i / 128) - y) < radius;
        let (sum, count) = (0..128 * 128).filter(near).fold((0.0, 0.0), |(s, n), i| (s + ink.data[i], n + 1.0));
        sum / count
    };
    let (eye, highlight, plain) = ([0.25, 0.0], [-0.25, 0.2], [0.0, -0.4]);
    let (dark, even) = (ink(&[], eye, 0.08), ink(&[("tone", "0"), ("edges", "0")], eye, 0.08));
    assert!(dark > 0.8 && even < 0.6, "{dark} {even}");
    assert!(ink(&[("gloss", "0.8")], highlight, 0.1) < 0.02 && ink(&[("edges", "0")], highlight, 0.1) > 0.05);
    let sparse = ink(&[("saliency", "1"), ("tone", "0")], plain, 0.2);
    let usual = ink(&[("saliency", "0"), ("tone", "0")], plain, 0.2);
    assert!(sparse < usual, "{sparse} {usual}");
    let lines = |hatching: &str| planned(eyed(), &quick(&[("hatching", hatching)])).targets[0].ink.clone();
    assert_ne!(lines("contours"), lines("slices"));
}

#[test]
fn the_object_that_is_chosen_is_drawn() {
    let tone = |object: &str| {
        let object = planned(pair(), &quick(&[("object", object)])).object;
        object.tone.data.iter().copied().fold(0.0, f32::max)
    };
    assert!(tone("2") < 0.7 * tone("1"), "the smaller is lighter");
    let error = plan(&Given::picture(pair()), &quick(&[("object", "3")])).unwrap_err();
    assert!(error.is_bad_input() && error.to_string().contains("2 objects in pair.png"), "{error}");
}

#[test]
fn creases_ask_for_the_solids_outline_from_the_sides() {
    // What the sides ask for shows in the fit: more of each side's outline is met.
    let ink_on_outline = |creases: &str| {
        let settings = quick(&[("creases", creases), ("hatch", "40")]);
        let made = finished(planned(ball(), &settings)).sculpture();
        let solid = planned(ball(), &settings).solid;
        let each = made.views[1..].iter().map(|view| {
            let shown = wire4d::sculpture::render(&made.wire, view);
            let wanted = solid.shown(view).creases(2.0);
            shown.data.iter().zip(&wanted.data).map(|(a, b)| a * b).sum::<f32>()
        });
        each.sum::<f32>()
    };
    let (with, without) = (ink_on_outline("1"), ink_on_outline("0"));
    assert!(with > 1.02 * without, "{with} {without}");
}

#[test]
fn the_papers_way_runs_and_refines() {
    let pairs = [("preset", "paper"), ("backend", "cpu"), ("iterations", "30"), ("size", "96"), ("side-views", "2")];
    let settings = Task::Stroke.settings(pairs).unwrap();
    let report = finished(planned(ball(), &settings)).report(TimeReport::default(), false);
    let happened: Vec<_> =
        report.events.iter().map(|event| (event.kind.as_str(), event.iteration)).filter(|it| it.0 != "stage").collect();
    assert_eq!(happened, [("reinit", 5), ("reinit", 10), ("refine", 20), ("done", 30)]);
    assert!(report.result.control_points > 200, "{}", report.result.control_points);
}

#[test]
fn more_sides_depth_and_masks_are_used() {
    let settings = quick(&[]);
    let side = |azimuth_deg: f64| ViewSpec::Direction { azimuth_deg, elevation_deg: 0.0 };
    let thin = picture("thin.png", |x, y| if x.abs() < 0.12 && y * y < 0.5 { 0.0 } else { 255.0 });
    let mut given = Given::picture(ball());
    given.others = vec![(thin, side(90.0))];
    let carved = plan(&given, &settings).unwrap();
    let round = planned(ball(), &settings);
    assert!(carved.solid.depths(0.0, 0.0)[1] < 0.5 * round.solid.depths(0.0, 0.0)[1]);
    assert_eq!((carved.targets[1].view.name.as_str(), carved.targets.len()), ("90,0", 5));

    let mut given = Given::picture(ball());
    given.depth = Some(picture("depth.png", |x, _| 128.0 + 120.0 * x));
    let sloping = plan(&given, &settings).unwrap().solid;
    assert!(sloping.depths(0.4, 0.0)[1] > sloping.depths(-0.4, 0.0)[1] + 0.1);
    given.depth = Some(Picture::new("small.png", 2, 1, vec![9; 8]).unwrap());
    let error = plan(&given, &settings).unwrap_err().to_string();
    assert!(error.starts_with("small.png") && error.contains("same size"), "{error}");

    let mut given = Given::picture(ball());
    let mut left = Image::new(SIDE, SIDE);
    (0..SIDE * SIDE)
        .filter(|i| i % SIDE < SIDE / 2 && i % SIDE > 20)
        .for_each(|i| left.data[i] = f32::from(i / SIDE > 20 && i / SIDE < 70));
    given.mask = Some(left);
    assert!(plan(&given, &settings).unwrap().object.mask.at(60, 48) == 0.0);
}

#[test]
fn bad_pictures_are_refused_by_name() {
    let settings = quick(&[]);
    let bad = [
        picture("plain.png", |_, _| 80.0),
        Picture::new("dot.png", 1, 1, vec![0, 0, 0, 255]).unwrap(),
        picture("speck.png", |x, y| if x.hypot(y) < 0.03 { 0.0 } else { 255.0 }),
        Picture::new(
            "full.png",
            SIDE,
            SIDE,
            (0..SIDE * SIDE).flat_map(|i| [9, 9, 9, 255 * u8::from(i % 99 > 0)]).collect(),
        )
        .unwrap(),
        Picture::new("clear.png", SIDE, SIDE, vec![0; 4 * SIDE * SIDE]).unwrap(),
    ];
    for picture in bad {
        let name = picture.name().to_owned();
        let error = plan(&Given::picture(picture), &settings).err().unwrap_or_else(|| panic!("{name} is taken"));
        assert!(error.is_bad_input() && error.to_string().starts_with(&name), "{error}");
    }
    // A drawing in hair lines, and one hair line alone.
    let hairs = picture("hairs.png", |x, y| {
        let on = |r: f64| (x.hypot(y) - r).abs() < 0.011;
        if on(0.7) || (x - 0.2).hypot(y).min((x + 0.2).hypot(y)) < 0.03 || y.abs() < 0.011 && x.abs() < 0.7 {
            0.0
        } else {
            255.0
        }
    });
    let found = result(hairs, &settings);
    assert!(found.views[0].soft_iou > Some(0.6) && found.shape.components == 1, "{:?}", found.views[0]);
    let hair = picture("hair.png", |x, y| if x.abs() < 0.011 && y.abs() < 0.8 { 0.0 } else { 255.0 });
    assert!(result(hair, &settings).views[0].soft_iou > Some(0.3), "a line one pixel wide is a thing too");
}

#[test]
fn sides_change_as_the_run_goes_and_a_checkpoint_knows_which() {
    let settings = quick(&[("iterations", "24"), ("new-sides", "8")]);
    let directions = |run: &Run| -> Vec<_> {
        let targets = run.session().problem().targets.iter();
        targets.map(|target| target.view.camera::<f64>().project(&[0.3, 0.2, 0.1, 0.1])).collect()
    };
    let start = || Run::start(planned(ball(), &settings), &mut |_| true).unwrap();
    let mut run = start();
    let mut seen = Vec::new();
    for _ in 0..3 {
        run.step(8).unwrap();
        seen.push(directions(&run));
    }
    for (a, b) in [(0, 1), (1, 2), (0, 2)] {
        assert_eq!(seen[a][0], seen[b][0], "the front stays");
        assert!(seen[a][1..].iter().zip(&seen[b][1..]).all(|(a, b)| a != b), "the sides change");
    }
    let measured: Vec<_> = run.targets()[1..].iter().map(|target| target.view.name.clone()).collect();
    assert!(measured.iter().all(|name| name.contains(',')), "measured from sides that stay: {measured:?}");
    // Interrupted before, at and after a change, in steps of any size.
    let whole = run.sculpture();
    for interrupted in [7, 8, 13] {
        let mut half = start();
        half.step(interrupted).unwrap();
        let mut resumed = Run::resume(planned(ball(), &settings), &half.checkpoint(), &mut |_| true).unwrap();
        while !resumed.session().is_done() {
            resumed.step(5).unwrap();
        }
        assert_eq!(resumed.sculpture(), whole, "interrupted after {interrupted}");
    }
    // Sibling: without the changes it is another wire.
    let kept = quick(&[("iterations", "24"), ("new-sides", "0")]);
    let mut other = finished(planned(ball(), &kept)).sculpture();
    other.made_with = whole.made_with.clone();
    assert_ne!(other, whole);
}
