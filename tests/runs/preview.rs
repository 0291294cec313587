//! Previews on real drawings: what they promise is what comes.
use std::path::Path;
use wire4d::picture::{Ink, read_picture};
use wire4d::settings::{Bend, Settings, Task};
use wire4d::start::Orientation;
use wire4d::tasks::multiview::preview::{Preview, RemedyKind, SEEN_PX, preview};
use wire4d::tasks::multiview::{Drawing, plan};
use wire4d::view::Image;

fn settings(arrange: &str) -> Settings {
    Task::Multiview.settings([("arrange", arrange)]).unwrap()
}

fn drawings(set: &str) -> Vec<Drawing> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/drawings").join(set);
    let paths = ["front", "side", "top"].map(|view| folder.join(format!("{view}.png")));
    let read = |path: &std::path::PathBuf| Drawing::new(&read_picture(path).unwrap(), None, &settings("on")).unwrap().0;
    paths.iter().filter(|path| path.is_file()).map(read).collect()
}

fn mean(found: &Preview) -> f64 {
    found.drawings.iter().map(|drawing| f64::from(drawing.placed.coverable)).sum::<f64>() / found.drawings.len() as f64
}

#[test]
fn remedies_keep_their_promise() {
    for set in ["t01-animals", "p02-garden"] {
        let given = drawings(set);
        let before = preview(&given, &settings("off")).unwrap();
        assert!((before.coverable - mean(&before)).abs() < 1e-6 && before.coverable == before.as_given);
        assert!(before.remedies.len() <= 5);
        let arranges = before.remedies.iter().any(|remedy| remedy.kind == RemedyKind::Arrange);
        assert_eq!(arranges, preview(&given, &settings("on")).unwrap().coverable >= before.coverable + 0.01);
        assert!(arranges || set != "t01-animals", "a set that nothing helps would prove nothing");
        assert!(before.remedies.windows(2).all(|pair| pair[0].coverable >= pair[1].coverable));
        for remedy in &before.remedies {
            let mut changed = given.clone();
            let mut way = "off";
            let mut turn = |mirrored, quarter_turns| {
                let ink = &mut changed[remedy.sources[0]].ink;
                *ink = Orientation { mirrored, quarter_turns }.applied(ink);
            };
            match remedy.kind {
                RemedyKind::Arrange => way = "on",
                RemedyKind::Mirror => turn(true, 0),
                RemedyKind::Turn => turn(false, remedy.quarter_turns),
                RemedyKind::Swap => changed.swap(remedy.sources[0], remedy.sources[1]),
            }
            let after = plan(&changed, &settings(way)).unwrap().mean_coverable();
            assert!((after - remedy.coverable).abs() < 0.01, "{set} {remedy:?}: {after}");
            assert!(after > before.coverable + 0.005, "{set} {remedy:?} against {}", before.coverable);
        }
    }
}

#[test]
fn pads_show_what_the_fit_will_see() {
    let mut given = drawings("t01-animals");
    // Oblong paper: the drawing beside as much blank paper.
    let wide = given[1].ink.window([0.0, 0.0, 2.0 * given[1].ink.width as f64, given[1].ink.height as f64], 600, 300);
    given[1].ink = wide;
    let found = preview(&given, &settings("on")).unwrap();
    assert!(found.coverable >= found.as_given);
    for (source, (drawing, given)) in found.drawings.iter().zip(&given).enumerate() {
        assert_eq!(drawing.placed.source, Some(source), "in the order given");
        let (seen, missing) = (&drawing.seen, &drawing.missing);
        assert_eq!(seen.width.max(seen.height), SEEN_PX);
        assert_eq!((seen.width, seen.height), (missing.width, missing.height));
        let aspect = |image: &Image| image.width as f64 / image.height as f64;
        assert!((aspect(seen) / aspect(&given.ink) - 1.0).abs() < 0.01, "same aspect");
        assert!(missing.data.iter().zip(&seen.data).all(|(missing, seen)| *missing >= 0.0 && missing <= seen));
        // Thickened lines lie over the drawing's own: nearly all of its ink is in them, and little far from it.
        let ink = given.ink.resized(seen.width, seen.height);
        let near = ink.threshold(0.3).distance_px();
        let (mut strays, mut total, mut met, mut all) = (0.0, 0.0, 0.0, 0.0);
        for (i, &value) in seen.data.iter().enumerate() {
            total += value;
            strays += if near.data[i] <= 4.0 { 0.0 } else { value };
            all += ink.data[i];
            met += ink.data[i].min(value);
        }
        assert!(strays < 0.01 * total && met > 0.9 * all, "{source}: {strays} of {total}, {met} of {all}");
        let share = 1.0 - missing.data.iter().sum::<f32>() / total;
        assert!((share - drawing.placed.coverable).abs() < 0.04, "{share} {}", drawing.placed.coverable);
    }
}

