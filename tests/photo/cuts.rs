//! Objects cut out of the twelve photographs.

use crate::judge::{PHOTOS, next_stroke};
use crate::photo_judge::{box_round, overlap};
use crate::scenes::SIDE;
use wire4d::Error;
use wire4d::picture::cut::{Cutter, Hints, SURE, Stroke};

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn least(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

#[test]
fn a_box_finds_the_object_and_four_strokes_mend_what_is_wrong() {
    let (mut boxed, mut stroked) = (Vec::new(), Vec::new());
    for (taken, photo) in PHOTOS.iter() {
        let mut cutter = Cutter::new(photo.clone());
        let mut hints = Hints { bounds: Some(box_round(&taken.mask, 0.12)), ..Hints::default() };
        let mut cut = cutter.cut(&hints).unwrap();
        let with_box = overlap(&taken.mask, &cut.mask);
        boxed.push(with_box);
        for _ in 0..4 {
            let Some((object, stroke)) = next_stroke(&taken.mask, &cut.mask) else { break };
            if object {
                hints.object.push(stroke)
            } else {
                hints.ground.push(stroke)
            }
            cut = cutter.cut(&hints).unwrap();
        }
        stroked.push(overlap(&taken.mask, &cut.mask));
        println!("{:20} box {with_box:.3}  four strokes {:.3}", taken.name, stroked[stroked.len() - 1]);
        // Nothing depends on what was asked before.
        assert_eq!(Cutter::new(photo.clone()).cut(&hints).unwrap(), cut);
    }
    println!("box {:.3}, worst {:.3}", mean(&boxed), least(&boxed));
    println!("four strokes {:.3}, worst {:.3}", mean(&stroked), least(&stroked));
    assert!(mean(&boxed) >= 0.93 && least(&boxed) >= 0.82);
    assert!(mean(&stroked) >= 0.97 && least(&stroked) >= 0.93);
}

#[test]
fn without_a_hint_what_is_sure_is_right() {
    let mut sure = Vec::new();
    for (taken, photo) in PHOTOS.iter() {
        let cut = Cutter::new(photo.clone()).cut(&Hints::default()).unwrap();
        println!("{:20} {:.3}, sure {:.2}", taken.name, overlap(&taken.mask, &cut.mask), cut.sure);
        assert_eq!(cut.sure < SURE, !cut.notes.is_empty(), "{:?}", cut.notes);
        if cut.sure >= SURE {
            sure.push(overlap(&taken.mask, &cut.mask));
        }
    }
    assert!(sure.len() >= 6 && mean(&sure) >= 0.95 && least(&sure) >= 0.85, "{sure:?}");
}

#[test]
fn the_hole_of_a_handle_stays_open() {
    let (taken, photo) = &PHOTOS[5];
    let hints = Hints { bounds: Some(box_round(&taken.mask, 0.12)), ..Hints::default() };
    let cut = Cutter::new(photo.clone()).cut(&hints).unwrap();
    let row = 290 * SIDE;
    let on = |x: usize| cut.mask.data[row + x] > 0.5;
    assert_eq!((1..SIDE).filter(|&x| on(x) != on(x - 1)).count(), 4);
}

fn dot(x: f32, y: f32) -> Stroke {
    Stroke { points: vec![[x, y]], radius_px: 4.0 }
}

#[test]
fn hints_that_cannot_be_meant_are_refused_with_a_way_on() {
    let (_, photo) = &PHOTOS[0];
    let mut cutter = Cutter::new(photo.clone());
    let boxed = |bounds: [f32; 4]| Hints { bounds: Some(bounds), ..Hints::default() };
    for (hints, name, problem) in [
        (boxed([600.0, 10.0, 700.0, 90.0]), "box", "outside"),
        (boxed([50.0, 50.0, 50.0, 90.0]), "box", "no area"),
        (boxed([f32::NAN, 50.0, 90.0, 90.0]), "box", "no area"),
        (boxed([50.0, 50.0, 52.0, 90.0]), "box", "too small"),
        (Hints { object: vec![dot(-90.0, 50.0)], ..Hints::default() }, "strokes", "outside the picture"),
        (Hints { object: vec![dot(f32::INFINITY, 50.0)], ..Hints::default() }, "strokes", "no number"),
        (Hints { object: vec![dot(20.0, 20.0)], ..boxed([100.0, 100.0, 400.0, 400.0]) }, "strokes", "outside the box"),
        (
            Hints { object: vec![dot(240.0, 240.0)], ground: vec![dot(241.0, 240.0)], ..Hints::default() },
            "strokes",
            "same place",
        ),
    ] {
        let error = cutter.cut(&hints).unwrap_err();
        let Error::Setting { name: named, problem: said, .. } = &error else { panic!("{error:?}") };
        assert!(named == name && said.contains(problem), "{error}");
    }
    // Whatever was refused, the next box works.
    assert!(cutter.cut(&boxed([60.0, 100.0, 420.0, 460.0])).is_ok());
}