#[test]
fn each_choice_of_bend_is_told_apart() {
    let found = preview(&drawings("t01-animals"), &settings("on")).unwrap();
    let [none, little, free] = &found.bends[..] else { panic!("{:?}", found.bends) };
    assert_eq!((none.bend, none.coverable, none.likeness), (Bend::None, Some(found.coverable), Some(1.0)));
    assert_eq!((little.bend, little.coverable, little.likeness, little.moved_px), (Bend::Little, None, None, None));
    assert!(free.coverable > none.coverable && free.likeness < none.likeness);
    assert!((0.5..8.0).contains(&free.moved_px.unwrap()), "{free:?}");
    let text = serde_json::to_value(&found).unwrap();
    assert!(text["asGiven"].is_number() && text["bends"][2]["movedPx"].is_number(), "{text}");
    assert_eq!(text["bends"][2]["bend"], "free");
    assert!(text["drawings"][0]["quarterTurns"].is_number() && text["drawings"][0]["view"]["name"].is_string());
}

/// An outline that fills a box of a sheet of 256 px.
fn frame(name: &str, width: usize, height: usize) -> Drawing {
    let [left, top] = [128 - width / 2, 128 - height / 2];
    let ink = |i: usize| {
        let (x, y) = ((i % 256).wrapping_sub(left), (i / 256).wrapping_sub(top));
        let inside = x < width && y < height;
        255 * u8::from(inside && !((5..width - 5).contains(&x) && (5..height - 5).contains(&y)))
    };
    Drawing::from_ink(name, 256, 256, &(0..256 * 256).map(ink).collect::<Vec<_>>()).unwrap()
}

#[test]
fn long_and_tall_drawings_keep_their_sizes_or_it_is_said() {
    let given = [frame("car", 220, 60), frame("giraffe", 60, 220)];
    let found = preview(&given, &settings("on")).unwrap();
    let names: Vec<&str> = found.drawings.iter().map(|drawing| drawing.placed.view.name.as_str()).collect();
    assert_eq!(names, ["front", "top"]);
    assert!(found.coverable > 0.99 && found.remedies.is_empty());
    assert!(found.notes.iter().any(|note| note.starts_with("giraffe is seen from the top")), "{:?}", found.notes);
    // Both fill what they would fill alone: a picture less its margins.
    for target in plan(&given, &settings("on")).unwrap().arrangement.targets {
        let ink = target.ink.threshold(0.5).bounding_box().unwrap();
        assert!(ink.width().abs_diff(215) < 4, "{}: {}", target.view.name, ink.width());
    }
    let pinned = preview(&given, &settings("off")).unwrap();
    assert_eq!(pinned.drawings[1].placed.view.name, "side");
    assert!(pinned.notes.iter().any(|note| note.starts_with("side: giraffe is drawn at 27%")), "{:?}", pinned.notes);
}

#[test]
fn a_blank_drawing_is_named() {
    let mut given = drawings("p02-garden");
    given[1] = Drawing::from_ink("Side", 512, 512, &[0; 512 * 512]).unwrap();
    let error = preview(&given, &settings("on")).unwrap_err().to_string();
    assert_eq!(error, "Side: there is no ink to draw; draw something, or use a picture with lines");
    assert!(Drawing::from_ink("Side", 512, 511, &[0; 512 * 512]).is_err());
    assert!(Drawing::from_ink("Side", 0, 0, &[]).is_err());
}
